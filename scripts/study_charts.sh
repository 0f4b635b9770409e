#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs the plans of cases/studies and draws their charts. Runs that are there already are not computed again.
# Writes docs/charts/NAME.csv and NAME.svg for where_the_jet_matters and what_to_measure.
# usage: scripts/study_charts.sh [THREADS] [OUT]      (1, docs/charts by default; GASJET names the program)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
# shellcheck source-path=SCRIPTDIR source=provenance.sh
source scripts/provenance.sh
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

style="set datafile separator ','; set border 3; set tics nomirror; set grid linecolor 'gray80' linewidth 0.5"
# rows FRICTION OUTLET: distance, difference and its error
rows() { awk -F, -v f="$1" -v o="$2" '$3 == f && $4 == o && $5 == "final_angle_rad" { print $2 "," $9 "," $10 }' "$out/where_the_jet_matters.csv"; }
{
  echo "set terminal svg size 900,400 font 'sans,13' background 'white' noenhanced"
  echo "set output '$out/where_the_jet_matters.svg'"
  echo "$style"
  echo "set xlabel 'Centre of the impactor to the plate [m]'; set ylabel 'What the jet adds to the angle [°]'"
  echo "set xrange [0.24:0.51]; set yrange [0:28]; set xtics 0.05; set key bottom left reverse Left samplen 3 title 'outlet, ± 2 s.e.'"
  for outlet in 1800 3600 7200; do
    for friction in 0 0.3; do printf '$o%sf%s << EOD\n%s\nEOD\n' "$outlet" "${friction/./}" "$(rows "$friction" "$outlet")"; done
  done
  echo "set multiplot layout 1,2"
  for friction in 0 0.3; do
    f=${friction/./}
    echo "set title 'Friction $friction'"
    printf 'plot '
    printf "\$o1800f$f using 1:(\$2*180/pi):(\$3*360/pi) with yerrorlines lc rgb '#0072b2' dt 1 pt 7 ps 0.7 title '1800 mm²', "
    printf "\$o3600f$f using 1:(\$2*180/pi):(\$3*360/pi) with yerrorlines lc rgb '#d55e00' dt 2 pt 5 ps 0.7 title '3600 mm²', "
    printf "\$o7200f$f using 1:(\$2*180/pi):(\$3*360/pi) with yerrorlines lc rgb '#009e73' dt 4 pt 9 ps 0.8 title '7200 mm²'\n"
  done
  echo "unset multiplot"
} | gnuplot

titles=("final_angle_rad|Final angle" "peak_pressure_Pa|Peak pressure" "peak_cg_acceleration_cfc180_m_s2|Peak acceleration, CFC 180" "path_impulse_Ns|Impulse along the path")
{
  echo "set terminal svg size 900,620 font 'sans,13' background 'white' noenhanced"
  echo "set output '$out/what_to_measure.svg'"
  echo "$style; unset grid; set grid x linecolor 'gray80' linewidth 0.5"
  echo "set xrange [0:1]; set yrange [7.6:-0.6]; set key off; set ytics scale 0; set xlabel 'Share of the variance'"
  echo "set multiplot layout 2,2"
  for title in "${titles[@]}"; do
    printf '$data << EOD\n%s\nEOD\n' "$(grep "^${title%%|*}," "$out/what_to_measure.csv")"
    echo "set title '${title#*|}'"
    echo "plot \$data using 6:0:(0):6:(\$0-0.35):(\$0+0.35):yticlabels(2) with boxxyerror fs solid 0.25 noborder lc rgb '#0072b2', \
      \$data using (\$3>0?\$3:0):0:(0):(\$3>0?\$3:0):(\$0-0.35):(\$0+0.35) with boxxyerror fs solid 0.8 noborder lc rgb '#0072b2', \
      \$data using 6:0:7:8 with xerrorbars pt 0 lc 'black'"
  done
  echo "unset multiplot"
} | gnuplot
echo "$out/where_the_jet_matters.svg $out/what_to_measure.svg"
