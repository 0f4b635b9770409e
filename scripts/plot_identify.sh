#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Plots the curves of `gasjet identify` with their 95 % bands where they are claimed: mass flow and temperature against
# time; what is masked is dotted, triangles mark where a band goes on above the panel.
# usage: scripts/plot_identify.sh [--title TEXT] OUT CURVES.csv [TRUE.csv]; TRUE.csv has the curves that are known, columns as
# `gasjet exact tank_test_pulse` writes them; writes OUT.svg and OUT.png
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=charts/plot_common.sh
source "$(dirname "${BASH_SOURCE[0]}")/charts/plot_common.sh"

# largest COLUMN: its largest value where nothing is masked.
largest() {
  awk -F, -v name="$1" '/^#/ { next }
    !value { for (i = 1; i <= NF; i++) { if ($i == name) value = i; if ($i == "masked") masked = i }; next }
    !$masked && $value > most { most = $value }
    END { print most + 0 }' "$table"
}

# panel QUANTITY UNIT LABEL TRUE: band, estimate, estimate where masked. The band is cut where nothing is known; marks say where it goes on.
panel() {
  local top
  top=$(awk -v largest="$(largest "$1_$2")" 'BEGIN { print 1.5 * largest }')
  local claimed="column('masked') == 0" low="column('$1_low_$2')" high="column('$1_high_$2')" value="column('$1_$2')"
  local truth="column('$4') > 0 && column('inflow_kg_s') > 0 ? column('$4') : NaN"
  has_column "$table" band_claimed && claimed="column('band_claimed') == 1"
  cat <<END
set ylabel '$3'
set yrange [0:$top]
plot $file using (1e3*column('time_s')):($claimed ? $low : NaN):($claimed ? $high : NaN) \
  with filledcurves fillcolor rgb blue_band title '95 % band', \
  '' using (1e3*column('time_s')):($claimed && $high > $top ? $top : NaN) with points linestyle 1 pointtype 9 notitle, \
  '' using (1e3*column('time_s')):(column('masked') == 0 ? $value : NaN) with lines linestyle 1 title 'estimate', \
  '' using (1e3*column('time_s')):(column('masked') == 1 ? $value : NaN) with lines linestyle 4 title 'masked'$([[ -z $known ]] || echo ", $known using (1e3*column('time_s')):($truth) with lines linestyle 2 title 'known, to be found'")
unset key
unset label 1
END
}

options "$@"
((${#arguments[@]} == 2 || ${#arguments[@]} == 3)) || fail "usage: plot_identify.sh [--title TEXT] OUT CURVES.csv [TRUE.csv]"
table=${arguments[1]} known=
[[ -f $table ]] || fail "no file $table"
require_whole "$table"
file=$(gnuplot_file "$table") || exit 2
if [[ ${arguments[2]:-} ]]; then
  for column in time_s inflow_kg_s inflow_temperature_K; do
    has_column "${arguments[2]}" "$column" || fail "${arguments[2]}: no column $column"
  done
  known=$(gnuplot_file "${arguments[2]}") || exit 2
fi
for column in time_s masked {mass_flow,mass_flow_low,mass_flow_high}_kg_s {temperature,temperature_low,temperature_high}_K; do
  has_column "$table" "$column" || fail "$table: no column $column"
done
{
  panel mass_flow kg_s 'Mass flow [kg/s]' inflow_kg_s
  panel temperature K 'Temperature [K]' inflow_temperature_K
} | render "${arguments[0]}" 2
