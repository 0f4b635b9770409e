# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Parts of command_test.sh (sourced): studies.

# bag_plan FILE SEEDS: the paper's scene for 4 ms, with and without its jet
bag_plan() {
  cat >"$1" <<END
[study]
case = "$source/cases/passenger_pendulum.toml"
set = ["scene.end_time=0.004"]
quantities = ["peak_pressure_Pa", "jet_force_N", "first_contact_s"]
seeds = $2

[[factor]]
name = "jet"
[[factor.level]]
name = "yes"
[[factor.level]]
name = "no"
unset = ["inflator.0.jet"]

[analysis.base]
factor = "jet"
level = "no"
END
  sed -i 's/"jet_force_N", //' "$1" # a column of one level only
}

# tank_plan FILE LINES...: a tank, whose closed form is known, with lines for [study] and tables
tank_plan() {
  printf '[study]\ncase = "%s/cases/rigid_tank.toml"\nquantities = ["pressure_Pa"]\n' "$source" >"$1"
  printf '%s\n' "${@:2}" >>"$1"
}

same_study() { # same_study FOLDER FOLDER [FILE...]: but for what a build that is not committed says of itself
  local file
  for file in results.csv means.csv "${@:3}"; do
    cmp <(grep -v '^# run' "$1/$file") <(grep -v '^# run' "$2/$file") || fail "$file of $1 and $2"
  done
}

part_study() {
  local plan=$work/thrice.toml share pid
  bag_plan "$plan" 6
  expect 0 "12 of 12 runs: 12 done" "$gasjet" study run "$plan" --out "$work/alone"
  expect 0 "12 of 12 runs: 12 done" "$gasjet" study run "$plan" --out "$work/threads" --threads 2
  same_study "$work/alone" "$work/threads" study.json
  [ "$(grep -c '^0,[1-6],yes,.*,done,[0-9]*,$' "$work/alone/results.csv")" = 6 ] || fail "rows of point 0"
  grep -Eq '^0,yes,peak_pressure_Pa(,[-0-9.e]+){2},6(,[-0-9.e]+){2},6,0(,[-0-9.e]+){2}$' "$work/alone/means.csv" || fail "a mean with its difference"
  # All seeds are common: the mean of the differences is the difference of the means.
  awk -F, '$3 == "peak_pressure_Pa" { mean[$2] = $4; if ($2 == "yes") difference = $7 }
    END { d = mean["yes"] - mean["no"]; exit !(d != 0 && (difference - d) ^ 2 < 1e-18 * mean["no"] ^ 2) }' "$work/alone/means.csv" ||
    fail "differences: $(grep -v '^#' "$work/alone/means.csv")"
  # A run of the study is a run of the command.
  "$gasjet" run "$source/cases/passenger_pendulum.toml" --quiet --out "$work/run" --set scene.end_time=0.004 \
    --set membrane.perturbation=1e-4 --set membrane.perturbation_seed=3
  local peak
  peak=$(sed -n 's/^0,3,yes,\([0-9.]*\),.*/\1/p' "$work/alone/results.csv")
  grep -q "\"pressure_Pa\": $peak" "$work/run/summary.json" || fail "seed 3: $peak is not the peak of the run"
  # Shares in any order, one of them twice and with another count in between.
  for share in 3/3 1/2 1/3 1/3 2/3; do
    expect 0 "" "$gasjet" study run "$plan" --out "$work/shares" --share $share --quiet
  done
  expect 0 "12 of 12 runs" "$gasjet" study merge "$work/shares"
  same_study "$work/alone" "$work/shares" study.json
  grep -q '"study": "thrice"' "$work/shares/study.json" || fail "the name is lost"
  expect 0 "goes on after 12 runs" "$gasjet" study run "$plan" --out "$work/alone"
  # Killed: what had ended is there, what had not is computed, and an incomplete folder says so.
  bag_plan "$work/long.toml" 40
  "$gasjet" study run "$work/long.toml" --out "$work/killed" --quiet &
  pid=$!
  until_there grep -q '"run":2,' "$work/killed/shares/1_of_1/journal.jsonl"
  expect 2 "another command is writing" "$gasjet" study run "$work/long.toml" --out "$work/killed"
  kill -KILL $pid
  wait $pid 2>/dev/null
  printf '{"run":7,"status":"do' >>"$work/killed/shares/1_of_1/journal.jsonl" # torn
  expect 4 "of 80 runs" "$gasjet" study merge "$work/killed"
  grep -q '"not run yet: .*point 1 (.*), 40 seeds"' "$work/killed/study.json" || fail "missing runs are not named"
  grep -q '"status": "incomplete"' "$work/killed/study.json" || fail "not incomplete"
  expect 0 "goes on after .* 80 of 80 runs: 80 done" bash -c "'$gasjet' study run '$work/long.toml' --out '$work/killed' --threads 2 2>&1 | tr '\n' ' '"
  expect 0 "" "$gasjet" study run "$work/long.toml" --out "$work/whole" --quiet --threads 2
  same_study "$work/whole" "$work/killed"
  # A full disk costs the runs that do not fit.
  expect 3 "write failed" limited 1 "$gasjet" study run "$plan" --out "$work/full" --quiet
  expect 0 "12 of 12 runs" "$gasjet" study run "$plan" --out "$work/full"
  same_study "$work/alone" "$work/full"
}

part_study_designs() {
  local plan=$work/plan.toml
  # p - p0 of a filled tank grows as the mass flow: exact at any point.
  tank_plan "$plan" 'design = "sobol_indices"' 'points = 32' '[[factor]]' 'key = "inflator.0.mass_flow"' 'range = [0.05, 0.15]' \
    '[[factor]]' 'key = "ambient.temperature"' 'range = [290, 300]'
  expect 0 "128 of 128 runs" "$gasjet" study run "$plan" --out "$work/indices"
  awk -F, '$2 == "inflator.0.mass_flow" { if ($6 < 0.999 || $7 > 1.001 + ($8 - $7)) exit 1; n++ } $2 == "ambient.temperature" { if ($8 > 1e-6) exit 1; n++ }
    END { exit n != 2 }' "$work/indices/sobol.csv" || fail "indices: $(cat "$work/indices/sobol.csv")"
  tank_plan "$plan" 'design = "latin_hypercube"' 'points = 20' '[[factor]]' 'key = "inflator.0.mass_flow"' 'name = "flow"' 'range = [0.05, 0.15]' \
    '[analysis]' 'response_surface = true'
  expect 0 "20 of 20 runs" "$gasjet" study run "$plan" --out "$work/surface"
  # From end to end of the range: p at a flow of 0 is the constant less twice the slope.
  awk -F, '$2 == "flow * flow" { square = $3 } $2 == "flow" { slope = $3 } $2 == "1" { middle = $3 }
    END { start = middle - 2 * slope - 101325; exit !(slope > 1e4 && square ^ 2 < 1e-18 * slope ^ 2 && start ^ 2 < 1e-4) }' \
    "$work/surface/surface.csv" || fail "surface: $(cat "$work/surface/surface.csv")"
  tank_plan "$plan" 'design = "latin_hypercube"' 'points = 9' '[[factor]]' 'key = "ambient.temperature"' 'range = [290, 300]' '[analysis]' \
    'response_surface = true'
  expect 0 "surface.csv, pressure_Pa: no surface, it does not vary" "$gasjet" study run "$plan" --out "$work/flat"
  # A quantity that no run has: the bag does not touch.
  printf '%s\n' '[study]' "case = \"$source/cases/contact_vent.toml\"" 'set = ["scene.end_time=5e-4"]' 'quantities = ["first_contact_s"]' \
    'design = "latin_hypercube"' 'points = 9' '[[factor]]' 'key = "vent.0.area"' 'range = [1e-3, 2e-3]' '[analysis]' 'response_surface = true' >"$plan"
  expect 0 "surface.csv, first_contact_s: no surface, the 0 of 9 points" "$gasjet" study run "$plan" --out "$work/untouched"
  # Points of a file, written by another program.
  printf 'flow,other\n0.05,1\n0.1,2\n' >"$work/points.csv"
  tank_plan "$plan" 'design = "file"' 'file = "points.csv"' '[[factor]]' 'key = "inflator.0.mass_flow"' 'name = "flow"'
  expect 0 "2 of 2 runs" "$gasjet" study run "$plan" --out "$work/file"
  "$gasjet" run "$source/cases/rigid_tank.toml" --quiet --out "$work/run" --set inflator.0.mass_flow=0.1
  grep -q "^1,0,0.1,$(tail -n 1 "$work/run/history.csv" | cut -d, -f2),done" "$work/file/results.csv" || fail "the file's second point"
  # A point that leaves its domain is a row with its reason, and no mean has it.
  printf '[study]\ncase = "%s/cases/sphere_inflation.toml"\nset = ["scene.end_time=1e-3"]\n[[factor]]\nkey = "time.step"\nvalues = [1e-5, 1e-3]\n' \
    "$source" >"$plan"
  expect 3 "1 done, 0 inaccurate, 1 failed" "$gasjet" study run "$plan" --out "$work/failed"
  grep -q '^1,0,0.001,.*,failed,[0-9]*,.*is unstable: the limit' "$work/failed/results.csv" || fail "no reason: $(tail -n 1 "$work/failed/results.csv")"
  grep -q '"in_no_mean": 1' "$work/failed/study.json" || fail "how many are left out is not told"
  # Sizes to a limit: fixed steps of the classical method.
  tank_plan "$plan" '[[factor]]' 'key = "output.history_every"' 'values = [0.02, 0.01, 0.005]' '[analysis]' 'convergence = "output.history_every"'
  expect 0 "convergence.csv, pressure_Pa: no order, the means do not differ beyond .*rounding" "$gasjet" study run "$plan" --out "$work/limit"
  [ "$(tail -n 1 "$work/limit/convergence.csv")" = "pressure_Pa,,,,,,3" ] || fail "rounding has an order: $(tail -n 1 "$work/limit/convergence.csv")"
  grep -q '"convergence.csv, pressure_Pa: no order' "$work/limit/study.json" || fail "not told in study.json"
  printf '[study]\ncase = "%s/cases/tank_fixed_steps.toml"\nset = ["gas.initial.pressure=101325.0", "scene.end_time=0.002", "time.gas_method=euler"]\n' "$source" >"$plan"
  printf 'quantities = ["pressure_Pa"]\n[[factor]]\nkey = "time.gas_step"\nvalues = [2e-4, 1e-4, 5e-5]\n[analysis]\nconvergence = "time.gas_step"\n' >>"$plan"
  expect 0 "3 of 3 runs" "$gasjet" study run "$plan" --out "$work/euler"
  tail -n 1 "$work/euler/convergence.csv" | awk -F, '{ exit !($4 > 0.9 && $4 < 1.1) }' || fail "Euler's order: $(tail -n 1 "$work/euler/convergence.csv")"
  # A stop rule spends seeds where they are needed.
  bag_plan "$plan" 4
  printf '[stop]\nquantity = "peak_pressure_Pa"\nsign_error_rate = 0.01\nmost_seeds = 32\n' >>"$plan"
  expect 0 "8 of 8 runs.* stop rule: 1 decided, 0 not decided" bash -c "'$gasjet' study run '$plan' --out '$work/sign' | tr '\n' ' '"
  grep -q '"decided": 1,' "$work/sign/study.json" || fail "what is decided is not in study.json"
  sed -i 's/^sign_error.*/standard_error = 1e-9/; s/^most.*/most_seeds = 8/' "$plan"
  expect 0 "stop rule: 0 decided, 2 not decided not decided after 8 seeds: point 0 .yes., peak_pressure_Pa not decided after 8 seeds: point 1 .no., peak" \
    bash -c "'$gasjet' study run '$plan' --out '$work/error' | tr '\n' ' '"
  expect 0 "16 of 16 runs" "$gasjet" study merge "$work/error"
  grep -q '"not_decided": 2,' "$work/error/study.json" || fail "what is not decided is not in study.json"
  expect 2 "--share 1/2: a stop rule looks at all runs" "$gasjet" study run "$plan" --out "$work/error" --share 1/2
}

part_study_levels() {
  local plan=$work/plan.toml value
  # A level with fewer seeds and its own amplitude: its runs are those of the command.
  printf '[study]\ncase = "%s/cases/passenger_pendulum.toml"\nset = ["scene.end_time=0.004"]\nquantities = ["peak_pressure_Pa"]\nseeds = 3\n' \
    "$source" >"$plan"
  printf '[[factor]]\nname = "nodes"\n[[factor.level]]\nname = "usual"\n[[factor.level]]\nname = "few"\nseeds = 2\namplitude = 1e-6\n' >>"$plan"
  expect 0 "2 points, 1 factors, 5 runs" "$gasjet" study run "$plan" --check
  expect 0 "5 of 5 runs: 5 done" "$gasjet" study run "$plan" --out "$work/levels"
  for share in 2/2 1/2; do "$gasjet" study run "$plan" --out "$work/shares" --share $share --quiet || fail "share $share"; done
  expect 0 "5 of 5 runs" "$gasjet" study merge "$work/shares"
  same_study "$work/levels" "$work/shares" study.json
  grep -Eq '^1,few,peak_pressure_Pa,[-0-9.e]+,[-0-9.e]+,2,0(,[-0-9.e]+){2}$' "$work/levels/means.csv" || fail "runs of the level: $(cat "$work/levels/means.csv")"
  for value in 0,3,usual,1e-4 1,2,few,1e-6; do
    "$gasjet" run "$source/cases/passenger_pendulum.toml" --quiet --out "$work/run" --set scene.end_time=0.004 \
      --set membrane.perturbation="${value##*,}" --set membrane.perturbation_seed="$(cut -d, -f2 <<<"$value")"
    grep -q "\"pressure_Pa\": $(sed -n "s/^${value%,*},\([0-9.]*\),.*/\1/p" "$work/levels/results.csv")" "$work/run/summary.json" ||
      fail "$value is not the peak of the run"
  done
  # Numbers over the rows of the history.
  tank_plan "$plan" '[[factor]]' 'key = "inflator.0.mass_flow"' 'values = [0.1]'
  sed -i 's/"pressure_Pa"/"max(pressure_Pa)", "min(pressure_Pa)", "integral(pressure_Pa)"/' "$plan"
  expect 0 "1 of 1 runs" "$gasjet" study run "$plan" --out "$work/rows"
  "$gasjet" run "$source/cases/rigid_tank.toml" --quiet --out "$work/run" --set inflator.0.mass_flow=0.1
  awk -F, '
    /^#/ || $1 ~ /^(time_s|point)$/ { next }
    FILENAME ~ /history/ {
      if (rows++) { sum += ($1 - time) * ($2 + last) / 2; if ($2 > most) most = $2; if ($2 < least) least = $2 } else most = least = $2
      time = $1; last = $2; next }
    { exit !(rows > 2 && most > least && $4 == most && $5 == least && ($6 / sum - 1) ^ 2 < 1e-24) }' "$work/run/history.csv" "$work/rows/results.csv" ||
    fail "over the rows: $(tail -n 1 "$work/rows/results.csv")"
  # And of the energies at its end.
  sed -i 's/"max(pressure_Pa)".*/"inflow_enthalpy_J"]/' "$plan"
  expect 0 "1 of 1 runs" "$gasjet" study run "$plan" --out "$work/energies"
  [ "$(tail -n 1 "$work/energies/results.csv" | cut -d, -f4)" = "$(tail -n 1 "$work/run/energy.csv" | cut -d, -f4)" ] ||
    fail "at the end: $(tail -n 1 "$work/energies/results.csv")"
  sed -i 's/"inflow_enthalpy_J"/"max(pressure_Pa)"/' "$plan"
  sed -i 's/max(/mean(/' "$plan"
  expect 2 "holds \"mean.pressure_Pa.\", which the scene lacks; allowed are .*integral.. of a column" "$gasjet" study run "$plan" --out "$work/none"
}

# The plans that ship: each is taken, and the stiffness that they give to finer meshes is that of the case.
part_study_plans() {
  local plan stiffness
  cp -r "$source/cases" "$work/cases" # shorter, because a check computes two runs
  sed -i -E 's/^(end_time = )[0-9.e-]+/\11e-4/; s/scene.end_time=[0-9.e-]+/scene.end_time=1e-4/' "$work"/cases/*.toml "$work"/cases/studies/*.toml
  for plan in "$work"/cases/studies/*.toml; do
    if [[ $plan == */mesh_parts.toml ]]; then # its meshes are made before
      expect 2 "factor.0: with \"none\" the case is refused: .*none_design.obj" "$gasjet" study run "$plan" --check
      continue
    fi
    expect 0 "points, .* factors, .* runs" "$gasjet" study run "$plan" --check
  done
  stiffness=$("$gasjet" check "$source/cases/passenger_pendulum.toml" | sed -n 's/^contact stiffness: \([^ ]*\).*/\1/p')
  grep -hoE 'contact=\{stiffness=[^}]*' "$source"/cases/studies/*.toml | cut -d= -f3 | sort -u |
    awk -v one="$stiffness" '{ ++n; share = $1 / one; if (share != 0.5 && share != 1 && share != 4) { print $1 " for " one; bad = 1 } } END { exit bad || !n }' ||
    fail "the stiffness of a plan is no share of the case's"
}

part_study_bad() {
  local plan=$work/plan.toml at=$work/plan.toml
  refused() { expect 2 "$1" "$gasjet" study run "$plan" --out "$work/none"; [ ! -e "$work/none" ] || fail "something is written: $1"; }
  tank_plan "$plan" '[[factor]]' 'key = "inflator.0.mas_flow"' 'values = [1, 2]'
  refused "$at:4:1: factor.0: with \"1\" the case is refused: .*mas_flow"
  tank_plan "$plan" '[[factor]]' 'key = "inflator.0.mass_flow"' 'values = [1, -2]'
  refused "$at:4:1: factor.0: with \"-2\" the case is refused: .*mass_flow: is -2"
  tank_plan "$plan" 'design = "sobol"' '[[factor]]' 'key = "inflator.0.mass_flow"' 'range = [-1, 2]'
  refused "$at:5:1: factor.0: with \"-0.9.*\" the case is refused"
  tank_plan "$plan" 'design = "sobol"' '[[factor]]' 'key = "inflator.0.mass_flow"' 'range = [2, 1]'
  refused "$at:7:1: factor.0.range: is no range"
  tank_plan "$plan" 'design = "sobol"' '[[factor]]' 'key = "inflator.0.mass_flow"' 'values = [1, 2]'
  refused "$at:4:1: study.design: needs a range"
  tank_plan "$plan" 'design = "random"'
  refused "$at:4:1: study.design: is \"random\", one of"
  tank_plan "$plan" 'set = ["gas.foo=1"]'
  refused "$at:4:1: study.set: gas.foo=1: gas.foo: unknown key"
  tank_plan "$plan" 'unset = ["gas.foo"]'
  refused "$at:4:1: study.unset: gas.foo: the case has no such key"
  tank_plan "$plan" 'seeds = 4'
  refused "$at:4:1: study.seeds: perturb the nodes of a membrane"
  tank_plan "$plan" '[[factor]]' 'key = "inflator.0.mass_flow"' 'values = []'
  refused "$at:6:1: factor.0.values: is no array of one value"
  tank_plan "$plan" '[[factor]]' 'key = "inflator.0.mass_flow"' 'values = [1, 1.0]'
  refused "$at:4:1: factor.0: has the level \"1\" twice"
  tank_plan "$plan" '[[factor]]' 'kye = "inflator.0.mass_flow"'
  refused "$at:5:1: factor.0.kye: unknown key, .*; is 'key' meant\?"
  tank_plan "$plan" '[stop]' 'quantity = "mass"'
  refused "stop.quantity: is \"mass\", one of the study's is needed: pressure_Pa"
  tank_plan "$plan" '[analysis]' 'base = { factor = "x", level = "y" }'
  refused "analysis.base.factor: is \"x\", a factor is needed"
  # An analysis that cannot be made of the points.
  local flow=('[[factor]]' 'key = "inflator.0.mass_flow"') heat=('[[factor]]' 'key = "inflator.0.temperature"' 'values = [300, 400, 500]')
  tank_plan "$plan" "${flow[@]}" 'values = [1, 2, 3]' '[analysis]' 'response_surface = true'
  refused "$at:8:1: analysis.response_surface: of 1 factors has 3 terms and needs 4 points or more, the plan has 3"
  tank_plan "$plan" '[analysis]' 'response_surface = true'
  refused "$at:5:1: analysis.response_surface: needs factors"
  tank_plan "$plan" "${flow[@]}" 'values = [1, 2]' "${heat[@]}" '[[factor]]' 'key = "tank.volume"' 'values = [1, 2, 3]' '[analysis]' 'response_surface = true'
  refused "analysis.response_surface: has 10 terms that the points do not tell apart"
  tank_plan "$plan" 'design = "list"' "${flow[@]}" 'values = [1, 1.5, 2]' "${heat[@]}" '[analysis]' 'convergence = "inflator.0.temperature"'
  refused "analysis.convergence: needs 3 points or more that differ in the size alone"
  sed -i 's/^convergence.*/base = { factor = "inflator.0.temperature", level = "400" }/' "$plan"
  refused "$at:12:1: analysis.base: pairs no points: two are needed that differ in inflator.0.temperature alone"
  sed -i 's/"400"/"40"/' "$plan"
  refused "analysis.base.level: is \"40\", which the factor does not have: it has \"300\", \"400\", \"500\""
  tank_plan "$plan" '[[factor]]' 'name = "way"' '[[factor.level]]' 'name = "a"' '[[factor.level]]' 'name = "b"' '[analysis]' 'response_surface = true'
  refused "analysis.response_surface: needs factors that are numbers, way has levels"
  tank_plan "$plan" 'design = "sobol_indices"' 'points = 7' "${flow[@]}" 'range = [1, 2]'
  refused "$at:5:1: study.points: is 7, a whole number from 8 to 1000000"
  # Columns and keys are each of one factor.
  for name in seed quantity standard_error runs pressure_Pa; do
    tank_plan "$plan" "${flow[@]}" "name = \"$name\"" 'values = [1, 2]'
    refused "$at:6:1: factor.0.name: is \"$name\", which is another column of the results"
  done
  tank_plan "$plan" "${flow[@]}" 'values = [1, 2]' "${flow[@]}" 'name = "again"' 'values = [3, 4]'
  refused "$at:8:1: factor.1.key: sets again what inflator.0.mass_flow sets"
  # Larger than memory is.
  tank_plan "$plan" "${flow[@]}" "values = [$(seq -s , 4000)]" '[[factor]]' 'key = "inflator.0.temperature"' "values = [$(seq -s , 300 4299)]"
  refused "study.design: has 16000000 points or more of 1 runs each, at most 10000000 runs are allowed"
  tank_plan "$plan" 'seeds = 1000000' 'design = "sobol_indices"' 'points = 8' "${flow[@]}" 'range = [1, 2]'
  sed -i 's|rigid_tank|sphere_inflation|; s/"pressure_Pa"/"peak_pressure_Pa"/; s/inflator.0.mass_flow/gas.initial.temperature/; s/\[1, 2\]/[290, 300]/' "$plan"
  refused "study.design: has 24 points or more of 1000000 runs each"
  for name in ../x /x a/b . .. '' 'a\nb' "$(printf 'x%.0s' {1..256})"; do
    tank_plan "$plan" "name = \"$name\""
    refused "$at:4:1: study.name: is \".*\", a file name is allowed"
  done
  tank_plan "$plan" 'unknown = 1'
  refused "$at:4:1: study.unknown: unknown key"
  tank_plan "$plan" '[[factor]]' 'name = "a"' '[[factor.level]]' 'name = "b"' 'seeds = 2'
  refused "$at:6:1: factor.0.level.0: has seeds or an amplitude, which need study.seeds"
  bag_plan "$plan" 4
  sed -i 's/^name = "yes"/&\nseeds = 5/' "$plan"
  refused "factor.0.level.0.seeds: is 5, a whole number from 1 to 4"
  sed -i 's/^seeds = 5/set = ["membrane.perturbation=1e-3"]/' "$plan"
  refused "factor.0.level.0.set: holds \"membrane.perturbation=1e-3\", but seeds set the perturbation"
  sed -i 's/^set = \["membrane.*/seeds = 2/' "$plan"
  printf '[stop]\nquantity = "peak_pressure_Pa"\nstandard_error = 1\n' >>"$plan"
  refused "stop: decides on seeds, but the level \"yes\" has some of its own"
  printf '[study]\ncase = "%s/cases/rigid_tank.toml"\nquantities = ["final_angle_rad"]\n' "$source" >"$plan"
  refused "$at:3:1: study.quantities: holds \"final_angle_rad\", which the scene lacks"
  printf '[study]\ncase = "none.toml"\n' >"$plan"
  refused "none.toml: no such file"
  tank_plan "$plan"
  for share in 0/3 4/3 1 1/0 a/b 1/2/3; do expect 2 "--share $share: NUMBER/COUNT" "$gasjet" study run "$plan" --share $share; done
  local command
  for command in "study run /dev/null" "ladder /dev/null --quantity pressure" "ensemble /dev/null" "cost /dev/null"; do
    # shellcheck disable=SC2086
    expect 2 "/dev/null: is no regular file" "$gasjet" $command --out "$work/none"
  done
  expect 2 "holds no plan.toml" "$gasjet" study merge "$source/cases"
  expect 0 "1 points, 0 factors, 1 runs" "$gasjet" study run "$plan" --check
  # One folder, one plan.
  expect 0 "" "$gasjet" study run "$plan" --out "$work/one"
  tank_plan "$work/other.toml" '[[factor]]' 'key = "inflator.0.mass_flow"' 'values = [0.1, 0.2]'
  expect 2 "is another plan than" "$gasjet" study run "$work/other.toml" --out "$work/one"
}
