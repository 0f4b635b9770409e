#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Means of the paper's scene, with and without jet, against seed, step, contact stiffness, mesh and friction: ensembles,
# one row a quantity and value. Writes OUT.csv and OUT.svg. Ensembles that are already in results/ are not run
# again: delete the folder to start anew. The finest mesh takes a quarter of the runs.
# usage: scripts/ensemble_convergence.sh [RUNS] [OUT]      (32 runs, docs/charts/ensemble_convergence by default)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source-path=SCRIPTDIR source=ensemble_common.sh
source scripts/ensemble_common.sh
runs=${1:-32} out=${2:-docs/charts/ensemble_convergence}
build_gasjet
# [N/m3], that of share 1 on 2744 elements, for all meshes
stiffness=$(contact_stiffness passenger_pendulum)
few=$(((runs + 3) / 4))
# refined LEVEL SHARE: the mesh refined so often, contact SHARE times as stiff as the default is on 2744 elements.
refined() {
  echo "--set membrane.mesh.refine=$1 --set contact={stiffness=$(awk "BEGIN { print $2 * $stiffness }")}"
}
# varied | value | options of `gasjet ensemble` | runs if fewer; the base case has seed 1e-4 m, safety 0.8, stiffness share 1
variations=(
  "seed|1e-12|--amplitude 1e-12" "seed|1e-9|--amplitude 1e-9" "seed|1e-7|--amplitude 1e-7"
  "seed|1e-5|--amplitude 1e-5" "seed|1e-4|"
  "step|0.9|--set time.safety=0.9" "step|0.8|" "step|0.6|--set time.safety=0.6"
  "contact|0.5|--set contact.stiffness_share=0.5" "contact|1|" "contact|4|--set contact.stiffness_share=4"
  "contact_10970|0.5|$(refined 1 0.5)|$few" "contact_10970|1|$(refined 1 1)|$few" "contact_10970|4|$(refined 1 4)|$few"
  "mesh|2744|" "mesh|10970|$(refined 1 1)" "mesh|43862|$(refined 2 1)|$few"
  "friction|0|" "friction|0.3|--set contact.friction=0.3"
)

mkdir -p "$(dirname "$out")"
{
  provenance
  echo "varied,value,quantity,mean_jet,standard_error_jet,mean_no_jet,standard_error_no_jet,runs,difference,standard_errors,decided"
  for variation in "${variations[@]}"; do
    IFS='|' read -r varied value options fewer <<<"$variation"
    # shellcheck disable=SC2086  # options are words
    effects "${fewer:-$runs}" $options | sed "s/^/$varied,$value,/"
  done
} >"$out.csv"

[[ $out != docs/charts/ensemble_convergence ]] || scripts/mesh_limits.sh

gnuplot -e "data=$(gnuplot_file "$out.csv"); out=$(gnuplot_file "$out.svg")" scripts/charts/ensemble_convergence.gp
echo "$out.svg"
