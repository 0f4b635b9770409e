# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Parts of command_test.sh (sourced): what a study says of its runs, beforehand, meanwhile and at the end.

# Runs that are not done are in no mean, and the means say what they could change.
part_study_left_out() {
  local plan=$work/plan.toml out=$work/out
  bag_plan "$plan" 6
  expect 0 "12 of 12 runs: 12 done" "$gasjet" study run "$plan" --out "$out"
  awk -F, '$3 == "peak_pressure_Pa" { exit !($(NF - 2) == 0 && $(NF - 1) == $4 && $NF == $4) }' "$out/means.csv" ||
    fail "nothing is left out: $(cat "$out/means.csv")"
  grep -q notes "$out/study.json" && fail "a note without a reason"
  sed -i -E '/"run":(2|4),/s/"done"/"failed"/' "$out"/shares/*/journal.jsonl
  expect 3 "^runs in no mean: 2 of 12, at 1 of 2 points; .* moves by at most [0-9.]+ standard errors .peak_pressure_Pa at point 0.$" \
    "$gasjet" study merge "$out"
  # From the rows of the runs: the two that are left out, as the least and as the greatest of the four others.
  awk -F, '/^(#|point)/ { next }
    FILENAME ~ /results/ { if ($1 == 0 && $(NF - 2) == "done") { x = $4; sum += x; ++n; if (n == 1 || x < least) least = x; if (x > most) most = x }; next }
    $1 == 0 && $3 == "peak_pressure_Pa" {
      low = (sum + 2 * least) / (n + 2); high = (sum + 2 * most) / (n + 2); found = $(NF - 2) == 2 && $6 == 4
      found = found && ($(NF - 1) / low - 1) ^ 2 < 1e-24 && ($NF / high - 1) ^ 2 < 1e-24 && $(NF - 1) < $4 && $4 < $NF
      move = (high - $4 > $4 - low ? high - $4 : $4 - low) / $5 }
    END { if (!found) exit 1; printf "%.2g\n", move }' "$out/results.csv" "$out/means.csv" >"$work/move" || fail "range: $(cat "$out/means.csv")"
  grep -q "at most $(cat "$work/move") standard errors" "$out/study.json" || fail "not by $(cat "$work/move"): $(cat "$out/study.json")"
  # One run shows no spread.
  sed -i -E '/"run":(7|8|9|10|11),/s/"done"/"inaccurate"/' "$out"/shares/*/journal.jsonl
  expect 3 "runs in no mean: 7 of 12, at 2 of 2 points; .*; fewer than two other runs at 1 of these points" "$gasjet" study merge "$out"
  grep -Eq '^1,no,peak_pressure_Pa,[-0-9.e]+,,1,,,0,5,,$' "$out/means.csv" || fail "a range of one run: $(cat "$out/means.csv")"
}

# What a study costs is told before it is paid, from runs of both ends.
part_study_cost() {
  local plan=$work/plan.toml
  bag_plan "$plan" 6
  expect 0 "12 runs.* about [0-9.]+ CPU s, an estimate from one run each: [0-9.]+ s at the first point, [0-9.]+ s at the last point" \
    bash -c "'$gasjet' study run '$plan' --check | tee '$work/told' | tr '\n' ' '"
  [ ! -e "$work/results" ] || fail "something is written"
  expect 0 "12 of 12 runs" "$gasjet" study run "$plan" --out "$work/out"
  # Twelve times the mean of both, to the two digits that are printed; and what the runs took, within what a busy machine does.
  awk -F, 'FILENAME ~ /told/ { if ($0 !~ /about/) next; split($0, word, " "); told = word[2]; sum = 6 * (word[11] + word[17]); next }
    /^[0-9]/ { took += $4 }
    END { exit !(sum > 0 && (told / sum - 1) ^ 2 < 0.1 ^ 2 && told < 4 * took && took < 4 * told) }' "$work/told" "$work/out/timing.csv" ||
    fail "the cost: $(cat "$work/told")"
  printf '[study]\ncase = "%s/cases/sphere_inflation.toml"\nset = ["scene.end_time=1e-3"]\n[[factor]]\nkey = "time.step"\nvalues = [1e-5, 1e-3]\n' \
    "$source" >"$plan"
  expect 0 "^the run at the last point is failed: .*is unstable: the limit" "$gasjet" study run "$plan" --check
  tank_plan "$plan"
  expect 0 "estimate from one run each: [0-9.e-]+ s at the first point$" "$gasjet" study run "$plan" --check
}

# The progress of a share counts what the others end meanwhile.
part_study_progress() {
  local plan=$work/plan.toml shares=$work/out/shares run
  bag_plan "$plan" 40
  sed -i 's/end_time=0.004/end_time=0.04/' "$plan"
  "$gasjet" study run "$plan" --out "$work/out" --share 1/2 2>"$work/log" &
  until_there grep -q '"run":0,' "$shares/1_of_2/journal.jsonl"
  mkdir "$shares/2_of_2"
  # 39 runs of another share, one of them twice, and one that is not whole yet.
  for ((run = 1; run < 79; run += 2)); do echo "{\"cpu_s\":1,\"run\":$run,\"status\":\"done\"}"; done >"$shares/2_of_2/journal.jsonl"
  printf '{"cpu_s":1,"run":1,"status":"done"}\n{"cpu_s":1,"run":79' >>"$shares/2_of_2/journal.jsonl"
  wait $! || fail "share 1/2: $(cat "$work/log")"
  # A line's share of 40 runs is this share's own; per cent are rounded to half a one, 0.2 runs.
  awk '/ all shares [0-9]+ of 80,/ { own = 0.4 * $2; for (i = 1; i < NF; ++i) if ($i == "shares") all = $(i + 1)
      if ((all - own) ^ 2 < 0.5) next; if ((all - own - 39) ^ 2 < 0.5) ++n; else exit 1 } END { exit !n }' "$work/log" ||
    fail "39 runs of the other share are not told: $(cat "$work/log")"
}

# A point takes memory for its numbers, not for texts.
part_study_memory() {
  local plan=$work/plan.toml key range
  tank_plan "$plan" 'design = "latin_hypercube"' 'points = 200000'
  while read -r key range; do
    printf '[[factor]]\nkey = "%s"\nrange = [%s]\n' "$key" "$range" >>"$plan"
  done <<<$'inflator.0.mass_flow 0.05, 0.15\ninflator.0.temperature 300, 500\nambient.temperature 290, 300\nambient.pressure 1e5, 1.02e5
gas.initial.temperature 280, 300\ntank.volume 0.05, 0.07'
  bash -c 'ulimit -v 60000 && exec "$@"' - "$gasjet" --version >/dev/null 2>&1 || return 0 # a sanitizer takes more
  # 60 MB of addresses are taken by the program, and 8 bytes by each of 1.2 million numbers.
  expect 0 "200000 points, 6 factors, 200000 runs" bash -c 'ulimit -v 150000 && exec "$@"' - "$gasjet" study run "$plan" --check
}

# drawn FOLDER NAME TEXT...: a picture, its commands and the texts in it
drawn() {
  local text
  [ -s "$1/$2.gp" ] && [ -s "$1/$2.svg" ] || { fail "no $2.svg: $(grep -A 3 '"notes"' "$1/study.json")" && return; }
  for text in "${@:3}"; do grep -qF -- "$text" "$1/$2.svg" || fail "no '$text' in $2.svg"; done
  grep -qF "$2.svg" "$1/gasjet.status" || fail "$2.svg is not listed"
}

# Pictures show the numbers of the tables; names of the plan are texts in them, whatever they hold.
part_study_pictures() {
  local plan=$work/plan.toml name="'a' \`touch $work/made\` {/Bold b} @c \"d\""
  tank_plan "$plan" '[[factor]]' 'name = "gas"' '[[factor.level]]' 'name = "warm"' '[[factor.level]]' "name = '''$name'''" \
    'set = ["inflator.0.temperature=500"]' '[[factor]]' 'key = "inflator.0.mass_flow"' 'values = [0.3, 0.1, 0.2]' '[analysis]' 'pictures = true'
  expect 0 "6 of 6 runs: 6 done" "$gasjet" study run "$plan" --out "$work/means"
  drawn "$work/means" means pressure_Pa inflator.0.mass_flow warm "'a' \`touch $work/made\` {/Bold b} @c"
  [ ! -e "$work/made" ] || fail "a name is a command"
  # A line for each gas, its points from the least flow to the greatest.
  diff <(sed -n '/^\$means_0_1 /,/^EOD/p' "$work/means/means.gp" | sed '1d;$d' | cut -d' ' -f1,2) \
    <(grep '^[345],' "$work/means/means.csv" | sed -E 's/^.*,(0\.[123]),pressure_Pa,([^,]*),.*/\1 \2/' | sort) || fail "the points of means.svg"
  grep -q notes "$work/means/study.json" && fail "a note without a reason"
  grep -q 'set logscale' "$work/means/means.gp" && fail "an axis from 0.1 to 0.3 is logarithmic"
  # Without gnuplot the tables are the same, and a note says so.
  mkdir "$work/none"
  cp "$work/means/means.csv" "$work/means/means.svg" "$work"
  expect 0 "^means.svg: not drawn, gnuplot: No such file.*; its commands are in means.gp$" env PATH="$work/none" "$gasjet" study merge "$work/means"
  [ ! -e "$work/means/means.svg" ] && cmp "$work/means.csv" "$work/means/means.csv" || fail "a picture of before, or other means"
  grep -q '"means.svg: not drawn' "$work/means/study.json" || fail "no note"
  expect 0 "6 of 6 runs" "$gasjet" study merge "$work/means"
  cmp "$work/means.svg" "$work/means/means.svg" || fail "the same picture has other bytes"
  # Points without numbers have rows with their names; Sobol indices and a convergence have pictures of their own.
  tank_plan "$plan" '[[factor]]' 'name = "way"' '[[factor.level]]' 'name = "50 % p"' '[[factor.level]]' 'name = "none"' 'unset = ["inflator"]' \
    '[analysis]' 'pictures = true'
  expect 0 "2 of 2 runs" "$gasjet" study run "$plan" --out "$work/rows"
  drawn "$work/rows" means "50 % p" none
  tank_plan "$plan" 'design = "sobol_indices"' 'points = 16' '[[factor]]' 'key = "inflator.0.mass_flow"' 'range = [0.05, 0.15]' 'scale = "logarithmic"' \
    '[[factor]]' 'key = "tank.volume"' 'range = [0.05, 0.07]' '[analysis]' 'pictures = true'
  expect 0 "64 of 64 runs" "$gasjet" study run "$plan" --out "$work/indices"
  drawn "$work/indices" means inflator.0.mass_flow
  grep -q '^set logscale x$' "$work/indices/means.gp" || fail "a factor on a logarithmic scale has no such axis"
  drawn "$work/indices" sobol inflator.0.mass_flow tank.volume pressure_Pa "of the factor alone" "with all others"
  diff <(sed -n '/^\$shares_0 /,/^EOD/p' "$work/indices/sobol.gp" | sed '1d;$d' | cut -d' ' -f2-7) \
    <(grep '^pressure' "$work/indices/sobol.csv" | cut -d, -f3-8 | tr , ' ') || fail "the shares of sobol.svg"
  printf '[study]\ncase = "%s/cases/tank_fixed_steps.toml"\nset = ["gas.initial.pressure=101325.0", "scene.end_time=0.002", "time.gas_method=euler"]\n' "$source" >"$plan"
  printf 'quantities = ["pressure_Pa"]\n[[factor]]\nkey = "time.gas_step"\nvalues = [2e-4, 1e-4, 5e-5]\n[analysis]\nconvergence = "time.gas_step"\npictures = true\n' >>"$plan"
  expect 0 "3 of 3 runs" "$gasjet" study run "$plan" --out "$work/limit"
  drawn "$work/limit" convergence time.gas_step "distance from the limit" "order $(tail -n 1 "$work/limit/convergence.csv" | awk -F, '{ printf "%.3g", $4 }')"
  awk -F, 'FILENAME ~ /means/ && /^[0-9]/ { mean[$2 + 0] = $4; next } FILENAME ~ /convergence.csv/ && /^pressure/ { limit = $3; next }
    /^\$errors_0/ { inside = 1; next } /^EOD/ { inside = 0 }
    inside { split($0, row, " "); error = mean[row[1] + 0] - limit; if (error < 0) error = -error; ++n; if ((row[2] - error) ^ 2 > 1e-6) bad = 1 }
    END { exit bad || n != 3 }' "$work"/limit/{means.csv,convergence.csv,convergence.gp} || fail "the errors of convergence.svg"
  # A study without pictures leaves files of their names alone.
  sed -i '/^pictures/d' "$plan"
  mkdir "$work/own" && touch "$work/own/means.svg"
  expect 0 "3 of 3 runs" "$gasjet" study run "$plan" --out "$work/own"
  [ ! -s "$work/own/means.svg" ] && [ ! -e "$work/own/means.gp" ] || fail "a picture that nobody asked for"
}
