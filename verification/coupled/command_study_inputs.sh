# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Parts of command_test.sh (sourced): studies whose files change, cannot be read or are damaged.

# file_plan FILE: a tank with points of p.csv beside the plan, and a case of its own there
file_plan() {
  cp "$source/cases/rigid_tank.toml" "${1%/*}/tank.toml"
  printf 'flow\n0.1\n0.2\n' >"${1%/*}/p.csv"
  printf '[study]\ncase = "tank.toml"\nquantities = ["pressure_Pa"]\ndesign = "file"\nfile = "p.csv"\n' >"$1"
  printf '[[factor]]\nname = "flow"\nkey = "inflator.0.mass_flow"\n' >>"$1"
}

# Outputs are never paired with other inputs than they were computed from.
part_study_inputs() {
  local plan=$work/plan.toml journal=$work/out/shares/1_of_1/journal.jsonl file line
  file_plan "$plan"
  expect 0 "2 of 2 runs" "$gasjet" study run "$plan" --out "$work/out"
  for file in p.csv tank.toml out/plan.toml; do
    cp "$work/$file" "$work/kept"
    sed -i 's/^0.2$/0.3/; s/^volume = 0.06/volume = 0.05/' "$work/$file"
    [ "$file" != out/plan.toml ] || sed -i "/^.study/a seeds = 0" "$work/$file"
    cmp -s "$work/$file" "$work/kept" && fail "$file is the same"
    expect 2 "/$file: is not as it was when the runs of .*/out/shares/1_of_1/journal.jsonl:2:1 read it" "$gasjet" study merge "$work/out"
    cp "$work/kept" "$work/$file"
    expect 0 "2 of 2 runs" "$gasjet" study merge "$work/out"
  done
  # A mesh that only a level names.
  cp "$source/cases/clamped_disc.obj" "$work/disc.obj"
  printf '[study]\ncase = "%s/cases/clamped_disc.toml"\nset = ["scene.end_time=1e-3"]\n' "$source" >"$work/meshes.toml"
  printf '[[factor]]\nkey = "membrane.mesh.file"\nvalues = ["clamped_disc.obj", "%s/disc.obj"]\n' "$work" >>"$work/meshes.toml"
  expect 0 "2 of 2 runs" "$gasjet" study run "$work/meshes.toml" --out "$work/meshes"
  echo '# more' >>"$work/disc.obj"
  expect 2 "disc.obj: is not as it was" "$gasjet" study merge "$work/meshes"
  # A curve that one factor names, and that is read at no first level of the other.
  printf 'time_s,flow\n0,1\n1,1\n' >"$work/flow.csv"
  printf '[study]\ncase = "tank.toml"\nquantities = ["pressure_Pa"]\n[[factor]]\nname = "flow"\n[[factor.level]]\nname = "own"\n[[factor.level]]\nname = "file"\n' >"$work/pairs.toml"
  printf 'set = ["inflator.0.mass_flow={file=\\"flow.csv\\", column=\\"flow\\"}"]\n[[factor]]\nname = "gas"\n' >>"$work/pairs.toml"
  printf '[[factor.level]]\nname = "none"\nunset = ["inflator"]\n[[factor.level]]\nname = "some"\n' >>"$work/pairs.toml"
  expect 0 "4 of 4 runs: 4 done" "$gasjet" study run "$work/pairs.toml" --out "$work/pairs"
  sed -i 's/^1,1$/1,2/' "$work/flow.csv"
  expect 2 "flow.csv: is not as it was" "$gasjet" study merge "$work/pairs"
  # A line that is none of a run of the plan.
  cp "$journal" "$work/journal"
  for line in '{"run":-3,"status":"done","steps":1,"cpu_s":1,"values":[1]}' '{"run":2,"status":"done","steps":1,"cpu_s":1,"values":[1]}' \
    '{"run":0,"status":"gone","steps":1,"cpu_s":1,"values":[1]}' '{"run":0,"status":"done","steps":1,"cpu_s":1,"values":[1,2]}' \
    '{"run":0,"status":"done","steps":1,"cpu_s":1,"values":["1"]}' '{"run":3}' '{"run":"0"}' '{"build":3}' '7'; do
    echo "$line" >>"$journal"
    expect 2 "journal.jsonl:5:1: is damaged: no run of the plan" "$gasjet" study merge "$work/out"
    cp "$work/journal" "$journal"
  done
  sed -i 's/"inputs":/"others":/' "$journal"
  expect 2 "journal.jsonl:3:1: a run, but no line before it says of which files" "$gasjet" study merge "$work/out"
  cp "$work/journal" "$journal"
  expect 0 "2 of 2 runs" "$gasjet" study merge "$work/out"
  printf 'flow\n# none\n0.1\n-2\n' >"$work/p.csv"
  expect 2 "^gasjet: $work/p.csv:4:1: flow: with \"-2\" the case is refused: .*mass_flow: is -2" "$gasjet" study run "$plan" --check
  # A folder that cannot be made says why. The administrator may write anywhere.
  local as=()
  [ "$(id -u)" != 0 ] || as=(setpriv --reuid=65534 --regid=65534 --clear-groups)
  file_plan "$plan"
  mkdir "$work/closed" && chmod 555 "$work/closed" && chmod 755 "$work"
  expect 2 "--out $work/closed/below: Permission denied" "${as[@]}" "$gasjet" study run "$plan" --out "$work/closed/below"
}

# What happens to the case or to the machine while a study runs is no result.
part_study_glitches() {
  local plan=$work/plan.toml pid ended
  bag_plan "$plan" 2 # of each point's scene
  printf '[[factor]]\nkey = "contact.friction"\nvalues = [0.0, 0.1, 0.2, 0.3, 0.4]\n' >>"$plan"
  sed "s|^\(set = \[\"scene.end_time=\).*|\10.008\"]|; s|^case = .*|case = \"bag.toml\"|" "$plan" >"$plan.1" && mv "$plan.1" "$plan"
  cp "$source/cases/passenger_pendulum.toml" "$work/bag.toml"
  expect 0 "20 of 20 runs" "$gasjet" study run "$plan" --out "$work/whole"
  start() { # start: in the background, until a run has ended
    "$gasjet" study run "$plan" --out "$work/out" --quiet 2>"$work/error" &
    pid=$!
    ended=$(grep -c '^{"cpu_s' "$work/out/shares/1_of_1/journal.jsonl" 2>/dev/null)
    until_there eval '[ "$(grep -c "^{\"cpu_s" "$work/out/shares/1_of_1/journal.jsonl")" -gt "${ended:-0}" ]'
  }
  stopped() { # stopped PATTERN: with exit code 2, and no run is refused
    wait "$pid"
    [ $? = 2 ] || fail "no exit code 2: $1"
    grep -Eq "$1" "$work/error" || fail "no '$1' in $(cat "$work/error")"
    grep -q '"status":"done"' "$work/out/shares/1_of_1/journal.jsonl" || fail "no run is kept"
    grep -q '"status":"refused"' "$work/out/shares/1_of_1/journal.jsonl" && fail "a run is refused: $1"
  }
  start
  sed 's/^end_time = .*/&\n# changed/' "$source/cases/passenger_pendulum.toml" >"$work/new.toml" && mv "$work/new.toml" "$work/bag.toml"
  stopped "bag.toml: changed while the study ran"
  expect 2 "of another plan, case or build" "$gasjet" study run "$plan" --out "$work/out"
  cp "$source/cases/passenger_pendulum.toml" "$work/bag.toml"
  start
  mv "$work/bag.toml" "$work/away.toml"
  stopped "bag.toml: (no such file|can no longer be read)"
  mv "$work/away.toml" "$work/bag.toml"
  expect 0 "20 of 20 runs: 20 done" "$gasjet" study run "$plan" --out "$work/out"
  same_study "$work/whole" "$work/out" study.json
  # A point's scene is read once, however few its runs are.
  bag_plan "$plan" 6
  sed -i "s|^case = .*|case = \"bag.toml\"|; /factor/,\$d" "$plan"
  rm -r "$work/out"
  start
  mv "$work/bag.toml" "$work/away.toml"
  stopped "bag.toml: no such file" # which the merge finds
  [ "$(grep -c '"status":"done"' "$work/out/shares/1_of_1/journal.jsonl")" = 6 ] || fail "a scene is read again: $(cat "$work/error")"
  # Memory is the machine's: rows of a million times need more than this limit.
  tank_plan "$plan" 'set = ["output.history_every=1e-7"]'
  ! bash -c 'ulimit -v 60000 && exec "$@"' - "$gasjet" --version >/dev/null 2>&1 || {
    expect 3 "point 0, seed 0: out of memory: .* the same command goes on" bash -c 'ulimit -v 110000 && exec "$@"' - \
      "$gasjet" study run "$plan" --out "$work/memory"
    expect 0 "1 of 1 runs: 1 done" "$gasjet" study run "$plan" --out "$work/memory"
  }
}
