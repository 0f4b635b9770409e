#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The gasjet command as a user meets it. Usage: command_test.sh GASJET SOURCE_DIR PART
set -u
gasjet=$1 source=$2 part=$3
work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT
failures=0

fail() { echo "FAILED: $*"; failures=$((failures + 1)); }

# expect CODE PATTERN COMMAND...: exit code and a pattern (extended regular expression) in what it prints
expect() {
  local code=$1 pattern=$2 output status
  shift 2
  output=$("$@" 2>&1 </dev/null)
  status=$?
  [ "$status" = "$code" ] || fail "exit $status, $code expected: $* : $output"
  grep -Eq -- "$pattern" <<<"$output" || fail "no '$pattern' in the output of $*: $output"
}

# lost COMMAND...: what cannot be printed is said, and told by the exit code
lost() {
  local error status
  error=$("$@" 2>&1 >/dev/full </dev/null)
  status=$?
  [ "$status" = 3 ] && grep -q "standard output: write failed" <<<"$error" || fail "exit $status with a full disk: $* : $error"
}

part_exit_codes() {
  expect 0 "done" "$gasjet" run "$source/cases/rigid_tank.toml" --out "$work/tank"
  for file in history.csv energy.csv summary.json; do [ -s "$work/tank/$file" ] || fail "no $file"; done
  expect 2 "^gasjet: .*not expected.*no-such-option" "$gasjet" run "$source/cases/rigid_tank.toml" --no-such-option
  expect 2 "^gasjet: .*subcommand is required" "$gasjet"
  expect 2 "^gasjet: 'no_such_command' is no command of gasjet, allowed are run, .*compare, .*\(see --help" "$gasjet" no_such_command
  expect 2 "^gasjet: 'nope' is no command of mesh, allowed are driver, passenger, convert, case" "$gasjet" mesh nope
  lost "$gasjet" check "$source/cases/rigid_tank.toml"
  lost "$gasjet" check "$source/cases/rigid_tank.toml" --format json
  lost "$gasjet" mesh passenger --out "$work/bag.obj"
  lost "$gasjet" exact tank_fill
  lost "$gasjet" --version
  expect 0 "ensemble" "$gasjet" --help
  expect 0 "gasjet [0-9]" "$gasjet" --version
  expect 3 "is unstable: the limit" "$gasjet" run "$source/cases/sphere_inflation.toml" --out "$work/bound" --set time.step=1e-3
  grep -q '"status": "failed"' "$work/bound/summary.json" || fail "no failed status"
  expect 3 "stage S" "$gasjet" run "$source/cases/sphere_inflation.toml" --out "$work/unsafe" \
    --set time.step=4e-4 --set time.unsafe_step=true --set gas.initial.pressure=121325.0
  [ "$(grep -vc '^#' "$work/unsafe/history.csv")" -gt 2 ] || fail "history of the blow-up is not kept"
  grep -Eiq 'nan|inf' <(grep -v '^#' "$work/unsafe/history.csv" | tail -n +2) && fail "nan or inf in the history"
  expect 0 "critical step .*fabric [0-9.e-]+, gas [0-9.e-]+, straps [0-9.e-]+, plate [0-9.e-]+\)" "$gasjet" check "$source/cases/passenger_pendulum.toml"
  expect 0 "critical step .*alone: fabric [0-9.e-]+, gas [0-9.e-]+\)" "$gasjet" check "$source/cases/sphere_inflation.toml"
  expect 0 "matters .* pressure on the impactor" "$gasjet" check "$source/cases/passenger_pendulum.toml"
  expect 0 "scene.end_time = 0.01" "$gasjet" check "$source/cases/rigid_tank.toml" --unset scene.end_time --set scene.end_time=0.01
  expect 2 "end_time: is missing" "$gasjet" check "$source/cases/rigid_tank.toml" --set scene.end_time=0.01 --unset scene.end_time
  expect 0 "does not fill the volume" "$gasjet" check "$source/cases/passenger_pendulum.toml" --set scene.end_time=0.001
  expect 0 "inflator 0: at its peak \(t = 0.012 s\) 4 kg/s at 406 K, R 296.8 J/\(kg K\), gamma 1.3995" "$gasjet" check "$source/cases/passenger_pendulum.toml"
  expect 0 "ambient.pressure \* = 101325$" "$gasjet" check "$source/cases/piston_leak.toml" # which names none
  expect 0 "vents: choked at the start, choked from 1918" "$gasjet" check "$source/cases/tank_blowdown.toml"
  expect 0 "done" "$gasjet" run "$source/cases/tank_backflow.toml" --out "$work/rest" --set time.gas_method=rosenbrock --set tank.volume=1e-3 --set vent.0.backflow=false --unset ambient.composition --unset ambient.composition_by --set gas.initial.temperature=200.5 --set gas.initial.pressure=101325.0 --set gas.heat_loss.outside_temperature=400.0
  expect 0 "warning: jet of inflator 0: the outlet pressure is below ambient" "$gasjet" run \
    "$source/cases/passenger_pendulum.toml" --out "$work/warned" --set scene.end_time=1e-4
  expect 0 "^warning: jet of inflator 0: the outlet" "$gasjet" run "$source/cases/passenger_pendulum.toml" --quiet --out "$work/warned" \
    --set scene.end_time=1e-4
  expect 0 "2744 elements" "$gasjet" mesh passenger --out "$work/bag.obj"
  expect 2 "not writable|No such|Permission|writ" "$gasjet" mesh passenger --out "$work/nowhere/bag.obj"
}

part_fields() {
  local short=(--set scene.end_time=2e-4 --quiet --out "$work/fields")
  expect 0 "" "$gasjet" run "$source/cases/sphere_inflation.toml" "${short[@]}" --set output.fields_every=1e-4
  [ "$(grep -c 'bag_0000[0-2].vtp' "$work/fields/fields.pvd")" = 3 ] || fail "frames at 0, 1e-4 and 2e-4 s expected"
  grep -q 'Name="principal_stress_Pa"' "$work/fields/bag_00002.vtp" || fail "no stress in the last frame"
  touch "$work/fields/bag_notes.vtp" "$work/fields/bag_00009.vtp" # the user's
  expect 0 "" "$gasjet" run "$source/cases/sphere_inflation.toml" "${short[@]}"
  [ "$(ls "$work/fields")" = "$(printf '%s\n' bag_00009.vtp bag_notes.vtp check.json energy.csv frames.bin gasjet.status history.csv summary.json)" ] ||
    fail "stale fields: $(ls "$work/fields")"
  expect 2 "bag_00009.vtp is there, and no run is known to have written it" "$gasjet" run \
    "$source/cases/sphere_inflation.toml" "${short[@]}" --set output.fields_every=1e-4
}

part_lost_output() {
  mkdir "$work/own"
  cp "$source/cases/tank_test_curves.csv" "$work/own/history.csv"
  cp "$source/cases/tank_test_curves.csv" "$work/own/ladder.csv"
  sed 's/tank_test_curves.csv/history.csv/' "$source/cases/tank_identified.toml" >"$work/own/run.toml"
  sed 's/tank_test_curves.csv/ladder.csv/' "$source/cases/tank_identified.toml" >"$work/own/ladder.toml"
  expect 2 "--out .*history.csv: would overwrite" "$gasjet" run "$work/own/run.toml" --out "$work/own"
  expect 2 "--out .*ladder.csv: would overwrite" "$gasjet" ladder "$work/own/ladder.toml" --quantity pressure --out "$work/own"
  cmp "$work/own/history.csv" "$source/cases/tank_test_curves.csv" || fail "an input was overwritten"
  mkdir -p "$work/way/summary.json" "$work/way/sphere_inflation/ensemble.json"
  expect 2 "--out .*/way: summary.json is there, and no run is known to have written it" "$gasjet" run \
    "$source/cases/rigid_tank.toml" --out "$work/way"
  expect 2 "ensemble.json is there, and no run" "$gasjet" ensemble "$source/cases/sphere_inflation.toml" --runs 2 --out "$work/way"
  expect 3 "no finite number" "$gasjet" run "$source/cases/plate_jet.toml" --out "$work/inf" --set inflator.0.mass_flow=1e300
  grep -Eiq '(^|,)-?(nan|inf)' <(grep -v '^#' "$work/inf/history.csv" | tail -n +2) && fail "nan or inf in the history"
  expect 0 "too coarse" "$gasjet" run "$source/cases/plate_jet.toml" --out "$work/coarse" --set target.rows=6 --set target.columns=6
  expect 0 "delivers nothing" "$gasjet" run "$source/cases/rigid_tank.toml" --out "$work/idle" --set inflator.0.start_time=5
}

part_bad_input() {
  local tank=$source/cases/rigid_tank.toml temperature
  expect 2 "inflator.0.jet.radius: makes an outlet of 0 m2" "$gasjet" check "$source/cases/jet_bag.toml" --set inflator.0.jet.radius=1e-200
  expect 3 "gas_step" "$gasjet" run "$source/cases/tank_fixed_steps.toml" --set time.gas_step=1e-9 --out "$work/small_steps"
  expect 2 "no such file" "$gasjet" run "$work/missing.toml" --out "$work/out"
  expect 2 "--set vent.0.area=1e-3: the case has no \[\[vent\]\]$" "$gasjet" check "$source/cases/rigid_tank.toml" --set vent.0.area=1e-3
  printf '[scene\nname = "x"\n' >"$work/syntax.toml"
  expect 2 "syntax.toml:1:[0-9]+: TOML syntax" "$gasjet" run "$work/syntax.toml" --out "$work/out"
  expect 2 "is a folder" "$gasjet" run "$work" --out "$work/out"
  expect 2 "unknown key" "$gasjet" run "$tank" --out "$work/out" --set scene.no_such_key=1
  expect 2 "unknown key" "$gasjet" run "$tank" --out "$work/out" --set no_such_table.key=1
  expect 2 "key.path=value" "$gasjet" run "$tank" --out "$work/out" --set novalue
  echo "file in the way" >"$work/file"
  expect 2 "--out" "$gasjet" run "$tank" --out "$work/file/below"
  expect 2 "--out" "$gasjet" run "$tank" --out /proc/no_such_folder
  expect 2 "--set scene.end_time=0.1,0.2" "$gasjet" run "$tank" --out "$work/out" --set scene.end_time=0.1,0.2
  expect 2 "--set a.b=1: a: unknown key" "$gasjet" run "$tank" --out "$work/out" --set a.b=1
  for temperature in 1e300 1e-300; do
    expect 2 "--set inflator.0.temperature=$temperature: inflator.0.temperature: .*1 to 1e5 .K." "$gasjet" run \
      "$source/cases/plate_jet.toml" --out "$work/out" --set inflator.0.temperature=$temperature
  done
  expect 2 "ambient.temperature: .*1 to 1e5 .K." "$gasjet" check "$tank" --set ambient.temperature=1e300
  expect 2 "gas.initial.temperature: .*1 to 1e5 .K." "$gasjet" check "$tank" --set gas.initial.temperature=1e300
  expect 2 "outside_temperature: .*1 to 1e5 .K." "$gasjet" check "$source/cases/tank_backflow.toml" --set gas.heat_loss.coefficient=1 \
    --set gas.heat_loss.area=1 --set gas.heat_loss.outside_temperature=1e300
  expect 2 "scene.end_time: is 9e-10, 1e-9 or more .s. is allowed" "$gasjet" check "$tank" --set scene.end_time=9e-10
  expect 2 "end_time: is missing, .* is needed; is 'end_tme' meant\?" "$gasjet" check "$tank" --unset scene.end_time --set scene.end_tme=1
  sed 's/^volume =/volumne =/' "$tank" >"$work/misspelt.toml"
  expect 2 "misspelt.toml:$(grep -n '^volumne' "$work/misspelt.toml" | cut -d: -f1):1: tank.volume: is missing, .*; is 'volumne' meant\?" "$gasjet" check "$work/misspelt.toml"
  expect 2 "volume: is missing, .* is needed; is 'voluem' meant\?" "$gasjet" check "$tank" --unset tank.volume --set tank.voluem=1
  # A misspelt table is named itself, not what its absence leaves another one without.
  for table in ambient gas fabric membrane pendulum contact inflator vent; do
    sed -E "s/^(\[+)$table\b/\1${table%?}/" "$source/cases/passenger_pendulum.toml" >"$work/misspelt.toml"
    expect 2 "misspelt.toml:[0-9]+:[0-9]+: ${table%?}: unknown key, .*; is '$table' meant\?" "$gasjet" check "$work/misspelt.toml"
  done
  { cat "$source/cases/pendulum_swing.toml" && echo '[gas]'; } >"$work/no_gas.toml"
  expect 2 "no_gas.toml:[0-9]+:1: gas: names no gas" "$gasjet" check "$work/no_gas.toml"
  printf 'a%.0s.' {1..200} >"$work/deep.toml" && echo 'a = 1' >>"$work/deep.toml"
  expect 2 "deep.toml:1:1: a key has more than 100 parts" "$gasjet" check "$work/deep.toml"
  expect 2 "a key has more than 100 parts" "$gasjet" check "$tank" --set "$(printf 'a%.0s.' {1..200})a=1"
  expect 2 "a key has more than 100 parts" "$gasjet" check "$tank" --set "scene.name={ $(printf 'a%.0s.' {1..200})a=1 }"
  awk 'BEGIN { for (i = 0; i <= 1000; i++) print "[[vent]]" }' | cat "$tank" - >"$work/vents.toml"
  expect 2 "vent: has 1001 tables, at most 1000 are allowed" "$gasjet" check "$work/vents.toml"
  # A build with sanitizers reserves more than any limit: it does not even start.
  ! bash -c 'ulimit -v 60000 && exec "$@"' - "$gasjet" --version >/dev/null 2>&1 ||
    expect 3 "gasjet: mesh: out of memory: [0-9]+ MiB of addresses are in use, .* the limit of 59 MiB" bash -c 'ulimit -v 60000 && exec "$@"' - \
      "$gasjet" mesh passenger --refine 5 --out "$work/large.obj"
  ! bash -c 'ulimit -v 60000 && exec "$@"' - "$gasjet" --version >/dev/null 2>&1 ||
    expect 3 "check: .*jet_bag.toml: membrane.*: out of memory: [0-9]+ MiB" bash -c 'ulimit -v 60000 && exec "$@"' - \
      "$gasjet" check "$source/cases/jet_bag.toml" --set membrane.mesh.levels=7
  # Long values are not told whole.
  [ "$("$gasjet" check "$tank" --set "a=$(printf '[%.0s' {1..50000})" 2>&1 | wc -c)" -lt 600 ] || fail "a long value is told whole"
  for command in "exact tank_fill --set volume=" "ladder $tank --quantity " "mesh passenger --out $work/o.obj --set " ""; do
    # shellcheck disable=SC2086
    [ "$("$gasjet" $command"$(printf '9%.0s' {1..50000})" 2>&1 | wc -c)" -lt 3000 ] || fail "$command tells a long value whole"
  done
  expect 2 "no.x1bsuch. is no command of gasjet" "$gasjet" $'no\x1bsuch'
  expect 2 "--set scene.xx+\.\.\.: scene.xx+\.\.\.: unknown key" "$gasjet" check "$tank" --set "scene.$(printf 'x%.0s' {1..50000})=1"
  for volume in 1e308 1e-320; do
    expect 2 "tank.volume: is .*, 1e-100 to 1e100 .m³. is allowed" "$gasjet" check "$tank" --set tank.volume=$volume
  done
  expect 2 "part of the path" "$gasjet" run "$tank" --out "$work/out" --set scene.end_time.=1
  expect 2 "longer than 64 MiB" "$gasjet" run /dev/zero --out "$work/out"
  expect 2 "another file name" "$gasjet" ensemble "$source/cases/sphere_inflation.toml" --runs 2 \
    --against "$source/cases/sphere_inflation.toml" --out "$work/out"
  expect 2 "no such file" "$gasjet" ensemble "$source/cases/sphere_inflation.toml" --runs 2 --against "$work/none.toml" --out "$work/out"
  expect 2 "the scene has none" "$gasjet" ensemble "$source/cases/sphere_inflation.toml" --runs 2 --against "$tank" --out "$work/out"
  expect 0 "warning: inflator.1 delivers nothing before end_time" "$gasjet" ensemble "$source/cases/jet_bag.toml" --runs 2 --quiet \
    --set scene.end_time=1e-4 --out "$work/warned"
  expect 2 "sets the perturbation itself" "$gasjet" ensemble "$source/cases/sphere_inflation.toml" --runs 2 \
    --set membrane.perturbation=1e-6 --out "$work/out"
  expect 2 "--amplitude.*1e-18 to 1e-3 m is allowed" "$gasjet" ensemble "$source/cases/sphere_inflation.toml" --amplitude nan --out "$work/out"
  [ -e "$work/out" ] && fail "bad input wrote $work/out"
}

part_interrupt() {
  "$gasjet" run "$source/cases/passenger_pendulum_no_jet.toml" --out "$work/stopped" --set scene.end_time=100 \
    >"$work/log" 2>&1 </dev/null &
  local pid=$! rows waited=0
  until [ -s "$work/stopped/history.csv" ] || [ $waited -ge 300 ]; do sleep 0.1; waited=$((waited + 1)); done
  kill -INT $pid
  wait $pid
  local status=$?
  [ $status = 130 ] || fail "exit $status after Ctrl-C, 130 expected: $(cat "$work/log")"
  grep -q '"status": "interrupted"' "$work/stopped/summary.json" || fail "no interrupted status"
  # While a file is read, here of a pipe into which nobody writes, nothing is there to keep.
  mkfifo "$work/nothing.csv"
  for signal in TERM INT HUP; do
    (trap - INT; exec "$gasjet" run "$source/cases/rigid_tank.toml" --out "$work/waiting" \
      --set "inflator.0.mass_flow={file='$work/nothing.csv',column='flow'}" >/dev/null 2>&1) &
    pid=$!
    sleep 0.5
    kill -$signal $pid
    wait $pid
    [ $? -gt 128 ] || fail "$signal while a file is read: exit $?"
    [ -e "$work/waiting" ] && fail "$signal while a file is read leaves results"
  done
  rows=$(grep -v '^#' "$work/stopped/history.csv" | awk -F, 'NR == 1 {n = NF} NF != n {bad = 1} END {print bad ? -1 : NR}')
  [ "$rows" -gt 1 ] || fail "history of $rows rows, or a torn row"
}

part_progress() {
  local run=("$gasjet" run "$source/cases/passenger_pendulum_no_jet.toml" --out "$work/bar")
  on_terminal() { script -qec "stty cols $1; $(printf '%q ' "${run[@]}")" "$work/terminal" >/dev/null </dev/null || fail "exit $? on a terminal"; }
  on_terminal 40
  tr '\r' '\n' <"$work/terminal" | sed 's/\x1b\[K.*//' | grep ' s left,' | awk 'length > 39 { bad = 1 } END { exit bad || !NR }' || fail "lines longer than 40 columns"
  on_terminal 100 # room for a short bar
  tr '\r' '\n' <"$work/terminal" | sed 's/\x1b\[K.*//' | grep -F '[#' | awk 'length > 99 { bad = 1 } END { exit bad || !NR }' || fail "no bar within 100 columns"
  on_terminal 140
  grep -qE '100 %, 0.0 s left, 100 ms, [0-9.]+ kPa, [0-9.]+ deg' "$work/terminal" || fail "the state so far is not told"
  tr '\r' '\n' <"$work/terminal" | sed -nE 's/.*\[[#.]{40}\] +([0-9]+) %.*/\1/p' >"$work/percent"
  sort -nc "$work/percent" || fail "progress goes back: $(paste -sd ' ' "$work/percent")"
  [ "$(tail -n 1 "$work/percent")" = 100 ] || fail "no 100 % at the end: $(paste -sd ' ' "$work/percent")"
  local bag=("${run[@]}")
  run=("$gasjet" run "$source/cases/plate_jet.toml" --out "$work/target" --set scene.end_time=1 --set output.history_every=1e-4)
  on_terminal 140 # nothing has a pressure
  tr '\r' '\n' <"$work/terminal" | sed 's/\x1b\[K.*//' | grep -q ' s left, [0-9.]* ms$' || fail "the time of a target is not told alone"
  run=("${bag[@]}" --set scene.end_time=0.002)
  "${run[@]}" >"$work/log" 2>&1 </dev/null || fail "exit $? without a terminal"
  ! grep -q $'\r' "$work/log" || fail "a bar without a terminal"
  [ -z "$("${run[@]}" --quiet 2>&1 </dev/null)" ] || fail "--quiet is not quiet"
}

without_dates() { sed -E '/^# (date|options): /d' "$1"; }

same_bytes() { # same_bytes CASE OPTION...: one run on one thread, one on two
  local file near=(--set "pendulum.pivot=[0.12,0.0,1.31]" --set inflator.0.mass_flow=4.0)  # contact within 1 ms
  "$gasjet" run "$source/cases/$1.toml" --out "$work/a" --quiet "${near[@]}" "${@:2}" || fail "$1, one thread"
  "$gasjet" run "$source/cases/$1.toml" --out "$work/b" --quiet "${near[@]}" "${@:2}" --threads 2 || fail "$1, two threads"
  grep -q '"first_contact_s": [0-9]' "$work/a/summary.json" || fail "$1: no contact"
  for file in history.csv energy.csv; do
    cmp <(without_dates "$work/a/$file") <(without_dates "$work/b/$file") || fail "$1: $file differs"
  done
  cmp <(sed -E '/"(date|wall_s|cpu_s|real_time_factor|S[0-9]+_[a-z_]+|rest)"/d' "$work/a/summary.json") \
    <(sed -E '/"(date|wall_s|cpu_s|real_time_factor|S[0-9]+_[a-z_]+|rest)"/d' "$work/b/summary.json") || fail "$1: summary differs"
}

part_same_bytes() {
  same_bytes passenger_pendulum_no_jet --set scene.end_time=0.001 --set membrane.mesh.refine=1  # enough blocks for two threads
  same_bytes passenger_pendulum --set scene.end_time=0.001
}

part_exact() {
  expect 0 "tank" "$gasjet" exact --list
  expect 2 "no_such" "$gasjet" exact no_such
  expect 2 "; is 'blowdown' meant.$" "$gasjet" exact blowdow
  local name
  for name in $("$gasjet" exact --list | sed -nE 's/^([a-z0-9_]+): .*/\1/p'); do
    "$gasjet" exact "$name" >"$work/rows.csv" 2>"$work/error" </dev/null
    [ $? = 0 ] || fail "$name: $(cat "$work/error")"
    grep -v '^#' "$work/rows.csv" | tail -n +2 | grep -Eiq '(^|,)-?(nan|inf)' && fail "$name prints nan or inf"
  done
  "$gasjet" exact --list --format markdown | cmp - "$source/docs/exact.md" ||
    fail "docs/exact.md is not what gasjet exact --list --format markdown prints"
  expect 0 "^# volume: 1$" "$gasjet" exact tank_fill --set volume=+1
  expect 2 "'nan' is no finite number" "$gasjet" exact tank_fill --set volume=nan
  expect 2 "given twice" "$gasjet" exact tank_fill --set volume=1 --set volume=2
  expect 2 "--format csv: prints one NAME; of --list markdown or json" "$gasjet" exact --list --format csv
  "$gasjet" exact --list --format json >"$work/list.json"
  diff <("$gasjet" exact --list | sed -nE 's/^([a-z0-9_]+): .*/\1/p') <(sed -nE 's/^      "name": "(.*)",$/\1/p' "$work/list.json") ||
    fail "the list in JSON names other closed forms"
  diff <("$gasjet" exact --list --format markdown | grep -oE '^- `[a-z0-9_]+`.*, required: ' | wc -l) <(grep -c '"default": null' "$work/list.json") ||
    fail "the list in JSON has other required parameters"
  grep -q '^  "format": 1,$' "$work/list.json" || fail "the list in JSON does not say its format"
  expect 2 "--list: prints the whole catalogue" "$gasjet" exact tank_fill --list
  expect 2 "--times.*is empty, first:last:step is needed" "$gasjet" exact tank_fill --times=
  expect 2 "--times.*is empty" "$gasjet" exact --list --times=
  expect 2 "prints --list only" "$gasjet" exact tank_fill --format markdown
  expect 2 "patch_angle" "$gasjet" exact pressed_balloon --times 1e-300
  expect 2 "overpressure" "$gasjet" exact pressed_balloon --set young_modulus=3
  expect 2 "no_such_parameter" "$gasjet" exact "$name" --set no_such_parameter=1
}

for family in channels check compare cost decks faults identify ladder mesh mpi own_files report resume study study_inputs study_tables; do
  # shellcheck source=/dev/null
  source "$(dirname "${BASH_SOURCE[0]}")/command_$family.sh"
done
"part_$part"
[ $failures -eq 0 ] && echo "command $part: passed" || exit 1
