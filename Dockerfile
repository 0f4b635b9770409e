# SPDX-License-Identifier: Apache-2.0
# README's first command on an empty Debian 12.
FROM debian:bookworm
COPY . /gasjet
WORKDIR /gasjet
RUN scripts/run_main_case.sh
