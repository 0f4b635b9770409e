#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs a build and uses all of its packages from one outside project, with the default compiler and with clang++
# where there is one. usage: outside_test.sh BUILD_DIR
set -euo pipefail
build=$1
project=$(cd "$(dirname "${BASH_SOURCE[0]}")/outside" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cmake --install "$build" --prefix "$scratch/prefix" >"$scratch/installed"

use_with() { # COMPILER
  echo "--- $1"
  cmake -S "$project" -B "$scratch/$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O0 \
    -DCMAKE_CXX_COMPILER="$1" -DCMAKE_PREFIX_PATH="$scratch/prefix"
  cmake --build "$scratch/$1"
  "$scratch/$1/outside"
}

use_with c++
for clang in clang++ clang++-14; do
  if command -v "$clang" >/dev/null; then
    use_with "$clang"
    break
  fi
done
