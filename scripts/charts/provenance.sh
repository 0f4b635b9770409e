# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# What a table was made on and by (sourced, from the repository's top): the first lines of each CSV of docs/charts and
# docs/figures, which a rule asks for.

# machine NOTE: the note says how much of it was used; may be empty
machine() { echo "# machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1), $(nproc) cores${1:+, $1}"; }

# build_version: version, commit, compiler and flags of the program, build/gasjet or $gasjet
build_version() { "${gasjet:-build/gasjet}" --version | sed 's/^/# /'; }

provenance() {
  machine ""
  build_version
}
