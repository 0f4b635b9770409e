# SPDX-License-Identifier: Apache-2.0
# The table of impulse_limits, from means.csv: levels NAME = VALUE of the variation as two columns.
/^#/ { next }
!head { head = 1; for (i = 1; i <= NF; ++i) at[$i] = i; print "varied,value,scene,quantity,mean,standard_error,runs"; next }
{
  sub(/ = /, ",", $2)
  printf "%s,%s,%s,%.6g,%.3g,%d\n", $2, $(at["scene"]), $(at["quantity"]), $(at["mean"]), $(at["standard_error"]), $(at["runs"])
}
