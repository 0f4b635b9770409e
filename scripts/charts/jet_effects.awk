# SPDX-License-Identifier: Apache-2.0
# What the jet changes: from means.csv of a study whose first factor has levels NAME = VALUE (or NAME alone) and whose second,
# jet, those of `with` and `without`. -v first=HEADING of the names. Columns: name, value, quantity, means and standard errors
# with and without jet, fewest runs of both, difference, in standard errors, decided (more than 5 of them, at least 16 runs).
/^#/ { next }
!head {
  head = 1
  for (i = 1; i <= NF; ++i) at[$i] = i
  print first ",value,quantity,mean_jet,standard_error_jet,mean_no_jet,standard_error_no_jet,runs,difference,standard_errors,decided"
  next
}
$(at["mean"]) == "" { next }  # of an event that did not occur
{ key = $2 "," $(at["quantity"]) }
$(at["jet"]) == "with" { mean[key] = $(at["mean"]); error[key] = $(at["standard_error"]); runs[key] = $(at["runs"]); next }
key in mean {
  cut = index($2, " = ")
  s = sqrt(error[key] ^ 2 + $(at["standard_error"]) ^ 2)
  d = mean[key] - $(at["mean"])
  n = s > 0 ? (d < 0 ? -d : d) / s : 0
  fewest = runs[key] < $(at["runs"]) ? runs[key] : $(at["runs"])
  decided = n > 5 && fewest >= 16 ? "yes" : "no"
  printf "%s,%s,%.6g,%.3g,%.6g,%.3g,%d,%.6g,%.3g,%s\n", cut ? substr($2, 1, cut - 1) "," substr($2, cut + 3) : $2 ",-", $(at["quantity"]),
    mean[key], error[key], $(at["mean"]), $(at["standard_error"]), fewest, d, n, decided
}
