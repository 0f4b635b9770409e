#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Centreline decay, spreading and entrainment of the jet model over its coefficient a, against bands of measured jets
# (their sources: docs/theory/jet.md).
# usage: scripts/charts/jet_decay.sh [OUT]      (docs/charts/jet_decay by default: OUT.svg)
set -euo pipefail
export LC_ALL=C.UTF-8 # numbers with a decimal point, wherever the user is
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
# shellcheck source-path=SCRIPTDIR source=gnuplot_text.sh
source scripts/charts/gnuplot_text.sh
out=${1:-docs/charts/jet_decay}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

scripts/setup_debian12.sh
cmake --preset release >/dev/null
cmake --build --preset release --target gasjet -j "$(nproc)" >/dev/null
for a in 0.066 0.08; do # R0 = 1/2: distances are in diameters
  build/gasjet exact round_jet --set radius=0.5 --set spread=$a --set outlet_velocity=1 --times 0:40:0.5 >"$work/round_$a.csv"
done
build/gasjet exact jet_far_field --times 0.06:0.125:0.001 >"$work/constants.csv"
mkdir -p "$(dirname "$out")"
gnuplot -e "data=$(gnuplot_file "$work"); out=$(gnuplot_file "$out.svg")" scripts/charts/jet_decay.gp
echo "$out.svg"
