#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Uses what is installed in PREFIX as a stranger does: builds and runs this folder's project, which takes all C++ packages at once,
# and without COMPILER the programs in C, Fortran and Python, where PREFIX has what they need.
# usage: use.sh PREFIX [COMPILER]
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
prefix=$1
compiler=${2:-c++}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

version=$("$prefix/bin/gasjet" --version | sed -nE '1s/^gasjet ([0-9]+[.][0-9]+)[.].*/\1/p') # as a user asks for it
[[ -n $version ]] || { echo "$prefix/bin/gasjet names no version"; exit 1; }
echo "--- $compiler, version $version"
cmake -S "$here" -B "$scratch" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O0 -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_PREFIX_PATH="$prefix" -DGASJET_VERSION="$version" >"$scratch/log" || { cat "$scratch/log"; exit 1; }
cmake --build "$scratch"
"$scratch/outside"
(($# == 1)) || exit 0

# installed NAME: the folder of a file in PREFIX/lib, of Debian's folders or of others
installed() { dirname "$(find "$prefix"/lib* -name "$1" -print -quit)"; }

libraries=$(installed libgasjet.so)
[[ $libraries != . ]] || exit 0
PKG_CONFIG_PATH=$(installed gasjet.pc)
export PKG_CONFIG_PATH LD_LIBRARY_PATH=$libraries${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
# shellcheck disable=SC2046
cc -std=c99 -Wall -Wextra -pedantic -Werror "$here/consumer.c" $(pkg-config --cflags --libs gasjet gasjet_exact) -lm -o "$scratch/consumer_c"
"$scratch/consumer_c"
if [[ $(installed gasjet_fortran.pc) != . ]]; then
  # shellcheck disable=SC2046
  gfortran -Wall -Werror "$here/consumer.f90" $(pkg-config --cflags --libs gasjet_fortran gasjet_exact) -o "$scratch/consumer_f"
  "$scratch/consumer_f"
  # As another compiler, which cannot read the .mod.
  # shellcheck disable=SC2046
  gfortran -std=f2018 -J "$scratch" "$(pkg-config --variable=source gasjet_fortran)" "$here/consumer.f90" \
    $(pkg-config --libs gasjet gasjet_exact) -o "$scratch/consumer_source"
  "$scratch/consumer_source"
fi
packages=$(installed _gasjet.*.so)
if [[ $packages != . ]]; then
  export PYTHONPATH=${packages%/gasjet} PYTHONDONTWRITEBYTECODE=1
  /usr/bin/python3 "$here/consumer.py"
fi
