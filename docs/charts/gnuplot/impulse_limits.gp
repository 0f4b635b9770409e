# SPDX-License-Identifier: Apache-2.0
# Impulse along the path and of the size against contact stiffness. usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
set terminal svg size 900,620 font small_face background paper
set output out
rows(varied, scene, quantity) = "< grep '^".varied.",[^,]*,".scene.",".quantity.",' ".data
set logscale x 2
set xrange [0.42:19]
set xtics (0.5, 1, 2, 4, 8, 16)
set offsets 0, 0, graph 0.08, graph 0.08
set multiplot layout 2,2 margins 0.08,0.98,0.085,0.865 spacing 0.09,0.15
set label 1 'With stiffer contact the impulse along the path nearly settles, that of the force’s size does not'
set key at screen 0.98, screen 0.945 right top vertical maxrows 1 samplen 2
scenes = 'no_jet no_jet jet jet'
quantities = 'path_impulse_Ns contact_impulse_Ns path_impulse_Ns contact_impulse_Ns'
titles = "'along the path, without jet' 'of the force’s size, without jet' 'along the path, with jet' 'of the force’s size, with jet'"
set xlabel 'Contact stiffness over that of the fabric' offset 0, 0.3
set ylabel 'Impulse [N s]' offset 1
do for [i = 1:4] {
  set title word(titles, i) offset 0, -0.5
  plot rows('contact', word(scenes, i), word(quantities, i)) using 2:5:(2 * $6) with yerrorbars linestyle 1 title 'step as long as each stiffness allows, mean ± 2 s.e.', \
    rows('one_step', word(scenes, i), word(quantities, i)) using (1.1 * $2):5:(2 * $6) with yerrorbars linestyle 2 title 'one step for all'
  unset key
  unset label 1
}
unset multiplot
