#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# What the impulse along the impactor's path (K.26), that of the force's size, the angle and the filtered peak of the paper's
# scene lead to as contact is made stiffer, the step shorter and the mesh finer: ensembles with and without jet. OUT.csv: means
# and standard errors; one_step: contact of that share, all at the step of sixteen times the default stiffness. OUT_fits.csv, by
# scripts/charts/impulse_limits.awk: limits, orders and chi-squared. OUT.svg: the stiffness. The finer mesh takes a quarter of the runs.
# Ensembles that are already in results/ are not run again.
# usage: scripts/impulse_limits.sh [RUNS] [OUT]      (32 runs, docs/charts/impulse_limits by default)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source-path=SCRIPTDIR source=ensemble_common.sh
source scripts/ensemble_common.sh
runs=${1:-32} out=${2:-docs/charts/impulse_limits}
build_gasjet
# [N/m3], that of share 1 on 2744 elements, for all meshes
stiffness=$(contact_stiffness passenger_pendulum)
few=$(((runs + 3) / 4))
# Contact that is as stiff as `share` times the fabric shortens the step by sqrt(1 + share).
one_step() { awk "BEGIN { printf \"--set time.safety=%.4f\", 0.8 * sqrt((1 + $1) / 17) }"; }
# varied | value | options of `gasjet ensemble` | runs if others
variations=(
  "contact|0.5|--set contact.stiffness_share=0.5" "contact|1|" "contact|2|--set contact.stiffness_share=2"
  "contact|4|--set contact.stiffness_share=4" "contact|8|--set contact.stiffness_share=8" "contact|16|--set contact.stiffness_share=16"
  "one_step|1|$(one_step 1)" "one_step|4|--set contact.stiffness_share=4 $(one_step 4)" "one_step|16|--set contact.stiffness_share=16"
  "step|0.9|--set time.safety=0.9" "step|0.8|" "step|0.6|--set time.safety=0.6"
  "mesh|2744|" "mesh|10970|--set membrane.mesh.refine=1 --set contact={stiffness=$stiffness}|$few"
)
mkdir -p "$(dirname "$out")" results/ensembles/passenger_pendulum results/ensembles/passenger_pendulum_no_jet
{
  provenance
  echo "varied,value,scene,quantity,mean,standard_error,runs"
  for variation in "${variations[@]}"; do
    IFS='|' read -r varied value options count <<<"$variation"
    for scene in passenger_pendulum_no_jet passenger_pendulum; do
      # shellcheck disable=SC2086  # options are words
      ensemble_quantities "$scene" "${count:-$runs}" $options | awk -F, -v head="$varied,$value,$([[ $scene == *no_jet ]] && echo no_jet || echo jet)" '
        /impulse|angle|cfc180/ { printf "%s,%s,%.6g,%.3g,%d\n", head, $1, $2, $3, $6 }'
    done
  done
} >"$out.csv"
awk -F, -f scripts/charts/impulse_limits.awk "$out.csv" >"${out}_fits.csv"

gnuplot -e "data=$(gnuplot_file "$out.csv"); out=$(gnuplot_file "$out.svg")" scripts/charts/impulse_limits.gp
echo "$out.svg"
