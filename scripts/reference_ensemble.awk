# SPDX-License-Identifier: Apache-2.0
# The reference of a chaotic scene from ensemble.csv (mean and standard error of each column), read after the history of the case as it
# is: the mean, and as band five standard deviations of a single run or, where that is more, twice what the case as it is, whose
# nodes are not displaced, differs from the mean; the largest within 20 rows. Variables: runs, stride, scene, file, made.
FNR == NR {
  if (/^#/) next
  if (!heads) { heads = NF; for (i = 2; i <= NF; i++) head[i] = $i; next }
  plain_time[++plain_rows] = $1
  for (i = 2; i <= NF; i++) plain[plain_rows, head[i]] = $i
  next
}
/^#/ { if ($0 !~ /^# (run|status|date|options|case):/) print; next }
!columns {
  columns = (NF - 1) / 2
  for (i = 1; i <= columns; i++) { name[i] = $(2 * i); sub(/_mean$/, "", name[i]) }
  at = 1
  next
}
function plain_value(t, column,   share) {
  while (at + 1 < plain_rows && plain_time[at + 1] < t) at++
  share = (t - plain_time[at]) / (plain_time[at + 1] - plain_time[at])
  return plain[at, column] + share * (plain[at + 1, column] - plain[at, column])
}
{
  time[++rows] = $1
  for (i = 1; i <= columns; i++) {
    text[rows, i] = $(2 * i); mean[rows, i] = $(2 * i) + 0
    width[rows, i] = 5 * sqrt(runs) * $(2 * i + 1)
    gap = 2 * (plain_value($1, name[i]) - mean[rows, i])
    if (gap < 0) gap = -gap
    if (gap > width[rows, i]) width[rows, i] = gap
    squares[i] += width[rows, i] ^ 2
  }
}
# Numbers of elements jump, now and then in one run of many: half the root mean square width at least.
function band(r, i,   k, most) {
  most = 1e-12 * top[i]
  if (name[i] ~ /_elements$/) most = sqrt(squares[i] / rows) / 2
  for (k = r - 20; k <= r + 20; k++) if (k >= 1 && k <= rows && width[k, i] > most) most = width[k, i]
  return most
}
# Not as wide as the signal for half of the rows and more.
function tells(i,   r, low, high, wide) {
  low = high = mean[1, i]
  for (r = 1; r <= rows; r++) {
    if (mean[r, i] < low) low = mean[r, i]
    if (mean[r, i] > high) high = mean[r, i]
    top[i] = (high > -low ? high : -low)
  }
  for (r = 1; r <= rows; r++) wide += band(r, i) >= high - low
  return 2 * wide < rows
}
END {
  for (i = 1; i <= columns; i++) if (!tells(i)) { print scene ": " name[i] " has a band as wide as the signal" >"/dev/stderr"; exit 1 }
  print "# scene: " scene "\n# case: " file "\n# made by: scripts/reference_set.sh" made
  print "# bands: five standard deviations of a run or twice what the case without displacements differs, the largest within 20 rows"
  print "# bands of numbers of elements: half their rms at least"
  printf "time_s"
  for (i = 1; i <= columns; i++) printf ",%s,%s_band", name[i], name[i]
  print ""
  for (r = 1; r <= rows; r++) {
    if ((r - 1) % stride && r < rows) continue
    printf "%s", time[r]
    for (i = 1; i <= columns; i++) printf ",%s,%.3g", text[r, i], band(r, i)
    print ""
  }
}
