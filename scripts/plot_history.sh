#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Plots history.csv of one result folder of `gasjet run`, or of two against each other (with and without jet).
# usage: scripts/plot_history.sh [--title TEXT] [--name TEXT]... OUT FOLDER [FOLDER]; writes OUT.svg and OUT.png
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=charts/plot_common.sh
source "$(dirname "${BASH_SOURCE[0]}")/charts/plot_common.sh"

curve() {
  echo "$1 using (1e3*column('time_s')):($3*column('$2')) with lines linestyle $4 title $(gnuplot_text "$5")"
}

options "$@"
((${#arguments[@]} == 2 || ${#arguments[@]} == 3)) || fail "usage: plot_history.sh [--title TEXT] [--name TEXT]... OUT FOLDER [FOLDER]"
plot_folders history.csv '' "${arguments[@]}"
