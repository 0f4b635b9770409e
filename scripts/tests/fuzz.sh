#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs the harnesses of verification/fuzz under AddressSanitizer and UndefinedBehaviorSanitizer, each from the shipped cases and
# meshes and from what earlier runs have kept in build-fuzz/corpus. Ends at the first input that breaks one, and keeps it there.
# Writes what each did to build-fuzz/fuzz.csv.
# usage: scripts/tests/fuzz.sh SECONDS [HARNESS...]      SECONDS for each; obj, keyword, visibility, contact, control_volume,
#                                                  case_reader, curve, history, written_mesh, all of them by default
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
all=(obj keyword visibility contact control_volume case_reader curve history written_mesh)

[[ ${1:-} =~ ^[1-9][0-9]*$ ]] || {
  echo "usage: scripts/tests/fuzz.sh SECONDS [HARNESS...]; harnesses: ${all[*]}" >&2
  exit 2
}
seconds=$1
shift
(($#)) || set -- "${all[@]}"
for name in "$@"; do
  [[ " ${all[*]} " == *" $name "* ]] || {
    echo "fuzz.sh: no harness '$name', allowed are ${all[*]}" >&2
    exit 2
  }
done

# seeds NAME: files that a harness begins with.
seeds() {
  case $1 in
    obj) find cases -name '*.obj' -size -200k ;;
    keyword) find cases -name '*.k' -size -200k ;;
    case_reader) find cases -maxdepth 1 -name '*.toml' ;;
    written_mesh) find verification/mesh/written -name '*.msh' -o -name '*.v*' ;;
    curve | history) find cases -name '*.csv' -size -200k ;;
  esac
}

cmake -S . -B build-fuzz -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_CXX_FLAGS_RELWITHDEBINFO='-O1 -g' \
  -DGASJET_SANITIZE=ON -DGASJET_FUZZ=ON -DGASJET_TESTS=OFF -DCMAKE_UNITY_BUILD=ON >/dev/null
cmake --build build-fuzz --target "${@/#/fuzz_}" -j "$(nproc)" >build-fuzz/log || { tail -n 60 build-fuzz/log; exit 1; }
printf '# commit: %s\nharness,cpu_s,inputs,edges\n' "$(git rev-parse --short=12 HEAD)" >build-fuzz/fuzz.csv
for name in "$@"; do
  corpus=build-fuzz/corpus/$name
  mkdir -p "$corpus"
  while IFS= read -r file; do cp "$file" "$corpus/$(basename "$file")"; done < <(seeds "$name")
  log=build-fuzz/$name.log
  TIMEFORMAT=%U
  if cpu=$({ time build-fuzz/verification/fuzz/fuzz_"$name" -max_total_time="$seconds" -timeout=60 -rss_limit_mb=2048 -max_len=65536 \
    -artifact_prefix="build-fuzz/$name-" "$corpus" >"$log" 2>&1 </dev/null; } 2>&1); then
    inputs=$(sed -n 's/^Done \([0-9]*\) runs in .*/\1/p' "$log")
    edges=$(sed -n 's/.*DONE *cov: \([0-9]*\) .*/\1/p' "$log")
    echo "$name,$cpu,$inputs,$edges" >>build-fuzz/fuzz.csv
    echo "$name: $inputs inputs in $cpu s of CPU, $edges edges of the program seen, nothing found"
  else
    tail -n 60 "$log"
    echo "fuzz.sh: $name: an input breaks it, see $log and build-fuzz/$name-*" >&2
    exit 1
  fi
done
