# SPDX-License-Identifier: Apache-2.0
# Stable or not over two parameters, beside the formula. usage: gnuplot -e "data='X.csv'; out='X.svg'; label='...'; formula='...'"
set terminal svg size 620,460 font 'sans,13' background 'white'
set output out
set datafile separator ','
set datafile commentschars '#'
set border 3
set tics nomirror
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set xlabel label
set ylabel 'Time step [s]'
set key outside top center horizontal Left reverse samplen 3
set autoscale xfix
set autoscale yfix
plot data using 1:($3 == 1 ? $2 : NaN) with points linecolor 'black' pointtype 7 pointsize 0.6 title 'stable', \
     data using 1:($3 == 0 ? $2 : NaN) with points linecolor 'gray50' pointtype 2 pointsize 0.8 title 'blown up', \
     data using 1:4 smooth unique with lines linecolor 'black' linewidth 2 title formula
