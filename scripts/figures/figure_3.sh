#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Fig. 3 of "Gas Jet Model for Airbag Inflators": mass flow of nitrogen at 673 K through 8.5 dm2 of hole, (G.6), and of
# porous fabric, (G.7), against the pressure difference to 101325 Pa. The paper states neither the ambient pressure nor
# the fabric's porosity there: the fabric is drawn for the porosity 0.05 of its scene, and over eta^2.
# usage: scripts/figures/figure_3.sh [GASJET]   (build/gasjet by default; writes docs/figures/figure_3.csv and .svg)
set -euo pipefail
export LC_ALL=C.UTF-8 # numbers with a decimal point, wherever the user is
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source-path=SCRIPTDIR source=../charts/provenance.sh
source scripts/charts/provenance.sh
gasjet=${1:-build/gasjet}
csv=docs/figures/figure_3.csv

# column NAME ARGUMENTS...: the second column of a closed form at 0 to 100 kPa. It rises like a root: finely spaced to 1 kPa.
column() {
  local times
  for times in 0:980:20 1000:100000:1000; do
    "$gasjet" exact "$1" --times "$times" --set temperature=673 --set ambient_pressure=101325 "${@:2}" |
      awk -F, '!/^#/ && header++ { print $2 }'
  done
}
{
  provenance
  echo "# N2 (R = 296.8 J/(kg K), gamma = 1.4), T = 673 K, A = 0.085 m2, Cd = 1, p_a = 101325 Pa (assumed)"
  echo "overpressure_Pa,hole_kg_s,fabric_over_eta2_kg_s,fabric_eta_0.05_kg_s"
  paste -d, <(seq 0 20 980 && seq 1000 1000 100000) <(column orifice_flow --set area=0.085 --set discharge_coefficient=1) \
    <(column porous_flow --set fabric_area=0.085 --set porosity=1) \
    <(column porous_flow --set fabric_area=0.085 --set porosity=0.05)
} >"$csv"
gnuplot -e "data='$csv'; out='${csv%.csv}.svg'" scripts/charts/figure_3.gp
echo "$csv ${csv%.csv}.svg"
