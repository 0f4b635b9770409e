#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs the plans of cases/studies and draws their charts. Runs that are there already are not computed again.
# Writes docs/charts/NAME.csv and NAME.svg for where_the_jet_matters and what_to_measure.
# usage: scripts/charts/studies.sh [THREADS] [OUT]      (1, docs/charts by default; GASJET names the program)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source-path=SCRIPTDIR source=gnuplot_text.sh
source scripts/charts/gnuplot_text.sh
# shellcheck source-path=SCRIPTDIR source=provenance.sh
source scripts/charts/provenance.sh
threads=${1:-1} out=${2:-docs/charts}
gasjet=${GASJET:-build/gasjet}
mkdir -p "$out"
for name in where_the_jet_matters what_to_measure; do
  "$gasjet" study run "cases/studies/$name.toml" --out "results/studies/$name" --threads "$threads" || [[ $? == 3 ]]
done

# table FILE OUT: by what and on what it was made, and how many runs there are, above its rows
table() { { provenance; grep '^# status: ' "$1"; grep -v '^#' "$1"; } >"$2"; }
table results/studies/where_the_jet_matters/means.csv "$out/where_the_jet_matters.csv"
table results/studies/what_to_measure/sobol.csv "$out/what_to_measure.csv"

for name in where_the_jet_matters what_to_measure; do
  gnuplot -e "data=$(gnuplot_file "$out/$name.csv"); out=$(gnuplot_file "$out/$name.svg")" "scripts/charts/$name.gp"
  echo "$out/$name.svg"
done
