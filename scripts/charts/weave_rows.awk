# SPDX-License-Identifier: Apache-2.0
# The table of weave, from means.csv: a row for each bag; the pressure over the ambient 101325 Pa.
/^#/ { next }
!head { head = 1; for (i = 1; i <= NF; ++i) at[$i] = i; print "fabric,refine,peak_overpressure_Pa,peak_volume_m3,peak_strap_force_N"; next }
{ value[$(at["quantity"])] = $(at["mean"]) }
$(at["quantity"]) == "max(strap_force_N)" {
  printf "%s,%s,%.6g,%.6g,%.6g\n", $(at["fabric"]), $(at["refine"]), value["peak_pressure_Pa"] - 101325, value["peak_volume_m3"],
    value["max(strap_force_N)"]
}
