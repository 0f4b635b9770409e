# SPDX-License-Identifier: Apache-2.0
# Error of a bag's frequency against CPU time, over mesh and step. usage: gnuplot -e "data='X.csv'; out='X.svg'"
set terminal svg size 1000,440 font 'sans,12' background 'white'
set output out
set datafile separator ','
set border 3
set tics nomirror
set grid linecolor 'gray70' linewidth 0.5 dashtype 3
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set xlabel 'CPU time of two periods [ms]'
set ylabel 'Relative error of the frequency'
set key top right samplen 4
rows(scene, share) = "< awk -F, '$1 == \"".scene."\" && $3 == \"".share."\"' ".data
shares = '0.9 0.45 0.225 0.1125'
set style line 1 linecolor 'black' linewidth 2.2 dashtype 1 pointtype 7 pointsize 0.7
set style line 2 linecolor 'black' linewidth 1.4 dashtype 2 pointtype 5 pointsize 0.7
set style line 3 linecolor 'gray30' linewidth 1.2 dashtype 1 pointtype 6 pointsize 0.8
set style line 4 linecolor 'gray50' linewidth 1.4 dashtype 4 pointtype 8 pointsize 0.8
set multiplot layout 1,2
scenes = 'sphere drum'
titles = "'breathing sphere with gas' 'circular membrane, lowest mode'"
do for [i = 1:2] {
  set title word(titles, i)
  plot for [s = 1:4] rows(word(scenes, i), word(shares, s)) using ($4 / 1e3):5 with linespoints linestyle s title word(shares, s).' of the critical step', \
    rows(word(scenes, i), '0.9') using ($4 / 1e3):5:(sprintf('%d', $6)) with labels offset -2.2,-0.5 font ',10' notitle
}
unset multiplot
