# SPDX-License-Identifier: Apache-2.0
# Error of the jet's effect on the final angle against CPU time spent in all, from one pair of runs to a thousand: bias and scatter. Above
# them, how far choices of the model and a direction 3 degrees off move the effect.
# usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
set terminal svg size 860,520 font face background paper
set output out
set logscale xy
set xrange [0.2:2000]
set yrange [0.1:30]
set xtics (1, 10, 60, 600)
set ytics (0.1, 0.2, 0.5, 1, 2, 5, 10, 20)
set xlabel 'CPU time in all [s]'
set ylabel 'Error of the jet’s effect on the angle [°]'
set label 1 'Error of the jet’s effect against CPU time, one pair of runs to a thousand'
set key at screen 0.985, screen 0.93 right top vertical maxrows 3 Left reverse samplen 2.5 width -3 font small_face
set tmargin 6.5
degrees = 180 / pi
names = "'1216 elements' 'as shipped' '10970 elements' 'step 0.9' 'step 0.4' 'no hidden-element test' '2 × 2 pieces'"
styles = '3 1 4 2 5 6 7'
set style line 7 linecolor rgb quiet linewidth 1.6 dashtype 2 pointtype 10 pointsize 0.7
cell_of(name, column) = real(system("docs/charts/gnuplot/rows.py cell ".data." ".column." 'variation=".name."'"))
array bias[7]
array scatter[7]
array cost[7]
do for [i = 1:7] {
  bias[i] = cell_of(word(names, i), 'bias_rad') * degrees
  scatter[i] = cell_of(word(names, i), 'scatter_rad') * degrees
  cost[i] = cell_of(word(names, i), 'cpu_s')
}
# The largest change of the jet's effect among the levels of what_the_jet_rests_on that a pattern finds.
largest(pattern) = real(system("docs/charts/gnuplot/rows.py largest_change docs/charts/what_the_jet_rests_on.csv '".pattern."'")) * degrees
model = largest('^model, ')
direction = largest('axis off by 3')
reference = cell_of('as shipped', 'bias_error_rad') * degrees
error_of(i, n) = sqrt(bias[i] ** 2 + scatter[i] ** 2 / n)
set samples 31
set arrow 1 from 60, graph 0 to 60, graph 1 nohead linestyle 9 linecolor rgb quiet linewidth 1
set object 1 rectangle from graph 0, first 0.1 to graph 1, first reference behind fillcolor rgb '#eeeeee' fillstyle solid 1 noborder
set label 2 'what the reference itself is uncertain by' at graph 0.985, first 0.115 right font small_face textcolor rgb quiet
set arrow 2 from graph 0, first model to graph 1, first model nohead linestyle 2 linewidth 1.2
set label 3 sprintf('model band: reflection, outlet and gas move the effect by up to %.1f°', model) at graph 0.985, first 0.87 * model right font small_face
set arrow 3 from graph 0, first direction to graph 1, first direction nohead linestyle 1 linewidth 1.2
set label 4 sprintf('input: an axis 3° off moves it by up to %.1f°', direction) at graph 0.985, first 1.15 * direction right font small_face
set parametric
set trange [0:3]
plot for [i = 1:7] cost[i] * 10 ** t, error_of(i, 10 ** t) with lines linestyle (int(word(styles, i))) title word(names, i)
