# SPDX-License-Identifier: Apache-2.0
# What the jet adds to the angle at the ends of the range of each input, the widest first: a tornado.
# usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
set terminal svg size 860,430 font face background paper
set output out
# label, low end, high end, standard errors, the texts of the ends; the first line is the scene as shipped
bars = "< docs/charts/gnuplot/rows.py tornado ".data
stats bars every ::0::0 using 2 nooutput
shipped = STATS_mean
set yrange [7.6:0.3]
set xrange [12:25.5]
set xlabel 'What the jet adds to the angle at 100 ms [°]'
set label 1 'What the jet adds to the angle, over the range of each input'
set key off
set lmargin 24
set tmargin 5
set grid noytics
set arrow from shipped,0.3 to shipped,7.6 nohead linewidth 1.4 dashtype 3 linecolor rgb ink
set label sprintf('as shipped: %.1f°', shipped) at shipped,0.3 offset 0,0.7 center
plot bars every ::1 using 2:($0+1):2:3:($0+0.7):($0+1.3):yticlabels(1) with boxxyerror fillcolor rgb blue_band, \
  bars every ::1 using 2:($0+1):4 with xerrorbars pointtype 7 pointsize 0.5 linecolor rgb blue, \
  bars every ::1 using 3:($0+1):5 with xerrorbars pointtype 7 pointsize 0.5 linecolor rgb blue, \
  bars every ::1 using ($2-$4):($0+1):6 with labels right offset -0.6,0 font small_face, \
  bars every ::1 using ($3+$5):($0+1):7 with labels left offset 0.6,0 font small_face
