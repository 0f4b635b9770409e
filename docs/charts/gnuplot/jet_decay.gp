# SPDX-License-Identifier: Apache-2.0
# Constants of the jet model against measured bands. usage: gnuplot -e "data='FOLDER'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
set terminal svg size 1000,760 font face background paper
set output out
constants = data.'/constants.csv'
velocity = 'centreline_velocity_m_s'
set label 1 'The jet model far from the outlet, and measured jets'
set multiplot layout 2,2 margins 0.085,0.985,0.075,0.94 spacing 0.1,0.11

set key top right Left reverse samplen 3
set xlabel 'Distance from the outlet [diameters]'
set ylabel 'V_{max} / V_0, round'
set yrange [0:1.3]
set ytics 0.2
plot data.'/round_0.08.csv' using 'distance_m':(column('distance_m') < 15 ? NaN : 5.7/column('distance_m')):(6.2/(column('distance_m') - 4)) with filledcurves linecolor rgb measured title 'measured, B 5.7 to 6.2', \
     data.'/round_0.066.csv' using 'distance_m':velocity with lines linestyle 2 title 'a = 0.066', \
     data.'/round_0.08.csv' using 'distance_m':velocity with lines linestyle 1 title 'a = 0.08'
unset label 1

set xlabel 'Coefficient a'
set xrange [0.06:0.125]
set ylabel 'Decay constant B, V_{max}/V_0 = B D/(z + z_0)'
set yrange [3.5:8.5]
set ytics 1
plot constants using 1:(5.7):(6.2) with filledcurves linecolor rgb measured title 'measured, round', \
     constants using 'spread':'round_decay_constant' with lines linestyle 1 title 'model, round: 0.48/a'

set key top left
set ylabel 'Growth of the half-velocity width, d y_{1/2} / d z'
set yrange [0.04:0.2]
set ytics 0.02
plot constants using 1:(0.086):(0.102) with filledcurves linecolor rgb measured title 'measured, round', \
     constants using 'spread':'round_half_width_slope' with lines linestyle 1 title 'model, round', \
     constants using 1:(0.10) with linespoints linecolor rgb quiet pointtype 6 pointinterval 8 title 'measured, plane', \
     constants using 'spread':'plane_half_width_slope' with lines linestyle 2 title 'model, plane'

set ylabel 'Entrainment, d(Q/Q_0) / d(z/D)'
set yrange [0.2:0.6]
set ytics 0.05
plot constants using 1:(0.32) with lines linecolor rgb measured linewidth 6 title 'measured, round', \
     constants using 'spread':'round_entrainment_slope' with lines linestyle 1 title 'model, round: 4 a/0.96'
unset multiplot
