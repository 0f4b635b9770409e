# SPDX-License-Identifier: Apache-2.0
# The table of first_contact_seed, from means.csv.
/^#/ { next }
!head { head = 1; for (i = 1; i <= NF; ++i) at[$i] = i; print "elements,seed_m,first_contact_s,standard_error_s,runs"; next }
{ printf "%d,%s,%.6g,%.3g,%d\n", $(at["elements"]), $(at["seed_m"]), $(at["mean"]), $(at["standard_error"]), $(at["runs"]) }
