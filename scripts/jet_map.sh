#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Where the jet matters: the paper's scene with each invented input at the ends of a plausible range, with and without jet.
# Writes OUT.csv and OUT.svg: the jet's effect on angle, impulse along the path and peak acceleration. Ensembles that are already
# in results/ are not run again.
# usage: scripts/jet_map.sh [RUNS] [OUT]      (32 runs, docs/charts/jet_map by default)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source-path=SCRIPTDIR source=ensemble_common.sh
source scripts/ensemble_common.sh
runs=${1:-32} out=${2:-docs/charts/jet_map}

# flow TIME PEAK: a triangle that reaches PEAK [kg/s] at 12 ms and ends at TIME [s].
flow() { echo "inflator.0.mass_flow={time=[0.0,0.012,$1],value=[0.0,$2,0.0]}"; }

# sides LONG SHORT: the outlet's, in the shipped proportion but for 0.005 and 0.0116 m2
sides() { echo "inflator.0.jet.long_side=$1;inflator.0.jet.short_side=$2"; }

matched="inflator.0.jet.outlet=pressure_matched;inflator.0.jet.temperature=stagnation"

# input | value | settings of both cases, by ; | settings of the jet alone, by ;
inputs=(
  "as shipped|-||"
  "gas [kg]|0.08|$(flow 0.08 2.0)|" "gas [kg]|0.24|$(flow 0.08 6.0)|"
  "pulse [ms]|40|$(flow 0.04 8.0)|" "pulse [ms]|120|$(flow 0.12 2.6667)|"
  "centre to plate [m]|0.25|pendulum.pivot=[0.25,0.0,1.31]|" "centre to plate [m]|0.5|pendulum.pivot=[0.5,0.0,1.31]|"
  "vent [m²]|0.0005|vent.0.area=0.0005|" "vent [m²]|0.006|vent.0.area=0.006|"
  "porosity|0|fabric.porosity=0.0|" "porosity|0.08|fabric.porosity=0.08|"
  "outlet [m²]|0.0018||$(sides 0.05657 0.03182)" "outlet [m²]|0.005||$(sides 0.10 0.05)" "outlet [m²]|0.0116||$(sides 0.145 0.08)"
  "outlet law|matched||$matched"
  "matched [m²]|0.0018||$(sides 0.05657 0.03182);$matched" "matched [m²]|0.005||$(sides 0.10 0.05);$matched"
  "matched [m²]|0.0116||$(sides 0.145 0.08);$matched"
  "406 K is|stagnation||inflator.0.jet.temperature=stagnation"
  "decay|0.09||inflator.0.jet.decay_coefficient=0.09" "decay|0.12||inflator.0.jet.decay_coefficient=0.12"
)

# settings LIST: --set options of a list separated by semicolons, one word a line.
settings() { tr ';' '\n' <<<"$1" | sed '/^$/d; s/^/--set\n/'; }

build_gasjet
mkdir -p "$(dirname "$out")" results/ensembles/passenger_pendulum results/ensembles/passenger_pendulum_no_jet
{
  provenance
  echo "input,value,quantity,mean_jet,standard_error_jet,mean_no_jet,standard_error_no_jet,runs,difference,standard_errors,decided"
  for input in "${inputs[@]}"; do
    IFS='|' read -r name value both jet <<<"$input"
    mapfile -t shared < <(settings "$both")
    mapfile -t own < <(settings "$both;$jet")
    with=$(ensemble_quantities passenger_pendulum "$runs" "${own[@]}")
    without=$(ensemble_quantities passenger_pendulum_no_jet "$runs" "${shared[@]}")
    compare <(echo "$with") <(echo "$without") | sed "s/^/$name,$value,/"
  done
} >"$out.csv"

gnuplot -e "data=$(gnuplot_file "$out.csv"); out=$(gnuplot_file "$out.svg")" scripts/charts/jet_map.gp
echo "$out.svg"
