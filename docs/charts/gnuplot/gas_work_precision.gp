# SPDX-License-Identifier: Apache-2.0
# Achieved error against CPU time of each method on each tank. usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
set terminal svg size 1050,700 font small_face background paper
set output out
set logscale xy
set format x '10^{%L}'
set format y '10^{%L}'
set yrange [1e-17:1e2]
set ytics 1e-16, 1e4, 1
set xlabel 'CPU time [µs]' offset 0, 0.3
set ylabel 'Achieved relative error' offset 1
unset key
# An exact answer is drawn at 1e-16.
rows(problem, solver) = "< docs/charts/gnuplot/rows.py where ".data." problem=".problem." solver=".solver
shown(error) = error < 1e-16 ? 1e-16 : error
solvers = 'dormand_prince rosenbrock runge_kutta euler msbdf cvode'
names = "'Dormand-Prince 5' 'Rosenbrock 4' 'Runge-Kutta 4' 'Euler' 'GSL msbdf' 'CVODE'"
set label 1 'Error of the gas solvers against cost, on six tanks'
set multiplot layout 2,3 margins 0.07,0.985,0.08,0.91 spacing 0.065,0.15
problems = 'filled_sealed filled_vented choked_blowdown equalisation tiny_volume three_pulses'
titles = "'filled, sealed' 'filled, vented' 'choked blow-down' 'equalisation' 'tiny volume' 'three pulses, vented'"
do for [i = 1:6] {
  set title word(titles, i) offset 0, -0.6
  if (i == 1) { set key center at graph 0.55, graph 0.6 samplen 4 spacing 1.1 } else { unset key }
  plot for [s = 1:6] rows(word(problems, i), word(solvers, s)) using 4:(shown($5)) with linespoints linestyle s title word(names, s)
  unset label 1
}
unset multiplot
