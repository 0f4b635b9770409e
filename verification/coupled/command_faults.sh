# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Parts of command_test.sh (sourced): nothing is lost and nothing is wrong in silence when descriptors are closed, disks are full,
# runs are killed, folders are shared and names are strange.

# until_there CONDITION...: waits for a command to succeed, at most 30 s.
until_there() {
  local tries=0
  until "$@" 2>/dev/null || [ $tries -ge 1500 ]; do
    sleep 0.02
    tries=$((tries + 1))
  done
  "$@" || fail "waited 30 s for: $*"
}

ended_as() { # ended_as FOLDER STATUS
  [ "$(sed -n 's/^status: //p' "$1/gasjet.status" | tail -n 1)" = "$2" ] || fail "$1: status $(cat "$1/gasjet.status"), $2 expected"
}

same_tables() { # same_tables FOLDER FOLDER FILE...: but for dates and costs
  local file
  for file in "${@:3}"; do
    cmp <(without_dates "$1/$file") <(without_dates "$2/$file") || fail "$file of $1 and $2"
  done
}

# limited KIBIBYTES COMMAND...: no file may grow beyond; a write that would fails, as on a full disk.
limited() { (trap '' XFSZ; ulimit -f "$1"; exec "${@:2}"); }

part_descriptors() {
  local n=0 name closed run=(run "$source/cases/passenger_pendulum.toml" --set scene.end_time=2e-4) # warns
  "$gasjet" "${run[@]}" --out "$work/plain" >/dev/null 2>&1 </dev/null || fail "run"
  for closed in '2>&-' '2>/dev/full' '<&- 2>&-' '2>&- >/dev/null' '>&-' '<&- >&-' '<&- >&- 2>&-'; do
    name=$work/closed$((++n))
    (eval "\"\$gasjet\" \"\${run[@]}\" --out \"\$name\" $closed") >/dev/null || fail "exit $? with $closed"
    same_tables "$work/plain" "$name" history.csv energy.csv
    ended_as "$name" done
  done
  (eval "\"\$gasjet\" \"\${run[@]}\" --out \"\$work/lost\" >/dev/full") 2>/dev/null
  [ $? = 3 ] || fail "a full standard output is not told"
}

# Nobody reads what is told: the run goes on, and what only prints ends without a word.
part_pipes() {
  local said status
  "$gasjet" run "$source/cases/passenger_pendulum.toml" --set scene.end_time=2e-4 --out "$work/unread" 2>&1 | true
  until_there ended_as "$work/unread" done
  said=$({ "$gasjet" exact tank_fill --times 0:1000:0.001; echo $? >"$work/status"; } 2>&1 >/dev/full)
  [ "$(<"$work/status")" = 3 ] && grep -q 'write failed' <<<"$said" || fail "a full standard output: $said"
  { "$gasjet" exact tank_fill --times 0:1000:0.001 2>"$work/said"; echo $? >"$work/status"; } | head -n 1 >/dev/null
  [ "$(<"$work/status")" = 141 ] && [ ! -s "$work/said" ] || fail "exact | head: $(cat "$work/status" "$work/said")"
  (ulimit -f 8; exec "$gasjet" run "$source/cases/rigid_tank.toml" --set output.history_every=1e-5 --out "$work/cut" --quiet) 2>"$work/said"
  status=$?
  [ $status = 3 ] && grep -q 'write failed' "$work/said" || fail "a limit of file sizes: exit $status, $(cat "$work/said")"
}

# Threads that cannot start are told, not met.
part_threads() {
  local threads=(ensemble "$source/cases/sphere_inflation.toml" --runs 40 --threads 200 --set scene.end_time=1e-4 --quiet)
  if (ulimit -v 400000; exec "$gasjet" --version) >/dev/null 2>&1; then # a sanitizer's program needs more
    (ulimit -v 400000; exec "$gasjet" "${threads[@]}" --out "$work/threads") 2>"$work/said"
    [ $? = 3 ] && grep -Eq 'threads: is 200, this system lets [0-9]+ run' "$work/said" || fail "200 threads: $(cat "$work/said")"
  fi
}

part_killed() {
  local file whole endless=(run "$source/cases/passenger_pendulum_no_jet.toml" --set scene.end_time=100 --set output.fields_every=1e-3)
  "$gasjet" run "$source/cases/rigid_tank.toml" --out "$work/run" --quiet || fail "a run before"
  "$gasjet" "${endless[@]}" --out "$work/run" >/dev/null 2>&1 </dev/null &
  local pid=$!
  until_there test -s "$work/run/bag_00003.vtp"
  expect 2 "--out .*/run: another command is writing this folder" "$gasjet" run "$source/cases/rigid_tank.toml" --out "$work/run"
  expect 2 "has not ended" "$gasjet" compare "$work/run/history.csv" "$work/run/history.csv"
  sleep 1.2 # rows are in the file after a second
  kill -KILL $pid
  wait $pid 2>/dev/null
  [ "$(grep -vc '^#' "$work/run/history.csv")" -gt 2 ] || fail "all rows are lost"
  [ -z "$(tail -c 1 "$work/run/history.csv")" ] || fail "a torn row"
  whole=$(tail -n 1 "$work/run/fields.pvd")
  [ "$whole" = "</VTKFile>" ] || fail "fields.pvd ends with $whole"
  for file in $(sed -nE 's/.*file="([^"]*)".*/\1/p' "$work/run/fields.pvd"); do
    grep -q '</VTKFile>' "$work/run/$file" || fail "$file is named and not whole"
  done
  grep -q '"status": "running"' "$work/run/summary.json" || fail "the summary does not say that the run had not ended"
  ended_as "$work/run" running
  expect 2 "history.csv: its run has not ended \(gasjet.status says so\)" "$gasjet" compare "$work/run/history.csv" "$work/run/history.csv"
  expect 2 "history.csv: its run has not ended" "$source/scripts/plot.sh" history "$work/plot" "$work/run"
  "$gasjet" run "$source/cases/rigid_tank.toml" --out "$work/run" --quiet || fail "no run after one that was killed"
  [ "$(ls "$work/run")" = "$(printf '%s\n' check.json energy.csv gasjet.status history.csv summary.json)" ] || fail "left: $(ls "$work/run")"
  # SIGHUP ends a run as SIGTERM does, but where nohup ignores it.
  "$gasjet" "${endless[@]}" --out "$work/hup" >/dev/null 2>&1 </dev/null &
  pid=$!
  until_there test -s "$work/hup/bag_00001.vtp"
  kill -HUP $pid
  wait $pid
  [ $? = 130 ] || fail "SIGHUP"
  ended_as "$work/hup" interrupted
  nohup "$gasjet" "${endless[@]}" --out "$work/nohup" >/dev/null 2>&1 </dev/null &
  pid=$!
  until_there test -s "$work/nohup/bag_00001.vtp"
  kill -HUP $pid
  until_there test -s "$work/nohup/bag_00003.vtp"
  kill -TERM $pid
  wait $pid
  [ $? = 130 ] || fail "SIGTERM after a SIGHUP that nohup ignores"
}

part_mixed() {
  local tank=$source/cases/rigid_tank.toml
  "$gasjet" run "$tank" --out "$work/a" --quiet || fail "run a"
  "$gasjet" run "$tank" --out "$work/b" --quiet --set scene.end_time=0.05 || fail "run b"
  [ "$(grep '^run: ' "$work/a/gasjet.status")" != "$(grep '^run: ' "$work/b/gasjet.status")" ] || fail "two runs have one id"
  for file in history.csv energy.csv; do
    grep -qxF "# $(grep '^run: ' "$work/a/gasjet.status")" "$work/a/$file" || fail "$file is of no run"
  done
  # The id follows from the contents, wherever they stand, and from files that the case names.
  cp -r "$source/cases/bag_from_files.toml" "$source/cases/bag_from_files" "$work"
  (cd "$work" && "$gasjet" run bag_from_files.toml --quiet --out here --set scene.end_time=1e-5) || fail "a case without a folder"
  "$gasjet" run "$source/cases/bag_from_files.toml" --quiet --out "$work/there" --set scene.end_time=1e-5 || fail "the same case elsewhere"
  [ "$(grep '^run: ' "$work/here/gasjet.status")" = "$(grep '^run: ' "$work/there/gasjet.status")" ] || fail "one run has two ids"
  echo "# another mesh" >>"$work/bag_from_files/design.obj"
  "$gasjet" run "$work/bag_from_files.toml" --quiet --out "$work/changed" --set scene.end_time=1e-5 || fail "a changed mesh"
  [ "$(grep '^run: ' "$work/here/gasjet.status")" != "$(grep '^run: ' "$work/changed/gasjet.status")" ] || fail "a changed file does not change the id"
  cp "$work/b/history.csv" "$work/a/history.csv"
  expect 2 "history.csv: is of the run '[0-9a-f]{16}', its folder is of" "$gasjet" compare "$work/a/history.csv" "$work/b/history.csv"
  expect 2 "history.csv: is of the run '[0-9a-f]{16}', its folder is of" "$source/scripts/plot.sh" history "$work/plot" "$work/a"
  expect 2 "--out .*: holds the results of gasjet run, another folder is allowed" "$gasjet" ladder "$tank" --quantity pressure --out "$work/a"
  # A status file that names what is outside of its folder, or none of ours.
  echo precious >"$work/precious"
  printf '%s\n' "$(head -n 1 "$work/a/gasjet.status")" "command: run" "run: 0" "file: ../precious" "status: done" >"$work/b/gasjet.status"
  expect 2 "(check.json|energy.csv|history.csv|summary.json) is there, and no run is known to have written it" "$gasjet" run "$tank" --out "$work/b"
  rm "$work/b"/*.{csv,json}
  expect 0 "done" "$gasjet" run "$tank" --out "$work/b"
  [ "$(cat "$work/precious")" = precious ] || fail "a file outside of the folder was removed"
  echo "mine" >"$work/b/gasjet.status"
  expect 2 "gasjet.status: is no status file of gasjet" "$gasjet" run "$tank" --out "$work/b"
  # Refused: all of the run before is there.
  "$gasjet" run "$tank" --out "$work/kept" --quiet && cp -r "$work/kept" "$work/before"
  rm "$work/kept/energy.csv" && mkdir "$work/kept/energy.csv"
  expect 2 "energy.csv is there and not writable" "$gasjet" run "$tank" --out "$work/kept" --set scene.end_time=0.05
  for file in history.csv summary.json gasjet.status; do cmp "$work/kept/$file" "$work/before/$file" || fail "$file is not what it was"; done
  # Two files are of one computation if, and only if, they are of one id.
  "$gasjet" run "$tank" --out "$work/same" --quiet --threads 2 --set scene.end_time=0.1 || fail "run"
  same_tables "$work/before" "$work/same" history.csv energy.csv
}

part_full_disk() {
  local mesh=("$gasjet" mesh passenger --out "$work/bag.obj") code
  "${mesh[@]}" >/dev/null && cp "$work/bag.obj" "$work/before.obj" || fail "mesh"
  expect 2 "bag.obj: cannot be written" limited 8 "${mesh[@]}" --refine 1
  cmp "$work/bag.obj" "$work/before.obj" || fail "the mesh before is lost"
  local run=(run "$source/cases/rigid_tank.toml" --out "$work/run" --set output.history_every=1e-5)
  expect 3 "(history|energy).csv: write failed" limited 64 "$gasjet" "${run[@]}"
  awk -F, '/^#/ { next } !n++ { width = NF } NF != width { bad = 1 } END { exit bad || n < 3 }' "$work/run/history.csv" ||
    fail "torn or lost rows on a full disk"
  [ -z "$(tail -c 1 "$work/run/history.csv")" ] || fail "a torn row on a full disk"
  ended_as "$work/run" failed
  expect 0 "done" "$gasjet" "${run[@]}"
  expect 3 "energy.csv: write failed" limited 6 "$gasjet" run "$source/cases/rigid_tank.toml" --out "$work/end" # as the last rows come
  ended_as "$work/end" failed
  grep -q '"status": "failed"' "$work/end/summary.json" || fail "the summary of a run on a full disk"
  expect 3 "write failed" limited 8 "$gasjet" run "$source/cases/sphere_inflation.toml" --out "$work/fields" --set scene.end_time=2e-4 \
    --set output.fields_every=1e-4
  ls "$work"/fields/*-part 2>/dev/null && fail "half a file is left"
}

part_names() {
  local wild folder picture
  # The name of a scene, of its file and of its folder.
  printf -v wild 'it'"'"'s "$(touch %s)" `touch %s`; system("touch %s"); <é&>' "OWNED" "OWNED" "OWNED"
  cd "$work" || exit 1
  sed '0,/^name = .*/s||name = "q'"'"'\\"\\n$(touch OWNED)`touch OWNED`<\&>\\u00e9"|' "$source/cases/rigid_tank.toml" >"$wild.toml"
  expect 0 "done" "$gasjet" run "./$wild.toml" --out "$wild"
  /usr/bin/env python3 - "$wild/summary.json" <<'PYTHON' || fail "the summary does not name the scene"
import json, sys
scene = json.load(open(sys.argv[1]))["scene"]
sys.exit(scene != "q'\"\n$(touch OWNED)`touch OWNED`<&>é")
PYTHON
  local column="it's \$(touch OWNED)\`touch OWNED\`"
  printf '%s\n' "time_s,$column,${column}_reference" 0,1,2 1,2,3 2,1,4 >"$wild.csv"
  "$source/scripts/plot.sh" compare "$wild rows" "$wild.csv" >/dev/null && [ -s "$wild rows.svg" ] || fail "no picture of strange columns"
  for folder in "$wild" "x'; system(\"touch OWNED\"); #" "<touch OWNED; cat " "|touch OWNED" "]]>"; do # as a file's name, and in a title
    [ "$folder" = "$wild" ] || "$gasjet" run "$source/cases/rigid_tank.toml" --out "$folder" --quiet || fail "run into $folder"
    "$source/scripts/plot.sh" history "$folder/plot" "$folder" >/dev/null || fail "plot of $folder"
    for picture in svg png; do [ -s "$folder/plot.$picture" ] || fail "no picture of $folder"; done
    python3 -c 'import sys, xml.etree.ElementTree as x; x.parse(sys.argv[1])' "$folder/plot.svg" || fail "the picture of $folder is no XML"
  done
  # A line break and bytes that are no UTF-8, in names of files and in options.
  folder=$'two\nlines \xff'
  cp "$source/cases/rigid_tank.toml" "$folder.toml"
  expect 0 "done" "$gasjet" run "$folder.toml" --out "$folder"
  awk '/^#/ { next } /^time_s,/ { found = 1 } { exit !found }' "$folder/history.csv" || fail "the head of a CSV file is torn: $(head "$folder/history.csv")"
  python3 -c 'import json, sys; json.load(open(sys.argv[1], encoding="utf-8"))' "$folder/summary.json" || fail "summary.json is no UTF-8"
  expect 2 "line break" "$source/scripts/plot.sh" history plot "$folder"
  expect 0 "cheapest" "$gasjet" ladder "$folder.toml" --quantity pressure --out "$folder ladder"
  python3 -c 'import json, sys; json.load(open(sys.argv[1], encoding="utf-8"))' "$folder ladder/ladder.json" || fail "ladder.json is no UTF-8"
  expect 0 "done" "$gasjet" run "$folder ladder/cheapest.toml" --out cheapest
  cp "$source/cases/sphere_inflation.toml" "$wild ensemble.toml"
  expect 0 "" "$gasjet" ensemble "./$wild ensemble.toml" --runs 2 --quiet --out "$folder ensemble" --set scene.end_time=2e-4
  python3 -c 'import json, sys; json.load(open(sys.argv[1], encoding="utf-8"))' "$folder ensemble/$wild ensemble/ensemble.json" || fail "ensemble.json"
  find . -name OWNED | grep -q . && fail "a name was run as a command"
  cd - >/dev/null || exit 1
}

# A real full disk, where the kernel lets a test mount one; else part_full_disk is all there is.
part_small_disk() {
  local disk=$work/disk inside='mount -t tmpfs -o size=96k none "$1" || exit 77
    "$2" run "$3/cases/rigid_tank.toml" --out "$1/run" --quiet || exit 1
    cp -r "$1/run/." "$4/before"
    "$2" run "$3/cases/rigid_tank.toml" --out "$1/run" --set output.history_every=1e-5 >"$4/output" 2>&1
    [ $? = 3 ] || exit 2
    cp -r "$1/run/." "$4/full"
    rm -r "$1/run"
    "$2" run "$3/cases/rigid_tank.toml" --out "$1/run" --quiet || exit 3
    "$2" mesh passenger --out "$1/bag.obj" >>"$4/output" 2>&1
    [ $? = 2 ] && [ ! -e "$1/bag.obj" ] || exit 4
    head -c 200000 /dev/zero >"$1/filling" 2>/dev/null
    "$3/scripts/plot.sh" history "$1/plot" "$1/run" >>"$4/output" 2>&1
    [ $? = 2 ] && [ ! -e "$1/plot.png" ] || exit 5'
  mkdir "$disk" "$work/before" "$work/full"
  unshare -rm bash -c "$inside" - "$disk" "$gasjet" "$source" "$work"
  case $? in
    0)
      grep -Eq 'history.csv: write failed|energy.csv: write failed|No space' "$work/output" || fail "a full disk is told as $(cat "$work/output")"
      [ "$(sed -n 's/^status: //p' "$work/full/gasjet.status" | tail -n 1)" != "done" ] || fail "a run on a full disk says that it is done"
      ! grep -qs '"status": "\(running\|done\)"' "$work/full/summary.json" || fail "the summary of a run on a full disk: $(head -n 3 "$work/full/summary.json")"
      awk -F, '/^#/ { next } !n++ { width = NF } NF != width { bad = 1 } END { exit bad || n < 3 }' "$work/full/history.csv" ||
        fail "torn or lost rows on a full disk" ;;
    1 | 77) echo "no disk of its own: unshare or mount is not allowed here" ;;
    *) fail "on a full disk: step $?, $(cat "$work/output")" ;;
  esac
}

# Killed at any moment: the status is true, rows are whole, and the next run has the bytes of one that was left alone.
part_killed_anywhere() {
  local scene=("$source/cases/sphere_inflation.toml" --set membrane.mesh.levels=3 --set scene.end_time=5e-3 --set output.fields_every=1e-3)
  local seed=$((RANDOM = 7)) n pid begin whole ended=0 cut_off=0
  begin=$(date +%s%N)
  "$gasjet" run "${scene[@]}" --out "$work/alone" --quiet || fail "run"
  whole=$((($(date +%s%N) - begin) / 1000000)) # [ms]; less as soon as kills come too late, for the load of a machine changes
  for ((n = 1; n <= 12 || (n <= 40 && cut_off <= 2); ++n)); do
    "$gasjet" run "${scene[@]}" --out "$work/run" --quiet >/dev/null 2>&1 </dev/null &
    pid=$!
    sleep "$(printf '0.%03d' $((RANDOM % (whole < 900 ? whole + 50 : 950))))"
    kill -KILL $pid 2>/dev/null
    wait $pid 2>/dev/null
    [ -e "$work/run/gasjet.status" ] || continue
    if [ "$(sed -n 's/^status: //p' "$work/run/gasjet.status" | tail -n 1)" = "done" ]; then
      same_tables "$work/alone" "$work/run" history.csv energy.csv
      ended=$((ended + 1)) whole=$((whole * 3 / 4 - 10))
      ((whole > -45)) || whole=-45
      continue
    fi
    cut_off=$((cut_off + 1))
    [ ! -s "$work/run/history.csv" ] || awk -F, '/^#/ { next } !n++ { width = NF } NF != width { bad = 1 } END { exit bad }' "$work/run/history.csv" ||
      fail "kill $n: torn rows"
    expect 2 "" "$gasjet" compare "$work/run/history.csv" "$work/alone/history.csv"
  done
  [ $cut_off -gt 2 ] || fail "of $n kills $cut_off met a run, $ended one that had ended (seed $seed)"
  "$gasjet" run "${scene[@]}" --out "$work/run" --quiet || fail "no run after $n kills (seed $seed)"
  same_tables "$work/alone" "$work/run" history.csv energy.csv
  [ "$(ls "$work/run")" = "$(ls "$work/alone")" ] || fail "left: $(ls "$work/run")"
}

# Where a comma separates decimals.
part_locale() {
  localedef -i de_DE -f UTF-8 "$work/de_DE.UTF-8" 2>/dev/null || { fail "no German locale (package locales)"; return; }
  local comma=(env LOCPATH="$work" LC_ALL=de_DE.UTF-8)
  [ "$("${comma[@]}" printf '%.1f' 0,5)" = "0,5" ] || fail "the locale has no decimal comma"
  for case in rigid_tank passenger_pendulum; do
    local scene=("$source/cases/$case.toml" --quiet --set scene.end_time=2e-3)
    "$gasjet" run "${scene[@]}" --out "$work/plain_$case" 2>/dev/null || fail "run"
    "${comma[@]}" "$gasjet" run "${scene[@]}" --out "$work/comma_$case" 2>/dev/null || fail "run with a decimal comma"
    same_tables "$work/plain_$case" "$work/comma_$case" history.csv energy.csv
    "${comma[@]}" python3 -c 'import json, sys; json.load(open(sys.argv[1]))' "$work/comma_$case/summary.json" || fail "summary.json"
  done
  "${comma[@]}" "$gasjet" run "$source/cases/rigid_tank.toml" --out "$work/fill" --quiet || fail "run"
  expect 0 "inside" "${comma[@]}" "$gasjet" compare "$work/fill/history.csv" "$source/cases/reference/tank_fill.csv"
  cmp <("${comma[@]}" "$gasjet" exact tank_fill) <("$gasjet" exact tank_fill) || fail "exact with a decimal comma"
  cmp <("${comma[@]}" "$gasjet" mesh passenger --out "$work/comma.obj" && cat "$work/comma.obj") \
    <("$gasjet" mesh passenger --out "$work/plain.obj" && cat "$work/plain.obj") >/dev/null || cmp "$work/comma.obj" "$work/plain.obj" || fail "mesh"
  "${comma[@]}" "$source/scripts/plot.sh" history "$work/comma" "$work/comma_rigid_tank" >/dev/null || fail "plot"
  "$source/scripts/plot.sh" history "$work/plain" "$work/plain_rigid_tank" >/dev/null || fail "plot"
  cmp <(sed 's/comma/plain/g' "$work/comma.svg") "$work/plain.svg" || fail "the picture differs where a comma separates decimals"
}
