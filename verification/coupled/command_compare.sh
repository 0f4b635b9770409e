# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Parts of command_test.sh (sourced): histories against references.

part_compare() {
  local mine=$work/tank/history.csv reference=$work/reference.csv rows=$work/rows.csv share
  "$gasjet" run "$source/cases/rigid_tank.toml" --out "$work/tank" --quiet || fail "run"
  # Bands of the closed form: eps x 100 steps of a number of order 1e5 and 1e3.
  with_bands() { awk -F, -v p="$1" -v T="$2" '/^#/ { print; next } !n++ { print $0 ",pressure_Pa_band,temperature_K_band"; next } { print $0 "," p "," T }'; }
  "$gasjet" exact tank_fill --times 0:0.1:0.01 | with_bands 2e-8 2e-10 >"$reference"
  expect 0 "^inside" "$gasjet" compare "$mine" "$reference" --rows "$rows"
  [ "$(grep -c . "$rows")" = 12 ] && grep -q '^time_s,pressure_Pa,pressure_Pa_reference,pressure_Pa_band,temperature_K' "$rows" ||
    fail "rows: $(head -2 "$rows")"
  expect 0 '"phase_lag_s": 0.0' "$gasjet" compare "$mine" "$reference" --format json
  # A value that does not depend on time, as the time of the end, is no column: the history of the case is all of it.
  printf '%s\n' '[scene]' 'name = "inrush"' 'end_time = 0.4' '[ambient]' 'composition = { N2 = 1 }' '[gas]' \
    'initial = { composition = { N2 = 1 }, pressure = 20000 }' '[tank]' 'volume = 0.06' '[[vent]]' 'area = 1e-3' 'backflow = true' \
    '[output]' 'history_exact = true' 'history_every = 0.01' >"$work/inrush.toml"
  "$gasjet" run "$work/inrush.toml" --out "$work/inrush" --quiet || fail "run of inrush"
  "$gasjet" exact ambient_inrush --times 0:0.4:0.01 --set gas_constant=296.7966951578939 --set heat_capacity_ratio=1.399547035325335 >"$work/inrush.csv"
  grep -q '^# end_time_s: 0.227' "$work/inrush.csv" || fail "no line of the end: $(head -20 "$work/inrush.csv")"
  expect 0 "^inside" "$gasjet" compare "$work/inrush/history.csv" "$work/inrush.csv" --tolerance 1e-8
  expect 0 '"end_time_s": 0.227' "$gasjet" exact ambient_inrush --format json
  # Time in ms and pressure in bar above ambient, brought back by a map; without it there are no such columns.
  # Begun by a byte order mark, as spreadsheets write it, which is none of the text.
  { printf '\xef\xbb\xbf' && awk -F, '/^#/ { next } !n++ { print "ms,bar"; next } { printf "%.17g,%.17g\n", 1e3 * $1, ($2 - 101325) / 1e5 }' "$mine"; } \
    >"$work/foreign.csv"
  printf 'format = "csv"\n[time]\ncolumn = "ms"\nscale = 1e-3\n[[quantity]]\nname = "pressure_Pa"\ncolumn = "bar"\nscale = 1e5\noffset = 101325\n' >"$work/map.toml"
  expect 0 "^inside" "$gasjet" compare "$work/foreign.csv" "$reference" --map "$work/map.toml" --columns pressure_Pa
  expect 4 "undecided: temperature_K: mine does not have it" "$gasjet" compare "$work/foreign.csv" "$reference" --map "$work/map.toml"
  expect 2 "foreign.csv:1:1: time_s: no such column, the header has ms, bar; --map names the columns" "$gasjet" compare "$work/foreign.csv" "$reference"
  tr , ';' <"$work/foreign.csv" >"$work/semicolons.csv"
  expect 2 "the header has ms;bar; commas are needed between columns; --map" "$gasjet" compare "$work/semicolons.csv" "$reference"
  # A column that is needed has to be there, a name to be one of the reference; what a map for many scenes has beside is left out.
  sed 's/"bar"/"barr"/' "$work/map.toml" >"$work/bad.toml"
  expect 2 "bad.toml:7:1: quantity.0.column: 'barr' is not in .*foreign.csv, the header has ms, bar; is 'bar' meant\?" "$gasjet" compare "$work/foreign.csv" "$reference" --map "$work/bad.toml"
  sed 's/pressure_Pa/presure_Pa/' "$work/map.toml" >"$work/bad.toml"
  expect 2 "bad.toml:6:1: quantity.0.name: the reference has no column 'presure_Pa', .* is 'pressure_Pa' meant\?" "$gasjet" compare "$work/foreign.csv" "$reference" --map "$work/bad.toml"
  { cat "$work/map.toml" && printf '[[quantity]]\nname = "skin_area_m2"\ncolumn = "none"\n'; } >"$work/wide.toml"
  expect 4 "wide.toml:11:1: quantity.1.name: 'skin_area_m2' is left out: the reference has no such column" "$gasjet" compare "$work/foreign.csv" "$reference" --map "$work/wide.toml"
  expect 0 "^inside" "$gasjet" compare "$work/foreign.csv" "$reference" --map "$work/wide.toml" --columns pressure_Pa
  # Outside, and no band to be inside of.
  "$gasjet" exact tank_fill --times 0:0.1:0.01 --set mass_flow=1.0001 | with_bands 2e-8 2e-10 >"$work/other.csv"
  expect 1 "^outside: pressure_Pa: 10 of 11 rows outside" "$gasjet" compare "$mine" "$work/other.csv"
  expect 1 '"verdict": "outside"' "$gasjet" compare "$mine" "$work/other.csv" --format json
  expect 4 "^undecided: the reference states no band, --tolerance gives one" "$gasjet" compare "$mine" "$mine"
  # Without any band the tolerance is the band: 1e-4 too much inflow is 9e-5 of the pressure.
  "$gasjet" exact tank_fill --times 0:0.1:0.01 --set mass_flow=1.0001 >"$work/bare.csv"
  expect 0 "^inside" "$gasjet" compare "$mine" "$work/bare.csv" --columns pressure_Pa,temperature_K --tolerance 1e-4
  expect 1 "^outside: pressure_Pa" "$gasjet" compare "$mine" "$work/bare.csv" --columns pressure_Pa,temperature_K --tolerance 8e-5
  expect 4 "^undecided: the reference states no band" "$gasjet" compare "$mine" "$work/bare.csv" --columns pressure_Pa --tolerance 0
  expect 2 "--columns volume_m3: .* allowed are pressure_Pa, temperature_K" "$gasjet" compare "$mine" "$reference" --columns volume_m3
  expect 2 "--columns '': a name is empty, allowed are pressure_Pa" "$gasjet" compare "$mine" "$reference" --columns pressure_Pa,
  expect 0 "^inside" "$gasjet" compare "$mine" "$reference" --columns pressure_Pa,temperature_K
  "$gasjet" exact tank_fill --times 0:0.1:0.01 | with_bands -0.1 2e-10 >"$work/negative.csv"
  expect 2 "negative.csv:[0-9]+:[0-9]+: pressure_Pa_band: -0.1: a half width of 0 or more" "$gasjet" compare "$mine" "$work/negative.csv"
  lost "$gasjet" compare "$mine" "$reference"
  lost "$gasjet" compare "$mine" "$reference" --format json
  expect 2 "no such file" "$gasjet" compare "$work/none.csv" "$reference"
  expect 2 "no such file" "$gasjet" compare "$mine" "$reference" --map "$work/none.toml"
  expect 2 "not writable" "$gasjet" compare "$mine" "$reference" --rows "$work/nowhere/rows.csv"
  expect 2 "required" "$gasjet" compare "$mine"
  # Thousands of columns take no longer than their bytes: a second, or a minute if each were looked for among all.
  awk 'BEGIN { for (r = 0; r < 5; ++r) { printf r ? r : "time_s"; for (c = 0; c < 20000; ++c) printf ",%s%d", r ? "" : "q", c; print "" } }' >"$work/wide.csv"
  expect 4 "states no band" timeout 30 "$gasjet" compare "$work/wide.csv" "$work/wide.csv"
  # What a run can write is read, however long; a device that never ends is not.
  awk 'BEGIN { print "time_s,pressure_Pa"; for (i = 0; i < 2600000; i++) printf "%d.0000000000,101325.0000\n", i }' >"$work/long.csv"
  [ "$(stat -c %s "$work/long.csv")" -gt $((64 << 20)) ] || fail "a short file"
  expect 4 "states no band" "$gasjet" compare "$work/long.csv" "$mine"
  expect 2 "/dev/zero:1:1: the line is longer than 1 MiB" "$gasjet" compare /dev/zero "$reference"
  cp "$reference" "$work/kept.csv"
  expect 2 "--rows .*would overwrite" "$gasjet" compare "$mine" "$reference" --rows "$work/./reference.csv"
  cmp "$reference" "$work/kept.csv" || fail "the reference is overwritten"
  expect 2 "--rows.*is empty" "$gasjet" compare "$mine" "$reference" --rows ""
  # 1e-4 too much inflow is 9e-5 of the pressure, less of the temperature.
  expect 0 "^inside" "$gasjet" compare "$mine" "$work/other.csv" --tolerance 1e-4
  expect 0 "^inside" "$gasjet" compare "$mine" "$work/other.csv" --tolerance 0.01%
  expect 0 "^inside" "$gasjet" compare "$mine" "$work/other.csv" --tolerance pressure_Pa=1e-4 --tolerance 1e-4
  expect 1 "^outside: pressure_Pa" "$gasjet" compare "$mine" "$work/other.csv" --tolerance pressure_Pa=1e-6 --tolerance 1e-4
  expect 1 "^outside: temperature_K" "$gasjet" compare "$mine" "$work/other.csv" --tolerance pressure_Pa=1e-4
  for share in nan -1 1.5 x "" pressure_Pa= pressure_Pa=nan; do
    expect 2 "--tolerance $share: .* a finite number from 0 to 1, such as 0.02 or 2%, or COLUMN=SHARE" "$gasjet" compare "$mine" "$reference" --tolerance "$share"
  done
  expect 2 "--tolerance volume: the reference has no such quantity, allowed are pressure_Pa" "$gasjet" compare "$mine" "$reference" --tolerance volume=0
  expect 2 "--tolerance 2e-3: is given twice" "$gasjet" compare "$mine" "$reference" --tolerance 1e-3 --tolerance 2e-3
}

# Means of many runs: what ensemble.csv holds is judged as it is; its number of runs has to be there.
part_compare_means() {
  local case=$source/cases/sphere_inflation.toml mine=$work/mine/sphere_inflation/ensemble.csv other=$work/other/sphere_inflation/ensemble.csv
  options=(--runs 4 --quiet --set scene.end_time=2e-3 --set membrane.mesh.levels=1)
  expect 0 "" "$gasjet" ensemble "$case" "${options[@]}" --out "$work/mine"
  expect 0 "" "$gasjet" ensemble "$case" "${options[@]}" --out "$work/other" --first-seed 5
  cmp -s "$mine" "$other" && fail "--first-seed does nothing"
  expect 0 "the mean of 4 runs against the mean of 4" "$gasjet" compare "$mine" "$other"
  expect 0 '"seen_share": ' "$gasjet" compare "$mine" "$other" --format json
  expect 0 '"reference_runs": 4' "$gasjet" compare "$mine" "$other" --format json
  expect 0 "" "$gasjet" run "$case" --quiet --out "$work/run" "${options[@]:3}" --set membrane.perturbation=1e-4 --set membrane.perturbation_seed=9
  expect 0 "one run against the mean of 4" "$gasjet" compare "$work/run/history.csv" "$other"
  expect 0 "" "$gasjet" run "$case" --quiet --out "$work/run" "${options[@]:3}" --set ambient.temperature=294
  expect 1 "^outside: temperature_K" "$gasjet" compare "$work/run/history.csv" "$other" --columns temperature_K
  local runs
  for runs in "" 1 0 -4 4.5 x 99999999999; do
    sed "s/^# runs: .*/# runs: $runs/" "$mine" >"$work/wrong.csv"
    expect 2 "wrong.csv:[0-9]+:1: runs: '$runs' is no number of runs, which .*_standard_error needs" "$gasjet" compare "$work/wrong.csv" "$other"
  done
  grep -v '^# runs: ' "$mine" >"$work/wrong.csv"
  expect 2 "wrong.csv:[0-9]+:1: runs: '' is no number" "$gasjet" compare "$work/wrong.csv" "$other"
  awk -F, -v OFS=, '/^#/ || !n++ { print; next } { $3 = -1; print }' "$mine" >"$work/wrong.csv"
  expect 2 "wrong.csv:[0-9]+:[0-9]+: .*-1: a standard error of 0 or more" "$gasjet" compare "$work/wrong.csv" "$other"
  printf '%s\n' '# runs: 4' time_s,alone_standard_error 0,1 1,1 2,1 >"$work/wrong.csv"
  expect 2 "wrong.csv:1:1: alone_standard_error: has no column alone beside it" "$gasjet" compare "$work/wrong.csv" "$other"
}

# The reference set is what its checksums say; every scene, run anew, lies within the bands. The passenger scenes with a seed that is none
# of the ensemble's, in optimised builds only: minutes under the sanitizers.
part_reference() {
  local scene case options word table=$source/cases/reference
  (cd "$table" && sha256sum --quiet --strict -c SHA256SUMS) || fail "SHA256SUMS of cases/reference"
  [ "$(ls "$table"/*.csv | wc -l)" = 14 ] || fail "14 scenes expected in $table"
  for scene in $(cd "$table" && ls -- *.csv | sed 's/\.csv$//'); do
    grep -q "^# band" "$table/$scene.csv" || fail "$scene does not say where its bands are from"
    grep -v '^#' "$table/$scene.csv" | head -1 | tr , '\n' | awk -v means="$(grep -c '^# runs: ' "$table/$scene.csv")" '
      NR == 1 { next } { part = (NR - 2) % (means ? 4 : 2) } part == 0 { last = $0; next }
      $0 != last (part == (means ? 3 : 1) ? "_band" : part == 1 ? "_standard_error" : "_scatter") { exit 1 }
      END { exit part != (means ? 3 : 1) }' || fail "$scene: a column without a band, or without standard error and scatter"
    case=$source/$(sed -n 's/^# case: //p' "$table/$scene.csv")
    "$gasjet" mesh case "$case" --out "$work/$scene.obj" >/dev/null 2>&1 && [ -e "$table/$scene.obj" ] &&
      { cmp "$work/$scene.obj" "$table/$scene.obj" || fail "$scene: the mesh is not the case's"; }
    options=()
    for word in $(sed -n 's/^# initial shape: //p' "$table/$scene.csv"); do options+=(--set "$word"); done
    if [ ${#options[@]} -gt 0 ] && ! "$gasjet" --version | grep -q "Release"; then continue; fi
    expect 0 "" "$gasjet" run "$case" --quiet --out "$work/$scene" "${options[@]}"
    expect 0 "^inside" "$gasjet" compare "$work/$scene/history.csv" "$table/$scene.csv"
    [ ${#options[@]} -gt 0 ] || continue
    expect 0 "" "$gasjet" run "$case" --quiet --out "$work/$scene" "${options[@]}" --set vent.0.area=2.1e-3
    expect 1 "^outside" "$gasjet" compare "$work/$scene/history.csv" "$table/$scene.csv"
  done
  # The command that made the set makes it: a scene whose case reads the mesh that is written beside it.
  mkdir "$work/set" && cp "$table"/plate_jet_shadow.toml "$work/set"
  expect 0 "plate_jet_shadow: 22 rows" env GASJET="$gasjet" REFERENCE_OUT="$work/set" "$source/scripts/reference_set.sh" plate_jet_shadow
  expect 0 "^inside" "$gasjet" compare "$work/set/plate_jet_shadow.csv" "$table/plate_jet_shadow.csv"
  for file in plate_jet_shadow.obj plate_jet_shadow.k; do cmp "$work/set/$file" "$table/$file" || fail "$file is made anew otherwise"; done
  (cd "$work/set" && sha256sum --quiet --strict -c SHA256SUMS) || fail "SHA256SUMS of a set made anew"
  expect 0 "" "$gasjet" run "$source/cases/reference/sphere_vent.toml" --quiet --out "$work/wrong" --set vent.0.area=3.2e-4
  expect 1 "^outside" "$gasjet" compare "$work/wrong/history.csv" "$table/sphere_vent.csv"
  local wrong
  for wrong in friction=0.25 stiffness=0.9e8; do
    expect 0 "" "$gasjet" run "$table/cushion_impact.toml" --quiet --out "$work/wrong" --set contact.$wrong
    expect 1 "contact_force_N .* outside: " "$gasjet" compare "$work/wrong/history.csv" "$table/cushion_impact.csv"
  done
}

# A whole history as foreign programs print it, in kg, mm and ms, by the shipped maps: abstat has four to five digits (l2a's formats),
# th_to_csv six decimals, which is nothing of a pressure in GPa.
part_foreign_history() {
  local reference=$source/cases/reference/sphere_vent.csv maps=$source/cases/maps columns=volume_m3,temperature_K,gas_mass_kg,skin_area_m2 flow
  "$gasjet" run "$source/cases/reference/sphere_vent.toml" --quiet --out "$work/vent" || fail "run"
  abstat() { # abstat FACTOR: of the vent's flow
    printf '\n  airbag/control volume statistics\n'
    awk -F, -v factor="$1" '/^#/ || !n++ { next } {
      printf "\n\n      time   airbag/cv #  volume        pressure    internal energy      dm/dt in      density dm/dt out  total mass gas temp. surface area   reaction\n"
      printf "%12.5E%8d%15.4E%15.4E%15.4E%15.4E%15.4E%11.3E%11.3E%11.3E%11.3E%11.3E\n", 1e3 * $1, 1, 1e9 * $4, $2 / 1e9, 0, $6 / 1e3, $5 / $4 / 1e9, factor * $7 / 1e3, $5, $3, 1e6 * $8, 0
    }' "$work/vent/history.csv"
  }
  abstat 1 >"$work/abstat"
  expect 0 "^inside" "$gasjet" compare "$work/abstat" "$reference" --map "$maps/lsdyna_abstat.toml" --tolerance 1e-3
  for flow in -1 1.1; do
    abstat $flow >"$work/wrong"
    expect 1 "^outside: vent_outflow_kg_s" "$gasjet" compare "$work/wrong" "$reference" --map "$maps/lsdyna_abstat.toml" --tolerance 1e-3
  done
  head -n 400 "$work/abstat" >"$work/cut"
  expect 4 "^undecided: .*covers 0 to 0.0[0-9]+ s, the reference 0 to 0.06 s" "$gasjet" compare "$work/cut" "$reference" --map "$maps/lsdyna_abstat.toml" --tolerance 1e-3
  head -c 20000 "$work/abstat" >"$work/torn"
  expect 2 "torn:[0-9]+:[0-9]+: the row ends in field" "$gasjet" compare "$work/torn" "$reference" --map "$maps/lsdyna_abstat.toml"
  awk -F, 'BEGIN { print "\"time\",\"MASS\",\"TH_BAG  1 bag       MASS      \",\"TH_BAG  1 bag       VOL       \",\"TH_BAG  1 bag       P         \",\"TH_BAG  1 bag       A         \",\"TH_BAG  1 bag       T         \"" }
    /^#/ || !n++ { next } { printf "%f,%f,%f,%f,%f,%f,%f\n", 1e3 * $1, 9, $5, 1e9 * $4, $2 / 1e9, 1e6 * $8, $3 }' "$work/vent/history.csv" >"$work/bagT01.csv"
  expect 0 "^inside" "$gasjet" compare "$work/bagT01.csv" "$reference" --map "$maps/openradioss_monvol.toml" --columns $columns
  expect 1 "^outside: pressure_Pa" "$gasjet" compare "$work/bagT01.csv" "$reference" --map "$maps/openradioss_monvol.toml"
  expect 4 "undecided: inflow_kg_s: mine does not have it" "$gasjet" compare "$work/bagT01.csv" "$reference" --map "$maps/openradioss_monvol.toml" --columns $columns,inflow_kg_s
}

# A foreign program is inside; each of its defects is caught, as outside, as undecided or as a bad file.
part_external() {
  local code defect
  export GASJET=$gasjet
  judge() { # judge CODE PATTERN [DEFECT [SCENES]]
    expect "$1" "$2" env DEFECT="${3:-}" "$source/verification/run_external.sh" --tolerance 1e-5 \
      --scenes "${4:-tank_fill,tank_blowdown}" "$source/verification/coupled/foreign_tank.sh"
  }
  judge 0 "pendulum_swing: not done" "" pendulum_swing,tank_fill
  judge 0 "tank_blowdown: inside"
  for defect in gauge kilopascal celsius late gamma discharge inflow ambient euler energy_in energy_out never_chokes; do judge 1 ": outside: " $defect; done
  for defect in no_volume stops; do judge 4 ": undecided: " $defect; done
  judge 4 "undecided: .* sampled too coarsely" sparse tank_fill
  judge 2 "tank_fill.csv:[0-9]+:[0-9]+: 'nan'" nan
  judge 2 "tank_fill: the program failed with exit code 3" crash
  printf '#!/bin/sh\n[ "$1" != compare ] || exit 139\nexec "%s" "$@"\n' "$gasjet" >"$work/dying" && chmod +x "$work/dying"
  GASJET=$work/dying judge 2 "tank_fill: " "" tank_fill
  expect 2 "does none of the scenes" "$source/verification/run_external.sh" --scenes pendulum_swing "$source/verification/coupled/foreign_tank.sh"
  # What no case says is handed over: the ends of the generator's straps, and three files of the mesh.
  cat >"$work/looks" <<'PROGRAM'
#!/bin/bash
mapfile -t meshes < <(sed -nE 's/^  "mesh[a-z_]*": "(.*)",$/\1/p' "$1")
[ ${#meshes[@]} = 3 ] && [ -s "${meshes[0]}" ] && grep -q ELEMENT_SHELL "${meshes[1]}" && [ -s "${meshes[2]}" ] || exit 1
[ "$(grep -c '"\(from\|to\)_m"' "$1")" = 4 ] && grep -q '"jet_hidden_elements"' "$1" && exit 77
PROGRAM
  chmod +x "$work/looks"
  expect 2 "passenger_jet: not done" "$source/verification/run_external.sh" --scenes passenger_jet "$work/looks"
  # A program that does not end is ended.
  printf '#!/bin/sh\nexec sleep 20\n' >"$work/endless" && chmod +x "$work/endless"
  expect 2 "tank_fill: the program took longer than 1 s .--out keeps" "$source/verification/run_external.sh" --timeout 1 --scenes tank_fill "$work/endless"
  expect 2 "tank_fill: the program wrote no history: " "$source/verification/run_external.sh" --scenes tank_fill true
  expect 0 "^usage: run_external.sh" "$source/verification/run_external.sh" --help
  expect 2 "--timeout 0: a whole number" "$source/verification/run_external.sh" --timeout 0 false
  expect 2 "no scene 'tank'" "$source/verification/run_external.sh" --scenes tank false
  expect 2 "needs the command" "$source/verification/run_external.sh" --tolerance 0.1
  expect 2 "^run_external.sh: unknown option --band; allowed before" "$source/verification/run_external.sh" --band
  expect 2 "^run_external.sh: no program '/no/such'" "$source/verification/run_external.sh" /no/such
  # A tolerance of one column of one scene; the last row that fits counts.
  local share wrong
  tolerances() { printf '%s\n' 'scene,column,tolerance' "$@" >"$work/tolerances.csv"; }
  judge_by() { # judge_by CODE PATTERN [DEFECT]
    expect "$1" "$2" env DEFECT="${3:-}" "$source/verification/run_external.sh" --tolerance 1e-5 --tolerances "$work/tolerances.csv" \
      --scenes tank_fill,tank_blowdown --out "$work/judged" "$source/verification/coupled/foreign_tank.sh"
  }
  tolerances 'tank_fill,*,0.002' '# of the vent' 'tank_fill , temperature_K , 1e-3'
  judge_by 0 "tank_fill: inside" inflow
  for file in tank_fill.{json,csv,log,txt,rows.csv} report.json junit.xml; do [ -e "$work/judged/$file" ] || fail "--out does not keep $file"; done
  tolerances 'tank_fill,*,0.002' 'tank_fill,inflow_kg_s,0'
  judge_by 1 "tank_fill: outside: inflow_kg_s" inflow
  grep -q '<failure type="outside"' "$work/judged/junit.xml" && grep -q '"verdict": "outside",' "$work/judged/report.json" || fail "reports of a wrong inflow"
  tolerances '*,inflow_kg_s,0.01' 'tank_blowdown,*,1e-5'
  judge_by 1 "  outside: gas_mass_kg: " inflow
  for wrong in 'tank_fil,*,0:3:1: scene: no scene' 'tank_fill,vent_outflow_kg_s,0:3:11: column: no column .* of tank_fill' '*,pressure,0:3:3: column: no column .* of any' \
    '*,*,nan:3:5: tolerance: .*a share from 0 to 1' '*,*,2:3:5: tolerance' '*,*:3:1: has 2 fields'; do
    tolerances '*,*,0' "${wrong%%:*}"
    judge_by 2 "tolerances.csv:${wrong#*:}"
  done
  : >"$work/tolerances.csv" && judge_by 2 "tolerances.csv:1:1: is empty"
  echo 'scene,tolerance' >"$work/tolerances.csv" && judge_by 2 "tolerances.csv:1:1: the header scene,column,tolerance is needed"
  rm "$work/tolerances.csv" && judge_by 2 "no such file"
  expect 2 "--out /proc/none: the folder is not writable" "$source/verification/run_external.sh" --out /proc/none false
  GASJET=$work/none expect 2 "no program .*/none: build it first, or name it by the variable GASJET" "$source/verification/run_external.sh" false
  for share in nan inf -1 1.5 x ""; do
    expect 2 "^run_external.sh: --tolerance $share: a share from 0 to 1" "$source/verification/run_external.sh" --tolerance "$share" false
  done
}
