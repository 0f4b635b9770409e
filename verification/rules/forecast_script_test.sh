#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Test of docs/make/charts/forecast.sh --check and forecast.awk: each drift is named, and what is infinite is above every bound.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() {
  echo "$*"
  exit 1
}

# said EXIT PATTERN [SED]: --check of the committed rows as the expression changes them
said() {
  local output status=0
  sed -e "${3:-}" "$root/docs/charts/forecast.csv" >"$work/rows.csv"
  output=$("$root/docs/make/charts/forecast.sh" --check "$work/rows.csv" 2>&1) || status=$?
  [[ $status == "$1" ]] && grep -q -- "$2" <<<"$output" || fail "${3:-nothing}: exit $status, $1 and '$2' expected: $output"
}
said 0 'holds: [0-9]* rows'
said 1 'totals' 's/^all that agree,,,,,,,,,[0-9]*/&1/'
said 1 'totals' '/^all sizes,/d'
said 1 'is not what' '/^driver_bag,/s/,no,/,yes,/'
said 1 'in its ladder: -58.2 0.79' '/^passenger_pendulum,[^,]*,jet off,/s/,-58.2,/,-58.3,/'
said 2 'has no rows' d
said 2 'has no rows' '/^[^#]/d'

# Sizes of check's JSON beside a ladder that measures 2 %.
ladder() {
  printf '# reference: 100\n# quantity: angle\nrung,runs,change,change_se\njet off,1,2,0\n' >"$work/ladder.csv"
  printf '{\n  "forecast": [\n    {\n      "name": "jet_on_impactor_0",\n      "value": %s,\n    }\n  ]\n}\n' "$1" >"$work/check.json"
  awk -v scene=s -f "$root/docs/make/charts/forecast.awk" "$work/check.json" "$work/ladder.csv" 2>&1
}
[[ $(ladder '"infinite"') == "s,angle,jet off,jet_on_impactor,infinite,yes,2,0,yes,1" ]] || fail "infinite: $(ladder '"infinite"')"
[[ $(ladder 0.001) == "s,angle,jet off,jet_on_impactor,0.001,no,2,0,yes,0" ]] || fail "0.001: $(ladder 0.001)"
! ladder null >/dev/null || fail "takes null as a number"
echo "forecast.sh noticed each drift"
