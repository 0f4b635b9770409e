# SPDX-License-Identifier: Apache-2.0
# Cost of the paper's scene against its elements, with the exponent of each line. usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
set terminal svg size 1000,520 font small_face background paper
set output out
set datafile missing ''
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set xrange [2e3:4e6]
set xlabel 'Elements'
set key top left Left reverse samplen 3
points(name) = "< docs/charts/gnuplot/rows.py filled ".data." elements ".name
named(text, name) = text.'  n^{'.system("docs/charts/gnuplot/rows.py cell ".data." ".name." elements=exponent").'}'
set label 1 'What more elements cost, one thread'
set multiplot layout 1,3 margins 0.06,0.985,0.115,0.86 spacing 0.065,0
set title 'a step'
set ylabel 'CPU time [ms]' offset 1
set yrange [5e-3:1e3]
plot points('step_ms') with linespoints linestyle 4 title named('all of it', 'step_ms'), \
     points('skin_ms') with linespoints linestyle 1 title named('skin', 'skin_ms'), \
     points('jet_ms') with linespoints linestyle 2 title named('jet', 'jet_ms'), \
     points('contact_ms') with linespoints linestyle 3 title named('contact', 'contact_ms')
set title 'hidden elements, a step of the folded bag'
plot points('hidden_embree_ms') with linespoints linestyle 3 title named('Embree, single precision', 'hidden_embree_ms'), \
     points('hidden_tree_ms') with linespoints linestyle 2 title named('CGAL’s tree, exact', 'hidden_tree_ms'), \
     points('hidden_ms') with linespoints linestyle 1 title named('Gasjet, exact', 'hidden_ms')
set title 'start, run, memory'
set ylabel 'CPU time [s], memory [GB]' offset 1
set yrange [1e-2:3e4]
plot points('run_s') with linespoints linestyle 4 title named('run', 'run_s'), \
     points('start_s') with linespoints linestyle 1 title named('start', 'start_s'), \
     points('memory_MB') using 1:($2 / 1e3) with linespoints linestyle 5 title named('memory', 'memory_MB')
unset multiplot
