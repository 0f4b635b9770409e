# SPDX-License-Identifier: Apache-2.0
# How many runs numbers need, from means.csv of a study with differences. scatter: standard deviation of a run. runs_for_1_percent:
# for two standard errors of 1 % of the mean; runs_for_effect: of 5 % of the difference. Two runs at least, since one has no
# standard error.
function needed(runs, ratio,    n) {
  n = runs * ratio * ratio
  n = n > int(n) ? int(n) + 1 : int(n)
  return n < 2 ? 2 : n
}
/^#/ { next }
!head {
  head = 1
  for (i = 1; i <= NF; ++i) at[$i] = i
  print "friction,jet,quantity,mean,scatter,runs,runs_for_1_percent,runs_for_effect"
  next
}
{
  mean = $(at["mean"]); error = $(at["standard_error"]); runs = $(at["runs"]); difference = $(at["difference"])
  effect = difference == "" ? "" : needed($(at["pairs"]), 2 * $(at["difference_standard_error"]) / (0.05 * difference))
  printf "%s,%s,%s,%.6g,%.3g,%d,%d,%s\n", $(at["friction"]), $(at["jet"]), $(at["quantity"]), mean, error * sqrt(runs), runs,
    needed(runs, 2 * error / (0.01 * mean)), effect
}
