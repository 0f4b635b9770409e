# SPDX-License-Identifier: Apache-2.0
# Sobol indices of eight inputs, a panel for each of four quantities.
# usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
load 'docs/charts/gnuplot/rows.gp'
set terminal svg size 900,620 font face background paper
set output out
# label, first order (0 if the estimate is below), total with its interval
rows(quantity) = "< docs/charts/gnuplot/rows.py sobol ".data." ".quantity
quantities = 'final_angle_rad peak_pressure_Pa peak_cg_acceleration_cfc180_m_s2 path_impulse_Ns'
titles = "'Final angle' 'Peak pressure' 'Peak acceleration, CFC 180' 'Impulse along the path'"
set xrange [0:1]
set yrange [7.6:-0.6]
set xlabel 'Share of the variance'
set label 1 'Which inputs the spread of each result rests on'
set key at screen 0.985, screen 0.945 right top maxrows 1 samplen 2 width -4
set multiplot layout 2,2 margins 0.16,0.97,0.105,0.84 spacing 0.2,0.19
do for [i = 1:4] {
  set title word(titles, i)
  plot rows(word(quantities, i)) using 3:0:(0):3:($0-0.35):($0+0.35):yticlabels(1) with boxxyerror fillcolor rgb blue_band title 'with all others, and its interval', \
    rows(word(quantities, i)) using 2:0:(0):2:($0-0.35):($0+0.35) with boxxyerror fillcolor rgb blue title 'of the input alone', \
    rows(word(quantities, i)) using 3:0:4:5 with xerrorbars pointtype 0 linecolor rgb ink
  unset key
  unset label 1
}
unset multiplot
