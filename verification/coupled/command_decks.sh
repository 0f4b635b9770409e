# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Parts of command_test.sh (sourced): scenes as decks of other programs, read by a parser of their own.

deck_formats=(radioss lsdyna)
read -ra deck_units <<<"${GASJET_DECK_UNITS:-kg-m-s t-mm-s kg-mm-ms}"

# Every key of a case has a row of its own, or stands below one, in the table of what becomes of it.
deck_keys() {
  local key
  while read -r key; do
    grep -qE "\"([a-z_0-9.]+\.)?$key\"" "$source/driver/src/export/feature.cpp" || fail "no row of the export's table names the key $key"
  done < <(sed '/^## Map of a foreign/,$d' "$source/docs/case_files.md" | grep -E '^\| `' | cut -d'|' -f2 | grep -oE '[a-z_0-9]+' | sort -u |
    grep -vxE 'file|time|value|strain|strain_column|overpressure_column|time_column|column|species|initial|radius|levels|generator|refine|heat_loss|nasa7|rings|vents|time_|fabric|ambient|gas|inflator|jet|vent|sensor|trigger|membrane|strap|plate|pendulum|contact|scene|output|weave|panel|depth|width|height|back_radius|front_radius|depth_cells|width_cells|height_cells|attachment_width_cells|attachment_height_cells|vent_depth_cell|vent_height_cell|inflator_radius|opening|inflator_rings|vent_ring|centre|normal|side|columns|rows|area|step|safety|unsafe_step|gas_tolerance|gas_step|gas_method')
}

part_decks() {
  local case name format units reader=$source/verification/coupled/deck_structure.py count=0 out settings
  local passenger=$source/cases/passenger_pendulum.toml
  deck_keys
  for case in "$source"/cases/*.toml "$source"/cases/reference/*.toml; do
    grep -q '^\[membrane\]' "$case" || continue
    if ! grep -q '^\[gas\]' "$case"; then
      expect 2 "membrane.overpressure: a sheet without gas is not exported" "$gasjet" export "$case" --format radioss --units kg-m-s --out "$work/sheet"
      continue
    fi
    name=$(basename "$case" .toml)
    settings=$("$gasjet" check "$case" | grep -cE '^  [a-z_]+\.[^ ]+( \*)? = ')
    for format in "${deck_formats[@]}"; do
      for units in "${deck_units[@]}"; do
        out=$work/$format/$name.$units
        expect 0 "export.md are in" "$gasjet" export "$case" --format "$format" --units "$units" --out "$out"
        grep -q '^## no counterpart' "$out/export.md" || fail "$name: export.md"
        [ "$(grep -c '"mapping": "\(exact\|approximated\|no counterpart\)"' "$out/export.json")" = "$settings" ] ||
          fail "$name: export.json does not name all $settings settings"
        count=$((count + 1))
      done
    done
  done
  [ $count -ge $((24 * ${#deck_units[@]})) ] || fail "only $count decks"
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
