#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Writes the reference of the public headers as HTML; fails where a member is undocumented. Installs doxygen if it is missing.
# usage: docs/make/site/api_docs.sh OUTPUT_FOLDER
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)
out=${1:?usage: api_docs.sh OUTPUT_FOLDER}
mkdir -p "$out"
out=$(cd "$out" && pwd)
command -v doxygen >/dev/null || "$root/scripts/setup_debian12.sh" doxygen
cd "$root"
{ cat docs/Doxyfile; echo "OUTPUT_DIRECTORY = \"$out\""; } | doxygen -
echo "$out/html/index.html"
