#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Proves that scripts/api_docs.sh fails where a public member is undocumented, and names it. usage: api_docs_can_fail.sh
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$root"
cp --parents -r docs/Doxyfile scripts/api_docs.sh lib*/include "$scratch"
printf '%s\n' '// the first line names the file' 'namespace gas {' 'struct Bare { double bare; };' '}' >"$scratch/libgas/include/gas/bare.hpp"
if "$scratch/scripts/api_docs.sh" "$scratch/out" >"$scratch/log" 2>&1; then
  echo "api_docs.sh lets an undocumented member pass"
  exit 1
fi
grep -q 'Member bare .* of struct gas::Bare is not documented' "$scratch/log" || { cat "$scratch/log"; exit 1; }
