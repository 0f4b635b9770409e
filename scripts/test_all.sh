#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Sets up the machine, builds with warnings as errors and runs the tests, then runs them once more with libraries and
# driver, built by clang, under AddressSanitizer (without its watch for use after scope) and UndefinedBehaviorSanitizer, with libFuzzer for
# a minute; left out there (CMakePresets.json) are long tests of values, whose code shorter ones run too. The last line counts the tests
# of both suites together.
# usage: scripts/test_all.sh [--no-sanitize] [--long]
#   --no-sanitize  leave out the sanitizer build
#   --long         also run the tests labelled `long` (release build only)
set -euo pipefail
export LC_ALL=C.UTF-8 # numbers with a decimal point, wherever the user is
cd "$(dirname "${BASH_SOURCE[0]}")/.."

sanitize=1
long=0
for argument in "$@"; do
  case $argument in
    --no-sanitize) sanitize=0 ;;
    --long) long=1 ;;
    *)
      echo "test_all.sh: unknown argument '$argument'; allowed: --no-sanitize, --long" >&2
      exit 2
      ;;
  esac
done

jobs=$(nproc)
logs=$(mktemp -d)
trap 'rm -rf "$logs"' EXIT
times=()
failed_suites=()
passed_suites=()

# phase NAME COMMAND...: runs it, and keeps its wall time and what its processes computed, in hundredths of a second by the kernel.
phase() {
  local name=$1 start=$SECONDS status=0 before after
  shift
  echo "=== $name"
  read -ra before </proc/$$/stat
  "$@" || status=$?
  read -ra after </proc/$$/stat
  times+=("$(printf '%-22s %4d s, %4d s of CPU' "$name" $((SECONDS - start)) $(((after[15] + after[16] - before[15] - before[16]) / 100)))")
  return "$status"
}

# suite PRESET [CTEST_OPTION...]: one ctest run; a failed test does not keep the next suite from running.
suite() {
  if phase "test $1" run_ctest "$@"; then passed_suites+=("$1"); else failed_suites+=("$1"); fi
}

run_ctest() {
  ctest --preset "$@" --no-tests=error -j $((jobs + 1)) </dev/null | tee "$logs/$1"
}

# build PRESET [CMAKE_OPTION...]
build() {
  phase "configure $1" cmake --preset "$1" -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=30 "${@:2}"
  phase "build $1" cmake --build --preset "$1" -j "$jobs"
}

# what_failed: the last lines that each failed test wrote, for who sees the end of a long log only.
what_failed() {
  awk -v last=12 '
    function tell(  i) { for (i = n > last ? n - last : 0; i < n; ++i) print line[i]; n = 0 }
    /^ *[0-9]+\/[0-9]+ Test +#/ { tell(); within = /\*\*\*/; if (within) print "--- " $0; next }
    /^ +Start +[0-9]+:/ { next }
    /tests passed, [0-9]+ tests* failed/ { tell(); within = 0 }
    within && NF { line[n++] = substr($0, 1, 240) }' "$logs"/*
}

# closing_line: ctest's "P% tests passed, F tests failed out of N", summed over the suites.
closing_line() {
  local failed=0 total=0 of_suite
  while read -r -a of_suite; do
    failed=$((failed + of_suite[0])) total=$((total + of_suite[1]))
  done < <(sed -n 's/.*tests passed, \([0-9]*\) tests* failed out of \([0-9]*\).*/\1 \2/p' "$logs"/*)
  ((total)) || return 1
  echo "$((100 * (total - failed) / total))% tests passed, $failed tests failed out of $total"
}

export UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1}
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache
fi

only_tests=(doxygen clang libclang-rt-14-dev clang-format clang-tidy mkdocs mkdocs-material python3-pymdownx katex chromium python3-jsonschema python3-pytest python3-jinja2 dpkg-dev file libopenmpi-dev python3-scipy python3-matplotlib python3-meshio python3-nbclient python3-ipykernel python3-venv)
((!long)) || only_tests+=(python3-vtk9 slurm-wlm parallel debootstrap) # without them tests say that they are skipped
phase "set-up" scripts/setup_debian12.sh "${only_tests[@]}"
build release -DGASJET_MPI=ON
rm -f build/claims/*.tsv build/green
suite fast
grep '^SKIPPED' build/Testing/Temporary/LastTest.log || true # why a test did not run
# Both pages are of the fast tests; long ones write rows of their own.
phase "pages of claims" docs/make/pages/claims.py --check || failed_suites+=("pages of claims")
if ((long)); then suite long; fi
if ((sanitize)); then
  build sanitize -DCMAKE_CXX_COMPILER=clang++ -DGASJET_FUZZ=ON
  suite sanitize
fi

echo "=== wall time and CPU time of each phase, on $jobs cores"
printf '%s\n' "${times[@]}"
if ((${#failed_suites[@]})); then
  what_failed
  echo "failed suites: ${failed_suites[*]}"
fi
closing_line
((${#failed_suites[@]} == 0)) || exit 1
if [[ -z $(git status --porcelain 2>&1) ]]; then
  echo "$(git rev-parse HEAD)$(printf ' %s' "${passed_suites[@]}")" >build/green # for scripts/release.sh
fi
