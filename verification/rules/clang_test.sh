#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds libraries and command with clang 14, warnings as errors, and runs a tank and a bag with them.
# usage: clang_test.sh BUILD_FOLDER       exit code 77: no clang++ here
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${1:?usage: clang_test.sh BUILD_FOLDER}
clang=$(command -v clang++-14 || command -v clang++) || { echo "SKIPPED: no clang++"; exit 77; }
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$clang" -DGASJET_WERROR=ON -DGASJET_TESTS=OFF >/dev/null
cmake --build "$build" --target gasjet
for case in rigid_tank driver_bag; do
  "$build/gasjet" run "$root/cases/$case.toml" --out "$build/$case" --set scene.end_time=0.002 --quiet
  grep -q '"status": "done"' "$build/$case/summary.json"
done
