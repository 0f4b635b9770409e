# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Part of command_test.sh (sourced): what was done before Ctrl-C or a kill is not done again, and the results are those of one go.

part_resume() {
  # A journal cannot hold what is no number: such a run has failed.
  expect 3 "failed run, left out: pendulum_joint_force_N is no finite number" "$gasjet" ensemble "$source/cases/ball_impact.toml" --runs 2 --out "$work/no_number" \
    --set scene.end_time=1e-3 --set membrane.mesh.levels=1 --set pendulum.mass=1e307
  local ensemble=(ensemble "$source/cases/sphere_inflation.toml" --runs 10 --set scene.end_time=1e-2 --set membrane.mesh.levels=3)
  local ladder=(ladder "$source/cases/jet_bag.toml" --set membrane.mesh.levels=2 --quantity pressure --tolerance 10%) signal pid code
  "$gasjet" "${ensemble[@]}" --quiet --out "$work/whole" || fail "ensemble"
  for signal in INT KILL; do
    "$gasjet" "${ensemble[@]}" --out "$work/$signal" >/dev/null 2>&1 </dev/null &
    pid=$!
    until_there test -s "$work/$signal/sphere_inflation/journal.jsonl"
    kill -$signal $pid
    wait $pid 2>/dev/null
    code=$?
    [ $signal = KILL ] || [ $code = 130 ] || fail "exit $code of an interrupted ensemble"
    [ $signal = KILL ] || ended_as "$work/$signal" interrupted
    [ $signal = KILL ] || grep -q '^# status: interrupted, [1-9] of 10 runs' "$work/$signal/sphere_inflation/ensemble.csv" ||
      fail "an interrupted ensemble does not say how many runs it has"
    [ $signal = KILL ] || expect 2 "was interrupted before all runs were done" "$source/scripts/plot.sh" ensemble "$work/plot" "$work/INT/sphere_inflation"
    expect 0 "goes on after [1-9] runs that are done" "$gasjet" "${ensemble[@]}" --out "$work/$signal"
    same_tables "$work/whole/sphere_inflation" "$work/$signal/sphere_inflation" ensemble.csv quantities.csv
    cmp <(sed '/"date"/d' "$work/whole/sphere_inflation/ensemble.json") <(sed '/"date"/d' "$work/$signal/sphere_inflation/ensemble.json") || fail "ensemble.json"
    ended_as "$work/$signal" done
    [ -e "$work/$signal/sphere_inflation/journal.jsonl" ] && fail "the journal stays"
  done
  local long
  long=$(printf 'n%.0s' {1..300})
  expect 2 "File name too long" "$gasjet" "${ensemble[@]}" --out "$work/$long"
  expect 2 "File name too long" "$gasjet" study run "$source/cases/studies/runs_needed.toml" --out "$work/$long"
  expect 2 "holds no plan.toml" "$gasjet" study merge "$work/$long"
  # In shares, of which one is cut off and one is damaged: the whole has the bytes of one go.
  local shared=("$gasjet" "${ensemble[@]}" --out "$work/shared") share runs journals=$work/shared/sphere_inflation/shares
  for share in 1/3 3/3; do
    [ $share = 1/3 ] && runs=4 || runs=3
    expect 0 "share ${share/\//_of_}: $runs of $runs runs have ended, 0 not done" "${shared[@]}" --share $share
    [ "$(grep -c '"key":"seed' "$journals/${share/\//_of_}/journal.jsonl")" = $runs ] || fail "runs of share $share"
  done
  truncate -s -10 "$journals/3_of_3/journal.jsonl"
  sed -i '1s/"status":0/"status":17/; 2s/"quantities":\[\[[^]]*\],/"quantities":[/; 3s/"rows":\[\[[^]]*\],/"rows":[[0.0],/; 4s/"quantities":\[\[[^]]*\],/"quantities":[[null],/' "$journals/1_of_3/journal.jsonl"
  expect 2 "--share 4/3: NUMBER/COUNT" "${shared[@]}" --share 4/3
  expect 2 "shares/[13]_of_3: is of another command, case or build than this" "${shared[@]}" --share 2/3 --amplitude 2e-5
  expect 0 "goes on after 2 runs that are done" "${shared[@]}"
  same_tables "$work/whole/sphere_inflation" "$work/shared/sphere_inflation" ensemble.csv quantities.csv
  [ -e "$journals" ] && fail "shares stay: $(ls "$journals")"
  # Results that are there stay when the shares are of another command.
  expect 0 "" "${shared[@]}" --quiet --share 1/3 --amplitude 2e-5
  expect 2 "shares/1_of_3: is of another command, case or build than this" "${shared[@]}"
  same_tables "$work/whole/sphere_inflation" "$work/shared/sphere_inflation" ensemble.csv quantities.csv
  # Another ensemble takes nothing over.
  "$gasjet" "${ensemble[@]}" --out "$work/other" >/dev/null 2>&1 </dev/null &
  pid=$!
  until_there test -s "$work/other/sphere_inflation/journal.jsonl"
  kill -INT $pid
  wait $pid
  expect 0 "quantity" "$gasjet" "${ensemble[@]}" --out "$work/other" --amplitude 2e-5
  "$gasjet" "${ensemble[@]}" --out "$work/fresh" --amplitude 2e-5 --quiet || fail "ensemble"
  same_tables "$work/fresh/sphere_inflation" "$work/other/sphere_inflation" ensemble.csv quantities.csv
  "$gasjet" "${ladder[@]}" --out "$work/ladder" >/dev/null 2>&1 </dev/null &
  pid=$!
  until_there test -s "$work/ladder/journal.jsonl"
  kill -KILL $pid
  wait $pid 2>/dev/null
  # What is damaged is found again.
  sed -i '1s/"value":[0-9.e+]*}}$/"value":"x"}}/; 2s/"cpu_s":[0-9.e-]*,//' "$work/ladder/journal.jsonl"
  grep -q '"value":"x"}}$' "$work/ladder/journal.jsonl" || fail "no run of the ladder is damaged"
  printf '{"key":7,"value":1}\n{"key":"volume by pressure","value":5}\n' >>"$work/ladder/journal.jsonl"
  expect 0 "goes on after [0-9]+ runs that are done" "$gasjet" "${ladder[@]}" --out "$work/ladder"
  "$gasjet" "${ladder[@]}" --out "$work/whole_ladder" --quiet || fail "ladder"
  # All but costs, and what costs decide: the front.
  values() { without_dates "$1/ladder.csv" | cut -d, -f1-6,9,11-; }
  cmp <(values "$work/whole_ladder") <(values "$work/ladder") || fail "a ladder that went on has other rows"
  [ "$(grep -c '^and ' "$work/ladder/ladder.csv")" -gt 2 ] || fail "nothing is left out together"
  # Two cases: the first is done when the second is killed, and effects are of runs of both.
  local against=(ensemble "$source/cases/sphere_inflation.toml" --against "$work/slow.toml" --runs 4 --set scene.end_time=1e-2 --set membrane.mesh.levels=3)
  sed 's/^name = .*/name = "slow"/; s/^mass_flow = .*/mass_flow = 0.1/' "$source/cases/sphere_inflation.toml" >"$work/slow.toml"
  "$gasjet" "${against[@]}" --quiet --out "$work/both" || fail "ensemble --against"
  for signal in INT KILL; do
    for _ in 1 2 3 4 5; do # on a busy machine it may end before this sees that it began
      rm -rf "$work/both$signal"
      "$gasjet" "${against[@]}" --out "$work/both$signal" >/dev/null 2>&1 </dev/null &
      pid=$!
      until [ -s "$work/both$signal/slow/journal.jsonl" ] || ! kill -0 $pid 2>/dev/null; do :; done
      kill -$signal $pid 2>/dev/null
      wait $pid 2>/dev/null
      grep -q '^status: done' "$work/both$signal/gasjet.status" || break
    done
    [ -e "$work/both$signal/effects.csv" ] && fail "effects of an ensemble that was not done"
    expect 0 "sphere_inflation: goes on after 4 runs .*slow: goes on after [1-3] runs" \
      bash -c '"$@" 2>&1 | tr "\n" " "' - "$gasjet" "${against[@]}" --out "$work/both$signal"
    same_tables "$work/both" "$work/both$signal" effects.csv {sphere_inflation,slow}/{ensemble,quantities,runs}.csv
  done
}
