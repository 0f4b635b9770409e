#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Writes docs/verification.md from the rows that the tests write.
# usage: scripts/verification_report.sh [ROWS]                      rows already in that folder; else the tests run
#        scripts/verification_report.sh --check [ROWS [REPORT]]     compares docs/verification.md (or REPORT) with the
#                                                                   rows of ROWS (build/claims); exit code 1 if they differ
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
report=docs/verification.md

# tables ROWS: every row of that folder, by family; row files in a fixed order.
tables() {
  local files
  mapfile -t files < <(find "$1" -name '*.tsv' | LC_ALL=C sort)
  ((${#files[@]})) || { echo "verification_report.sh: no rows in $1; run the tests first (ctest --preset fast)" >&2; return 1; }
  awk -f scripts/theory_links.awk -f scripts/verification_report.awk docs/theory/*.md "${files[@]}"
}

if [[ ${1:-} == --check ]]; then
  report=${3:-$report}
  tables "${2:-build/claims}" >"$work/new"
  LC_ALL=C awk -f scripts/verification_drift.awk "$report" "$work/new" | sort -u >"$work/drift"
  if [[ -s $work/drift ]]; then
    cat "$work/drift"
    echo "$report is not what the tests say: scripts/verification_report.sh writes it anew"
    exit 1
  fi
  echo "$report holds: $(grep -c '^| \[' "$work/new") rows"
  exit
elif [[ ${1:-} == -* ]]; then
  echo "verification_report.sh: unknown argument '$1'; allowed: [ROWS], --check [ROWS [REPORT]]" >&2
  exit 2
fi

(($#)) || scripts/claim_rows.sh "$work/rows"
tables "${1:-$work/rows}" >"$work/new"
{
  cat <<'HEAD'
# Verification report

Written by `scripts/verification_report.sh` from the tests' own assertions: each row is a check that the test named last
makes, with the numbers that it saw. A row of several `checks` (a sweep over parameters, times or elements) shows the one
that used most of what is allowed. Error and allowance are shares of the exact value; `abs.` marks those in the quantity's
own unit, where that value is zero or smaller than the allowance. Errors of an order are those of successive levels, each
twice as fine as the one before unless the row says otherwise, and the orders lie inside the band on both sides. The links
lead to the section of the theory that defines the equation, and to the test. Closed forms are those of
[`verification/closed_form`](../verification/closed_form/README.md), which sees none of the libraries.

CI compares this page with what its own tests wrote (`scripts/verification_report.sh --check`): a row that appeared or
vanished, another exact value (more than 1e-6 of it), allowance (2 %) or number of checks, an error that moved by more than
a tenth of its allowance, or an order by more than 0.05, is a failure. Errors of the size of rounding (an allowance below
1e-9) may differ between machines: they only have to stay inside it.

HEAD
  cat "$work/new"
} >"$report"
echo "$report: $(grep -c '^| \[' "$report") rows"
