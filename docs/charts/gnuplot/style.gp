# SPDX-License-Identifier: Apache-2.0
# The style sheet of every chart: what all of them share, loaded first. Colours are those of Okabe and Ito, which
# colour-blind readers tell apart; each has a dash and a mark of its own, so a print without colour reads too.
face = 'sans-serif,13'       # font of a chart
small_face = 'sans-serif,11' # font of a chart of many panels
paper = '#ffffff'
ink = '#222222'
blue = '#0072b2'
vermilion = '#d55e00'
green = '#009e73'
purple = '#aa4499'
sky = '#56b4e9'
quiet = '#767676'    # what is only there for comparison
measured = '#dddddd' # bands of measurements and tolerances
blue_band = '#b9d9ec'
vermilion_band = '#f6cdb0'

set datafile separator ','
set datafile commentschars '#'
set encoding utf8
set border 3 linecolor rgb ink
set tics nomirror
set grid linecolor rgb '#c8c8c8' linewidth 0.5 dashtype 3
set style fill solid 1 noborder
set style line 1 linecolor rgb blue linewidth 2.2 dashtype 1 pointtype 7 pointsize 0.7
set style line 2 linecolor rgb vermilion linewidth 2.2 dashtype 2 pointtype 5 pointsize 0.7
set style line 3 linecolor rgb green linewidth 2 dashtype 4 pointtype 9 pointsize 0.8
set style line 4 linecolor rgb ink linewidth 1.6 dashtype 3 pointtype 6 pointsize 0.8
set style line 5 linecolor rgb purple linewidth 1.6 dashtype 5 pointtype 4 pointsize 0.7
set style line 6 linecolor rgb sky linewidth 1.6 dashtype 1 pointtype 8 pointsize 0.8
set key noautotitle
# The title of a chart: `set label 1 'TEXT'`, left above it. What `set title` says is the name of a panel, centred.
set label 1 '' at screen 0.015, screen 1 offset 0, -1.2 font 'sans-serif,15'
