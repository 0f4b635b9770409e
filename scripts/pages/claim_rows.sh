#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds and runs, into an empty FOLDER, every test that writes rows of docs/verification.md or docs/stability.md
# (verification/support/claim.hpp), long ones too. CI writes the same rows to build/claims while it tests.
# usage: scripts/pages/claim_rows.sh FOLDER
set -euo pipefail
folder=$(realpath -m "${1:?usage: scripts/pages/claim_rows.sh FOLDER}")
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

mkdir -p "$folder"
rm -f "$folder"/*.tsv
cmake --preset release >"$folder/log"
cmake --build --preset release -j "$(nproc)" >>"$folder/log"
suites=$(grep -rlE --include='*_test.cpp' 'claim::expect_' verification |
  xargs sed -nE 's/^TEST(_F|_P)?\(([A-Za-z0-9_]+), .*/\2/p' | sort -u | paste -sd '|')
GASJET_CLAIMS=$folder ctest --test-dir build -R "(^|/)($suites)\." --no-tests=error -j "$(nproc)" </dev/null >>"$folder/log" ||
  { grep -E 'Failed|\*\*\*' "$folder/log" >&2; echo "claim_rows.sh: a claim does not hold; see $folder/log" >&2; exit 1; }
