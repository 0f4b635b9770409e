# SPDX-License-Identifier: Apache-2.0
# Error of the jet force against cost for each rung of fidelity. usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
set terminal svg size 800,560 font face background paper
set output out
set logscale xy
set xrange [3:6e4]
set format x '10^{%L}'
set format y '10^{%L}'
set xlabel 'Field and visibility, time per step [µs], one thread'
set ylabel 'Relative error of the total jet force'
set label 1 'Error of the jet force against cost'
set tmargin 3
set key bottom left Left reverse samplen 3 font small_face
rows(rung) = "< docs/charts/gnuplot/rows.py where ".data." rung=".rung
plot rows('pieces') using 3:4 with linespoints linestyle 1 title 'n × n pieces, r.m.s. over the instants', \
     rows('pieces') using 3:5 with linespoints linestyle 2 title 'n × n pieces, impulse', \
     rows('cgal_tree') using 3:4 with linespoints linestyle 3 title "the same by CGAL’s tree, r.m.s.", \
     rows('brute_force') using 3:4 with points linecolor rgb ink pointtype 2 title 'the same by brute force, r.m.s.', \
     rows('no_occlusion') using 3:4 with points linecolor rgb purple pointtype 13 pointsize 1.2 title 'no occlusion, r.m.s.', \
     rows('no_occlusion') using 3:5 with points linecolor rgb purple pointtype 12 pointsize 1.2 title 'no occlusion, impulse', \
     rows('pieces') using 3:4:(sprintf('n = %d', $2)) with labels offset 2.5,0.9 notitle
