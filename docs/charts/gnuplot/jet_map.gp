# SPDX-License-Identifier: Apache-2.0
# The jet's effect on three quantities of the paper's scene, a row for each value of an invented input.
# usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
load 'docs/charts/gnuplot/rows.gp'
set terminal svg size 1000,560 font small_face background paper
set output out
# y, label, effect, two standard errors; a gap parts the inputs
rows(quantity, factor) = "< docs/charts/gnuplot/rows.py effects ".data." ".quantity." ".sprintf('%.9g', factor)
set yrange [25.4:0.2]
quantities = 'final_angle_rad path_impulse_Ns peak_cg_acceleration_cfc180_m_s2'
titles = "'on the final angle [°]' 'on the impulse along the path [N s]' 'on the peak acceleration, CFC 180 [m/s²]'"
array factor[3] = [180 / pi, 1, 1]
left = 0.18
panels = 3
set multiplot
set bmargin at screen 0.1
set tmargin at screen 0.905
set label 1 'What the jet adds, over the range of each input that the paper does not state (± 2 s.e.; dashed: as shipped)'
do for [i = 1:3] {
  set lmargin at screen panel_left(i)
  set rmargin at screen panel_right(i)
  set xlabel word(titles, i)
  set xrange [0:*]
  shipped = factor[i] * real(system("docs/charts/gnuplot/rows.py cell ".data." difference 'input=as shipped' quantity=".word(quantities, i)))
  set arrow 2 from first shipped, graph 0 to first shipped, graph 1 nohead linecolor rgb quiet linewidth 1.2 dashtype 2
  if (i == 1) {
    plot rows(word(quantities, i), factor[i]) using 3:1:4:yticlabels(2) with xerrorbars linestyle 1
    unset label 1
    set format y ''
  } else {
    plot rows(word(quantities, i), factor[i]) using 3:1:4 with xerrorbars linestyle 1
  }
}
unset multiplot
