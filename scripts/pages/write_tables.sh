#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Writes the tables of the pages, each between its marks <!-- table NAME --> and <!-- end of table NAME -->, from the CSV files that
# docs/tables.tsv names. Run it when a CSV was made anew, and then scripts/pages/write_numbers.sh.
# usage: scripts/pages/write_tables.sh [--check [TREE]]
#   --check  change nothing: exit code 1 if a page, of this tree or of TREE, is not what it would write
set -euo pipefail
scripts=$(cd "${BASH_SOURCE[0]%/*}" && pwd)
if (($# > 2)) || [[ ${1:---check} != --check ]]; then
  echo "write_tables.sh: cannot take '$*'; allowed: nothing, --check [TREE]" >&2
  exit 2
fi
cd "${2:-$scripts/../..}"
new=$(mktemp)
trap 'rm -f "$new"' EXIT
broken=0

mapfile -t pages < <(grep -rlE --include='*.md' --exclude-dir={.git,results,'build*'} '^<!-- table [a-z0-9_]+ -->$' . | sed 's|^\./||' | LC_ALL=C sort)
for page in "${pages[@]}"; do
  awk -f "$scripts/csv_number.awk" -f "$scripts/write_tables.awk" -v page="$page" "$page" >"$new" || { broken=1; continue; }
  ! cmp -s "$new" "$page" || continue
  if (($#)); then
    echo "$page: not what scripts/pages/write_tables.sh writes:"
    diff "$page" "$new" || broken=1
  else
    cp "$new" "$page"
    echo "$page: written"
  fi
done
missing=$({ grep -hE '^<!-- table [a-z0-9_]+ -->$' "${pages[@]}" /dev/null || true; } |
  awk 'NR == FNR { has[$3]; next } $1 == "table" && !($2 in has) { print "docs/tables.tsv: no page has the table " $2 }' - FS='\t' docs/tables.tsv)
[[ -z $missing ]] || { echo "$missing"; broken=1; }
exit $broken
