# SPDX-License-Identifier: Apache-2.0
# Cost of the jet's stages against the number of elements, folded and inflated. usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
set terminal svg size 1000,520 font face background paper
set output out
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set xrange [500:1.5e6]
set yrange [1:2e6]
set xlabel 'Elements'
set ylabel 'Time per step [µs], one thread'
set label 1 'Cost of the jet: hidden elements by route, and the velocity field'
set key at screen 0.985, screen 0.925 right top Left reverse maxrows 2 samplen 2 width -3 font small_face
rows(shape, route) = "< docs/charts/gnuplot/rows.py where ".data." shape=".shape." route=".route
set multiplot layout 1,2 margins 0.075,0.985,0.115,0.785 spacing 0.085,0
do for [shape in "folded inflated"] {
  set title shape." bag"
  plot rows(shape, 'fast') using 2:($4+$5+$6) with lines linecolor rgb '#bbbbbb' linewidth 5 title 'bag without jet', \
       rows(shape, 'brute_force') using 2:9 with linespoints linestyle 4 pointtype 2 title 'hidden: brute force', \
       rows(shape, 'cgal_tree') using 2:9 with linespoints linestyle 2 title 'hidden: CGAL tree', \
       rows(shape, 'embree') using 2:9 with linespoints linestyle 3 title 'hidden: Embree, single precision', \
       rows(shape, 'fast') using 2:9 with linespoints linestyle 1 title 'hidden: fast (exact)', \
       rows(shape, 'fast') using 2:8 with linespoints linestyle 5 title 'velocity field'
  unset key
  unset label 1
}
unset multiplot
