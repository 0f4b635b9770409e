# SPDX-License-Identifier: Apache-2.0
# Error of the jet force against cost for each rung of fidelity. usage: gnuplot -e "data='X.csv'; out='X.svg'"
set terminal svg size 760,480 font 'sans,13' background 'white'
set output out
set datafile separator ','
set border 3
set tics nomirror
set grid linecolor 'gray70' linewidth 0.5 dashtype 3
set logscale xy
set xrange [10:3e5]
set format x '10^{%L}'
set format y '10^{%L}'
set xlabel 'Field and visibility, time per step [µs], one thread'
set ylabel 'Relative error of the total jet force'
set key top right Left reverse samplen 4
rows(rung) = "< awk -F, '$1 == \"".rung."\"' ".data
plot rows('pieces') using 3:4 with linespoints linecolor 'black' linewidth 2 dashtype 1 pointtype 7 title 'n × n pieces, r.m.s. over the instants', \
     rows('pieces') using 3:5 with linespoints linecolor 'black' dashtype 2 pointtype 6 title 'n × n pieces, impulse', \
     rows('cgal_tree') using 3:4 with linespoints linecolor 'black' dashtype 4 pointtype 8 title "the same by CGAL’s tree, r.m.s.", \
     rows('brute_force') using 3:4 with points linecolor 'black' pointtype 2 title 'the same by brute force, r.m.s.', \
     rows('no_occlusion') using 3:4 with points linecolor 'black' pointtype 5 pointsize 1.2 title 'no occlusion, r.m.s.', \
     rows('no_occlusion') using 3:5 with points linecolor 'black' pointtype 4 pointsize 1.2 title 'no occlusion, impulse', \
     rows('pieces') using 3:4:(sprintf('n = %d', $2)) with labels offset 2.5,0.9 notitle
