#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# tidy.sh passes a small good tree, and tells a bad name, a bad enumerator and a header that does not compile.
set -euo pipefail
here=$(cd "${BASH_SOURCE[0]%/*}" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
cp "$here/../../.clang-tidy" "$tree"
mkdir -p "$tree"/{libgas,libjet,driver}/{include,src}
good='#pragma once\nnamespace gas {\nenum class Kind { round_one, other };\nclass Tank {\n public:\n  int size() const { return size_; }\n\n private:\n  int size_ = 0;\n};\n}'
printf "$good\n" >"$tree/libgas/include/tank.hpp"
printf '#pragma once\n#include "tank.hpp"\n' >"$tree/libjet/src/jet.hpp"
"$here/tidy.sh" "$tree" "$tree"

# tells WORDS SED: with the header changed so, tidy.sh fails and says the words
tells() {
  local report status=0
  printf "$good\n" | sed "$2" >"$tree/libgas/include/tank.hpp"
  report=$("$here/tidy.sh" "$tree" "$tree") || status=$?
  if ((status != 1)) || [[ $report != "libgas/include/tank.hpp:"*"$1"* ]]; then
    printf 'changed by %s tidy.sh ends with %d and says:\n%s\n' "$2" "$status" "$report"
    exit 1
  fi
}

tells "'tank' [readability-identifier-naming" 's/class Tank/class tank/'
tells "'roundOne' [readability-identifier-naming" 's/round_one/roundOne/'
tells "unknown type name 'real'" 's/int size_ =/real size_ =/'

# The same of a source that a build compiles.
printf 'rule cxx\n  command = c++ -c $in -o $out\nbuild tank.o: cxx %s/libgas/src/tank.cpp\n' "$tree" >"$tree/build.ninja"
printf 'namespace {\nint sizeOf() { return 1; }\n}\nint main() { return sizeOf(); }\n' >"$tree/libgas/src/tank.cpp"
report=$("$here/tidy.sh" "$tree" "$tree" sources) && { echo "tidy.sh passes a bad name in a source" && exit 1; }
[[ $report == "libgas/src/tank.cpp:2:"*"'sizeOf' [readability-identifier-naming"* ]] || { echo "of a bad name in a source tidy.sh says: $report" && exit 1; }
