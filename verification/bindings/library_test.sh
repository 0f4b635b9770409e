#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The shared libraries: what they export, and what they are made of.
# usage: library_test.sh PART SOURCE BUILD         PART: exports, permissive, abi, valgrind, can_fail; write_abi rewrites what abi compares with
set -euo pipefail

part=$1 source=$2 build=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

fail() {
  echo "library_test: $1" >&2
  exit 1
}

# declared HEADER...: functions of the headers.
declared() { sed -nE 's/^GASJET_API [a-z0-9_ ]+\*? ?(gasjet_[a-z0-9_]+)\(.*/\1/p' "$@" | LC_ALL=C sort; }
exported() { nm -D --defined-only "$1" | awk '{ print $3 }' | LC_ALL=C sort; }

# same_symbols LIBRARY HEADER...: the library exports what the headers declare, and nothing else.
same_symbols() {
  local library=$1
  shift
  diff <(exported "$library") <(declared "$@") >"$folder/difference" ||
    fail "$(basename "$library") exports (<) and its headers declare (>): $(grep '^[<>]' "$folder/difference" | paste -sd ' ')"
}

# dependencies OBJECT_PATTERN: all files that the objects of the build were compiled from.
dependencies() { ninja -C "$build" -t deps | awk -v wanted="$1" '/^[^ ]/ { on = $0 ~ wanted } on && /^ / { print $1 }' | LC_ALL=C sort -u; }

# gpl_of LIBRARY: what is GPL in it: static libraries on its link line, headers that its objects include.
gpl_of() {
  ninja -C "$build" -t query "bindings/c/$1" | grep -E 'lib(gsl|gasjet_(jet_tree|closed_form|tank_test))' || true
  readelf -d "$build/bindings/c/$1" | grep -E 'NEEDED.*gsl' || true
  dependencies "$2" | grep -E '/CGAL/license/|/gsl/' | grep -v '/lgpl.h$' || true
}

# interface SOURCE: what a compiled program relies on: enumerations, structures, functions, without comments, in fixed lines.
interface() {
  mkdir -p "$folder/empty"
  touch "$folder/empty/stddef.h" "$folder/empty/stdint.h"
  for header in gasjet.h gasjet_exact.h; do
    cc -E -P -nostdinc -isystem "$folder/empty" -I "$1/bindings/c/include" "$1/bindings/c/include/$header"
  done | tr -s ' \n' ' ' | sed -E 's/ ?__attribute__\(\(visibility\("default"\)\)\) ?/\n/g; s/; (typedef|enum) /;\n\1 /g; s/ $//' | awk '!seen[$0]++'
}

case $part in
  exports)
    same_symbols "$build/bindings/c/libgasjet.so" "$source"/bindings/c/include/gasjet/*.h
    same_symbols "$build/bindings/c/libgasjet_exact.so" "$source/bindings/c/include/gasjet_exact.h"
    version=$(sed -nE 's/^set.GASJET_VERSION ([0-9]+[.][0-9]+)[.].*/\1/p' "$source/cmake/GasjetVersion.cmake")
    readelf -d "$build/bindings/c/libgasjet.so" | grep -q "SONAME.*libgasjet.so.$version\]" || fail "the soname is not that of version $version"
    ;;
  permissive)
    library=$(basename "$(readlink -f "$build/bindings/c/libgasjet.so")")
    found=$(gpl_of "$library" '^(bindings/c/CMakeFiles/gasjet_(c|border)|driver/(base|engine|forecast|results|compare)/|libgas/CMakeFiles/gasjet_gas|libjet/CMakeFiles/gasjet_jet[.]|libmembrane/|libcoupling/)')
    [[ -z $found ]] || fail "$library has parts under the GPL: $found"
    ;;
  abi)
    list=$source/bindings/c/interface.txt
    interface "$source" | diff "$list" - >"$folder/difference" ||
      fail "the interface differs from $list. If version $(sed -nE 's/^set.GASJET_VERSION ([0-9.]+).*/\1/p' "$source/cmake/GasjetVersion.cmake") is released, \
raise it (docs/versions.md); write the new interface: library_test.sh write_abi. $(cat "$folder/difference")"
    ;;
  valgrind)
    libraries=$build/bindings/c
    cc -g "$source/verification/bindings/every_kind.c" -I"$source/bindings/c/include" -L"$libraries" -Wl,-rpath,"$libraries" \
      -lgasjet -lgasjet_exact -o "$folder/every_kind"
    "$folder/every_kind" "$source/cases/tank_blowdown.toml"
    if ! command -v valgrind >/dev/null; then
      echo "library_test: no valgrind here"
      exit 77
    fi
    valgrind -q --leak-check=full --errors-for-leak-kinds=definite,indirect,possible --error-exitcode=1 \
      "$folder/every_kind" "$source/cases/tank_blowdown.toml" || fail "valgrind found what stands above"
    ;;
  write_abi) interface "$source" >"$source/bindings/c/interface.txt" ;;
  can_fail)
    cp -r "$source/bindings" "$folder/bindings"
    interface "$folder" >"$folder/before"
    sed -i 's/double poisson;/float poisson;/' "$folder/bindings/c/include/gasjet/membrane.h"
    interface "$folder" | cmp -s - "$folder/before" && fail "a member of another type is not seen"
    # The same questions to what is under the GPL, and to a header that lacks a function.
    library=$(basename "$(readlink -f "$build/bindings/c/libgasjet_exact.so")")
    [[ -n $(gpl_of "$library" '^nothing') ]] || fail "GSL is not seen in $library"
    [[ -n $(dependencies '^libjet/CMakeFiles/gasjet_jet_tree[.]' | grep /CGAL/license/AABB_tree.h) ]] || fail "CGAL's AABB tree is not seen in jet_tree"
    sed '/gasjet_tank_read(/d' "$source/bindings/c/include/gasjet/gas.h" >"$folder/gas.h"
    (same_symbols "$build/bindings/c/libgasjet.so" "$folder/gas.h") 2>/dev/null && fail "an export that no header declares is not seen"
    true
    ;;
  *) fail "no part $part" ;;
esac
echo "library_test: $part holds"
