#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Test of docs/make/pages/verification_report.sh --check: rows that say the same as the report pass, each drift is named.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# rows LINE...: row files with these lines, `|` standing for a tab, and what --check says of them.
rows() {
  rm -rf "$work/rows" && mkdir "$work/rows"
  printf '%s\n' "$@" | tr '|' '\t' >"$work/rows/some.tsv"
}
check() { "$root/docs/make/pages/verification_report.sh" --check "$work/rows" "$work/report.md" 2>&1; }
fail() {
  echo "$*"
  exit 1
}

file=verification/gas/tank_test.cpp
pressure="near|tank.fill|$file|G.8|pressure [Pa]|rounding|100.0000000001|100|1e-8"
order="order|tank.pulse|$file|G.10|pulse|order two|16 4 1|2 2|1.9|2.1"
steps=("near|tank.steps|$file|G.9|mass [kg]|steps|1.01|1|0.1" "near|tank.steps|$file|G.9|mass [kg]|steps|2.08|2|0.1")
long="near|Bag.shape/3|verification/membrane/bag_long_test.cpp|M.5|height [m]|published|0.216|0.217|0.002"
good=("$pressure" "$order" "${steps[@]}" "$long")

rows "${good[@]}"
awk -f "$root/docs/make/pages/theory_links.awk" -f "$root/docs/make/pages/verification_report.awk" "$root"/docs/theory/*.md "$work/rows/some.tsv" >"$work/report.md"
grep -qF '| [G.9](theory/gas.md#balances) | mass [kg] | 2.08 | 2 | 4.0e-02 | 5.0e-02 | steps | 2 | [tank.steps](' "$work/report.md" ||
  fail "the worst row of a sweep is not shown: $(cat "$work/report.md")"
check | grep -q '4 rows' || fail "refuses its own rows: $(check)"
rows "$pressure" "$order" "${steps[@]}"
check >/dev/null || fail "wants the row of a long test that did not run"

# drifts TEXT LINE...: rows of these lines are refused, and the report says TEXT.
tried=0
drifts() {
  local said
  rows "${@:2}"
  tried=$((tried + 1))
  if said=$(check); then fail "did not notice: $1"; fi
  grep -qF "$1" <<<"$said" || fail "noticed for another reason than $1: $said"
}
drifts 'pressure [Pa]: no test says this any more' "$order" "${steps[@]}"
drifts 'volume [m3]: not in the report' "${good[@]}" "${pressure/pressure \[Pa\]/volume [m3]}"
drifts 'pressure [Pa]: not in the report' "${pressure/rounding/another reason}" "$order" "${steps[@]}"
drifts 'mass [kg]: not in the report' "$pressure" "$order" "${steps[0]}"
drifts 'exact is 100.01' "${pressure//100/100.01}" "$order" "${steps[@]}"
drifts 'allowed is 1.2e-10' "${pressure/1e-8/1.2e-8}" "$order" "${steps[@]}"
drifts 'is more than allowed' "${pressure/100.0000000001/100.01}" "$order" "${steps[@]}"
drifts 'error is 0.046' "$pressure" "$order" "${steps[@]/2.08/2.092}"
drifts 'orders are 2.07 1.93' "$pressure" "${order/|2 2|/|2.07 1.93|}" "${steps[@]}"
drifts 'errors are 1.80e+01' "$pressure" "${order/16 4 1/18 4 1}" "${steps[@]}"
drifts 'no equation (G.99)' "$pressure" "${order/G.10/G.99}" "${steps[@]}"
rows "${pressure/100.0000000001/100.0000000090}" "$order" "${steps[@]}"
check >/dev/null || fail "does not let an error of rounding's size move inside its allowance"
rm "$work/rows/some.tsv"
if check >/dev/null; then fail "passes without any row"; fi
echo "the report's check noticed each of $tried drifts"
