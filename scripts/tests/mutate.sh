#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Shows that the tests can fail: applies each mutation of a list to a scratch copy of the work tree, one at a time, and
# expects the named test to turn red there. `@gas coupled` in place of a test: any fast test of verification/gas or
# verification/coupled.
# usage: scripts/tests/mutate.sh [--list FILE] [--only REGEX] [--scratch FOLDER]
#   --list FILE       in place of verification/mutations.tsv: what scripts/tests/random_mutations.py wrote
#   --only REGEX      only the lines of the list that match
#   --scratch FOLDER  keep copy and build there; a later call builds incrementally
# Exit code: 0 all mutations killed; 1 some survived or could not be tried; 2 bad arguments.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
list=$root/verification/mutations.tsv
test_time_limit=300 # [s] a mutant that hangs counts as killed
jobs=$(nproc)

only=.
scratch=
while (($#)); do
  case $1 in
    --list | --only | --scratch)
      if (($# < 2)); then
        echo "mutate.sh: $1 needs a value" >&2
        exit 2
      fi
      declare "${1#--}=$2"
      shift 2
      ;;
    *)
      echo "mutate.sh: unknown argument '$1'; allowed: --list FILE, --only REGEX, --scratch FOLDER" >&2
      exit 2
      ;;
  esac
done
if [[ -z $scratch ]]; then
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
fi
if [[ ! -r $list ]]; then
  echo "mutate.sh: --list '$list' is no file that can be read" >&2
  exit 2
fi
matches=0
grep -qE -e "$only" /dev/null 2>/dev/null || matches=$?
if ((matches > 1)); then
  echo "mutate.sh: --only '$only' is no extended regular expression" >&2
  exit 2
fi
if ! mkdir -p "$scratch" 2>/dev/null || [[ ! -w $scratch ]]; then
  echo "mutate.sh: --scratch '$scratch' is no folder that can be made and written" >&2
  exit 2
fi
scratch=$(cd "$scratch" && pwd)
copy=$scratch/source
build=$scratch/build
log=$scratch/log

# Brings the copy up to date, touching only files that differ, so that a kept build stays incremental.
copy_work_tree() {
  local file
  mkdir -p "$copy"
  git -c safe.directory="$root" -C "$root" ls-files --cached --others --exclude-standard | LC_ALL=C sort -u >"$scratch/files"
  (cd "$copy" && find . -type f -printf '%P\n') | LC_ALL=C sort | LC_ALL=C comm -13 "$scratch/files" - |
    while IFS= read -r file; do rm "$copy/$file"; done
  while IFS= read -r file; do
    if [[ -f $root/$file ]] && ! cmp -s "$root/$file" "$copy/$file"; then
      mkdir -p "$(dirname "$copy/$file")"
      cp "$root/$file" "$copy/$file"
      [[ ! -x $root/$file ]] || chmod +x "$copy/$file"
    fi
  done <"$scratch/files"
}

# Warnings stay warnings: a mutation may leave a variable unused. What one scratch folder compiled serves the next.
configure() {
  if command -v ccache >/dev/null; then
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache CCACHE_BASEDIR=$scratch CCACHE_NOHASHDIR=1
  fi
  cmake -S "$copy" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DGASJET_WERROR=OFF -DGASJET_BENCHMARKS=ON \
    -DCMAKE_UNITY_BUILD=OFF >"$log" 2>&1
}

# build_for [TEST]: the programs that this test's commands name in the build folder; everything if none.
build_for() {
  local word targets=()
  if [[ ${1:-} == @* ]]; then
    read -ra targets <<<"${1#@}"
    targets=("${targets[@]/#/verification/}")
    targets=(gasjet "${targets[@]/%//all}")
  elif (($#)); then
    while IFS= read -r word; do
      [[ ! -f $word || ! -x $word ]] || targets+=("${word#"$build/"}")
    done < <(ctest --test-dir "$build" -N -V -R "$1" | grep 'Test command:' | grep -oE "$build/[^ \"]+" | sort -u)
  fi
  cmake --build "$build" -j "$jobs" ${targets[0]+--target "${targets[@]}"} >"$log" 2>&1
}

# run_test TEST: 0 if it passes; of a suite the first failure ends it.
run_test() {
  local folder
  if [[ $1 == @* ]]; then
    for folder in ${1#@}; do
      timeout $((6 * test_time_limit)) ctest --test-dir "$build/verification/$folder" -L fast --no-tests=error --stop-on-failure \
        --timeout "$test_time_limit" -j "$jobs" >"$log" 2>&1 </dev/null || return 1
    done
    return 0
  fi
  timeout "$test_time_limit" ctest --test-dir "$build" -R "$1" --no-tests=error -j "$jobs" >"$log" 2>&1 </dev/null
}

# find_red_tests: the tests that fail, or do not exist, before any mutation; nothing can be shown with them.
declare -A red=()
find_red_tests() {
  local test matching single=()
  for test in "${tests[@]}"; do
    if [[ $test != @* ]]; then
      single+=("$test")
    elif [[ -z ${red[$test]:-} ]]; then
      red[$test]=0
      run_test "$test" || red[$test]=1
    fi
  done
  ((${#single[@]})) || return 0
  ctest --test-dir "$build" -N | sed -n 's/^ *Test *#[0-9]*: //p' >"$scratch/names"
  ctest --test-dir "$build" -R "$(printf '%s\n' "${single[@]}" | LC_ALL=C sort -u | paste -sd '|')" --timeout "$test_time_limit" \
    -j "$jobs" >"$log" 2>&1 </dev/null || true
  sed -n '/^The following tests FAILED/,$s/^[[:space:]]*[0-9]* - \(.*\) (.*/\1/p' "$log" >"$scratch/failed"
  for test in "${single[@]}"; do
    matching=$(grep -E -e "$test" "$scratch/names" || true)
    red[$test]=0
    if [[ -z $matching ]] || grep -qxF -e "$matching" "$scratch/failed"; then red[$test]=1; fi
  done
}

# try_mutation TEST FILE EXPRESSION: sets `verdict`. The restored file is compiled with the next mutation.
try_mutation() {
  local file=$copy/$2
  if [[ ! -f $file ]]; then
    verdict="no such file"
    return
  fi
  if [[ ${red[$1]} == 1 ]]; then
    verdict="test fails or is missing without mutation"
    return
  fi
  cp "$file" "$scratch/original"
  if ! sed -i -e "$3" "$file" 2>"$log"; then
    verdict="sed refuses the expression"
  elif cmp -s "$file" "$scratch/original"; then
    verdict="sed changed nothing"
  elif ! build_for "$1"; then
    verdict="does not compile"
  elif run_test "$1"; then
    verdict="SURVIVED"
  else
    verdict="killed"
  fi
  cp "$scratch/original" "$file"
}

tests=() mutated_files=() expressions=()
while IFS=$'\t' read -r test file expression _; do
  tests+=("$test") mutated_files+=("$file") expressions+=("$expression")
done < <(grep -v -e '^#' -e '^[[:space:]]*$' "$list" | grep -E -e "$only")
if ((${#tests[@]} == 0)); then
  echo "mutate.sh: no line of $list matches '$only'" >&2
  exit 2
fi

copy_work_tree
if ! { configure && build_for; }; then
  tail -40 "$log" >&2
  echo "mutate.sh: the unmutated tree does not build" >&2
  exit 1
fi
find_red_tests

killed=0
for i in "${!tests[@]}"; do
  verdict=
  try_mutation "${tests[i]}" "${mutated_files[i]}" "${expressions[i]}"
  printf '%-10s %s | %s | %s\n' "$verdict" "${tests[i]}" "${mutated_files[i]}" "${expressions[i]}"
  [[ $verdict != killed ]] || killed=$((killed + 1))
done
echo "$killed of ${#tests[@]} mutations killed"
((killed == ${#tests[@]}))
