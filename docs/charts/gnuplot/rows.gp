# SPDX-License-Identifier: Apache-2.0
# Shared by the charts with a row for each variation (loaded after style.gp): tables of y, label, value and half width of its
# bar, panels side by side, names of the rows left of the first one.
set border 1
set grid xtics noytics
set ytics scale 0
set style line 9 linecolor rgb quiet linewidth 1

# row_panel: edges of the next panel, numbers of `panels` panels between `left` and 0.985 of the width
panel_left(i) = left + (i - 1) * (0.985 - left) / panels
panel_right(i) = panel_left(i) + (0.985 - left) / panels - 0.022
