#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Test of docs/make/pages/stale.sh: in a small repository it names what is older than its code, and nothing else.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
cd "$tree"
fail() {
  echo "$*"
  exit 1
}

commit() { git add -A && git -c user.name=test -c user.email=test@example.org commit -q -m "$1" && git rev-parse --short=12 HEAD; }
put() { mkdir -p "$(dirname "$1")" && printf '%s\n' "${@:2}" >"$1"; }
csv() { put docs/charts/force.csv "# gasjet 0.1.0 ($1, GNU 12, Release -O3)" 'x' "$2"; }

# says EXIT PATTERN...: stale.sh has this exit code, and says no more than these lines and its last.
says() {
  local output status=0 pattern
  output=$("$root/docs/make/pages/stale.sh" "$tree" 2>&1) || status=$?
  [[ $status == "$1" && $(wc -l <<<"$output") == "$#" ]] || fail "exit $1 and $# lines expected, seen $status: $output"
  for pattern in "${@:2}"; do grep -qE "$pattern" <<<"$output" || fail "'$pattern' expected: $output"; done
}

git init -q .
put libjet/jet.cpp 'one' && put libgas/gas.cpp 'one' && put libjet/README.md 'one' && put scripts/force.sh 'one'
put docs/tables.tsv $'table\tforces\tdocs/charts/force.csv'
put docs/provenance.tsv '# comment' $'@jet\t-\tlibjet' $'docs/charts/force.csv\tscripts/force.sh\t@jet' \
  $'docs/charts/force.svg\tscripts/force.sh\tdocs/charts/force.csv' $'docs/charts/frames.jpg\tscripts/force.sh\tlibgas'
first=$(commit 'Code')
csv "$first" 1 && put docs/charts/force.svg '<svg/>' && put docs/charts/frames.jpg 'JFIF'
commit 'Results' >/dev/null
says 0

put libjet/README.md 'two' && commit 'Words' >/dev/null
says 0
put libjet/jet.cpp 'two' && second=$(commit 'Another jet')
says 1 "^docs/charts/force.csv \(tables forces\): changes since: 1, the last: [0-9a-f]+ Another jet$"
csv "$second" 1 && commit 'The same rows' >/dev/null
says 0
csv "$second" 2 && commit 'Other rows' >/dev/null
says 1 '^docs/charts/force.svg: .* docs/charts/force.csv has other rows'
put docs/charts/force.svg '<svg></svg>' && commit 'Drawn anew' >/dev/null
says 0
put libgas/gas.cpp 'three' && commit 'Another gas' >/dev/null
says 1 '^docs/charts/frames.jpg: .* Another gas$'
put docs/charts/frames.jpg 'JFIF 2' && put scripts/force.sh 'two' && commit 'Another script' >/dev/null
says 1 '^docs/charts/force.csv .* Another script$'
csv 0123456789ab 2 && commit 'Nobody knows that commit' >/dev/null
says 1 '^docs/charts/force.csv .* 0123456789ab is not in this clone$'
echo "stale.sh named each"
