#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Test of scripts/tests/mutate.sh on a project of one function: a mutation that its test sees is killed, one that it
# does not see survives, and mutations that cannot be tried are reported, none of them as killed.
set -euo pipefail
scripts=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../scripts" && pwd)
tree=$(mktemp -d)
scratch=$(mktemp -d)
trap 'rm -rf "$tree" "$scratch"' EXIT

mkdir -p "$tree/scripts/tests" "$tree/verification"
cp "$scripts/tests/mutate.sh" "$tree/scripts/tests"
cat >"$tree/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(toy LANGUAGES CXX)
enable_testing()
add_executable(toy toy.cpp)
add_test(NAME toy COMMAND toy)
END
cat >"$tree/toy.cpp" <<'END'
double twice(double x) { return 2 * x; }
int unseen() { return 7; }
int main() { return twice(3) == 6 ? 0 : 1; }
END
git -C "$tree" init -q

# outcome EXPECTED_EXIT EXPECTED_VERDICT TEST FILE EXPRESSION
outcome() {
  local report status=0
  printf '# comment\n%s\t%s\t%s\n' "$3" "$4" "$5" >"$tree/verification/mutations.tsv"
  report=$("$tree/scripts/tests/mutate.sh" --scratch "$scratch" 2>&1) || status=$?
  if [[ $status != "$1" || $report != "$2"* ]]; then
    printf 'mutation %s: expected exit %s and "%s", got exit %s and:\n%s\n' "$5" "$1" "$2" "$status" "$report"
    exit 1
  fi
}

outcome 0 'killed' toy toy.cpp 's/2 \* x/3 * x/'
outcome 1 'SURVIVED' toy toy.cpp 's/return 7/return 8/'
outcome 1 'sed changed nothing' toy toy.cpp 's/absent/x/'
outcome 1 'does not compile' toy toy.cpp 's/2 \* x/2 * y/'
outcome 1 'test fails or is missing' no_such_test toy.cpp 's/2 \* x/3 * x/'
outcome 1 'no such file' toy gone.cpp 's/2/3/'
outcome 0 'killed' '^t[o]y$' toy.cpp 's/2 \* x/4 * x/'

# One change of a function that a test calls, one of a function that none calls: both written by the program, tried by its suite.
cp "$scripts/tests/random_mutations.py" "$tree/scripts/tests"
mkdir -p "$tree/libgas" "$tree/verification/gas"
cat >"$tree/libgas/toy.cpp" <<'END'
#include "toy.hpp"
namespace gas {
double Toy::twice(double x) const { return 2 * x; }  // 2 * x
double unseen(double x) { return "1 * 2"[0] * x; }
}  // namespace gas
END
cat >"$tree/libgas/toy.hpp" <<'END'
namespace gas {
struct Toy {
  double twice(double x) const;
};
}  // namespace gas
END
cat >"$tree/verification/gas/toy_test.cpp" <<'END'
#include "toy.hpp"
int main() { return gas::Toy().twice(3) == 6 ? 0 : 1; }
END
cat >"$tree/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(toy LANGUAGES CXX)
enable_testing()
add_custom_target(gasjet)
add_subdirectory(verification/gas)
END
cat >"$tree/verification/gas/CMakeLists.txt" <<'END'
add_executable(toy ../../libgas/toy.cpp toy_test.cpp)
target_include_directories(toy PRIVATE ../../libgas)
add_test(NAME toy COMMAND toy)
set_tests_properties(toy PROPERTIES LABELS fast)
END
list=$scratch/random.tsv
"$tree/scripts/tests/random_mutations.py" --number 5 >"$list"
sed -i 's/^@gas coupled/@gas/' "$list"
printf '@gas\tlibgas/toy.cpp\t%s\n' '3s/ \* / \/ /1' '4s/ \* / \/ /2' | cmp - "$list"
report=$("$tree/scripts/tests/mutate.sh" --scratch "$scratch" --list "$list" 2>&1) && exit 1
[[ $report == "killed "*$'\nSURVIVED '*'1 of 2 mutations killed' ]] || { echo "suite: $report"; exit 1; }
[[ $("$tree/scripts/tests/random_mutations.py" --functions unseen) == *'4s/'* ]]

# refuses PATTERN ARGUMENT...: exit code 2 and one line
refuses() {
  local said status=0
  said=$("$tree/scripts/tests/mutate.sh" "${@:2}" 2>&1) || status=$?
  [[ $status == 2 && $said == *"$1"* && $said != *$'\n'* ]] || { echo "exit $status, 2 and '$1' expected: $said"; exit 1; }
}
refuses "no file that can be read" --list "$tree/absent"
refuses "no folder that can be made" --scratch /dev/null
refuses "no extended regular expression" --only '['
refuses "no line of" --only no_such_line
echo "mutate.sh told all six outcomes apart"
