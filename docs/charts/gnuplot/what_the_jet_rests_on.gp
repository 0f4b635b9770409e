# SPDX-License-Identifier: Apache-2.0
# What the jet adds to the angle when an input, a choice of the model or a numerical setting goes to its ends, the widest
# first: a tornado for each scene.
# usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
set terminal svg size 1180,640 font small_face background paper
set output out
scenes = '"without friction" "with friction"'
colour(kind) = kind == 1 ? 0xb9d9ec : kind == 2 ? 0xf3c38c : 0xbbbbbb
set label 1 'What the jet adds to the angle at 100 ms: direction and reflection decide, numerics do not'
set label 2 'blue: inputs; orange: choices of the model; grey: numerics' at screen 0.015, screen 1 offset 0, -2.6 font small_face
set xlabel 'added angle [°]'
set key off
set grid noytics
set multiplot
set bmargin 4
set tmargin 6
do for [i=1:2] {
  # label, low end, high end, standard errors, the texts of the ends, kind; the first line is the scene as shipped
  bars = "< docs/charts/gnuplot/rows.py tornado ".data." '".word(scenes, i)."'"
  set xrange [*:*]
  set yrange [*:*]
  stats bars using 2 nooutput
  count = STATS_records - 1
  stats bars every ::0::0 using 2 nooutput
  shipped = STATS_mean
  set xrange [-24:30]
  set yrange [count + 0.6:0.3]
  set lmargin at screen (i == 1 ? 0.19 : 0.69)
  set rmargin at screen (i == 1 ? 0.49 : 0.985)
  set title sprintf('%s: %.1f° as shipped', word(scenes, i), shipped)
  set arrow 1 from shipped,0.3 to shipped,count + 0.6 nohead linewidth 1.4 dashtype 3 linecolor rgb ink
  set arrow 2 from 0,0.3 to 0,count + 0.6 nohead linewidth 1 linecolor rgb ink
  plot bars every ::1 using 2:($0+1):2:3:($0+0.7):($0+1.3):(colour($8)):yticlabels(1) with boxxyerror fillcolor rgb variable, \
    bars every ::1 using 2:($0+1):4 with xerrorbars pointtype 7 pointsize 0.3 linecolor rgb ink, \
    bars every ::1 using 3:($0+1):5 with xerrorbars pointtype 7 pointsize 0.3 linecolor rgb ink, \
    bars every ::1 using ($2-$4):($0+1):6 with labels right offset -0.6,0 font small_face, \
    bars every ::1 using ($3+$5):($0+1):7 with labels left offset 0.6,0 font small_face
  unset label 1
  unset label 2
}
unset multiplot
