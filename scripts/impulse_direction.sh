#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Which part of the contact impulse of the paper's scene moves with the mesh: the impulse of the force's size, and of its part
# along the impactor's path, (I omega + the moment of gravity over time) / L_i, of runs with seeds of 1e-4 m on two meshes,
# contact as stiff on both. Runs that are already in results/ are not run again. Writes OUT.csv.
# usage: scripts/impulse_direction.sh [RUNS] [OUT]      (8 runs, docs/charts/impulse_direction by default)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source-path=SCRIPTDIR source=ensemble_common.sh
source scripts/ensemble_common.sh
runs=${1:-8} out=${2:-docs/charts/impulse_direction}
build_gasjet
work=results/impulse_direction
stiffness=$(build/gasjet check cases/passenger_pendulum.toml | sed -n 's/^contact stiffness: \([^ ]*\).*/\1/p')

# run_level CASE LEVEL SEED: elements, impulse of the size, impulse along the path [N s]. Pendulum and gravity are the case's.
run_level() {
  local folder=$work/$1_$2_$3
  [[ -f $folder/summary.json ]] ||
    build/gasjet run "cases/$1.toml" --quiet --out "$folder" --set "membrane.mesh.refine=$2" --set "contact={stiffness=$stiffness}" \
      --set membrane.perturbation=1e-4 --set "membrane.perturbation_seed=$3" >/dev/null
  awk -F, -v elements="$(sed -n 's/.*"elements": \([0-9]*\).*/\1/p' "$folder/summary.json")" -v size="$(sed -n 's/.*"contact_impulse_Ns": \([^,]*\).*/\1/p' "$folder/summary.json")" '
    /^#/ { next }
    !named { for (i = 1; i <= NF; ++i) column[$i] = i; named = 1; next }
    { t = $column["time_s"]; omega = $column["pendulum_angular_velocity_rad_s"]; s = sin($column["pendulum_angle_rad"])
      moment += 10.9 * 9.80665 * 1.065 * (s + s_before) / 2 * (t - t_before); t_before = t; s_before = s }
    END { print elements "," size "," ((2.07 + 10.9 * 1.065 ^ 2) * omega + moment) / 1.31 }' "$folder/history.csv"
}

{
  provenance
  echo "case,elements,contact_impulse_Ns,standard_error_Ns,impulse_along_path_Ns,standard_error_along_path_Ns,runs"
  for case in passenger_pendulum passenger_pendulum_no_jet; do
    for level in 0 1; do
      for ((seed = 1; seed <= runs; ++seed)); do run_level "$case" "$level" "$seed"; done |
        awk -F, -v name="$case" '{ ++n; elements = $1; a += $2; aa += $2 ^ 2; b += $3; bb += $3 ^ 2 }
          function error(sum, squares) { return sqrt((squares - sum ^ 2 / n) / (n - 1) / n) }
          END { printf "%s,%d,%.6g,%.3g,%.6g,%.3g,%d\n", name, elements, a / n, error(a, aa), b / n, error(b, bb), n }'
    done
  done
} >"$out.csv"
