# SPDX-License-Identifier: Apache-2.0
# The table of coupled_work_precision, from timing.csv and means.csv: levels NAME = VALUE of the variation as two columns, CPU time
# [s] a run.
FNR == 1 { ++file; head = 0 }
/^#/ { next }
!head { head = 1; split("", at); for (i = 1; i <= NF; ++i) at[$i] = i; next }
file == 1 { seconds[$(at["point"])] += $(at["cpu_s"]); ++timed[$(at["point"])]; next }
{
  split($(at["variation"]), name, " = ")
  quantity = $(at["quantity"])
  mean[name[1], quantity] = $(at["mean"]); error[name[1], quantity] = $(at["standard_error"])  # the last of a group stays
  group[++rows] = name[1]; of[rows] = quantity; own_mean[rows] = $(at["mean"]); own_error[rows] = $(at["standard_error"])
  row[rows] = sprintf("%s,%s,%s,%.4g,%s,%s,%s", name[1], name[2], quantity, seconds[$(at["point"])] / timed[$(at["point"])], $(at["mean"]),
    $(at["standard_error"]), $(at["runs"]))
}
END {
  print "# error: of the mean, against the last of the group (gas: of step), with its standard error"
  print "varied,value,quantity,cpu_s,mean,standard_error,runs,error,error_standard_error"
  for (i = 1; i <= rows; ++i) {
    base = group[i] == "gas" ? "step" : group[i]
    m = mean[base, of[i]]; d = own_mean[i] / m - 1
    printf "%s,%.3g,%.3g\n", row[i], d < 0 ? -d : d, sqrt(own_error[i] ^ 2 + error[base, of[i]] ^ 2) / m
  }
}
