# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Parts of command_test.sh (sourced): scenes as decks of other programs, read by a parser of their own.

deck_formats=(radioss lsdyna)
read -ra deck_units <<<"${GASJET_DECK_UNITS:-kg-m-s t-mm-s kg-mm-ms}"

# Every key of a case has a row of its own, or stands below one, in the table of what becomes of it.
deck_keys() {
  local key
  while read -r key; do
    grep -qE "\"([a-z_0-9.]+\.)?$key\"" "$source/driver/export/src/feature_table.cpp" || fail "no row of the export's table names the key $key"
  done < <(sed '/^## Map of a foreign/,$d' "$source/docs/case_files.md" | grep -E '^\| `' | cut -d'|' -f2 | grep -oE '[a-z_0-9]+' | sort -u |
    grep -vxE 'file|time|value|strain|strain_column|overpressure_column|time_column|column|species|initial|radius|levels|generator|refine|heat_loss|nasa7|rings|vents|time_|fabric|ambient|gas|inflator|jet|vent|sensor|trigger|membrane|strap|plate|pendulum|contact|scene|output|weave|panel|depth|width|height|back_radius|front_radius|depth_cells|width_cells|height_cells|attachment_width_cells|attachment_height_cells|vent_depth_cell|vent_height_cell|inflator_radius|opening|inflator_rings|vent_ring|centre|normal|side|columns|rows|area|step|safety|unsafe_step|gas_tolerance|gas_step|gas_method')
}

# Curves of fabric and pressure are the case's: deck_curves JUDGE READER
deck_curves() {
  local judge=$1 reader=$2 format name units wrong out
  declare -A scale=([kg-m-s]="1 1" [t-mm-s]="1e6 1" [kg-mm-ms]="1e9 1e-3")
  for format in "${deck_formats[@]}"; do
    for name in measured_fabric clamped_disc damped_sphere; do
      for units in "${deck_units[@]}"; do
        # shellcheck disable=SC2086 # two numbers
        expect 0 "curves agree" python3 -B "$judge" "$format" "$source/cases/$name.toml" "$work/$format/$name.$units" ${scale[$units]}
      done
    done
    # Several panels, and fabric that leaks.
    out=$work/$format/threads
    expect 0 "export.md are in" "$gasjet" export "$source/cases/measured_fabric.toml" --set fabric.leak_law=printed --set fabric.porosity=0.1 \
      --set 'fabric.panel=[{panels=["skin"],thickness=0.4e-3,weave={shear_modulus=2e6,warp=[0.0,0.0,1.0]}}]' --format "$format" --units kg-m-s --out "$out"
    expect 0 "nodes=" python3 -B "$reader" "$format" "$out"
    expect 0 "curves agree" python3 -B "$judge" "$format" "$source/cases/measured_fabric.toml" "$out" 1 1
    grep -q 'stops, it goes on straight' "$out/export.md" || fail "$format: export.md of measured curves"
  done
  # What is wrong is seen: warp for weft, another measure of strain, stress in compression, a pressure the other way, what does not
  # go together, and a curve that is nowhere.
  damaged radioss measured_fabric '/^#   FCT_ID/,+1s/^         2/         3/' "off by" "$judge"
  damaged radioss measured_fabric '/^\/FUNCT\/2$/,+11s/^ *0\.22 /                0.27/' "off by" "$judge"
  damaged radioss measured_fabric 's/^\( *-1\. *\)-.*/\1-1e6/' "off by" "$judge"
  damaged radioss clamped_disc '/^#  surf_ID  funct/,+1s/ 1\.$/-1./' "pressure at" "$judge"
  damaged radioss measured_fabric 's/^\( *-1\. *\)-.*/\11e6/' "falls" "$reader"
  damaged radioss measured_fabric 's/SH_FABR/SH_ORTH/' "do not go together" "$reader"
  damaged radioss clamped_disc '/^\/PLOAD/,+3d' "neither gas nor pressure" "$reader"
  damaged lsdyna measured_fabric '/ LCA /,+1s/         3/         2/' "off by" "$judge"
  damaged lsdyna measured_fabric '/^ *0\.2442 /s/0\.2442/  0.22/' "off by" "$judge"
  damaged lsdyna clamped_disc '/^\*LOAD_SHELL_SET/,+3s/-1\./ 1./' "pressure at" "$judge"
  damaged lsdyna measured_fabric '/FORM/,+1s/       14\./       12./' "lines" "$reader"
  damaged lsdyna measured_fabric '/ LCA /,+1s/         3/      4711/' "curve 4711" "$reader"
  damaged lsdyna measured_fabric '/ISREFG/,+1s/ 0$/ 1/' "goes with FORM 12" "$reader"
  damaged lsdyna clamped_disc '/^\*LOAD_SHELL_SET/,+3d' "neither gas nor pressure" "$reader"
}

# damaged FORMAT CASE SED PATTERN JUDGE: a judge of decks sees what sed makes of one
damaged() {
  local format=$1 name=$2 file=bag_0000.rad out=$work/wrong/curves.$1
  [ "$format" = radioss ] || file=bag.k
  mkdir -p "$out"
  sed "$3" "$work/$format/$name.kg-m-s/$file" >"$out/$file"
  cmp -s "$work/$format/$name.kg-m-s/$file" "$out/$file" && fail "'$3' changes nothing"
  if [[ $5 == */deck_curves.py ]]; then
    expect 1 "$4" python3 -B "$5" "$format" "$source/cases/$name.toml" "$out" 1 1
  else
    expect 1 "$4" python3 -B "$5" "$format" "$out/$file"
  fi
}

part_decks() {
  local case name format units reader=$source/verification/coupled/deck_structure.py count=0 out settings
  local passenger=$source/cases/passenger_pendulum.toml
  deck_keys
  for case in "$source"/cases/*.toml "$source"/cases/reference/*.toml; do
    grep -q '^\[membrane\]' "$case" || continue
    name=$(basename "$case" .toml)
    settings=$("$gasjet" check "$case" | grep -cE '^  [a-z_]+\.[^ ]+( \*)? = ')
    for format in "${deck_formats[@]}"; do
      for units in "${deck_units[@]}"; do
        out=$work/$format/$name.$units
        expect 0 "export.md are in" "$gasjet" export "$case" --format "$format" --units "$units" --out "$out"
        grep -q '^## no counterpart' "$out/export.md" || fail "$name: export.md"
        [ "$(grep -c '"mapping": "\(exact\|approximated\|no counterpart\|left out\)"' "$out/export.json")" = "$settings" ] ||
          fail "$name: export.json does not name all $settings settings"
        count=$((count + 1))
      done
    done
  done
  [ $count -ge $((40 * ${#deck_units[@]})) ] || fail "only $count decks"
  for format in "${deck_formats[@]}"; do
    expect 0 "nodes=" python3 -B "$reader" "$format" "$work/$format"/*
  done
  # The parser sees what is wrong: a field moved by one column, a number that nothing defines, a lost line.
  local deck=$work/radioss/passenger_pendulum.kg-m-s/bag_0000.rad wrong
  for wrong in 's/^\(  *5 .*\)$/ \1/' '/^\/PART\/1$/,+3s/         1/      4711/' '/^\/RBODY\/1$/,+5{/Jxx/,+1d}' 's/^\/GRAV/\/GRAF/' \
    '/^\/LEAK/,+7d' '/Iformps/,+1s/^\( *[0-9]*\)         3/\1         0/'; do
    sed "$wrong" "$deck" >"$work/wrong_0000.rad"
    cmp -s "$deck" "$work/wrong_0000.rad" && fail "'$wrong' changes nothing"
    expect 1 "wrong_0000.rad:[0-9]+" python3 -B "$reader" radioss "$work/wrong_0000.rad"
  done
  deck=$work/lsdyna/passenger_pendulum.kg-m-s/bag.k
  for wrong in 's/^\(  *5  *[0-9].*\)$/ \1/' '/^\*PART$/,+3s/         1/      4711/' '/^\*PART_INERTIA$/,+5{/TM/,+1d}' 's/^\*LOAD_BODY_Z/*LOAD_BODY_W/' \
    '/LCIDM/,+1s/^         0/         1/' '/^\*CONSTRAINED_JOINT/,+3s/^\( *[0-9]*\) \( *[0-9]*\)/\2\1 /' '/^\*SECTION_SHELL$/,+2{/SECID/,+1d}'; do
    sed "$wrong" "$deck" >"$work/wrong.k"
    cmp -s "$deck" "$work/wrong.k" && fail "'$wrong' changes nothing"
    expect 1 "wrong.k:[0-9]+" python3 -B "$reader" lsdyna "$work/wrong.k"
  done
  # Numbers with a name are those of the case, in each system of units; a deck under another system's name is seen.
  for format in "${deck_formats[@]}"; do
    expect 0 "numbers agree" python3 -B "${reader%/*}/deck_units.py" "$format" "$passenger" "${deck_units[@]/#/$work/$format/passenger_pendulum.}"
    mkdir -p "$work/wrong"
    cp -rT "$work/$format/passenger_pendulum.t-mm-s" "$work/wrong/$format.kg-mm-ms"
    expect 1 "in the first deck" python3 -B "${reader%/*}/deck_units.py" "$format" "$passenger" "$work/$format/passenger_pendulum.kg-m-s" "$work/wrong/$format.kg-mm-ms"
  done
  deck_curves "${reader%/*}/deck_curves.py" "$reader"
  # Strain is logarithmic, and linear for woven fabric.
  grep -qE '^         0         4         2' "$work/radioss/sphere_inflation.kg-m-s/bag_0000.rad" || fail "strain of isotropic fabric"
  grep -qE '^         0        11         2' "$work/radioss/driver_bag.kg-m-s/bag_0000.rad" || fail "strain of woven fabric"
  # A vent that stays closed, and a name that would begin keywords of its own.
  for format in "${deck_formats[@]}"; do
    out=$work/$format/closed
    expect 0 "export.md are in" "$gasjet" export "$passenger" --set 'vent.0.area={time=[0.0,0.1],value=[0.0,0.0]}' \
      --set 'scene.name="*END\n/END"' --format "$format" --units kg-m-s --out "$out"
    expect 0 "nodes=" python3 -B "$reader" "$format" "$out"
    grep -qx '_[*]END_/END' "$out"/bag* || fail "$format: the scene's name"
  done
  # What is left out is told loudly. The run goes on past the scene's end, by an interval of the histories and a hundredth.
  for format in "${deck_formats[@]}"; do
    expect 0 "^warning: the deck has none of the case's 1 inflators" "$gasjet" export "$source/cases/sphere_inflation.toml" \
      --set 'sensor=[{name="p",overpressure=5e3}]' --set 'inflator.0.trigger="p"' --format "$format" --units kg-m-s --out "$work/$format/without"
    grep -A1 -hE '^/RUN/|ENDTIM' "$work/$format/without"/bag* | grep -qE '^ +0?\.0607$' || fail "$format: end of the run"
  done
  # Bad input.
  expect 2 "has no \[membrane\]" "$gasjet" export "$source/cases/rigid_tank.toml" --format radioss --units kg-m-s --out "$work/none"
  expect 2 "longest extent is 680 m" "$gasjet" export "$source/cases/sphere_inflation.toml" --set membrane.mesh.radius=340.0 --format radioss --units kg-m-s --out "$work/none"
  expect 0 "export.md" "$gasjet" export "$source/cases/sphere_inflation.toml" --set membrane.mesh.radius=340.0 --any-size --format radioss --units kg-m-s --out "$work/large"
  expect 2 "--format" "$gasjet" export "$passenger" --format abaqus --units kg-m-s --out "$work/none"
  expect 2 "--units" "$gasjet" export "$passenger" --format radioss --units inches --out "$work/none"
  expect 2 "required" "$gasjet" export "$passenger" --format radioss --units kg-m-s
  expect 2 "/proc/none: (No such file|Permission|Not permitted|Operation)" "$gasjet" export "$passenger" --format radioss --units kg-m-s --out /proc/none
  [ ! -e "$work/none" ] || fail "a folder of a deck that was refused"
}
