#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Proves that docs/make/site/api_docs.sh fails where a public member is undocumented, in any folder of public headers, and names
# it. usage: api_docs_can_fail.sh
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$root"
cp --parents -r docs/Doxyfile docs/make/site/api_docs.sh lib*/include verification/closed_form/include "$scratch"
folders=(lib*/include/*/ verification/closed_form/include/*/)
for folder in "${folders[@]}"; do
  name=Bare_$(basename "$folder")
  printf '%s\n' '// the first line names the file' 'namespace bare {' "struct $name { double bare; };" '}' >"$scratch/$folder/bare.hpp"
done
if "$scratch/docs/make/site/api_docs.sh" "$scratch/out" >"$scratch/log" 2>&1; then
  echo "api_docs.sh lets an undocumented member pass"
  exit 1
fi
for folder in "${folders[@]}"; do
  grep -q "Member bare .* of struct bare::Bare_$(basename "$folder") is not documented" "$scratch/log" || { echo "$folder is not read"; cat "$scratch/log"; exit 1; }
done
