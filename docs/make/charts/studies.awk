# SPDX-License-Identifier: Apache-2.0
# The tables that studies.sh's plans make of means.csv (coupled_work_precision: of timing.csv and means.csv). usage: awk -F, -v study=NAME
# -f docs/make/charts/studies.awk FILE...
#   jet_map, ensemble_convergence  what the jet changes: means and standard errors with and without jet, fewest runs of both,
#     difference, in standard errors, decided (more than 5 of them, at least 16 runs)
#   runs_needed  scatter: standard deviation of a run; runs_for_1_percent: for two standard errors of 1 % of the mean;
#     runs_for_effect: of 5 % of the difference; two at least, since one has no standard error
#   coupled_work_precision  CPU time [s] of a run; error: of the mean against the last of its group
#   mesh_parts  a row for each mesh; its elements are counted in the file that charts.sh has made
#   weave  a row for each bag; the pressure over the ambient 101325 Pa
#   speed_accuracy  the jet's effect; bias: less that of the finest meshes (limits in docs/charts/mesh_limits.csv), with its standard
#     error; scatter of a pair of runs, with and without jet; CPU time [s] of a pair; pairs that a minute has, and the error of
#     their mean: root of the squares of bias and standard error
#   the others  the columns that are needed
# Levels NAME = VALUE are two columns, VALUE alone `-` where there is none.
BEGIN {
  effects = ",value,quantity,mean_jet,standard_error_jet,mean_no_jet,standard_error_no_jet,runs,difference,standard_errors,decided"
  heads["jet_map"] = "input" effects
  heads["ensemble_convergence"] = "varied" effects
  heads["impulse_limits"] = "varied,value,scene,quantity,mean,standard_error,runs"
  heads["first_contact_seed"] = "elements,seed_m,first_contact_s,standard_error_s,runs"
  heads["mesh_parts"] = "part,elements,contact_impulse_Ns,standard_error_Ns,final_angle_rad,standard_error_rad,runs"
  heads["weave"] = "fabric,refine,peak_overpressure_Pa,peak_volume_m3,peak_strap_force_N"
  heads["runs_needed"] = "friction,jet,quantity,mean,scatter,runs,runs_for_1_percent,runs_for_effect"
  heads["coupled_work_precision"] = \
    "# error: of the mean, against the last of the group (gas: of step), with its standard error\n" \
    "varied,value,quantity,cpu_s,mean,standard_error,runs,error,error_standard_error"
  heads["speed_accuracy"] = "variation,effect_rad,bias_rad,bias_error_rad,scatter_rad,cpu_s,pairs_in_a_minute,error_rad"
  if (!(study in heads)) { print "studies.awk: no study '" study "'" >"/dev/stderr"; exit 2 }
  print heads[study]
}
FNR == 1 { head = 0 }
/^#/ { next }
!head { head = 1; split("", at); for (i = 1; i <= NF; ++i) at[$i] = i; next }

function of(column) { return $(at[column]) }
function two_columns(level,   cut) {
  cut = index(level, " = ")
  return cut ? substr(level, 1, cut - 1) "," substr(level, cut + 3) : level ",-"
}
function abs(x) { return x < 0 ? -x : x }
function needed(runs, ratio,   n) {
  n = runs * ratio * ratio
  n = n > int(n) ? int(n) + 1 : int(n)
  return n < 2 ? 2 : n
}

heads[study] ~ /mean_no_jet/ {
  if (of("mean") == "") next  # of an event that did not occur
  key = $2 "," of("quantity")
  if (of("jet") == "with") { mean[key] = of("mean"); error[key] = of("standard_error"); runs[key] = of("runs"); next }
  if (!(key in mean)) next
  s = sqrt(error[key] ^ 2 + of("standard_error") ^ 2)
  d = mean[key] - of("mean")
  n = s > 0 ? abs(d) / s : 0
  fewest = runs[key] < of("runs") ? runs[key] : of("runs")
  decided = n > 5 && fewest >= 16 ? "yes" : "no"
  printf "%s,%s,%.6g,%.3g,%.6g,%.3g,%d,%.6g,%.3g,%s\n", two_columns($2), of("quantity"), mean[key], error[key], of("mean"),
    of("standard_error"), fewest, d, n, decided
}
study == "impulse_limits" {
  printf "%s,%s,%s,%.6g,%.3g,%d\n", two_columns($2), of("scene"), of("quantity"), of("mean"), of("standard_error"), of("runs")
}
study == "first_contact_seed" {
  printf "%d,%s,%.6g,%.3g,%d\n", of("elements"), of("seed_m"), of("mean"), of("standard_error"), of("runs")
}
study == "mesh_parts" && of("quantity") == "contact_impulse_Ns" { impulse = sprintf("%.6g,%.3g", of("mean"), of("standard_error")) }
study == "mesh_parts" && of("quantity") == "final_angle_rad" {
  count_faces = "grep -c '^f' 'results/studies/mesh_parts/" of("part") "_design.obj'"
  count_faces | getline elements
  printf "%s,%d,%s,%.6g,%.3g,%d\n", of("part"), elements, impulse, of("mean"), of("standard_error"), of("runs")
}
study == "weave" {
  value[of("quantity")] = of("mean")
  if (of("quantity") == "max(strap_force_N)")
    printf "%s,%s,%.6g,%.6g,%.6g\n", of("fabric"), of("refine"), value["peak_pressure_Pa"] - 101325, value["peak_volume_m3"],
      value["max(strap_force_N)"]
}
study == "runs_needed" {
  effect = of("difference") == "" ? "" : needed(of("pairs"), 2 * of("difference_standard_error") / (0.05 * of("difference")))
  printf "%s,%s,%s,%.6g,%.3g,%d,%d,%s\n", of("friction"), of("jet"), of("quantity"), of("mean"), of("standard_error") * sqrt(of("runs")),
    of("runs"), needed(of("runs"), 2 * of("standard_error") / (0.01 * of("mean"))), effect
}
"cpu_s" in at { seconds[of("point")] += of("cpu_s"); ++timed[of("point")]; next }
study == "speed_accuracy" {
  both[of("variation")] += seconds[of("point")] / timed[of("point")]
  if (of("jet") != "with") next
  way[++ways] = of("variation"); size[ways] = of("difference")
  size_error[ways] = of("difference_standard_error"); pairs[ways] = of("pairs")
}
study == "coupled_work_precision" {
  group[++rows] = substr($2, 1, index($2, " = ") - 1); quantity[rows] = of("quantity")
  own[rows] = of("mean"); own_error[rows] = of("standard_error")
  last[group[rows], of("quantity")] = of("mean"); last_error[group[rows], of("quantity")] = of("standard_error")
  row[rows] = sprintf("%s,%s,%.4g,%s,%s,%s", two_columns($2), of("quantity"), seconds[of("point")] / timed[of("point")], of("mean"),
    of("standard_error"), of("runs"))
}
function limit_of_effect(   line, cell) {
  while ((getline line < "docs/charts/mesh_limits.csv") > 0) {
    split(line, cell, ",")
    if (cell[2] != "final_angle_rad") continue
    limit += (cell[1] == "jet" ? 1 : -1) * cell[5]
    limit_error = sqrt(limit_error ^ 2 + cell[7] ^ 2)
  }
}
END {
  if (ways) limit_of_effect()
  for (i = 1; i <= ways; ++i) {
    scatter = size_error[i] * sqrt(pairs[i]); bias = size[i] - limit; minute = int(60 / both[way[i]])
    printf "%s,%.6g,%.4g,%.3g,%.4g,%.4g,%d,%.4g\n", way[i], size[i], bias, sqrt(size_error[i] ^ 2 + limit_error ^ 2), scatter,
      both[way[i]], minute, sqrt(bias ^ 2 + scatter ^ 2 / minute)
  }
  for (i = 1; i <= rows; ++i) {
    key = (group[i] == "gas" ? "step" : group[i]) SUBSEP quantity[i]
    printf "%s,%.3g,%.3g\n", row[i], abs(own[i] / last[key] - 1), sqrt(own_error[i] ^ 2 + last_error[key] ^ 2) / last[key]
  }
}
