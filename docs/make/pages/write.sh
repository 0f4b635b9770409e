#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Writes what pages say from tables. Run it when a CSV was made anew, then read what `git diff` shows: a sentence may no longer hold
# with its new numbers.
#   tables   each between its marks <!-- table NAME --> and <!-- end of table NAME -->, from the CSV files that docs/tables.tsv names
#   numbers  each that docs/numbers.tsv lists, from the table that it comes from
# usage: docs/make/pages/write.sh [--check [TREE]]
#   --check  change nothing: exit code 1 if a table of a page, of this tree or of TREE, is not what it would write
set -euo pipefail
scripts=$(cd "${BASH_SOURCE[0]%/*}" && pwd)
if (($# > 2)) || [[ ${1:---check} != --check ]]; then
  echo "write.sh: cannot take '$*'; allowed: nothing, --check [TREE]" >&2
  exit 2
fi
cd "${2:-$scripts/../../..}"
new=$(mktemp)
trap 'rm -f "$new"' EXIT
broken=0

mapfile -t pages < <(grep -rlE --include='*.md' --exclude-dir={.git,results,'build*'} '^<!-- table [a-z0-9_]+ -->$' . | sed 's|^\./||' | LC_ALL=C sort)
for page in "${pages[@]}"; do
  awk -f "$scripts/csv_number.awk" -f "$scripts/write_tables.awk" -v page="$page" "$page" >"$new" || { broken=1; continue; }
  ! cmp -s "$new" "$page" || continue
  if (($#)); then
    echo "$page: not what docs/make/pages/write.sh writes:"
    diff "$page" "$new" || broken=1
  else
    cp "$new" "$page"
    echo "$page: written"
  fi
done
missing=$({ grep -hE '^<!-- table [a-z0-9_]+ -->$' "${pages[@]}" /dev/null || true; } |
  awk 'NR == FNR { has[$3]; next } $1 == "table" && !($2 in has) { print "docs/tables.tsv: no page has the table " $2 }' - FS='\t' docs/tables.tsv)
[[ -z $missing ]] || { echo "$missing"; broken=1; }
if (($# || broken)); then exit $broken; fi

# number_of FILE ROW COLUMN FACTOR FORMAT: that number, formatted (csv_number.awk says how rows and columns are named).
number_of() {
  awk -f "$scripts/csv_number.awk" -f <(echo 'BEGIN { print formatted(ARGV[1], ARGV[2], ARGV[3], ARGV[4], ARGV[5]) }') "$@"
}

changed=0
while IFS=$'\t' read -r page pattern source row column scale format; do
  [[ -n $page && $page != \#* ]] || continue
  number=$(number_of "$source" "$row" "$column" "$scale" "$format")
  [[ $number =~ ^[-+]?[0-9.]+(e[-+]?[0-9]+)?$ ]] || { echo "$page: '$pattern': $source says '$number'" >&2; continue; }
  before=$(sed -nE "s@.*$pattern.*@\\1@p" "$page")
  [[ $before != "$number" ]] || continue
  PATTERN=$pattern NUMBER=$number perl -i -pe \
    'substr($_, $-[1], $+[1] - $-[1]) = $ENV{NUMBER} if /$ENV{PATTERN}/' "$page"
  changed=$((changed + 1))
  echo "$page: $before -> $number ($source, $row, $column)"
done <docs/numbers.tsv
echo "$changed numbers changed"
