# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Parts of command_test.sh (sourced): files of the user's, in folders of results and in names.

part_own_files() {
  local tank=$source/cases/rigid_tank.toml bag=$source/cases/jet_bag.toml name plan=$work/plan.toml
  mkdir "$work/parts"
  for name in summary.json.part history.csv.part bag.obj.part; do echo mine >"$work/parts/$name"; done
  expect 0 "done" "$gasjet" run "$tank" --out "$work/parts"
  expect 0 "done" "$gasjet" run "$tank" --out "$work/parts"
  expect 0 "elements" "$gasjet" mesh passenger --out "$work/parts/bag.obj"
  for name in summary.json.part history.csv.part bag.obj.part; do
    [ "$(cat "$work/parts/$name")" = mine ] || fail "$name of the user's is lost"
  done
  # What another command is writing into the same file, or the user's, keeps its own name beside it.
  cp "$work/parts/bag.obj" "$work/before.obj"
  for name in bag.obj page.html; do echo mine >"$work/parts/$name.gasjet-part"; done
  expect 0 "elements" "$gasjet" mesh passenger --out "$work/parts/bag.obj"
  expect 0 "MB" "$gasjet" report "$work/parts" --out "$work/parts/page.html"
  cmp "$work/parts/bag.obj" "$work/before.obj" && tail -n 1 "$work/parts/page.html" | grep -q '</html>' || fail "half a file"
  for name in bag.obj page.html; do
    [ "$(cat "$work/parts/$name.gasjet-part")" = mine ] || fail "$name.gasjet-part of another's is lost"
    [ "$(ls -d "$work/parts/$name".gasjet-part*)" = "$work/parts/$name.gasjet-part" ] || fail "left: $(ls "$work/parts")"
  done
  rm "$work/parts"/*.gasjet-part
  # A result that the user has put in another's place, also where this run writes no such file.
  local short=(run "$bag" --quiet --set scene.end_time=1e-3)
  expect 0 "" "$gasjet" "${short[@]}" --set output.fields_every=1e-3 --out "$work/replaced"
  for name in history.csv bag_00001.vtp; do
    cp "$work/replaced/$name" "$work/left" && echo mine >"$work/replaced/$name"
    expect 2 "$name is not as its run left it: move it away" "$gasjet" "${short[@]}" --out "$work/replaced"
    [ "$(cat "$work/replaced/$name")" = mine ] && cp "$work/left" "$work/replaced/$name" || fail "$name of the user's is lost"
  done
  expect 0 "" "$gasjet" "${short[@]}" --out "$work/replaced"
  [ ! -e "$work/replaced/bag_00001.vtp" ] || fail "a frame of the run before stays"
  # A run that ends before its first frame: the same command takes its place.
  for _ in 1 2; do
    expect 3 "step 0: .* is not finite" "$gasjet" run "$source/cases/plate_jet.toml" --set output.frames=3 --set inflator.0.mass_flow=1e305 --out "$work/failed"
  done
  # A deck's folder is a folder of results.
  local deck=(export "$bag" --units kg-m-s)
  mkdir "$work/deck" && echo mine >"$work/deck/export.md"
  expect 2 "export.md is there, and no run is known to have written it" "$gasjet" "${deck[@]}" --format radioss --out "$work/deck"
  [ "$(cat "$work/deck/export.md")" = mine ] && rm "$work/deck/export.md" || fail "export.md of the user's is lost"
  expect 0 "are in" "$gasjet" "${deck[@]}" --format radioss --out "$work/deck"
  expect 0 "are in" "$gasjet" "${deck[@]}" --format lsdyna --out "$work/deck"
  [ "$(ls "$work/deck")" = "$(printf '%s\n' bag.k export.json export.md gasjet.status)" ] || fail "two decks in one folder: $(ls "$work/deck")"
  expect 2 "holds the results of gasjet run" "$gasjet" "${deck[@]}" --format radioss --out "$work/parts"
  expect 0 "a.x0ab: bag.k and export.md are in" "$gasjet" "${deck[@]}" --format lsdyna --out "$work/deck" --set 'scene.name="a\nb"'
  grep -q '^# a.x0ab as a deck of lsdyna' "$work/deck/export.md" || fail "a name of two lines: $(head -n 2 "$work/deck/export.md")"
  # The folder around an ensemble's results is the ensemble's too.
  expect 0 "" "$gasjet" ensemble "$source/cases/sphere_inflation.toml" --runs 2 --quiet --set scene.end_time=2e-4 --out "$work/around"
  expect 2 "holds the results of gasjet ensemble, another folder is allowed" "$gasjet" run "$tank" --out "$work/around"
  # A study that is refused leaves nothing.
  printf '[study]\ncase = "%s"\nquantities = ["peak_pressure_Pa"]\n' "$tank" >"$plan"
  ls "$work/parts" >"$work/before"
  expect 2 "holds the results of gasjet run, another folder is allowed" "$gasjet" study run "$plan" --out "$work/parts"
  ls "$work/parts" | cmp - "$work/before" || fail "a study that is refused leaves files"
  mkdir "$work/study" && echo mine >"$work/study/results.csv"
  expect 2 "results.csv is there" "$gasjet" study run "$plan" --out "$work/study"
  [ "$(ls "$work/study")" = results.csv ] || fail "a study that is refused leaves files"
  # Names of files that are no UTF-8.
  name=$work/$'a\xff.csv'
  cp "$source/cases/reference/tank_fill.csv" "$name"
  "$gasjet" compare "$name" "$name" --format json >"$work/compare.json" || fail "compare of a file whose name is no UTF-8"
  python3 -c 'import json, sys; json.load(open(sys.argv[1], encoding="utf-8"))' "$work/compare.json" || fail "compare.json"
  # Lines that end with a carriage return alone.
  tr '\n' '\r' <"$source/cases/reference/tank_fill.csv" >"$work/mac.csv"
  expect 2 "mac.csv:1:[0-9]+: a carriage return within a line" "$gasjet" compare "$work/mac.csv" "$work/mac.csv"
  # Half a million knots: whatever looks at them all looks at each once.
  sed '/^mass_flow/d' "$tank" >"$work/knots.toml"
  awk 'BEGIN { print "time_s,flow"; for (i = 0; i < 500000; i++) printf "%.7f,1\n", i * 2e-7 }' >"$work/knots.csv"
  expect 0 "done" timeout 100 "$gasjet" run "$work/knots.toml" --set 'inflator.0.mass_flow={file="knots.csv",time_column="time_s",column="flow"}' --out "$work/knots"
}
