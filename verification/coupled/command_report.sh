# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Parts of command_test.sh (sourced): the page of `gasjet report`, without a browser (report_page.py has one).

# a_copy [FOLDER]: a fresh copy of the results in it, $work/bag by default, to be damaged.
a_copy() { rm -rf "$work/bad" && cp -r "${1:-$work/bag}" "$work/bad"; }

part_report() {
  local page=$work/page.html
  "$gasjet" run "$source/cases/passenger_pendulum.toml" --out "$work/bag" --quiet --set scene.end_time=1e-3 --set output.frames=4 || fail "run"
  expect 0 "page.html: [0-9.]+ MB" "$gasjet" report "$work/bag" --out "$page"
  ! grep -qE '(src|href)="?(http|//)' "$page" || fail "the page asks the network"
  [ "$(grep -c '@@' "$page")" = 0 ] || fail "a part of the page is missing"
  # Results that are none.
  expect 2 "nowhere: no such folder or file" "$gasjet" report "$work/nowhere" --out "$page"
  mkdir "$work/empty"
  expect 2 "empty: is no result: it has no history.csv, ensemble.csv or ladder.json" "$gasjet" report "$work/empty" --out "$page"
  expect 2 "RESULTS.*required" "$gasjet" report --out "$page"
  expect 2 "out.*required" "$gasjet" report "$work/bag"
  expect 2 "rigid_tank.toml:[0-9]+:1: time_s: is to be one of the columns" "$gasjet" report "$source/cases/rigid_tank.toml" --out "$page"
  expect 2 "bag/frames.bin: is a part of a result: its folder or a CSV file is allowed" "$gasjet" report "$work/bag/frames.bin" --out "$page"
  # The page never takes the place of a result.
  expect 2 "--out .*is a folder" "$gasjet" report "$work/bag" --out "$work/bag"
  expect 2 "--out .*frames.bin: a page ends with .html" "$gasjet" report "$work/bag" --out "$work/./bag/frames.bin"
  expect 2 "page.html: not writable .No such file" "$gasjet" report "$work/bag" --out "$work/nowhere/page.html"
  : >"$work/nothing.csv"
  expect 2 "nothing.csv:1:1: has no header row" "$gasjet" report "$work/nothing.csv" --out "$page"
  # Damaged tables.
  a_copy && sed -i '$s/,[^,]*$/,nan/' "$work/bad/history.csv"
  expect 2 "history.csv:[0-9]+:[0-9]+: plate_force_N: 'nan': a finite number is allowed" "$gasjet" report "$work/bad" --out "$page"
  a_copy && sed -i '$s/,[^,]*$//' "$work/bad/energy.csv"
  expect 2 "energy.csv:[0-9]+:1: has [0-9]+ columns, the header [0-9]+" "$gasjet" report "$work/bad" --out "$page"
  a_copy && tail -1 "$work/bag/history.csv" >>"$work/bad/history.csv"
  expect 2 "history.csv:[0-9]+:1: time_s: .* does not rise" "$gasjet" report "$work/bad" --out "$page"
  a_copy && sed -i '/^[0-9]/d' "$work/bad/history.csv"
  expect 2 "history.csv:[0-9]+:1: has no rows" "$gasjet" report "$work/bad" --out "$page"
  # Cut between two rows, or between two frames.
  for file in history.csv energy.csv; do
    a_copy && sed -i '$d' "$work/bad/$file"
    expect 2 "ends at .* s, .*cut" "$gasjet" report "$work/bad" --out "$page"
  done
  a_copy && truncate -s "-$(head -1 "$work/bag/frames.bin" | grep -oE '"frame_bytes":[0-9]+' | cut -d: -f2)" "$work/bad/frames.bin"
  expect 2 "frames.bin: ends at .* s, the run at .* cut" "$gasjet" report "$work/bad" --out "$page"
  # Where no status tells runs apart.
  a_copy && rm "$work/bad/gasjet.status" && sed -i 's/^# run: .*/# run: another/' "$work/bad/energy.csv"
  expect 2 "energy.csv: is of the run 'another', the table beside it" "$gasjet" report "$work/bad" --out "$page"
  a_copy && rm "$work/bad/gasjet.status" && sed -i '1s/"run":"[^"]*"/"run":"another"/' "$work/bad/frames.bin"
  expect 2 "frames.bin: is of the run 'another', the table beside it" "$gasjet" report "$work/bad" --out "$page"
  # Damaged frames and JSON.
  a_copy && truncate -s -1 "$work/bad/frames.bin"
  expect 2 "frames.bin: holds [0-9]+ bytes of frames, whole frames of [0-9]+ bytes are needed" "$gasjet" report "$work/bad" --out "$page"
  a_copy && sed -i '1s/"nodes":1374/"nodes":1373/' "$work/bad/frames.bin"
  expect 2 "frames.bin: its header contradicts itself" "$gasjet" report "$work/bad" --out "$page"
  a_copy && sed -i '1s/"triangles":\[\[[0-9]*/"triangles":[[1374/' "$work/bad/frames.bin"
  expect 2 "frames.bin: its header contradicts itself" "$gasjet" report "$work/bad" --out "$page"
  a_copy && sed -i '1s/"straps"/"Straps"/' "$work/bad/frames.bin"
  expect 2 "frames.bin: its header lacks what" "$gasjet" report "$work/bad" --out "$page"
  a_copy && echo "something else" >"$work/bad/frames.bin"
  expect 2 'frames.bin: does not begin as "gasjet frames" of format 1' "$gasjet" report "$work/bad" --out "$page"
  a_copy && truncate -s 100 "$work/bad/summary.json"
  expect 2 "summary.json: is no JSON object, or cut short" "$gasjet" report "$work/bad" --out "$page"
  a_copy && echo '{"status": 1}' >"$work/bad/summary.json"
  expect 2 "bad: its JSON is none that gasjet writes" "$gasjet" report "$work/bad" --out "$page"
  # A folder of two runs, and one whose run has not ended.
  a_copy && sed -i 's/"run": "[0-9a-f]*"/"run": "0123456789abcdef"/' "$work/bad/summary.json"
  expect 2 "summary.json: is of the run '0123456789abcdef', its folder is of" "$gasjet" report "$work/bad" --out "$page"
  a_copy && sed -i '1s/"run":"[0-9a-f]*"/"run":"0123456789abcdef"/' "$work/bad/frames.bin"
  expect 2 "frames.bin: is of the run '0123456789abcdef', its folder is of" "$gasjet" report "$work/bad" --out "$page"
  expect 2 "frames.bin: is of the run '0123456789abcdef', its folder is of" "$gasjet" mesh state "$work/bad" --time 0 --out "$work/bag.obj"
  a_copy && sed -i 's/"run": "[0-9a-f]*"/"run": "0123456789abcdef"/' "$work/bad/check.json"
  expect 2 "check.json: is of the run '0123456789abcdef', its folder is of" "$gasjet" report "$work/bad" --out "$page"
  a_copy && sed -i 's/^status: done/status: running/' "$work/bad/gasjet.status"
  expect 2 "history.csv: its run has not ended" "$gasjet" report "$work/bad" --out "$page"
  # What is missing makes the page smaller, and it says so.
  a_copy && rm "$work/bad/"{frames.bin,energy.csv,check.json}
  expect 0 "MB" "$gasjet" report "$work/bad" --out "$page"
  for file in frames.bin energy.csv check.json; do grep -q "$file is missing: no" "$page" || fail "$file: what is missing is not said"; done
  # A long history is thinned, and no peak is lost.
  awk 'BEGIN { print "time_s,pressure_Pa"; for (i = 0; i < 100000; ++i) print i * 1e-6 "," (i == 77777 ? "123456.789" : 1e5) }' >"$work/long.csv"
  expect 0 "MB" "$gasjet" report "$work/long.csv" --out "$page"
  grep -q "thinned to 400[0-9] of 100000 rows" "$page" && grep -q "123456.789" "$page" || fail "long histories are not thinned as said"
  # output.frames = 0 leaves the frames out; those of the run before go.
  expect 0 "" "$gasjet" run "$source/cases/passenger_pendulum.toml" --out "$work/bag" --quiet --set scene.end_time=1e-4 --set output.frames=0
  [ ! -e "$work/bag/frames.bin" ] || fail "frames of the run before"
  expect 2 "output.frames: is -1, a whole number from 0 to 10000" "$gasjet" run "$source/cases/passenger_pendulum.toml" --out "$work/none" --set output.frames=-1
  # Of a rigid target, too; it is no bag for meshes of states.
  "$gasjet" run "$source/cases/plate_jet.toml" --out "$work/plate" --quiet || fail "run with a target"
  expect 2 "plate/frames.bin: is of a rigid target: a run with a bag is needed" "$gasjet" mesh state "$work/plate" --time 0 --out "$work/plate.obj"
  a_copy "$work/plate" && rm "$work/bad/frames.bin"
  expect 0 "MB" "$gasjet" report "$work/bad" --out "$page"
  grep -q "frames.bin is missing: no pictures" "$page" || fail "missing pictures of a target"
  expect 2 "output.frames: the scene has no membrane and no target" "$gasjet" run "$source/cases/rigid_tank.toml" --out "$work/none" --set output.frames=10
}

# Ensembles, and bands of all kinds.
part_report_bands() {
  local page=$work/page.html all=$work/all/sphere_inflation
  "$gasjet" ensemble "$source/cases/sphere_inflation.toml" --runs 2 --quiet --set scene.end_time=1e-3 --set membrane.mesh.levels=1 \
    --out "$work/all" || fail "ensemble"
  expect 0 "MB" "$gasjet" report "$all" --out "$page"
  a_copy "$all" && echo '{}' >"$work/bad/ensemble.json"
  expect 2 "ensemble.json: is no result of gasjet ensemble" "$gasjet" report "$work/bad" --out "$page"
  a_copy "$all" && rm "$work/bad/gasjet.status" && sed -i 's/"run": "[^"]*"/"run": "another"/' "$work/bad/ensemble.json"
  expect 2 "ensemble.json: is of the run 'another', the table beside it" "$gasjet" report "$work/bad" --out "$page"
  a_copy "$all" && rm "$work/bad/runs.csv" && sed -i '$d' "$work/bad/ensemble.csv"
  expect 2 "ensemble.csv: ends at .* s, the run at 0.001 s .ensemble.json says so.: the file is cut" "$gasjet" report "$work/bad" --out "$page"
  a_copy "$all" && truncate -s -2 "$work/bad/ensemble.csv"
  expect 2 "ensemble.csv: its last row has no end of line: the file is cut" "$gasjet" report "$work/bad" --out "$page"
  expect 2 "ensemble.csv: its last row has no end of line" "$gasjet" compare "$work/bad/ensemble.csv" "$all/ensemble.csv"
  printf 'time_s,force_low_N,force_high_N,force_N\n0,1,2,1\n1,2,2,2\n2,2,3,2\n' >"$work/interval.csv"
  expect 0 "MB" "$gasjet" report "$work/interval.csv" --out "$page"
  # A history of another program is judged, too.
  local tank=$source/cases/reference/tank_fill.csv
  grep -v '^#' "$tank" | cut -d, -f1,2,4 >"$work/foreign.csv"
  mkdir "$work/ladder" && echo '{}' >"$work/ladder/ladder.json"
  expect 0 "MB" "$gasjet" report "$work/foreign.csv" --against "$tank" --out "$work/foreign.html"
  expect 2 "--against: .* is a ladder, a run, an ensemble or a history" "$gasjet" report "$work/ladder" --against "$tank" --out "$work/foreign.html"
  expect 2 "--against .*interval.csv: force_low_N: a reference states its band as half width, in NAME_band" \
    "$gasjet" report "$all" --against "$work/interval.csv" --out "$page"
  sed -i 's/^1,2,2,2/1,3,2,2/' "$work/interval.csv"
  expect 2 "interval.csv:3:1: force_low_N: 3 is above force_high_N, 2" "$gasjet" report "$work/interval.csv" --out "$page"
  for width in force_band force_standard_error; do
    printf 'time_s,force,%s\n0,1,0\n1,2,-0.5\n' $width >"$work/width.csv"
    expect 2 "width.csv:3:1: $width: -0.5: a half width of 0 or more is allowed" "$gasjet" report "$work/width.csv" --out "$page"
  done
}
