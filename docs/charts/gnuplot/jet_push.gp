# SPDX-License-Identifier: Apache-2.0
# Restitution that computed flows in closed cavities have, over injected by contained mass.
# usage: gnuplot -e "data='docs/data/jet_cavity_cfd.csv'; out='X.svg'"
load 'docs/charts/gnuplot/style.gp'
set terminal svg size 1000,470 font face background paper
set output out
# e at the middle of each window of a run
place(run) = strcol('case') eq run ? (column('mass_ratio_start') + column('mass_ratio_end'))/2 : NaN
deep = 'C_flat_8_6_q1 Ck_keps_8_6_q1 E_flat_6_3_q1'
compact = 'K_keps_4_6_q1 K2_keps_4_6_q1_fine Gk_keps_cap_4_6_q1 F3k_keps_4_6_q3 T_box3d_4_6_q1'
open = 'A0_flat_4_6_q1_coarse A1_flat_4_6_q1_med A_flat_4_6_q1 A5_flat_4_6_q1_dx1.5 D_flat_3_8_q1 F_flat_4_6_q2 G_cap_4_6_q1 I_sealed_4_6_q3'
# the range of a group after the first passes of the jet
later(group) = strcol('group') eq group && column('mass_ratio_start') > 0.3 ? column('restitution') : NaN
stats data using (later('deep')) name 'D' nooutput
stats data using (later('compact')) name 'C' nooutput

set label 1 'How much more than its thrust a jet pushes in a closed bag: e of (J.6), 16 computed flows'
set multiplot layout 1,2 margins 0.075,0.985,0.125,0.86 spacing 0.075,0
set xlabel 'Injected over contained mass'
set ylabel 'Restitution e'
set xrange [0:1.8]
set xtics 0.5
set yrange [-0.5:1.3]
set ytics 0.5
set key top right maxrows 2 samplen 2 font small_face
set title 'deep bags, and compact ones by k-ε or in three dimensions' offset 0,-0.6
set object 1 rectangle from 0.34,C_min to 1.8,C_max fillcolor rgb vermilion_band fillstyle solid 0.5 noborder behind
set object 2 rectangle from 0.34,D_min to 1.8,D_max fillcolor rgb blue_band fillstyle solid 0.5 noborder behind
set label 2 sprintf('compact, later: %.2f to %.2f', C_min, C_max) at 1.78,C_max right offset 0,-0.8 textcolor rgb vermilion font small_face
set label 3 sprintf('deep, later: %.2f to %.2f', D_min, D_max) at 1.78,D_max right offset 0,-0.8 textcolor rgb blue font small_face
set arrow 1 from 0,1 to 1.8,1 nohead linecolor rgb ink dashtype 3 linewidth 1.4
set arrow 2 from 0,0 to 1.8,0 nohead linecolor rgb ink dashtype 3 linewidth 1.4
set label 4 'the paper' at 0.02,1 offset 0,0.5 font small_face
set label 5 'plate in free air' at 1.78,0 right offset 0,0.5 font small_face
set label 11 'C' at 0.76,0.39 textcolor rgb blue
set label 12 'Ck' at 0.57,-0.06 textcolor rgb blue
set label 13 'E' at 1.77,-0.13 right textcolor rgb blue
set label 14 'K' at 0.85,0.51 textcolor rgb vermilion
set label 15 'K2' at 0.80,0.75 textcolor rgb vermilion
set label 16 'Gk' at 1.06,0.68 textcolor rgb vermilion
set label 17 'F3k' at 1.49,0.61 textcolor rgb vermilion
set label 18 'T' at 0.88,0.07 textcolor rgb vermilion
plot for [run in compact] data using (place(run)):'restitution' with linespoints linestyle 2 notitle, \
     for [run in deep] data using (place(run)):'restitution' with linespoints linestyle 1 notitle, \
     NaN with linespoints linestyle 2 title 'compact', NaN with linespoints linestyle 1 title 'deep'

do for [i=1:18] { unset label i }
unset object 1
unset object 2
unset key
set yrange [-0.5:3.5]
set title 'compact bags, axisymmetric, k-ω SST: not converged in grid'
set label 4 'the paper' at 0.02,1 offset 0,0.5 font small_face
set label 5 'plate in free air' at 1.78,0 right offset 0,0.5 font small_face
set label 21 'A0: 6 cells over the outlet' at 1.13,0.33 font small_face
set label 22 'A1: 12' at 1.14,2.55 font small_face
set label 23 'A: 16' at 1.14,3.05 font small_face
set label 24 'A5: 24' at 0.36,1.45 right font small_face
set label 25 'D' at 0.83,2.52 font small_face
set label 26 'F: pe/pa 2' at 1.78,2.05 right font small_face
set label 27 'G: cap' at 1.46,3.16 font small_face
set label 28 'I: sealed' at 0.53,1.12 font small_face
plot for [run in open] data using (place(run)):'restitution' with linespoints linecolor rgb quiet linewidth 1.6 pointtype 5 pointsize 0.5
unset multiplot
