#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Proves that one library stands alone: configures, builds and installs a copy of it that has no other library
# beside it, then compiles the first ```cpp block of its README against the installed package, without a warning, and
# runs it. It prints each line of the ```text block that follows.
# usage: scripts/tests/test_library_alone.sh [--of BUILD] NAME [SCRATCH_FOLDER]   (NAME: gas, membrane, jet, coupling, closed_form)
#   --of BUILD  installs the library of that build of the whole tree instead: does its package need another?
# A given scratch folder is kept, so that a second call builds incrementally.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
max_example_lines=20

whole=
if [[ ${1:-} == --of ]]; then
  whole=$(cd "$2" && pwd)
  shift 2
fi
name=${1:?usage: test_library_alone.sh [--of BUILD] NAME [SCRATCH_FOLDER]}
library=$([[ $name == closed_form ]] && echo verification/closed_form || echo "lib$name") # its folder in the tree
if [[ ! -f $root/$library/CMakeLists.txt ]]; then
  echo "test_library_alone.sh: no library $library" >&2
  exit 2
fi
if [[ $# -ge 2 ]]; then
  scratch=$2
  mkdir -p "$scratch"
else
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
fi
scratch=$(cd "$scratch" && pwd)

# The copy keeps file times, so that an unchanged library is not compiled again.
copy_sources() {
  rm -rf "$scratch/source" "$scratch/prefix" "$scratch/consumer"
  mkdir -p "$scratch/source/$(dirname "$library")" "$scratch/consumer"
  cp -a "$root/$library" "$scratch/source/$library"
  cp -a "$root/cmake" "$root/elementary" "$scratch/source"
}

# Without optimisation: whether it stands alone does not depend on it.
build_and_install() {
  if [[ -n $whole ]]; then
    cmake --install "$whole/$library" --prefix "$scratch/prefix"
    return
  fi
  cmake -S "$scratch/source/$library" -B "$scratch/build" -G Ninja -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DCMAKE_INSTALL_PREFIX="$scratch/prefix" -DGASJET_WERROR=ON -DCMAKE_UNITY_BUILD=ON
  cmake --build "$scratch/build" -j 2
  cmake --install "$scratch/build"
}

extract_example() {
  awk '/^```/ { if (inside) exit; if ($0 == "```cpp") { inside = 1; next } } inside' \
    "$root/$library/README.md" >"$scratch/consumer/example.cpp"
  awk '/^```text$/ && seen { inside = 1; next } /^```/ { if (inside) exit; if ($0 == "```cpp") seen = 1 } inside' \
    "$root/$library/README.md" >"$scratch/consumer/printed"
  local lines
  lines=$(wc -l <"$scratch/consumer/example.cpp")
  if ((lines == 0 || lines > max_example_lines)); then
    echo "$library/README.md: the first \`\`\`cpp block has $lines lines; allowed: 1 to $max_example_lines" >&2
    exit 1
  fi
}

build_and_run_example() {
  cat >"$scratch/consumer/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.25)
project(example LANGUAGES CXX)
find_package(gasjet_$name REQUIRED)
add_executable(example example.cpp)
target_link_libraries(example PRIVATE gasjet::$name)
END
  cmake -S "$scratch/consumer" -B "$scratch/consumer/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O3 -Wall -Wextra -Werror" \
    -DCMAKE_PREFIX_PATH="$scratch/prefix"
  cmake --build "$scratch/consumer/build"
  echo "--- output of the example of $library/README.md"
  (cd "$scratch/consumer" && build/example | tee output)
  [[ -s $scratch/consumer/printed ]] || { echo "$library/README.md does not say what its example prints" >&2; exit 1; }
  grep -vxFf "$scratch/consumer/output" "$scratch/consumer/printed" >&2 || return 0
  echo "$library/README.md: its example does not print these lines" >&2
  exit 1
}

copy_sources
extract_example
build_and_install
build_and_run_example
