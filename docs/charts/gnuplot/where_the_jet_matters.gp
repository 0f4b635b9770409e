# SPDX-License-Identifier: Apache-2.0
# What the jet adds to the angle against the distance, for three outlets, a panel for each friction.
# usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
set terminal svg size 900,400 font face background paper
set output out
# distance, difference [degrees], two standard errors
rows(friction, outlet) = "< docs/charts/gnuplot/rows.py distances ".data." ".friction." ".outlet
set xlabel 'Centre of the impactor to the plate [m]'
set ylabel 'What the jet adds to the final angle [°]'
set xrange [0.24:0.51]
set yrange [0:28]
set xtics 0.05
set key bottom left reverse Left samplen 3 title 'outlet, ± 2 s.e.'
set label 1 'What the jet adds to the final angle, by distance, outlet and friction'
set multiplot layout 1,2 margins 0.075,0.98,0.155,0.8 spacing 0.095,0
do for [friction in '0 0.3'] {
  set title 'Friction '.friction
  plot rows(friction, '1800') using 1:2:3 with yerrorlines linestyle 1 title '1800 mm²', \
    rows(friction, '3600') using 1:2:3 with yerrorlines linestyle 2 title '3600 mm²', \
    rows(friction, '7200') using 1:2:3 with yerrorlines linestyle 3 title '7200 mm²'
  unset key
  unset label 1
}
unset multiplot
