#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Draws results against time, each time as OUT.svg and OUT.png, columns found by name, by the style sheet docs/charts/gnuplot/style.gp.
#   history   history.csv of one folder of `gasjet run`, or of two against each other (with and without jet): angle, acceleration of
#             the pendulum's centre of gravity (filtered, where the table has it) and pressure, those that the scene has
#   ensemble  the same of `gasjet ensemble`: means, each in a band of two standard errors either side
#   compare   what `gasjet compare --rows` wrote: each quantity of mine and of the reference, its band in grey where it states one
#   identify  curves of `gasjet identify` with their 95 % bands where they are claimed; what is masked is dotted, triangles mark where
#             a band goes on above the panel. TRUE.csv: the curves that are known, as `gasjet exact tank_test_pulse` writes them
# usage: scripts/plot.sh history|ensemble [--title TEXT] [--name TEXT]... OUT FOLDER [FOLDER]
#        scripts/plot.sh compare OUT ROWS.csv
#        scripts/plot.sh identify [--title TEXT] OUT CURVES.csv [TRUE.csv]
set -euo pipefail
export LC_ALL=C.UTF-8 # numbers with a decimal point, wherever the user is

# shellcheck source-path=SCRIPTDIR source=../docs/make/charts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/../docs/make/charts/common.sh"

fail() {
  echo "plot.sh: $*" >&2
  exit 2
}

# column of the result table | factor to the plot's unit | axis label
panels=(
  "pendulum_angle_rad|180/pi|Pendulum angle [°]"
  "pendulum_cg_acceleration_cfc180_m_s2|1|Acceleration of c.g., CFC 180 [m/s²]"
  "pendulum_cg_acceleration_m_s2|1|Acceleration of c.g. [m/s²]"
  "pressure_Pa|1e-3|Pressure [kPa]"
)

# has_column FILE NAME: looks in the header row, the first line that is no comment.
has_column() { awk -F, -v name="$2" '/^#/ { next } { for (i = 1; i <= NF; i++) found += $i == name; exit } END { exit !found }' "$1"; }

# require_whole FILE: its folder does not say that the run has not ended, was interrupted before all was done, or is another.
require_whole() {
  local name status folder
  name=$(basename -- "$1") folder=$(dirname -- "$1")
  status=$folder/gasjet.status
  [[ -f $status ]] && grep -qxF -- "file: $name" "$status" || return 0
  local says run own
  [[ -z $(tail -c 1 -- "$1") ]] || fail "$1: its last row has no end of line: the file is cut"
  says=$(sed -n 's/^status: //p' "$status" | tail -n 1)
  run=$(sed -n 's/^run: //p' "$status" | tail -n 1)
  own=$(sed -n '/^#/!q; s/^# run: //p' "$1" | head -n 1)
  [[ ${says:-running} != running ]] ||
    fail "$1: its run has not ended ($status says so): wait for its end; if it was killed, run it again"
  if [[ $says == interrupted ]] && grep -qx 'file: journal.jsonl' "$status"; then
    fail "$1: was interrupted before all runs were done ($status says so): the same command goes on from there"
  fi
  [[ $own == "$run" ]] || fail "$1: is of the run '$own', its folder is of '$run' ($status says so): run the case again"
}

# shown_panels TABLE COLUMN_SUFFIX FOLDER...: the panels whose column every folder's table has.
shown_panels() {
  local table=$1 suffix=$2 panel folder
  shift 2
  for folder in "$@"; do
    [[ -f $folder/$table ]] || fail "no file $folder/$table"
    require_whole "$folder/$table"
    has_column "$folder/$table" time_s || fail "$folder/$table: no column time_s"
  done
  local filtered=''
  for panel in "${panels[@]}"; do
    [[ $filtered && $panel == pendulum_cg_acceleration_m_s2* ]] && continue
    for folder in "$@"; do
      has_column "$folder/$table" "${panel%%|*}$suffix" || continue 2
    done
    [[ $panel == *_cfc180_* ]] && filtered=1
    echo "$panel"
  done
}

# options ARGUMENT...: takes --title TEXT and --name TEXT (one a folder, for the legend) off the front, the rest is in `arguments`.
title='' names=()
options() {
  while [[ ${1:-} == --* ]]; do
    (($# >= 2)) || fail "$1 needs a text"
    case $1 in
      --title) title=$2 ;;
      --name) names+=("$2") ;;
      *) fail "unknown option '$1'; allowed: --title TEXT, --name TEXT" ;;
    esac
    shift 2
  done
  arguments=("$@")
}

# bounds COLUMN FILE...: the axis starts at 0 for what is never negative but for noise and comes near 0.
bounds() {
  awk -F, -v name="$1" '/^#/ { next }
    FNR == 1 || !(FILENAME in at) { for (i = 1; i <= NF; i++) if ($i == name) at[FILENAME] = i; next }
    $at[FILENAME] != "" { v = $at[FILENAME] + 0; if (!n++ || v < low) low = v; if (n == 1 || v > high) high = v }
    END { print (n && high > 0 && low >= -0.02 * high && low < 0.3 * high ? "set yrange [0:*]" : "set yrange [*:*]") }' "${@:2}"
}

# render OUT COUNT: draws the COUNT panels, gnuplot commands on standard input, as OUT.svg and OUT.png; the legend stands above
# the first panel alone.
render() {
  local out=$1 count=$2 height commands terminal name made style
  height=$((90 + 230 * $2))
  commands=$(cat)
  style=$(gnuplot_file "$(dirname "${BASH_SOURCE[0]}")/../docs/charts/gnuplot/style.gp") || exit 2
  mkdir -p -- "$(dirname -- "$out")"
  for terminal in "svg size 820,$height font face background paper" \
    "pngcairo size 1640,$((2 * height)) font face fontscale 2 linewidth 2"; do
    made=$out.${terminal:0:3}
    name=$(gnuplot_file "$made.part") || exit 2
    { : >"$made.part"; } 2>/dev/null || fail "$made: not writable"
    gnuplot <<END
load $style
set terminal $terminal noenhanced
set output $name
set multiplot layout $count,1 margins screen 0.11, screen 0.97, screen $(awk "BEGIN { print 55 / $height }"), \
  screen $(awk "BEGIN { print 1 - 66 / $height }") spacing screen 0, screen $(awk "BEGIN { print 62 / $height }")
set key at screen 0.97, screen $(awk "BEGIN { print 1 - 58 / $height }") right bottom vertical maxrows 1 Left reverse samplen 3 width -1 font small_face
set label 1 $(gnuplot_text "$title") noenhanced
set xlabel 'Time [ms]' offset 0, 0.4
set autoscale xfix
set ylabel offset 0.5
$commands
unset multiplot
END
    # gnuplot says nothing of a full disk.
    if ! tail -c 16 -- "$made.part" | grep -qaE '</svg>|IEND'; then
      rm -f -- "$made.part"
      fail "$made: write failed (disk full?)"
    fi
    mv -T -- "$made.part" "$made" || exit 2
    echo "$made"
  done
}

# curve FILE COLUMN FACTOR NUMBER TITLE: gnuplot's plot elements of one folder, FILE in gnuplot's quotes.
curve() {
  local time="1e3*column('time_s')" mean="column('$2_mean')" error="$band*column('$2_standard_error')"
  if [[ $kind == history ]]; then
    echo "$1 using ($time):($3*column('$2')) with lines linestyle $4 title $(gnuplot_text "$5")"
  else
    echo "$1 using ($time):($3*($mean-$error)):($3*($mean+$error)) with filledcurves" \
      "fillcolor rgb ${fills[$4 - 1]} notitle," \
      "$1 using ($time):($3*$mean) with lines linestyle $4 title $(gnuplot_text "$5, mean ± $band s.e.")"
  fi
}

# plot_folders TABLE COLUMN_SUFFIX OUT FOLDER...: one panel a quantity.
plot_folders() {
  local table=$1 suffix=$2 out=$3 column factor label elements i shown file legend
  local folders=("${@:4}")
  shown=$(shown_panels "$table" "$suffix" "${folders[@]}")
  [[ -n $shown ]] || fail "no quantity to plot is in every $table"
  while IFS='|' read -r column factor label; do
    elements=
    for i in "${!folders[@]}"; do
      file=$(gnuplot_file "${folders[i]}/$table") || exit 2
      legend=${names[i]:-$(basename -- "${folders[i]}" | tr _ ' ')}
      elements+="${elements:+, }$(curve "$file" "$column" "$factor" $((i + 1)) "$legend")"
    done
    printf "%s\nset ylabel '%s'\nplot %s\nunset key\nunset label 1\n" "$(bounds "$column$suffix" "${folders[@]/%//$table}")" "$label" "$elements"
  done <<<"$shown" | render "$out" "$(wc -l <<<"$shown")"
}

# --- compare

# quantities: names of the columns that have a column <name>_reference
quantities() {
  awk -F, '/^#/ { next } { for (i = 1; i <= NF; i++) there[$i]; for (i = 1; i <= NF; i++) if ($i "_reference" in there) print $i; exit }' "$table"
}

# label NAME: the name with its unit in brackets, by the endings that the program knows
label() {
  local endings
  endings=$(dirname "${BASH_SOURCE[0]}")/../driver/results/include/results/unit_endings.hpp
  grep -oE '\{"_[^"]+", "[^"]+"\}' "$endings" | sed -E 's/^\{"|"\}$//g; s/", "/ /' | awk -v name="$1" '
    !unit && substr(name, length(name) - length($1) + 1) == $1 { name = substr(name, 1, length(name) - length($1)); sub(/^[^ ]+ /, ""); unit = " [" $0 "]" }
    END { gsub(/_/, " ", name); print name unit }'
}

compared() {
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

draw_comparison() {
  (($# == 2)) || fail "usage: plot.sh compare OUT ROWS.csv"
  table=$2
  [[ -f $table ]] || fail "no file $table"
  require_whole "$table"
  file=$(gnuplot_file "$table") || exit 2
  has_column "$table" time_s || fail "$table: no column time_s"
  header=$(sed "/^#/d; q" "$table") banded="title 'band'"
  mapfile -t shown < <(quantities)
  ((${#shown[@]})) || fail "$table: no column with a column <name>_reference beside it"
  for name in "${shown[@]}"; do compared "$name"; done | render "$1" "${#shown[@]}"
}

# --- identify

# largest COLUMN: its largest value where nothing is masked.
largest() {
  awk -F, -v name="$1" '/^#/ { next }
    !value { for (i = 1; i <= NF; i++) { if ($i == name) value = i; if ($i == "masked") masked = i }; next }
    !$masked && $value > most { most = $value }
    END { print most + 0 }' "$table"
}

# identified QUANTITY UNIT LABEL TRUE: band, estimate, estimate where masked. The band is cut where nothing is known; marks say where it goes on.
identified() {
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

draw_identified() {
  options "$@"
  ((${#arguments[@]} == 2 || ${#arguments[@]} == 3)) || fail "usage: plot.sh identify [--title TEXT] OUT CURVES.csv [TRUE.csv]"
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
    identified mass_flow kg_s 'Mass flow [kg/s]' inflow_kg_s
    identified temperature K 'Temperature [K]' inflow_temperature_K
  } | render "${arguments[0]}" 2
}

kind=${1:-} band=2 fills=(blue_band vermilion_band) # band: standard errors
(($# == 0)) || shift
case $kind in
  history | ensemble)
    options "$@"
    ((${#arguments[@]} == 2 || ${#arguments[@]} == 3)) || fail "usage: plot.sh $kind [--title TEXT] [--name TEXT]... OUT FOLDER [FOLDER]"
    if [[ $kind == history ]]; then plot_folders history.csv '' "${arguments[@]}"; else plot_folders ensemble.csv _mean "${arguments[@]}"; fi
    ;;
  compare) draw_comparison "$@" ;;
  identify) draw_identified "$@" ;;
  *) fail "cannot draw '$kind'; allowed: history, ensemble, compare, identify" ;;
esac
