# SPDX-License-Identifier: Apache-2.0
# Deviation of the coupled scene's ensemble means from those of the reference, and CPU time, a row for each variation.
# usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
load 'docs/charts/gnuplot/rows.gp'
set terminal svg size 1100,480 font small_face background paper
set output out
# y, label, deviation from the last of the group (gas: of step) [%], two standard errors, CPU time [s]; a gap parts the groups
rows(quantity) = "< docs/charts/gnuplot/rows.py work_precision ".data." ".quantity
set yrange [13.8:0.4]
set multiplot
quantities = 'final_angle_rad path_impulse_Ns peak_cg_acceleration_cfc180_m_s2'
titles = "'Final angle' 'Impulse along the path' 'Peak acceleration, CFC 180'"
left = 0.2
panels = 4
set bmargin at screen 0.12
set tmargin at screen 0.85
set label 1 'Finer steps, gas tolerances and meshes: the means against those of the finest step and mesh'
set xlabel 'Deviation [%], ± 2 s.e.'
set arrow 1 from first 0, graph 0 to first 0, graph 1 nohead linestyle 9
set xrange [-6:12]
set xtics 3
do for [i = 1:3] {
  set lmargin at screen panel_left(i)
  set rmargin at screen panel_right(i)
  set title word(titles, i) offset 0, -0.5
  if (i == 1) {
    plot rows(word(quantities, i)) using 3:1:4:yticlabels(2) with xerrorbars linestyle 1
  } else {
    unset label 1
    set format y ''
    plot rows(word(quantities, i)) using 3:1:4 with xerrorbars linestyle 1
  }
}
unset arrow 1
set lmargin at screen panel_left(4)
set rmargin at screen panel_right(4)
set title 'Cost' offset 0, -0.5
set xlabel 'CPU time of a run [s]'
set xrange [0:*]
set xtics 0.5
plot rows(word(quantities, 1)) using (0):1:5:(0) with vectors nohead linecolor rgb sky linewidth 6, \
  '' using 5:1 with points linestyle 1
unset multiplot
