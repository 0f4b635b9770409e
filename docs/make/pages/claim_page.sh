# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Sourced by stability_atlas.sh and verification_report.sh: a page of docs, written from the rows that tests
# write, or compared with them. The caller defines page_head, which prints what stands above the tables.

# claim_tables TABLES ROWS: what docs/make/pages/TABLES.awk makes of that folder; row files in a fixed order.
claim_tables() {
  local files
  mapfile -t files < <(find "$2" -name '*.tsv' | LC_ALL=C sort)
  ((${#files[@]})) || {
    echo "$1.sh: no rows in $2; run the tests first (ctest --preset fast)" >&2
    return 1
  }
  awk -f docs/make/pages/theory_links.awk -f "docs/make/pages/$1.awk" docs/theory/*.md "${files[@]}"
}

count_rows() { grep -c '](../verification/' "$1"; }

# claim_rows FOLDER: builds and runs, into an empty folder, every test that writes rows of docs/verification.md or docs/stability.md
# (verification/support/claim.hpp), long ones too. CI writes the same rows to build/claims while it tests.
claim_rows() {
  local folder suites
  folder=$(realpath -m "$1")
  mkdir -p "$folder"
  rm -f "$folder"/*.tsv
  cmake --preset release >"$folder/log"
  cmake --build --preset release -j "$(nproc)" >>"$folder/log"
  suites=$(grep -rlE --include='*_test.cpp' 'claim::expect_' verification |
    xargs sed -nE 's/^TEST(_F|_P)?\(([A-Za-z0-9_]+), .*/\2/p' | sort -u | paste -sd '|')
  GASJET_CLAIMS=$folder ctest --test-dir build -R "(^|/)($suites)\." --no-tests=error -j "$(nproc)" </dev/null >>"$folder/log" ||
    { grep -E 'Failed|\*\*\*' "$folder/log" >&2; echo "a claim does not hold; see $folder/log" >&2; return 1; }
}

# claim_page NAME PAGE [--from ROWS | --check [ROWS [OTHER_PAGE]]]: of docs/make/pages/NAME.sh, whose tables are
# by NAME.awk.
claim_page() {
  local name=$1 page=$2 rows work
  shift 2
  work=$(mktemp -d)
  # shellcheck disable=SC2064  # this folder
  trap "rm -rf '$work'" EXIT
  if [[ ${1:-} == --check && $# -le 3 ]]; then
    page=${3:-$page}
    claim_tables "$name" "${2:-build/claims}" >"$work/new"
    LC_ALL=C awk -f docs/make/pages/claim_drift.awk "$page" "$work/new" | sort -u >"$work/drift"
    [[ -s $work/drift ]] || { echo "$page holds: $(count_rows "$work/new") rows"; return; }
    cat "$work/drift"
    echo "$page is not what the tests say: docs/make/pages/$name.sh writes it anew"
    return 1
  elif [[ ${1:-} == --from && $# == 2 ]]; then
    rows=$2
  elif (($#)); then
    echo "$name.sh: cannot take '$*'; allowed: nothing, --from ROWS, --check [ROWS [PAGE]]" >&2
    return 2
  else
    rows=$work/rows
    claim_rows "$rows"
  fi
  claim_tables "$name" "$rows" >"$work/new"
  { page_head && cat "$work/new"; } >"$page"
  echo "$page: $(count_rows "$work/new") rows"
}
