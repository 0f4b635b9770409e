#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Plots ensemble.csv of one result folder of `gasjet ensemble`, or of two against each other (with and without
# jet): means, each in a band of two standard errors either side.
# usage: scripts/plot_ensemble.sh [--title TEXT] [--name TEXT]... OUT FOLDER [FOLDER]; writes OUT.svg and OUT.png
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=charts/plot_common.sh
source "$(dirname "${BASH_SOURCE[0]}")/charts/plot_common.sh"
band=2 # [standard errors]
fills=(blue_band vermilion_band)

curve() {
  local time="1e3*column('time_s')" mean="column('$2_mean')" error="$band*column('$2_standard_error')"
  echo "$1 using ($time):($3*($mean-$error)):($3*($mean+$error)) with filledcurves" \
    "fillcolor rgb ${fills[$4 - 1]} notitle," \
    "$1 using ($time):($3*$mean) with lines linestyle $4 title $(gnuplot_text "$5, mean ± $band s.e.")"
}

options "$@"
((${#arguments[@]} == 2 || ${#arguments[@]} == 3)) || fail "usage: plot_ensemble.sh [--title TEXT] [--name TEXT]... OUT FOLDER [FOLDER]"
plot_folders ensemble.csv _mean "${arguments[@]}"
