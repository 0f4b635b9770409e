#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the Debian 12 packages that Gasjet needs (root, or a user with sudo). Does nothing when all are there.
# usage: scripts/setup_debian12.sh [PACKAGE...]      further packages, for a benchmark
set -euo pipefail

packages=(
  g++ cmake ninja-build make git ca-certificates # make: what CMake takes where no generator is named
  libeigen3-dev libboost-dev libgsl-dev libcgal-dev libgmp-dev libmpfr-dev
  libgtest-dev libbenchmark-dev libtomlplusplus-dev libcli11-dev libfmt-dev nlohmann-json3-dev libtbb-dev zlib1g-dev
  gnuplot-nox libjs-three locales # locales: a test with a decimal comma
  libflint-arb-dev # optional: proved bounds, gasjet enclose
  gfortran python3-dev python3-numpy pybind11-dev pkg-config patchelf # the bindings; patchelf: for wheels
  "$@"
)

is_installed() {
  [[ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  echo "setup_debian12.sh: no apt-get here; install by other means: ${packages[*]}" >&2
  exit 1
fi

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  echo "setup: all ${#packages[@]} packages are installed"
  exit 0
fi

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "setup_debian12.sh: needs root or sudo to install: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
echo "setup: installing ${missing[*]}"
"${as_root[@]}" apt-get update -q </dev/null
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}" </dev/null
