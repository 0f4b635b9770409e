#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# clang-tidy of every header, public and private: names, and the checks of the list below. All headers together are two translation
# units, which takes seconds; all sources, as BUILD compiles them, take minutes. Prints what it finds as clang-tidy does, with the
# tree's paths.
# usage: tidy.sh ROOT BUILD [sources]; exit code 0: nothing found, 1: something
set -euo pipefail
root=$(cd "$1" && pwd) build=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$root"
checks='-*,readability-identifier-naming,readability-duplicate-include,misc-definitions-in-headers,misc-unused-alias-decls'
checks+=',bugprone-copy-constructor-init,bugprone-integer-division,bugprone-sizeof-expression,bugprone-use-after-move'
checks+=',bugprone-virtual-near-miss,performance-for-range-copy,performance-unnecessary-copy-initialization'

# tidy HEADER...: of one translation unit that includes them
tidy() {
  local unit=$scratch/$BASHPID.cpp folders=()
  printf '#include "%s"\n' "$@" >"$unit"
  mapfile -t folders < <({ printf '%s\n' "$root"/{lib*,elementary,verification/{enclosure,closed_form}}/include/; printf '%s\n' "$@" | grep -oE '^.*/(include|src)/'; } | sort -u | sed 's/^/-I/')
  clang-tidy --quiet --checks="$checks" --warnings-as-errors='*' --header-filter="$root/(lib|driver)" --config-file=.clang-tidy "$unit" -- \
    -std=c++20 -ferror-limit=0 "${folders[@]}" -I"$root/libgas/src/tank_test" -I"$build/driver" -isystem /usr/include/eigen3 2>&1 |
    grep -E '^/.*(warning|error):' | sed "s|^$root/||" || true
}

# tidy_unit FILE: as the build compiles it; warnings of the compiler are another test's
tidy_unit() {
  clang-tidy --quiet -p "$scratch" --checks="$checks" --warnings-as-errors='*' --header-filter="$root/(lib|driver)" \
    --config-file=.clang-tidy --extra-arg=-w "$1" 2>&1 | grep -E '^/.*(warning|error):' | sed "s|^$root/||" || true
}

if [[ ${3:-} == sources ]]; then
  ninja -C "$build" -t compdb >"$scratch/compile_commands.json"
  mapfile -t units < <(grep -oE '"file": "[^"]*/(lib[a-z]+|driver)/[^"]*\.c(pp|xx)"' "$scratch/compile_commands.json" | cut -d'"' -f4 | LC_ALL=C sort -u)
  ((${#units[@]})) || { echo "tidy.sh: $build compiles no source" && exit 1; }
  export -f tidy_unit
  export root scratch checks
  printf '%s\0' "${units[@]}" | xargs -0 -n1 -P"$(nproc)" bash -c 'tidy_unit "$1"' - | sort -u | tee "$scratch/all"
  [[ ! -s $scratch/all ]]
  exit
fi

# Two headers of one name, or of one type, are not in one unit.
mapfile -t headers < <(find "$root"/lib* "$root"/driver -name '*.hpp' -regex '.*/\(include\|src\)/.*' | LC_ALL=C sort)
mapfile -t first < <(printf '%s\n' "${headers[@]}" | grep -vE '/libjet/src/|/lanes_whole')
mapfile -t second < <(printf '%s\n' "${headers[@]}" | grep '/libjet/src/')
tidy "${first[@]}" >"$scratch/first" &
tidy "${second[@]}" >"$scratch/second"
wait
sort -u "$scratch"/{first,second} | tee "$scratch/all"
[[ ! -s $scratch/all ]]
