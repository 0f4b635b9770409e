# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Part of command_test.sh (sourced): the ladder.

part_ladder() {
  local tank=$source/cases/rigid_tank.toml bag=("$source/cases/jet_bag.toml" --set membrane.mesh.levels=2 --quantity pressure)
  expect 0 "cheapest within 2 %: " "$gasjet" ladder "$tank" --quantity pressure --out "$work/tank"
  expect 0 "" "$gasjet" run "$work/tank/cheapest.toml" --out "$work/run" --quiet
  grep -q '^0.1,586098.3333' "$work/run/history.csv" || fail "the cheapest rung is not the tank"
  expect 0 "jet off .* inside" "$gasjet" ladder "${bag[@]}" --out "$work/bag" --tolerance 10%
  grep -q '^rigid tank,1,' "$work/bag/ladder.csv" || fail "no row of the tank"
  grep -q '"verdict": "inside"' "$work/bag/ladder.json" || fail "no verdict"
  expect 0 "" "$gasjet" run "$work/bag/cheapest.toml" --out "$work/run" --quiet
  expect 4 "undecided: no rung" "$gasjet" ladder "${bag[@]}" --out "$work/bag" --tolerance 1e-5 --hold pieces
  [ -e "$work/bag/cheapest.toml" ] && fail "the cheapest rung of an earlier ladder stayed"
  cp "$tank" "$work/bag/cheapest.toml"
  expect 2 "--out .*/bag: would overwrite cheapest.toml, which no ladder wrote" "$gasjet" ladder "$tank" --quantity pressure --out "$work/bag"
  cmp "$tank" "$work/bag/cheapest.toml" || fail "a cheapest.toml of the user's was overwritten"
  [ -z "$("$gasjet" ladder "$tank" --quantity pressure --out "$work/tank" --quiet 2>&1)" ] || fail "--quiet prints"
  expect 4 "undecided: pressure_Pa is 101325 in the full case" "$gasjet" ladder "$tank" --quantity pressure --quiet \
    --set inflator.0.start_time=5 --out "$work/nothing"
  grep -q '"reason": "pressure_Pa is' "$work/nothing/ladder.json" || fail "no reason in ladder.json"
  grep -Eiq '(^|,)-?(nan|inf)' "$work/nothing/ladder.csv" && fail "nan or inf in ladder.csv"
  expect 3 "rung \"full\".*limit" "$gasjet" ladder "$source/cases/tank_fixed_steps.toml" --quantity pressure \
    --set time.gas_step=4e-3 --quiet --out "$work/limit"
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
  expect 2 "--out .*/way: ladder.csv is there and not writable" "$gasjet" ladder "$tank" --quantity pressure --out "$work/way"
  expect 2 "--runs" "$gasjet" ladder "$tank" --quantity pressure --runs 1 --out "$work/out"
  [ -e "$work/out" ] && fail "bad input wrote $work/out"
}
