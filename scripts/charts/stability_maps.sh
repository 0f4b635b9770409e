#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Maps of the stability atlas: stable or not over two parameters, each point a run, beside the formula. Writes
# OUT_sliver, OUT_gas and OUT_lagged, .csv with machine, compiler, flags and commit, and .svg.
# usage: scripts/charts/stability_maps.sh [OUT]      (docs/charts/stability by default)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source-path=SCRIPTDIR source=provenance.sh
source scripts/charts/provenance.sh
# shellcheck source-path=SCRIPTDIR source=gnuplot_text.sh
source scripts/charts/gnuplot_text.sh
out=${1:-docs/charts/stability}

cmake --preset release >/dev/null
cmake --build --preset release --target stability_maps gasjet -j "$(nproc)" >/dev/null
mkdir -p "$(dirname "$out")"

# map NAME X_LABEL FORMULA TITLE
map() {
  {
    provenance
    echo "# points: $1, stable over time (1) or grown 1e5-fold from a disturbance of 1e-10 (0); formula: $3"
    build/benchmarks/stability_maps "$1"
  } >"$out"_"$1.csv"
  gnuplot -e "data=$(gnuplot_file "${out}_$1.csv"); out=$(gnuplot_file "${out}_$1.svg"); label='$2'; formula='$3'; heading='$4'" scripts/charts/stability_maps.gp
}
map sliver 'Shortest side over what it was' 'bound of the step (M.12)' 'A sliver in the mesh shortens the stable step'
map gas 'Volume over that of the sphere' 'bound of the step (M.12)' 'A small volume of gas shortens the stable step'
map lagged 'Time simulated [s]' 'growth 1e5-fold by (M.20)' 'A pressure that lags grows slowly at any step'
