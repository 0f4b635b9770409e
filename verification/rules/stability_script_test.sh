#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Test of docs/make/pages/stability_atlas.sh --check: rows that say the same as the atlas pass, each drift is named.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# rows LINE...: row files with these lines, `~` standing for a tab, and what --check says of them.
rows() {
  rm -rf "$work/rows" && mkdir "$work/rows"
  printf '%s\n' "$@" | tr '~' '\t' >"$work/rows/some.tsv"
}
check() { "$root/docs/make/pages/stability_atlas.sh" --check "$work/rows" "$work/atlas.md" 2>&1; }
fail() {
  echo "$*"
  exit 1
}

vent="threshold~threshold.tiny~verification/gas/threshold_test.cpp~G.14~Euler~bisection~vent time~h |λ| = 2~1e-3~1.001e-3~s~0.99~1.01~error"
sliver="threshold~Stability.largest~verification/membrane/stability_test.cpp~M.10~needle~bisection~sliver~2/ω~2.5e-6~2.5e-6~s~0.9~1.1~exit 3"
near="near~tank.fill~verification/gas/tank_test.cpp~G.8~pressure~rounding~1~1~1"
good=("$vent" "$sliver" "$near")

rows "${good[@]}"
awk -f "$root/docs/make/pages/theory_links.awk" -f "$root/docs/make/pages/stability_atlas.awk" "$root"/docs/theory/*.md "$work/rows/some.tsv" >"$work/atlas.md"
grep -qF '| vent time: Euler | [G.14](theory/gas.md#how-fast-the-gas-relaxes) h \|λ\| = 2 | 0.001 s | 0.001001 s | 1.0010 | 0.99 to 1.01: bisection | error | [' "$work/atlas.md" ||
  fail "writes another row: $(cat "$work/atlas.md")"
check | grep -q '2 rows' || fail "refuses its own rows: $(check)"
rows "${vent/1.001e-3/1.0049e-3}" "$sliver"
check >/dev/null || fail "does not let a ratio move by less than it says"

# drifts TEXT LINE...: rows of these lines are refused, and the check says TEXT.
tried=0
drifts() {
  local said
  rows "${@:2}"
  tried=$((tried + 1))
  if said=$(check); then fail "did not notice: $1"; fi
  grep -qF "$1" <<<"$said" || fail "noticed for another reason than $1: $said"
}
drifts 'vent time: Euler: no test says this any more' "$sliver"
drifts 'vent time: RK4: not in the atlas' "${good[@]}" "${vent/Euler/RK4}"
drifts 'vent time: Euler: not in the atlas' "${vent/threshold.tiny/threshold.other}" "$sliver"
drifts 'ratio is 1.0070' "${vent/1.001e-3/1.007e-3}" "$sliver"
drifts 'ratio is 0.9950' "${vent/1.001e-3/0.995e-3}" "$sliver"
drifts 'predicted is 0.00101 s' "${vent/1e-3~1.001e-3/1.01e-3~1.01101e-3}" "$sliver"
drifts 'reads otherwise' "${vent/h |λ| = 2/h |λ| = 3}" "$sliver"
drifts 'reads otherwise' "${vent/0.99~1.01/0.99~1.02}" "$sliver"
drifts 'reads otherwise' "$vent" "${sliver/exit 3/goes on}"
drifts 'no equation (G.99)' "${vent/G.14/G.99}" "$sliver"
rm "$work/rows/some.tsv"
if check >/dev/null; then fail "passes without any row"; fi
echo "the atlas's check noticed each of $tried drifts"
