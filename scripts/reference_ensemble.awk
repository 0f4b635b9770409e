# SPDX-License-Identifier: Apache-2.0
# From ensemble.csv (mean and standard error of each column) the reference of a chaotic scene: the mean, and as band four standard
# deviations of a single run, the largest within 10 rows. Variables: runs, stride, scene, file, made.
/^#/ { if ($0 !~ /^# (date|options|case):/) print; next }
!columns {
  columns = (NF - 1) / 2
  for (i = 1; i <= columns; i++) { name[i] = $(2 * i); sub(/_mean$/, "", name[i]) }
  next
}
{
  time[++rows] = $1
  for (i = 1; i <= columns; i++) { text[rows, i] = $(2 * i); mean[rows, i] = $(2 * i) + 0; width[rows, i] = 4 * sqrt(runs) * $(2 * i + 1) }
}
function band(r, i,   k, most) {
  for (k = r - 10; k <= r + 10; k++) if (k >= 1 && k <= rows && width[k, i] > most) most = width[k, i]
  return most > 1e-12 * top[i] ? most : 1e-12 * top[i]
}
# As wide as the signal for half of the rows and more: no band.
function tells(i,   r, low, high, wide) {
  low = high = mean[1, i]
  for (r = 1; r <= rows; r++) {
    if (mean[r, i] < low) low = mean[r, i]
    if (mean[r, i] > high) high = mean[r, i]
    top[i] = (high > -low ? high : -low)
  }
  for (r = 1; r <= rows; r++) wide += band(r, i) >= high - low
  return 2 * wide < rows && name[i] !~ /_elements$/
}
END {
  print "# scene: " scene "\n# case: " file "\n# made by: scripts/reference_set.sh" made
  print "# bands: four standard deviations of a run, the largest within 10 rows of the ensemble"
  for (i = 1; i <= columns; i++) told[i] = tells(i)
  printf "time_s"
  for (i = 1; i <= columns; i++) printf ",%s%s", name[i], told[i] ? "," name[i] "_band" : ""
  print ""
  for (r = 1; r <= rows; r++) {
    if ((r - 1) % stride && r < rows) continue
    printf "%s", time[r]
    for (i = 1; i <= columns; i++) printf ",%s%s", text[r, i], told[i] ? sprintf(",%.3g", band(r, i)) : ""
    print ""
  }
}
