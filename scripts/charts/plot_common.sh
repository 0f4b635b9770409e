# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash
# Shared by the plot scripts (sourced): panels of pendulum angle, acceleration of its centre of gravity (filtered, where the table
# has it) and bag pressure against time (those that the scene has), for one or two result folders, by the style sheet charts/style.gp.

export LC_ALL=C.UTF-8 # numbers with a decimal point, wherever the user is

# shellcheck source-path=SCRIPTDIR source=gnuplot_text.sh
source "$(dirname "${BASH_SOURCE[0]}")/gnuplot_text.sh"

fail() {
  echo "$(basename "$0"): $*" >&2
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
  # shellcheck disable=SC2034  # of the callers
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
  local out=$1 count=$2 height commands terminal name style
  height=$((90 + 230 * $2))
  commands=$(cat)
  style=$(gnuplot_file "$(dirname "${BASH_SOURCE[0]}")/style.gp") || exit 2
  mkdir -p -- "$(dirname -- "$out")"
  for terminal in "svg size 820,$height font face background paper" \
    "pngcairo size 1640,$((2 * height)) font face fontscale 2 linewidth 2"; do
    name=$(gnuplot_file "$out.${terminal:0:3}") || exit 2
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
    echo "$out.${terminal:0:3}"
  done
}

# plot_folders TABLE COLUMN_SUFFIX OUT FOLDER...: one panel a quantity; the caller's curve FILE COLUMN FACTOR
# NUMBER TITLE, FILE in gnuplot's quotes, prints the gnuplot plot elements of one folder.
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
