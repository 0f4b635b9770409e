# SPDX-License-Identifier: Apache-2.0
# Deviation of ensemble means from those of the default, a row for each variation. usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
load 'docs/charts/gnuplot/rows.gp'
set terminal svg size 1100,580 font small_face background paper
set output out
# y, label, deviation with jet [%], its two standard errors, the same without jet
rows(quantity) = "< docs/charts/gnuplot/rows.py convergence ".data." ".quantity
set yrange [18.8:-0.8]
set multiplot
quantities = 'final_angle_rad contact_impulse_Ns peak_cg_acceleration_cfc180_m_s2 peak_cg_acceleration_m_s2'
titles = "'Final angle' 'Contact impulse' 'Peak acceleration, CFC 180' 'Peak acceleration, raw'"
left = 0.215
panels = 4
set bmargin at screen 0.09
set tmargin at screen 0.885
set label 1 'Means of the paper’s scene against those of its default'
set xlabel 'Deviation from the default [%]'
set arrow 1 from first 0, graph 0 to first 0, graph 1 nohead linestyle 9
do for [i = 1:4] {
  set lmargin at screen panel_left(i)
  set rmargin at screen panel_right(i)
  step = i < 3 ? 2 : i == 3 ? 5 : 20
  set xtics step
  set title word(titles, i) offset 0, -0.5
  if (i == 1) { set key at screen 0.985, screen 0.985 right top vertical maxrows 1 width -2 samplen 2 } else { unset key; unset label 1 }
  if (i == 1) {
    plot rows(word(quantities, i)) using 3:1:4:yticlabels(2) with xerrorbars linestyle 1 title 'with jet, mean ± 2 s.e.', \
      '' using 5:($1 + 0.32):6 with xerrorbars linecolor rgb vermilion linewidth 2.2 pointtype 4 pointsize 0.7 title 'without jet'
  } else {
    set format y ''
    plot rows(word(quantities, i)) using 3:1:4 with xerrorbars linestyle 1, \
      '' using 5:($1 + 0.32):6 with xerrorbars linecolor rgb vermilion linewidth 2.2 pointtype 4 pointsize 0.7
  }
}
unset multiplot
