# SPDX-License-Identifier: Apache-2.0
# Cost of the jet's stages against the number of elements, folded and inflated. usage: gnuplot -e "data='X.csv'; out='X.svg'"
set terminal svg size 1000,520 font 'sans,13' background 'white'
set output out
set datafile separator ','
set border 3
set tics nomirror
set grid linecolor 'gray70' linewidth 0.5 dashtype 3
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set xrange [500:1.5e6]
set yrange [1:3e8]
set xlabel 'Elements'
set ylabel 'Time per step [µs], one thread'
set key top left Left reverse samplen 4 spacing 1.1
rows(shape, route) = "< awk -F, '$1 == \"".shape."\" && $3 == \"".route."\"' ".data
set multiplot layout 1,2
do for [shape in "folded inflated"] {
  set title "S5 visibility by route, ".shape." bag"
  plot rows(shape, 'fast') using 2:($4+$5+$6) with lines linecolor 'gray50' linewidth 4 dashtype 1 title 'bag without jet (S1, S6, S8)', \
       rows(shape, 'brute_force') using 2:9 with linespoints linecolor 'black' dashtype 4 pointtype 2 title 'S5 brute force', \
       rows(shape, 'cgal_tree') using 2:9 with linespoints linecolor 'black' dashtype 2 pointtype 4 title 'S5 CGAL tree', \
       rows(shape, 'embree') using 2:9 with linespoints linecolor 'black' dashtype 5 pointtype 8 title 'S5 Embree, single precision', \
       rows(shape, 'fast') using 2:9 with linespoints linecolor 'black' linewidth 2 dashtype 1 pointtype 7 title 'S5 fast (exact)', \
       rows(shape, 'fast') using 2:8 with linespoints linecolor 'black' dashtype 3 pointtype 6 title 'S4 field'
}
unset multiplot
