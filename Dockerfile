# SPDX-License-Identifier: Apache-2.0
# README's first command on an empty Debian 12.
FROM debian:bookworm
COPY . /gasjet
WORKDIR /gasjet
ENV PATH=/gasjet/build:$PATH
RUN scripts/run_main_case.sh
