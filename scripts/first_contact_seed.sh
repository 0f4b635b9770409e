#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# First contact of the paper's scene without jet on three meshes, with a seed in proportion to the
# elements: ensembles up to 15.5 ms, contact as stiff on each. Writes OUT.csv.
# usage: scripts/first_contact_seed.sh [RUNS] [OUT]      (8 runs, docs/charts/first_contact_seed by default)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source-path=SCRIPTDIR source=ensemble_common.sh
source scripts/ensemble_common.sh
runs=${1:-8} out=${2:-docs/charts/first_contact_seed}
build_gasjet
name=passenger_pendulum_no_jet
stiffness=$(contact_stiffness "$name")
mkdir -p "results/ensembles/$name"
{
  provenance
  echo "elements,seed_m,first_contact_s,standard_error_s,runs"
  for level_seed in 0,1e-4 1,5e-5 2,2.5e-5; do
    level=${level_seed%,*} seed=${level_seed#*,}
    elements=$(build/gasjet check "cases/$name.toml" --set "membrane.mesh.refine=$level" | sed -n 's/.*[^0-9]\([0-9]*\) elements.*/\1/p' | head -1)
    ensemble_quantities "$name" "$runs" --amplitude "$seed" --set "membrane.mesh.refine=$level" \
      --set "contact={stiffness=$stiffness}" --set scene.end_time=0.0155 |
      awk -F, -v elements="$elements" -v seed="$seed" '$1 == "first_contact_s" {
        printf "%d,%s,%.6g,%.3g,%d\n", elements, seed, $2, $3, $6 }'
  done
} >"$out.csv"
[[ $out != docs/charts/first_contact_seed ]] || scripts/mesh_limits.sh
