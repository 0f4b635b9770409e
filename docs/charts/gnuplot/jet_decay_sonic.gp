# SPDX-License-Identifier: Apache-2.0
# Measured centrelines beside Witze's law and the model. usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
set terminal svg size 900,560 font face background paper
set output out
set label 1 'How fast a jet slows down: measured, by Witze, and in the model'
set logscale xy
set xrange [2:20]
set yrange [0.2:1.15]
set xtics (2, 3, 4, 5, 6, 8, 10, 15, 20)
set ytics (0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0)
set xlabel 'Distance from the outlet [diameters]'
set ylabel 'V_{max} / V_0'
set key bottom left Left reverse samplen 3 spacing 1.15
set tmargin 3
of(point, column) = stringcolumn('set_point') eq point ? column(column) : NaN
x = 'x_over_d'
model(a) = of('7', 'a_'.a)  # the same for each set point
plot data using x:(model('0.044')) with lines linecolor rgb ink linewidth 1.6 dashtype 2 title 'model, a = 0.044', \
     data using x:(model('0.066')) with lines linecolor rgb ink linewidth 1.6 dashtype 3 title 'model, a = 0.066 (contracting nozzle)', \
     data using x:(model('0.08')) with lines linecolor rgb ink linewidth 1.6 dashtype 4 title 'model, a = 0.08 (tube)', \
     data using x:(of('7', 'witze')) with lines linecolor rgb blue linewidth 2, \
     data using x:(of('3', 'witze')) with lines linecolor rgb green linewidth 2, \
     data using x:(of('23', 'witze')) with lines linecolor rgb vermilion linewidth 2, \
     data using x:(of('7', 'measured')) with points linecolor rgb blue pointtype 7 pointsize 0.8 title 'measured (line: Witze), Mach 0.985, 1.20 times the density around', \
     data using x:(of('3', 'measured')) with points linecolor rgb green pointtype 9 pointsize 0.9 title 'the same, Mach 0.51, 1.05 times', \
     data using x:(of('23', 'measured')) with points linecolor rgb vermilion pointtype 5 pointsize 0.8 title 'the same, Mach 0.38, 0.57 times (hot)'
