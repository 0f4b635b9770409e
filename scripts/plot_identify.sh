#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Plots the curves of `gasjet identify` with their 95 % bands where they are claimed: mass flow and temperature against
# time; what is masked is dashed.
# usage: scripts/plot_identify.sh OUT CURVES.csv; writes OUT.svg and OUT.png
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=plot_common.sh
source "$(dirname "${BASH_SOURCE[0]}")/plot_common.sh"

# largest COLUMN: its largest value where nothing is masked.
largest() {
  awk -F, -v name="$1" '/^#/ { next }
    !value { for (i = 1; i <= NF; i++) { if ($i == name) value = i; if ($i == "masked") masked = i }; next }
    !$masked && $value > most { most = $value }
    END { print most + 0 }' "$table"
}

# panel QUANTITY UNIT LABEL: band, estimate, estimate where masked. The band is cut where nothing is known.
panel() {
  local claimed="column('masked') == 0" low="column('$1_low_$2')" high="column('$1_high_$2')" value="column('$1_$2')"
  has_column "$table" band_claimed && claimed="column('band_claimed') == 1"
  cat <<END
set ylabel '$3'
set yrange [0:1.5*$(largest "$1_$2")]
plot $file using (1e3*column('time_s')):($claimed ? $low : NaN):($claimed ? $high : NaN) \
  with filledcurves fillcolor 'gray80' title '95 % band', \
  '' using (1e3*column('time_s')):(column('masked') == 0 ? $value : NaN) with lines linestyle 1 title 'estimate', \
  '' using (1e3*column('time_s')):(column('masked') == 1 ? $value : NaN) with lines linestyle 2 title 'masked'
END
}

(($# == 2)) || fail "usage: plot_identify.sh OUT CURVES.csv"
table=$2
[[ -f $table ]] || fail "no file $table"
require_whole "$table"
file=$(gnuplot_file "$table") || exit 2
for column in time_s masked {mass_flow,mass_flow_low,mass_flow_high}_kg_s {temperature,temperature_low,temperature_high}_K; do
  has_column "$table" "$column" || fail "$table: no column $column"
done
{
  panel mass_flow kg_s 'Mass flow [kg/s]'
  panel temperature K 'Temperature [K]'
} | render "$1" 2
