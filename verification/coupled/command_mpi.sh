# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Part of command_test.sh (sourced): commands of many runs on the ranks of an MPI job.

# The commands of many runs on ranks: the bytes are those of one process.
part_mpi() {
  local plan=$work/plan.toml program=${gasjet%/*}/gasjet_mpi
  ranks() { mpirun --allow-run-as-root --oversubscribe -n "$1" "$program" "${@:2}"; }
  bag_plan "$plan" 6
  "$gasjet" study run "$plan" --out "$work/alone" --quiet || fail "alone"
  expect 0 "12 of 12 runs: 12 done" ranks 3 study run "$plan" --out "$work/ranks"
  same_study "$work/alone" "$work/ranks"
  expect 2 "with 2 ranks or more" ranks 1 study run "$plan" --out "$work/ranks"
  expect 2 "gasjet_mpi ensemble.ladder.study run" ranks 2 run "$source/cases/rigid_tank.toml"
  expect 2 "gasjet_mpi ensemble.ladder.study run" ranks 2 study merge "$work/ranks" # all ranks would write
  expect 0 "^gasjet [0-9]" "$program" --version
  tank_plan "$plan" 'seeds = 4'
  expect 2 "study.seeds: perturb the nodes" ranks 2 study run "$plan" --out "$work/none"
  [ "$(ranks 3 study run "$plan" 2>&1 | grep -c 'study.seeds: perturb')" = 1 ] || fail "each rank says what is wrong with the plan"
  local ensemble=(ensemble "$source/cases/sphere_inflation.toml" --against "$work/slow.toml" --runs 5 --set scene.end_time=4e-3 --set membrane.mesh.levels=2)
  sed 's/^name = .*/name = "slow"/; s/^mass_flow = .*/mass_flow = 0.1/' "$source/cases/sphere_inflation.toml" >"$work/slow.toml"
  "$gasjet" "${ensemble[@]}" --out "$work/one" --quiet || fail "ensemble"
  expect 0 "difference" ranks 3 "${ensemble[@]}" --out "$work/many"
  local table
  for table in effects.csv {sphere_inflation,slow}/{ensemble,quantities,runs}.csv; do
    cmp <(sed '/^#/d' "$work/one/$table") <(sed '/^#/d' "$work/many/$table") || fail "$table on ranks"
  done
  local ladder=(ladder "$source/cases/jet_bag.toml" --set membrane.mesh.levels=1 --set scene.end_time=5e-3 --quantity pressure --tolerance 50%)
  "$gasjet" "${ladder[@]}" --out "$work/ladder" --quiet 2>"$work/warnings" || fail "ladder"
  [ "$(sort -u "$work/warnings" | grep -c '^warning: jet of inflator [01]: element sides')" = "$(wc -l <"$work/warnings")" ] || fail "a warning is told twice"
  expect 0 "cheapest within" ranks 3 "${ladder[@]}" --out "$work/ladder_ranks"
  values() { sed '/^#/d' "$1/ladder.csv" | cut -d, -f1-6,9,11-; } # all but costs, and what they decide
  cmp <(values "$work/ladder") <(values "$work/ladder_ranks") || fail "a ladder on ranks has other rows"
  # A rank that sees another case says so, and all end.
  cp "$source/cases/sphere_inflation.toml" "$work/both.toml"
  expect 2 "rank 1 reads another plan, case or file" mpirun --allow-run-as-root --oversubscribe -n 1 "$program" ensemble "$work/both.toml" --runs 2 --out "$work/two" : \
    -n 1 "$program" ensemble "$work/slow.toml" --runs 2 --out "$work/two"
  expect 2 "missing.toml" mpirun --allow-run-as-root --oversubscribe -n 1 "$program" ensemble "$work/both.toml" --runs 2 --out "$work/two" : \
    -n 1 "$program" ensemble "$work/missing.toml" --runs 2 --out "$work/two"
  # What a run of each rank refuses is said once, and the folder says it.
  local small=(ensemble "$source/cases/sphere_inflation.toml" --amplitude 1e-3 --set membrane.mesh.levels=1 --set membrane.mesh.radius=1e-4)
  [ "$(ranks 5 "${small[@]}" --out "$work/small" 2>&1 | grep -c 'gasjet: volume .* must be finite and positive')" = 1 ] || fail "each rank says why its run fails"
  ended_as "$work/small" failed
  # Ctrl-C of one rank, the only one that computes, is one of the command, which goes on from there.
  local pid
  bag_plan "$plan" 200
  ranks 2 study run "$plan" --out "$work/stopped" >/dev/null 2>&1 </dev/null &
  until_there grep -sq '"run":3,' "$work/stopped/shares/1_of_1/journal.jsonl"
  pid=$(pgrep -nf "^$program study run .*/stopped") # the newest
  kill -INT "$pid"
  wait $!
  [ $? = 130 ] || fail "exit $? of a study of which one rank was interrupted"
  ended_as "$work/stopped/shares/1_of_1" interrupted
  expect 0 "goes on after [0-9]+ runs that are done" ranks 3 study run "$plan" --out "$work/stopped"
  "$gasjet" study run "$plan" --out "$work/unstopped" --quiet || fail "study"
  same_study "$work/unstopped" "$work/stopped"
}
