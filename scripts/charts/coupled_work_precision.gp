# SPDX-License-Identifier: Apache-2.0
# Error of ensemble means of the coupled scene against CPU time, with two standard errors. usage: gnuplot -e "data='X.csv'; out='X.svg'"
set terminal svg size 1000,440 font 'sans,12' background 'white'
set output out
set datafile separator ','
set border 3
set tics nomirror
set grid linecolor 'gray70' linewidth 0.5 dashtype 3
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set xlabel 'CPU time of a run [s]'
set key top right samplen 2 font ',10'
# A bar that reaches below the axis is drawn down to it.
low(error, bar) = error - 2 * bar > 1e-5 ? error - 2 * bar : 1e-5
rows(varied, quantity) = "< awk -F, '$1 == \"".varied."\" && $3 == \"".quantity."\" && $8 > 0' ".data
set yrange [1e-4:1]
set multiplot layout 1,2
quantities = 'contact_impulse_Ns final_angle_rad'
labels = "'Relative error of the mean impulse' 'Relative error of the mean angle at 100 ms'"
groups = 'step gas mesh'
titles = "'step' 'gas: method and tolerance' 'mesh'"
do for [i = 1:2] {
  set ylabel word(labels, i)
  plot for [g = 1:3] rows(word(groups, g), word(quantities, i)) using 4:8:(low($8, $9)):($8 + 2 * $9) with yerrorbars \
    linecolor 'black' linewidth (g == 3 ? 2 : 1) dashtype g pointtype (g == 1 ? 7 : g == 2 ? 6 : 5) pointsize 0.8 title word(titles, g), \
    for [g = 1:3] rows(word(groups, g), word(quantities, i)) using 4:8:2 with labels left offset 0.7,0.2 font ',8' notitle
}
unset multiplot
