#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What CONTRIBUTING.md says of a new species and a new impactor, done to a copy: one row of the table of species, and a capsule in the
# header of the impactor's shape. Both libraries are built, and a program uses what is new.
# usage: extend_test.sh [SCRATCH]; a given folder is kept
set -euo pipefail
root=$(cd "${BASH_SOURCE[0]%/*}/../.." && pwd)
here=$root/verification/rules/extend
scratch=${1:-}
if [[ -z $scratch ]]; then
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
fi
rm -rf "$scratch/source"
mkdir -p "$scratch/source"
cp -a "$root"/{cmake,libgas,libcoupling} "$scratch/source"

echo 'Kr,83.798,200.0,6000.0,2.5,0.0,0.0,0.0,0.0,-745.375,5.49095651,test' >>"$scratch/source/libgas/data/nasa7.csv"

shape=$scratch/source/libcoupling/include/coupling/impactor.hpp
{
  sed '/^\/\/\/ The shape that contact is compiled for/,$d; s/^#include <optional>/&\n\n#include "coupling\/side.hpp"/' "$shape"
  cat "$here/capsule.hpp"
  sed -n '/^\/\/\/ The shape that contact is compiled for/,$p' "$shape" | sed 's/= Sphere;/= Capsule;/'
} >"$scratch/impactor.hpp"
mv "$scratch/impactor.hpp" "$shape"

# build LIBRARY PROGRAM: the library of the copy, and a program that links it
build() {
  cmake -S "$scratch/source/lib$1" -B "$scratch/$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$scratch/prefix" \
    -DCMAKE_UNITY_BUILD=ON >/dev/null
  cmake --build "$scratch/$1" -j 2 >/dev/null
  cmake --install "$scratch/$1" >/dev/null
  mkdir -p "$scratch/$2"
  cp "$here/$2.cpp" "$scratch/$2"
  printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' "project($2 CXX)" "find_package(gasjet_$1 REQUIRED)" \
    "add_executable($2 $2.cpp)" "target_link_libraries($2 gasjet::$1)" >"$scratch/$2/CMakeLists.txt"
  cmake -S "$scratch/$2" -B "$scratch/$2/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$scratch/prefix" >/dev/null
  cmake --build "$scratch/$2/build" >/dev/null
  "$scratch/$2/build/$2"
}
build gas species_test
build coupling capsule_test
echo "a species took one row, an impactor one header"
