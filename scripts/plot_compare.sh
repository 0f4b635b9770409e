#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Plots what `gasjet compare --rows` wrote: each quantity of mine and of the reference against time, the
# reference's band in grey where it states one.
# usage: scripts/plot_compare.sh OUT ROWS.csv; writes OUT.svg and OUT.png
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=charts/plot_common.sh
source "$(dirname "${BASH_SOURCE[0]}")/charts/plot_common.sh"

# quantities: names of the columns that have a column <name>_reference
quantities() {
  awk -F, '/^#/ { next } { for (i = 1; i <= NF; i++) there[$i]; for (i = 1; i <= NF; i++) if ($i "_reference" in there) print $i; exit }' "$table"
}

# label NAME: the name with its unit in brackets
label() { sed -E 's/_(rad_s|kg_s|m_s2|m_s|Pa|K|m3|m2|kg|N|rad|m|J|s)$/ [\1]/; s/\[(rad|kg|m)_s/[\1\/s/; s/2]$/²]/; s/3]$/³]/; s/_/ /g' <<<"$1"; }

panel() {
  local band='' value reference width
  value="column($(gnuplot_text "$1"))"
  reference="column($(gnuplot_text "${1}_reference"))" width="column($(gnuplot_text "${1}_band"))"
  if has_column "$table" "${1}_band"; then
    band="$file using (1e3*column('time_s')):($reference-$width):($reference+$width) with filledcurves fillcolor rgb measured $banded, "
    banded=notitle
  elif [[ $banded != notitle ]] && grep -q _band <<<"$header"; then
    band="keyentry with filledcurves fillcolor rgb measured $banded, " banded=notitle
  fi
  cat <<END
$(bounds "$1" "$table")
set ylabel $(gnuplot_text "$(label "$1")")
plot $band$file using (1e3*column('time_s')):($value) with lines linestyle 1 title 'mine', \
  '' using (1e3*column('time_s')):($reference) with lines linestyle 2 title 'reference'
unset key
unset label 1
END
}

(($# == 2)) || fail "usage: plot_compare.sh OUT ROWS.csv"
table=$2
[[ -f $table ]] || fail "no file $table"
require_whole "$table"
file=$(gnuplot_file "$table") || exit 2
has_column "$table" time_s || fail "$table: no column time_s"
header=$(sed "/^#/d; q" "$table") banded="title 'band'"
mapfile -t shown < <(quantities)
((${#shown[@]})) || fail "$table: no column with a column <name>_reference beside it"
for name in "${shown[@]}"; do panel "$name"; done | render "$1" "${#shown[@]}"
