# SPDX-License-Identifier: Apache-2.0
# Error of ensemble means of the coupled scene against CPU time, with two standard errors.
# usage: gnuplot -e "data='X.csv'; out='X.svg'"
set terminal svg size 1050,670 font 'sans,12' background 'white'
set output out
set datafile separator ','
set border 3
set tics nomirror
set grid linecolor 'gray70' linewidth 0.5 dashtype 3
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
unset key
# A bar that reaches below the axis is drawn down to it.
low(error, bar) = error - 2 * bar > 1e-4 ? error - 2 * bar : 1e-4
rows(varied, quantity) = "< awk -F, '$1 == \"".varied."\" && $3 == \"".quantity."\" && $8 > 0' ".data
# "1: first value, 2: second ..." of the points drawn
values(varied, quantity) = system("awk -F, '$1 == \"".varied."\" && $3 == \"".quantity."\" && $8 > 0 ". \
  "{ gsub(\"_\", \" \", $2); printf \"%s%d: %s\", n == 3 ? \"\\n\" : n ? \", \" : \"\", ++n, $2 }' ".data)
extreme(order, varied) = real(system("awk -F, '$1 == \"".varied."\" && $8 > 0 { print $4 }' ". \
  data." | sort ".order." | head -n 1"))
set yrange [1e-4:0.5]
set format x '%g'
set multiplot layout 2,3 margins 0.075,0.985,0.155,0.95 spacing 0.065,0.2
quantities = 'path_impulse_Ns final_angle_rad'
labels = "'Relative error of the mean impulse' 'Relative error of the mean angle'"
groups = 'step gas mesh'
titles = "'share of the critical step' 'gas: method and tolerance' 'elements'"
do for [i = 1:2] {
  do for [g = 1:3] {
    set ylabel word(labels, i) offset 1
    set title word(titles, g) offset 0, -0.6
    set xlabel "CPU time of a run [s]\n".values(word(groups, g), word(quantities, i)) noenhanced
    least = extreme('-g', word(groups, g))
    most = extreme('-gr', word(groups, g))
    set xrange [least / 1.03 : most * 1.05]
    if (most > 1.5 * least) {
      set xtics (0.1, 0.2, 0.3, 0.35, 0.4, 0.45, 0.5, 0.6, 0.8, 1, 1.5, 2, 3, 4, 6, 10)
    } else {
      set xtics (sprintf('%.3f', least) least, sprintf('%.3f', most) most)
    }
    plot rows(word(groups, g), word(quantities, i)) using 4:8:(low($8, $9)):($8 + 2 * $9) with yerrorbars \
      linecolor 'black' pointtype 7 pointsize 0.7, \
      '' using 4:8:(int($0) % 2 == 0 ? sprintf('%d', $0 + 1) : '') with labels left offset 0.6, 0.3 font ',11', \
      '' using 4:8:(int($0) % 2 == 1 ? sprintf('%d', $0 + 1) : '') with labels right offset -0.6, 0.3 font ',11'
  }
}
unset multiplot
