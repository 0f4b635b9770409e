# SPDX-License-Identifier: Apache-2.0
# Mass flow through a hole and through fabric against pressure difference. usage: gnuplot -e "data='X.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
set terminal svg size 820,460 font face background paper
set output out
set label 1 'Nitrogen of 673 K through 8.5 dm² of hole and of fabric'
set tmargin 3
set key left top Left reverse samplen 3
set xlabel 'Pressure difference [kPa]'
set ylabel 'Mass flow [kg/s]'
sonic = 90.476 # [kPa], of gamma 1.4 to 101325 Pa
set arrow from sonic, graph 0 to sonic, graph 1 nohead linecolor rgb quiet dashtype 3
set label 'sonic' at sonic - 1, graph 0.3 right textcolor rgb quiet
plot data using ($1 / 1e3):2 with lines linestyle 1 title 'hole', \
  '' using ($1 / 1e3):3 with lines linestyle 2 title 'fabric, flow over η²', \
  '' using ($1 / 1e3):(100 * $4) with lines linestyle 3 title 'fabric of porosity η = 0.05, flow times 100'
