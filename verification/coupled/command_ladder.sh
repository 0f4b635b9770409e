# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Part of command_test.sh (sourced): the ladder.

# chart_is_of FOLDER: the picture numbers and names the rungs that the table has on the front.
chart_is_of() {
  local number name
  awk -F, '/^#/ { next } !at { for (i = 1; i <= NF; ++i) if ($i == "front") at = i; next } $at > 0 { print $at "|" $1 }' \
    "$1/ladder.csv" | sort -n >"$work/front"
  [ -s "$work/front" ] || fail "no front in $1/ladder.csv"
  while IFS='|' read -r number name; do
    grep -q ">$number  $name<" "$1/ladder.svg" || fail "the chart in $1 does not name '$number  $name'"
  done <"$work/front"
  [ "$(grep -cE '>[0-9]+  [^<]*<' "$1/ladder.svg")" = "$(wc -l <"$work/front")" ] || fail "the chart in $1 names more than the front"
}

part_ladder() {
  local tank=$source/cases/rigid_tank.toml bag=("$source/cases/jet_bag.toml" --set membrane.mesh.levels=2 --quantity pressure)
  expect 0 "cheapest within 2 %: " "$gasjet" ladder "$tank" --quantity pressure --out "$work/tank"
  chart_is_of "$work/tank"
  expect 0 "" "$gasjet" run "$work/tank/cheapest.toml" --out "$work/run" --quiet
  grep -q '^0.1,586098.3333' "$work/run/history.csv" || fail "the cheapest rung is not the tank"
  expect 0 "jet off .* inside" "$gasjet" ladder "${bag[@]}" --out "$work/bag" --tolerance 10%
  grep -q '^rigid tank,1,' "$work/bag/ladder.csv" || fail "no row of the tank"
  grep -q '^volume by pressure,1,' "$work/bag/ladder.csv" || fail "no row of the bag without a membrane"
  chart_is_of "$work/bag"
  grep -q '"verdict": "inside"' "$work/bag/ladder.json" || fail "no verdict"
  expect 0 "" "$gasjet" run "$work/bag/cheapest.toml" --out "$work/run" --quiet
  expect 4 "undecided: no rung" "$gasjet" ladder "${bag[@]}" --out "$work/bag" --tolerance 1e-5 --hold pieces
  # Seeds hardly scatter this pressure: single runs, unless more are allowed where a verdict is open.
  expect 0 "only: single runs" "$gasjet" ladder "${bag[@]}" --out "$work/single" --tolerance 5% --hold mesh,pieces,step,gas
  expect 4 "means of 2 to 4 runs" "$gasjet" ladder "${bag[@]}" --out "$work/means" --tolerance 5% \
    --hold mesh,pieces,step,gas --runs 2 --most-runs 4
  [ -e "$work/bag/cheapest.toml" ] && fail "the cheapest rung of an earlier ladder stayed"
  cp "$tank" "$work/bag/cheapest.toml"
  expect 2 "--out .*/bag: cheapest.toml is there, and no run is known to have written it" "$gasjet" ladder "$tank" --quantity pressure --out "$work/bag"
  cmp "$tank" "$work/bag/cheapest.toml" || fail "a cheapest.toml of the user's was overwritten"
  [ -z "$("$gasjet" ladder "$tank" --quantity pressure --out "$work/tank" --quiet 2>&1)" ] || fail "--quiet prints"
  # Without gnuplot, and with one that ends badly.
  mkdir -p "$work/none" "$work/bad"
  printf '#!/bin/sh\necho half >ladder.svg\nexit 1\n' >"$work/bad/gnuplot"
  chmod +x "$work/bad/gnuplot"
  local path
  for path in none bad; do
    expect 0 "no chart: gnuplot.*; its commands are in .*/tank/ladder.gp" \
      env PATH="$work/$path" "$gasjet" ladder "$tank" --quantity pressure --quiet --out "$work/tank"
    [ -e "$work/tank/ladder.svg" ] && fail "a chart that is not of this ladder is there"
  done
  grep -q '^plot' "$work/tank/ladder.gp" || fail "no commands of the chart"
  # One that never ends goes with Ctrl-C.
  printf '#!/bin/sh\n: >begun\nexec sleep 100\n' >"$work/bad/gnuplot"
  rm -f "$work/tank/begun"
  PATH="$work/bad:$PATH" "$gasjet" ladder "$tank" --quantity pressure --quiet --out "$work/tank" >"$work/hung" 2>&1 </dev/null &
  local hung=$! tries=0 from
  until [ -e "$work/tank/begun" ] || [ $tries -ge 300 ]; do sleep 0.1; tries=$((tries + 1)); done
  from=$SECONDS
  kill -INT $hung
  wait $hung
  grep -q "gnuplot did not end" "$work/hung" || fail "nothing says that gnuplot did not end: $(cat "$work/hung")"
  ((SECONDS - from < 15)) || fail "Ctrl-C waits for gnuplot"
  expect 4 "undecided: pressure_Pa is 101325 in the full case" "$gasjet" ladder "$source/cases/tank_blowdown.toml" \
    --quantity pressure --quiet --out "$work/at_ambient"
  expect 4 "undecided: pressure_Pa is 101325 in the full case" "$gasjet" ladder "$tank" --quantity pressure --quiet \
    --set inflator.0.start_time=5 --out "$work/tank"
  grep -q '"reason": "pressure_Pa is' "$work/tank/ladder.json" || fail "no reason in ladder.json"
  grep -Eiq '(^|,)-?(nan|inf)' "$work/tank/ladder.csv" && fail "nan or inf in ladder.csv"
  [ -e "$work/tank/ladder.gp" ] && fail "the chart of an earlier ladder stayed"
  expect 3 "rung \"full\".*limit" "$gasjet" ladder "$source/cases/tank_fixed_steps.toml" --quantity pressure \
    --set time.gas_step=4e-3 --quiet --out "$work/limit"
  # Interrupted: what was computed is kept, and says what it is.
  "$gasjet" ladder "$source/cases/passenger_pendulum.toml" --quantity pendulum_angle --out "$work/tank" >"$work/interrupted" 2>&1 </dev/null &
  local pid=$! code=0 waited=0
  until [ -s "$work/interrupted" ] || [ $waited -ge 300 ]; do sleep 0.1; waited=$((waited + 1)); done
  kill -INT $pid
  wait $pid || code=$?
  [ $code = 130 ] || fail "an interrupted ladder ends with $code"
  grep -q "interrupted: .*ladder.csv, the same command goes on" "$work/interrupted" || fail "nothing says where the partial ladder is"
  grep -q '^# status: interrupted' "$work/tank/ladder.csv" || fail "the partial ladder does not say so"
  grep -q '"status": "interrupted"' "$work/tank/ladder.json" || fail "ladder.json does not say that it is partial"
  "$gasjet" ladder "$tank" --quantity pressure --out "$work/tank" --quiet || fail "no ladder after an interrupted one"
  grep -q '^# status' "$work/tank/ladder.csv" && fail "the partial ladder outlives a whole one"
  [ -e "$work/tank/journal.jsonl" ] && fail "the journal outlives a whole ladder"
  local tolerance
  for tolerance in "" 0 -1% nan inf 2%% two 200%; do
    expect 2 "--tolerance.*such as 0.02 or 2%" "$gasjet" ladder "$tank" --quantity pressure --tolerance="$tolerance" --out "$work/out"
  done
  expect 2 "--quantity angle: the scene has none" "$gasjet" ladder "$tank" --quantity angle --out "$work/out"
  expect 2 "--quantity is required" "$gasjet" ladder "$tank" --out "$work/out"
  expect 2 "--hold mesh: .*allowed are gas" "$gasjet" ladder "$tank" --quantity pressure --hold mesh --out "$work/out"
  expect 2 "--hold '': a name is empty, allowed are gas" "$gasjet" ladder "$tank" --quantity pressure --hold gas, --out "$work/out"
  expect 2 "--unset scene.x: the case has no such key" "$gasjet" ladder "$tank" --quantity pressure --unset scene.x --out "$work/out"
  mkdir -p "$work/way/ladder.csv"
  expect 2 "--out .*/way: ladder.csv is there, and no run is known to have written it" "$gasjet" ladder "$tank" --quantity pressure --out "$work/way"
  expect 2 "--runs" "$gasjet" ladder "$tank" --quantity pressure --runs 1 --out "$work/out"
  [ -e "$work/out" ] && fail "bad input wrote $work/out"
}
