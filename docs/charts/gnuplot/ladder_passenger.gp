# SPDX-License-Identifier: Apache-2.0
# Rungs of a ladder, the dearest first: what each moves the pendulum's angle by, and its cost. usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
load 'docs/charts/gnuplot/rows.gp'
set terminal svg size 1000,560 font small_face background paper
set output out
comment(key) = real(system("sed -n 's/^# ".key.": //p' ".data))
tolerance = 100 * comment('tolerance')
uncertainty = 100 * comment('uncertainty') / comment('reference')
rows(kind) = "< docs/charts/gnuplot/rows.py ladder ".data." ".kind." ".sprintf('%.17g', comment('reference'))
rungs = int(system("grep -vc '^#' ".data)) - 1
left = 0.2
# The axis is broken where no rung is, below the rungs with jet.
stats rows('all') using ($3 - $4 < -12 && $3 + $4 > -40 ? 1 : 0) name 'between' nooutput
cut = between_sum > 0 ? 0 : 27
shown(error) = error < -26 ? error + cut : error
set yrange [rungs + 0.7:0.3]
set multiplot
set bmargin at screen 0.11
set tmargin at screen 0.815
set lmargin at screen left
set rmargin at screen 0.69
set label 1 'What each simplification does to the pendulum’s angle, and what it costs'
set label 2 'dearest first' at screen 0.015, screen 0.835 textcolor rgb quiet
set object 1 rectangle from first -tolerance, graph 0 to first tolerance, graph 1 behind fillcolor rgb '#eeeeee' fillstyle solid 1 noborder
set object 2 rectangle from first -uncertainty, graph 0 to first uncertainty, graph 1 behind fillcolor rgb '#c4c4c4' fillstyle solid 1 noborder
set xlabel 'Error of the angle at 100 ms [%], mean of 16 runs ± 2 s.e.'
set xrange [cut - 67:15]
if (cut) {
  set xtics ('-60' cut - 60, '-50' cut - 50, -10, 0, 10)
  set label 3 '//' at first -12.5, graph 0 center front
} else { set xtics 10 }
set key at screen 0.985, screen 0.925 right top vertical maxrows 2 width -4 samplen 2
plot rows('all') using (shown($3)):1:4:yticlabels(2) with xerrorbars linecolor rgb quiet linewidth 1.6 pointtype 6 pointsize 0.7 title 'rung', \
  rows('front') using (shown($3)):1:4 with xerrorbars linestyle 1 linewidth 2.4 title 'on the front: none is cheaper and as good', \
  keyentry with boxes fillstyle solid 1 noborder fillcolor rgb '#eeeeee' title sprintf('tolerance, %g %%', tolerance), \
  keyentry with boxes fillstyle solid 1 noborder fillcolor rgb '#c4c4c4' title 'uncertainty of the reference'
unset object 1
unset object 2
unset label
unset key
set format y ''
set lmargin at screen 0.72
set rmargin at screen 0.975
set xlabel 'CPU time of a run [s]'
set logscale x
set xrange [0.1:6]
set xtics (0.1, 0.2, 0.5, 1, 2, 5)
plot rows('all') using 5:1 with points linecolor rgb quiet pointtype 6 pointsize 0.7, \
  rows('front') using 5:1 with points linestyle 1 pointsize 0.8
unset multiplot
