# SPDX-License-Identifier: Apache-2.0
# Stable or not over two parameters, beside the formula. usage: gnuplot -e "data='X.csv'; out='X.svg'; label='...'; formula='...'; heading='...'"
load 'docs/charts/gnuplot/style.gp'
set terminal svg size 680,500 font face background paper
set output out
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set xlabel label
set ylabel 'Time step [s]'
set label 1 heading
set tmargin 6
set key at graph 1, graph 1.03 right bottom horizontal Left reverse samplen 3 maxrows 2
set autoscale xfix
set autoscale yfix
plot data using 1:($3 == 1 ? $2 : NaN) with points linecolor rgb blue pointtype 7 pointsize 0.6 title 'stable', \
     data using 1:($3 == 0 ? $2 : NaN) with points linecolor rgb vermilion pointtype 2 pointsize 0.8 title 'blown up', \
     data using 1:4 smooth unique with lines linecolor rgb ink linewidth 2 title formula
