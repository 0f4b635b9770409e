#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Uses what is installed in PREFIX as a stranger does: builds and runs this folder's project, which takes all C++ packages at once.
# usage: use.sh PREFIX [COMPILER]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
prefix=$1
compiler=${2:-c++}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

echo "--- $compiler"
cmake -S "$here" -B "$scratch" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O0 -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_PREFIX_PATH="$prefix" >"$scratch/log" || { cat "$scratch/log"; exit 1; }
cmake --build "$scratch"
"$scratch/outside"
