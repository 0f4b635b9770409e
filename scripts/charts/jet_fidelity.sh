#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Error of the jet force against cost for each rung of the hidden-element test, on the paper's scene: CSV with machine,
# compiler, flags and commit, and a chart.
# usage: scripts/charts/jet_fidelity.sh [OUT]      (docs/charts/jet_fidelity by default: OUT.csv and OUT.svg)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source-path=SCRIPTDIR source=provenance.sh
source scripts/charts/provenance.sh
# shellcheck source-path=SCRIPTDIR source=gnuplot_text.sh
source scripts/charts/gnuplot_text.sh
out=${1:-docs/charts/jet_fidelity}

scripts/setup_debian12.sh
cmake --preset release >/dev/null
cmake --build --preset release --target jet_fidelity -j "$(nproc)" >/dev/null
mkdir -p "$(dirname "$out")"
{
  machine "one thread used"
  build/benchmarks/jet_fidelity
} >"$out.csv.new"
mv "$out.csv.new" "$out.csv"
cat "$out.csv"
gnuplot -e "data=$(gnuplot_file "$out.csv"); out=$(gnuplot_file "$out.svg")" scripts/charts/jet_fidelity.gp
