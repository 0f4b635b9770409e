# SPDX-License-Identifier: Apache-2.0
# Error of the inverse tank test against noise, and against CPU time over the number of readings. usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
set terminal svg size 1000,440 font small_face background paper
set output out
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set ylabel 'r.m.s. error'
set key bottom right samplen 4
by_noise(method) = "< docs/charts/gnuplot/rows.py where ".data." readings=601 method=".method
by_readings(method, noise) = "< docs/charts/gnuplot/rows.py rising ".data." readings method=".method." noise=".noise
set label 1 'Error of the inverse tank test: mass flow, temperature, and their product'
set multiplot layout 1,2 margins 0.065,0.985,0.115,0.845 spacing 0.085,0
set title 'against noise (601 readings, 10 kHz)'
set xlabel 'Noise of a reading, relative'
plot by_noise('dual') using 2:6 with linespoints linestyle 2 title 'dual: T_s', \
  by_noise('dual') using 2:5 with linespoints linestyle 1 title 'dual: mass flow', \
  by_noise('average') using 2:5 with linespoints linestyle 3 title 'average: product', \
  by_noise('average') using 2:6 with linespoints linestyle 4 title 'average: mean T'
unset label 1
set title 'against cost (151 to 4801 readings)'
set xlabel 'CPU time of an analysis [ms]'
set key top right
set yrange [1e-4:1]
set xrange [10:1000]
plot by_readings('dual', '1e-2') using ($4 / 1e3):5 with linespoints linestyle 1 title 'dual: mass flow, noise 10^{-2}', \
  by_readings('average', '1e-2') using ($4 / 1e3):5 with linespoints linestyle 3 title 'average: product, noise 10^{-2}', \
  by_readings('dual', '1e-4') using ($4 / 1e3):5 with linespoints linestyle 1 dashtype 2 pointtype 6 title 'dual: mass flow, noise 10^{-4}', \
  by_readings('average', '1e-4') using ($4 / 1e3):5 with linespoints linestyle 3 dashtype 2 pointtype 8 title 'average: product, noise 10^{-4}'
unset multiplot
