# SPDX-License-Identifier: Apache-2.0
# From means.csv of a study with the levels `INPUT: END` and `as shipped`: rows label, lower and upper difference in degrees, their
# standard errors, the texts of both ends; the first for the scene as shipped, then the widest first. An input with one END goes
# from as shipped to it, and has no text there.
BEGIN { degrees = 180 / atan2(0, -1) }
/^#/ { next }
!heads { for (i = 1; i <= NF; i++) at[$i] = i; heads = 1; next }
$at["quantity"] != "final_angle_rad" || $at["difference"] == "" { next }
{
  text = $at["input"]; value = degrees * $at["difference"]; error = degrees * $at["difference_standard_error"]
  if (text == "as shipped") { shipped = value; shipped_error = error; next }
  split(text, part, ": ")
  if (!(part[1] in ends)) { order[++inputs] = part[1]; low[part[1]] = 1e9; high[part[1]] = -1e9 }
  ends[part[1]]++
  if (value < low[part[1]]) { low[part[1]] = value; low_error[part[1]] = error; low_text[part[1]] = part[2] }
  if (value > high[part[1]]) { high[part[1]] = value; high_error[part[1]] = error; high_text[part[1]] = part[2] }
}
END {
  print "as shipped", shipped, shipped, shipped_error, shipped_error, "", ""
  for (k = 1; k <= inputs; k++) {
    name = order[k]
    if (shipped > high[name]) { high[name] = shipped; high_error[name] = shipped_error; high_text[name] = "" }
    if (shipped < low[name]) { low[name] = shipped; low_error[name] = shipped_error; low_text[name] = "" }
    width[name] = high[name] - low[name]
  }
  for (k = 1; k <= inputs; k++) {
    widest = ""
    for (i = 1; i <= inputs; i++) if (!(order[i] in done) && (widest == "" || width[order[i]] > width[widest])) widest = order[i]
    done[widest]
    print widest, low[widest], high[widest], low_error[widest], high_error[widest], low_text[widest], high_text[widest]
  }
}
