# SPDX-License-Identifier: Apache-2.0
# The reference of a chaotic scene from two files ensemble.csv: of runs at half the step, and of those that the reference is the
# mean of. Beside each column: its standard error, the scatter of a run (standard deviation), and as band the error of the step, 4/3
# of the change when it is halved as the scheme is of order 2, the largest within 20 rows. Numbers of elements jump, now and then in
# one run of many, so their band is five times their largest scatter; that of a single row, as where the flow ends, is its own.
# Variables: scene, file, made.
/^# runs: / { runs = $0; sub(/^# runs: /, "", runs) }
/^#/ {
  if (FNR != NR && $0 !~ /^# (run|status|date|options|case|runs):/) print
  next
}
FNR == NR {
  if (!halved_heads++) next
  for (i = 1; i <= NF; i++) halved[FNR, i] = $i
  halved_rows++
  order[halved_rows] = FNR
  next
}
!columns {
  columns = (NF - 1) / 2
  for (i = 1; i <= columns; i++) { name[i] = $(2 * i); sub(/_mean$/, "", name[i]) }
  next
}
{
  time[++rows] = $1
  if (halved[order[rows], 1] != $1) { print scene ": the times of both ensembles differ" >"/dev/stderr"; bad = 1; exit 1 }
  for (i = 1; i <= columns; i++) {
    mean[rows, i] = $(2 * i); error[rows, i] = $(2 * i + 1)
    change[rows, i] = halved[order[rows], 2 * i] - $(2 * i)
    if (change[rows, i] < 0) change[rows, i] = -change[rows, i]
    if (rows > 2) {
      middle = median(error[rows - 2, i], error[rows - 1, i], error[rows, i])
      if (middle > widest[i]) widest[i] = middle
    }
    size = mean[rows, i] < 0 ? -mean[rows, i] : mean[rows, i]
    if (size > top[i]) top[i] = size
  }
}
function median(a, b, c) { return a < b ? (b < c ? b : (a < c ? c : a)) : (a < c ? a : (b < c ? c : b)) }
function band(r, i,   k, most) {
  if (name[i] ~ /_elements$/) return 5 * sqrt(runs) * (error[r, i] > widest[i] ? error[r, i] : widest[i])
  for (k = r - 20; k <= r + 20; k++) if (k >= 1 && k <= rows && change[k, i] > most) most = change[k, i]
  return 4 / 3 * most
}
# Less than 1e-9 of the column's size is round-off.
function short(value, i) { return value + 0 < 1e-9 * top[i] ? "0" : sprintf("%.3g", value) }
END {
  if (bad) exit 1
  print "# scene: " scene "\n# case: " file "\n# made by: scripts/reference_set.sh" made "\n# runs: " runs
  print "# initial shape: membrane.perturbation=1e-4 membrane.perturbation_seed=1001"
  print "# standard error: of the mean; scatter: standard deviation of a run"
  print "# bands: 4/3 of the change of the means when the step is halved, the largest within 20 rows"
  print "# bands of numbers of elements: five times their largest scatter, in a row that scatters alone its own"
  printf "time_s"
  for (i = 1; i <= columns; i++) printf ",%s,%s_standard_error,%s_scatter,%s_band", name[i], name[i], name[i], name[i]
  print ""
  for (r = 1; r <= rows; r++) {
    printf "%.10g", time[r]
    for (i = 1; i <= columns; i++)
      printf ",%.7g,%s,%s,%s", mean[r, i], short(error[r, i], i), short(error[r, i] * sqrt(runs), i), short(band(r, i), i)
    print ""
  }
}
