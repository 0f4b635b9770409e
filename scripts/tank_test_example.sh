#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The worked example of the tank test: readings made up from a closed form with 1 % noise, their analysis, and the
# picture of it. Rewrites cases/tank_test_readings.csv, cases/tank_test_curves.csv and docs/figures/tank_test.svg
# usage: scripts/tank_test_example.sh [FOLDER]   writes to FOLDER/ instead; GASJET names another binary
set -euo pipefail
export LC_ALL=C.UTF-8 # numbers with a decimal point, wherever the user is
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
gasjet=${GASJET:-$root/build/gasjet}
[[ ! -d $gasjet ]] || gasjet+=/build/gasjet # a clone, as the tutorials set it
tables=${1:-$root/cases}
figures=${1:-$root/docs/figures}
noise=0.01 # of the reading

# 80 g of nitrogen in 50 ms, 800 K falling to 400 K, into 60 l of air; cp of both constant, as at 298.15 K.
exact() {
  "$gasjet" exact tank_test_pulse --times 0:0.06:1e-4 --set gas_constant=296.79670 --set heat_capacity_ratio=1.3995470 \
    --set tank_gas_constant=287.04164 --set tank_heat_capacity_ratio=1.3999531 --set outlet_area=1e-4
}

# Gaussian noise by Box and Muller's method from Park and Miller's generator: the same in every awk.
with_noise() {
  awk -F, -v noise="$noise" '
    function uniform() { seed = (16807 * seed) % 2147483647; return seed / 2147483647 }
    function normal() { return sqrt(-2 * log(uniform())) * cos(6.283185307179586 * uniform()) }
    BEGIN { seed = 20260; OFS = "," }
    /^#/ { next }
    $1 == "time_s" { print $1, $2, $3; next }
    { printf "%.4f,%.0f,%.0f\n", $1, $2 * (1 + noise * normal()), $3 * (1 + noise * normal()) }'
}

{
  echo "# synthetic: closed form tank_test_pulse (80 g of N2, 800 to 400 K, Cd A = 1e-4 m2) with 1 % noise, made by scripts/tank_test_example.sh"
  exact | with_noise
} >"$tables/tank_test_readings.csv"
(cd "$tables" && "$gasjet" identify tank_test_readings.csv --method dual --volume 0.06 --mass 0.08 --gas N2 \
  --thermodynamics constant --points 241 --out tank_test_curves.csv)
known=$(mktemp)
trap 'rm -f "$known"' EXIT
exact >"$known"
"$root/scripts/plot.sh" identify --title 'Tank test of a known pulse, readings with 1 % noise' "$figures/tank_test" \
  "$tables/tank_test_curves.csv" "$known"
rm "$figures/tank_test.png" # the pages show the other
