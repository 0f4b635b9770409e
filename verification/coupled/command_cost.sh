# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Parts of command_test.sh (sourced): what a case costs.

# adds_up FILE: in each row of cost.csv the stages are the step, the steps are the run, and the ratio is that of the runs
adds_up() {
  grep -v '^#' "$1" | awk -F, '
    function near(a, b) { return a - b < 1e-4 * b && b - a < 1e-4 * b }
    NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
    { sum = 0; for (name in at) if (name ~ /^S[0-9]+_.*_us$/ || name == "rest_us") sum += $at[name] }
    $1 == "as it is" { base = $at["cpu_s"] }
    !near(sum, $at["us_per_step"]) || !near(1e-6 * sum * $at["steps"], $at["cpu_s"]) { print "sum of " $0; bad = 1 }
    !near(base * $at["ratio"], $at["cpu_s"]) { print "ratio of " $0; bad = 1 }
    !($at["cpu_s"] > 0 && $at["median_cpu_s"] >= $at["cpu_s"] && $at["largest_cpu_s"] >= $at["median_cpu_s"]) { print "order of " $0; bad = 1 }
    END { exit bad || NR < 2 }' || fail "numbers of $1 do not add up"
}

# value FILE VARIANT COLUMN
value() {
  grep -v '^#' "$1" | awk -F, -v variant="$2" -v column="$3" \
    'NR == 1 { for (i = 1; i <= NF; i++) if ($i == column) at = i } $1 == variant { print $at }'
}

part_cost() {
  local case=$source/cases/passenger_pendulum.toml variant json short=(--set scene.end_time=0.006)
  expect 0 "a run with jet over one without: .*3803 s / 2072 s = 1.84" \
    bash -c "'$gasjet' cost '$case' ${short[*]} --runs 3 --out '$work/cost' 2>&1 | tr '\n' ' '"
  adds_up "$work/cost/cost.csv"
  for variant in "as it is" "without jet" "without hidden-element test" "hidden elements by CGAL's tree" \
    "without pendulum and contact" "gas to 1e-6" "without files"; do
    [ "$(value "$work/cost/cost.csv" "$variant" runs)" = 3 ] || fail "3 runs of '$variant'"
    grep -qF "$variant" "$work/cost/cost.txt" || fail "no '$variant' in cost.txt"
  done
  # A run of a variant is a run of the command: as many steps.
  "$gasjet" run "$case" "${short[@]}" --unset inflator.0.jet --quiet --out "$work/run"
  grep -q "\"steps\": $(value "$work/cost/cost.csv" "without jet" steps)," "$work/run/summary.json" || fail "steps without jet"
  # A stage costs only where it has work to do, and the slow route is slow in the test of hidden elements.
  [ "$(value "$work/cost/cost.csv" "without jet" S6_jet_field_us)" = 0 ] || fail "a field without jet"
  [ "$(value "$work/cost/cost.csv" "without jet" S7_visibility_us)" = 0 ] || fail "a test without jet"
  [ "$(value "$work/cost/cost.csv" "without pendulum and contact" S4_contact_us)" = 0 ] || fail "contact without pendulum"
  awk -v slow="$(value "$work/cost/cost.csv" "hidden elements by CGAL's tree" S7_visibility_us)" \
    -v fast="$(value "$work/cost/cost.csv" "as it is" S7_visibility_us)" 'BEGIN { exit !(slow > 5 * fast && fast > 0) }' || fail "the slow route's time"
  # That route is nearly all of its run, whatever other programs do meanwhile.
  awk -v rest="$(value "$work/cost/cost.csv" "hidden elements by CGAL's tree" rest_us)" \
    -v all="$(value "$work/cost/cost.csv" "hidden elements by CGAL's tree" us_per_step)" 'BEGIN { exit !(rest < 0.2 * all) }' || fail "a rest beside the slow route"
  expect 0 "^without jet " "$gasjet" cost "$case" "${short[@]}" --runs 3 --quiet
  # Its JSON: parts are differences of variants.
  json=$("$gasjet" cost "$case" "${short[@]}" --runs 3 --quiet --format json)
  python3 - "$json" <<'END' || fail "JSON: $json"
import json, sys
cost = json.loads(sys.argv[1])
least = {v["variant"]: v["cpu_s"]["least"] for v in cost["variants"]}
for v in cost["variants"]:
    assert abs(sum(v["stage_cpu_s"].values()) - v["cpu_s"]["least"]) < 1e-9, v
    assert len(v["cpu_s"]["runs"]) == 3 and min(v["cpu_s"]["runs"]) == v["cpu_s"]["least"], v
jet = cost["parts"]["jet"]
assert abs(jet["cpu_s"] - (least["as it is"] - least["without jet"])) < 1e-12
assert abs(jet["by_steps_s"] + jet["by_cost_of_a_step_s"] - jet["cpu_s"]) < 1e-12
assert abs(sum(jet["stage_cpu_s"].values()) - jet["cpu_s"]) < 1e-9
assert abs(jet["run_ratio"] - least["as it is"] / least["without jet"]) < 1e-9
assert jet["stage_cpu_s"]["S7_visibility"] > 0
assert set(cost["parts"]) == {"jet", "hidden-element test", "pendulum and contact", "files and rows", "gas"}
assert cost["elements"] == 2744 and cost["left_out"] == []
END
  # A scene without jet, pendulum or mesh.
  expect 0 "left out: without jet: the scene has none" "$gasjet" cost "$source/cases/rigid_tank.toml" --runs 3 --out "$work/tank"
  adds_up "$work/tank/cost.csv"
  [ "$(value "$work/tank/cost.csv" "without jet" runs)" = "" ] || fail "a tank has no jet"
  expect 0 "left out: without jet: the scene is nothing else" "$gasjet" cost "$source/cases/plate_jet.toml" --runs 3
  # What goes with the pendulum: channel classes, and sensors of its contact, without which the case is another one.
  local quick=(--unset inflator.0.jet --set scene.end_time=2e-4 --runs 3 --quiet)
  expect 0 "^without pendulum and contact " "$gasjet" cost "$case" "${quick[@]}" --set output.channel_classes=[60,180]
  expect 0 "left out: without pendulum and contact: a sensor waits for the contact" \
    "$gasjet" cost "$source/cases/contact_vent.toml" --set scene.end_time=2e-4 --runs 3 --quiet
  # What is wrong is refused, and nothing is written.
  expect 2 "no_such.toml: no such file" "$gasjet" cost "$work/no_such.toml" --out "$work/none"
  expect 2 "--runs.*2.*3" "$gasjet" cost "$case" --runs 2 --out "$work/none"
  expect 2 "--runs" "$gasjet" cost "$case" --runs many --out "$work/none"
  expect 2 "--format" "$gasjet" cost "$case" --format yaml --out "$work/none"
  expect 2 "fabric.thickness: is -1" "$gasjet" cost "$case" --set fabric.thickness=-1 --out "$work/none"
  [ ! -e "$work/none" ] || fail "something is written"
  expect 2 "rigid_tank.toml" "$gasjet" cost "$source/cases/rigid_tank.toml" --runs 3 --out "$source/cases/rigid_tank.toml"
  # A step above its bound: the message stands for the numbers.
  expect 3 "as it is: stage S.*is unstable: the limit" "$gasjet" cost "$source/cases/sphere_inflation.toml" --runs 3 --set time.step=1e-3
}
