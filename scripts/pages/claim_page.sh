# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Sourced by stability_atlas.sh and verification_report.sh: a page of docs, written from the rows that tests
# write, or compared with them. The caller defines page_head, which prints what stands above the tables.

# claim_tables TABLES ROWS: what scripts/pages/TABLES.awk makes of that folder; row files in a fixed order.
claim_tables() {
  local files
  mapfile -t files < <(find "$2" -name '*.tsv' | LC_ALL=C sort)
  ((${#files[@]})) || {
    echo "$1.sh: no rows in $2; run the tests first (ctest --preset fast)" >&2
    return 1
  }
  awk -f scripts/pages/theory_links.awk -f "scripts/pages/$1.awk" docs/theory/*.md "${files[@]}"
}

count_rows() { grep -c '](../verification/' "$1"; }

# claim_page NAME DRIFT PAGE [--from ROWS | --check [ROWS [OTHER_PAGE]]]: of scripts/pages/NAME.sh, whose tables are
# by NAME.awk and compared by DRIFT.awk.
claim_page() {
  local name=$1 drift=$2 page=$3 rows work
  shift 3
  work=$(mktemp -d)
  # shellcheck disable=SC2064  # this folder
  trap "rm -rf '$work'" EXIT
  if [[ ${1:-} == --check && $# -le 3 ]]; then
    page=${3:-$page}
    claim_tables "$name" "${2:-build/claims}" >"$work/new"
    LC_ALL=C awk -f "scripts/pages/$drift.awk" "$page" "$work/new" | sort -u >"$work/drift"
    [[ -s $work/drift ]] || { echo "$page holds: $(count_rows "$work/new") rows"; return; }
    cat "$work/drift"
    echo "$page is not what the tests say: scripts/pages/$name.sh writes it anew"
    return 1
  elif [[ ${1:-} == --from && $# == 2 ]]; then
    rows=$2
  elif (($#)); then
    echo "$name.sh: cannot take '$*'; allowed: nothing, --from ROWS, --check [ROWS [PAGE]]" >&2
    return 2
  else
    rows=$work/rows
    scripts/pages/claim_rows.sh "$rows"
  fi
  claim_tables "$name" "$rows" >"$work/new"
  { page_head && cat "$work/new"; } >"$page"
  echo "$page: $(count_rows "$work/new") rows"
}
