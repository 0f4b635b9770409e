# SPDX-License-Identifier: Apache-2.0
# Rows of ensemble_convergence.gp, from the table read twice: y, label, deviation [%] of the mean with jet from that of the
# default (amplitude of 1e-4 m), two standard errors, the same without jet; -v quantity=NAME. A gap parts the groups.
BEGIN {
  y = 0
  OFS = ","
  text["seed"] = "amplitude %s m"
  text["step"] = "step %s of critical"
  text["contact"] = "contact stiffness × %s"
  text["contact_10970"] = "stiffness × %s on 10970 elements"
  text["mesh"] = "%s elements"
}
# Friction is physics: its row is in the table alone.
$3 != quantity || $1 == "friction" { next }
NR == FNR {
  if ($1 == "seed" && $2 == "1e-4") { jet = $4; bare = $6 }
  next
}
{
  if (before && $1 != before) y += 0.55
  before = $1
  print y, sprintf(text[$1], $2), 100 * ($4 / jet - 1), 200 * $5 / jet, 100 * ($6 / bare - 1), 200 * $7 / bare
  y += 1
}
