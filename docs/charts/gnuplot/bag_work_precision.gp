# SPDX-License-Identifier: Apache-2.0
# Error of a bag's frequency against CPU time, over mesh and step. usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
set terminal svg size 1000,440 font small_face background paper
set output out
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set xlabel 'CPU time of two periods [ms]'
set ylabel 'Relative error of the frequency'
set key top right samplen 4
rows(scene, share) = "< docs/charts/gnuplot/rows.py where ".data." scene=".scene." share_of_critical_step=".share
shares = '0.9 0.45 0.225 0.1125'
set label 1 'Error of a bag’s frequency against cost, over mesh and step (numbers: elements)'
set multiplot layout 1,2 margins 0.065,0.97,0.11,0.85 spacing 0.075,0
scenes = 'sphere drum'
titles = "'breathing sphere with gas' 'circular membrane, lowest mode'"
do for [i = 1:2] {
  set title word(titles, i)
  plot for [s = 1:4] rows(word(scenes, i), word(shares, s)) using ($4 / 1e3):5 with linespoints linestyle s title word(shares, s).' of the critical step', \
    rows(word(scenes, i), word(shares, 4)) using ($4 / 1e3):5:(sprintf('%d', $6)) with labels left offset 0.4,0.7 font ',10' notitle
  unset key
  unset label 1
}
unset multiplot
