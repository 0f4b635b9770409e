# SPDX-License-Identifier: Apache-2.0
# shellcheck shell=bash disable=SC2154
# Parts of command_test.sh (sourced): `gasjet mesh`.

part_mesh() {
  expect 0 "2352 elements" "$gasjet" mesh driver --out "$work/design.k" --initial "$work/open.obj"
  expect 0 "panel vent_left: 4 elements" "$gasjet" mesh driver --out "$work/again.k" --set rings=14 --set radius=0.35
  cmp "$work/design.k" "$work/again.k" || fail "the default options by --set give another mesh"
  expect 2 "design.k: is no closed control volume, and nothing is written" "$gasjet" mesh convert "$work/design.k" --out "$work/bad.k"
  expect 0 "closed control volume: no" "$gasjet" mesh convert "$work/design.k" --report --out "$work/reported.k"
  cmp "$work/design.k" "$work/reported.k" || fail "--report wrote another mesh"
  printf '\xef\xbb\xbf' | cat - "$work/open.obj" >"$work/marked.obj"
  tr '\n' '\r' <"$work/open.obj" >"$work/returns.obj"
  for file in marked returns; do expect 0 "closed control volume: yes" "$gasjet" mesh convert "$work/$file.obj"; done
  sed 's/^\(f [0-9]*\) \([0-9]*\) \([0-9]*\)/\1 \3 \2/' "$work/open.obj" >"$work/inverted.obj"
  expect 2 "inward" "$gasjet" mesh convert "$work/inverted.obj"
  expect 0 "inward" "$gasjet" mesh convert "$work/inverted.obj" --report
  expect 2 "wound outward, or --report; --outward turns elements" "$gasjet" mesh convert "$work/inverted.obj"
  expect 0 "^elements turned: 2352$" "$gasjet" mesh convert "$work/inverted.obj" --outward --out "$work/outward.obj"
  expect 0 "^elements turned: 0$" "$gasjet" mesh convert "$work/outward.obj" --outward
  { echo 'v 9 9 9' && sed 's/^f /f 1+/' "$work/open.obj" | awk '$1 == "f" { for (i = 2; i <= 4; ++i) $i = substr($i, index($i, "+") + 1) + 1 } 1'; } >"$work/unused.obj"
  expect 0 "^nodes that no element uses, left out: 1$" "$gasjet" mesh convert "$work/unused.obj"
  expect 0 "longest extent: 699 m; --length-unit" "$gasjet" mesh convert "$work/open.obj" --length-unit 1e3
  ln -s /dev/zero "$work/endless.obj"
  expect 2 "endless.obj: is longer than 256 MiB" "$gasjet" mesh convert "$work/endless.obj"
  sed 's/^g vent_left/g $vent/' "$work/open.obj" >"$work/dollar.obj"
  expect 2 "--out .*/dollar.k: panel_names: .*; must be non-empty" "$gasjet" mesh convert "$work/dollar.obj" --out "$work/dollar.k"
  expect 0 "closed control volume: yes" "$gasjet" mesh convert "$work/open.obj" --out "$work/open.k"
  expect 0 "closed control volume: yes" "$gasjet" mesh convert "$work/open.k" --out "$work/back.obj"
  cmp "$work/open.obj" "$work/back.obj" || fail "OBJ to keyword and back changed the file"
  expect 0 "9396 elements.*volume 0.0059362" "$gasjet" mesh convert "$work/open.k" --refine 1 --null-panel vent_left --null-panel vent_right
  expect 0 "volume 5.9362e-12" "$gasjet" mesh convert "$work/open.k" --length-unit 1e-3
  expect 0 "10970 elements" "$gasjet" mesh passenger --out "$work/fine.obj" --refine 1 --set vent_depth_cell=5
  expect 0 "panel attachment: 0.0075 m2" "$gasjet" check "$source/cases/driver_bag.toml"
  expect 2 "rings = 3, allowed: 4 to 100" "$gasjet" mesh driver --out "$work/bad.k" --set rings=3
  expect 2 "unknown option, allowed are radius" "$gasjet" mesh driver --out "$work/bad.k" --set depth=0.1
  expect 2 "whole number" "$gasjet" mesh driver --out "$work/bad.k" --set rings=5.5
  expect 2 "ends with .obj, .k, .key, .dyn or .stl" "$gasjet" mesh driver --out "$work/bad.vtk"
  expect 2 "bad.step: a mesh file ends with one of .obj" "$gasjet" mesh convert "$work/bad.step"
  printf '*KEYWORD\n*NODE\n1,0,0,zero\n*END\n' >"$work/number.k"
  expect 2 "number.k:3:7: \"zero\" is not a number" "$gasjet" mesh convert "$work/number.k"
  expect 2 "lid" "$gasjet" mesh convert "$work/open.k" --refine 1 --null-panel lid
  expect 2 "" "$gasjet" mesh driver --out "$work/bad.k" --refine 7
  expect 2 "lid" "$gasjet" mesh convert "$work/open.k" --null-panel lid
  expect 2 "--initial .*would overwrite" "$gasjet" mesh driver --out "$work/bad.k" --initial "$work/./bad.k"
  expect 2 "--out .*would overwrite" "$gasjet" mesh convert "$work/open.k" --out "$work/open.k"
  cp -r "$source/cases/bag_from_files" "$source/cases/bag_from_files.toml" "$work"
  expect 2 "--out .*would overwrite .*design.obj" "$gasjet" mesh case "$work/bag_from_files.toml" --out "$work/bag_from_files/design.obj"
  expect 2 "--initial .*would overwrite .*start.obj" "$gasjet" mesh case "$work/bag_from_files.toml" --out "$work/bad.k" \
    --initial "$work/bag_from_files/start.obj"
  [ "$("$gasjet" check "$work/bag_from_files.toml" | grep -c 'membrane.mesh.\(initial_\)*file = ')" = 2 ] || fail "check prints a file twice"
  for file in design start; do cmp "$work/bag_from_files/$file.obj" "$source/cases/bag_from_files/$file.obj" || fail "$file.obj changed"; done
  expect 2 "ends with .obj" "$gasjet" mesh driver --out "$work/bad.k" --initial "$work/bad.xyz"
  expect 2 "open.k:[0-9]+:1: mesh: the element has no area" "$gasjet" mesh convert "$work/open.k" --out "$work/bad.k" --length-unit 1e-300
  printf 'v 0 0 0\nv 1e-80 0 0\nv 0 1e-80 0\nf 1 2 3\n' >"$work/small.obj" # squares of a fine mesh's areas underflow
  expect 2 "small.obj: element [0-9]+: its area is zero" "$gasjet" mesh convert "$work/small.obj" --report --out "$work/bad.k" --refine 5
  expect 2 "open.k:[0-9]+:1: mesh: the element has no area" "$gasjet" mesh convert "$work/open.k" --length-unit 1e120
  for unit in inf 0 mm; do expect 2 "$unit: a finite number above 0 is allowed" "$gasjet" mesh convert "$work/open.k" --length-unit $unit; done
  sed '$d' "$work/open.obj" >"$work/hole.obj" # the last element, f 791 792 838, has the side 791-838 with that of the line above
  expect 2 "3 boundary edges.* nodes 791-838 of elements in lines 3535;" "$gasjet" mesh convert "$work/hole.obj"
  expect 2 "--out.*is empty" "$gasjet" mesh driver --out ""
  for file in bad.k bad.vtk; do [ -e "$work/$file" ] && fail "bad input wrote $file"; done
}

part_mesh_formats() {
  "$gasjet" mesh driver --out "$work/design.k" --initial "$work/open.obj" >/dev/null
  # Each triangle of STL has corners of its own; seams of another program are open by a little.
  expect 0 "closed control volume: yes" "$gasjet" mesh convert "$work/open.obj" --out "$work/open.stl"
  expect 0 "2352 elements, 1178 nodes, volume 0.00" "$gasjet" mesh convert "$work/open.stl"
  awk '!moved && $1 == "vertex" { $2 += 5e-5; moved = 1 } 1' "$work/open.stl" >"$work/seam.stl"
  expect 2 "no closed control volume.* --merge DISTANCE joins nodes" "$gasjet" mesh convert "$work/seam.stl"
  expect 0 "^nodes merged within 0.0001 m: 1$" "$gasjet" mesh convert "$work/seam.stl" --merge 1e-4
  expect 2 "no closed control volume" "$gasjet" mesh convert "$work/seam.stl" --merge 0
  # An element that collapses leaves a node without one.
  { cat "$work/open.obj" && printf 'v 2 2 2\nv 2 2 2.0000001\nv 3 3 3\nf -3 -2 -1\n'; } >"$work/spike.obj"
  expect 0 "^nodes that no element uses, left out: 2$" "$gasjet" mesh convert "$work/spike.obj" --merge 1e-6
  expect 2 "leaves no element" "$gasjet" mesh convert "$work/open.stl" --merge 10
  expect 2 "nan: a finite number from 0 is allowed" "$gasjet" mesh convert "$work/open.stl" --merge nan
  for file in pyramid.ply pyramid.off; do
    [ $file = pyramid.off ] && printf 'OFF\n5 5 0\n' >"$work/$file" ||
      printf 'ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\nelement face 5\nproperty list uchar int vertex_indices\nend_header\n' >"$work/$file"
    printf '0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n4 0 3 2 1\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n' >>"$work/$file"
    expect 0 "^quads split in two: 1$" "$gasjet" mesh convert "$work/$file"
  done
}

# The bag of a whole deck comes back as its case has it: both its shapes.
part_mesh_deck() {
  local case=$source/cases/passenger_sharp.toml panels="--panel main --panel side_left --panel side_right --panel attachment --panel vent"
  "$gasjet" mesh case "$case" --out "$work/design.stl" --initial "$work/start.k" >/dev/null
  "$gasjet" mesh case "$case" --out "$work/cut.k" >/dev/null
  for shape in start cut; do "$gasjet" mesh convert "$work/$shape.k" --report >"$work/wanted_$shape"; done
  for format in lsdyna radioss; do
    expect 0 "" "$gasjet" export "$case" --format $format --units kg-m-s --out "$work/$format"
    file=$(ls "$work/$format"/bag.k "$work/$format"/bag_0000.rad 2>/dev/null)
    expect 2 "disconnected components" "$gasjet" mesh convert "$file"
    # shellcheck disable=SC2086
    expect 0 "^elements that are no shells: .*(DISCRETE|SPRING) \([23]\)$" "$gasjet" mesh convert "$file" $panels --out "$work/back_cut.k" --initial "$work/back_start.k"
    for shape in start cut; do
      "$gasjet" mesh convert "$work/back_$shape.k" --report | diff - "$work/wanted_$shape" || fail "$format: another $shape came back"
    done
    expect 2 "\"none\" does not exist.* \"main\"" "$gasjet" mesh convert "$file" --panel none
    sed "s|^mesh = .*|mesh = { file = \"$file\" }|" "$source/cases/sphere_inflation.toml" >"$work/whole.toml"
    expect 2 "elements that are no shells: .*--panel NAME" "$gasjet" check "$work/whole.toml"
  done
  mkdir -p "$work/parts"
  printf '*KEYWORD\n*INCLUDE\nparts/bag.k\n*END\n' >"$work/top.k"
  cp "$work/back_start.k" "$work/parts/bag.k"
  expect 0 "closed control volume: yes" "$gasjet" mesh convert "$work/top.k"
  expect 2 "--out .*would overwrite .*parts/bag.k" "$gasjet" mesh convert "$work/top.k" --out "$work/parts/bag.k"
  rm "$work/parts/bag.k"
  expect 2 "top.k:3:1: include: .*parts/bag.k: is no file that can be read" "$gasjet" mesh convert "$work/top.k"
}

# points FILE: the nodes of a .vtp or .obj, a line each
points() { sed -n '/Name="Points"/,/DataArray>/{/Array/!p};s/^v //p' "$1"; }
# values FILE NAME: an array of a .vtp
values() { sed -n "/Name=\"$2\"/,/DataArray>/{/Array/!p}" "$1"; }
# differ FILE FILE: the largest difference between two files of numbers, which have as many
differ() {
  paste -d ' ' "$1" "$2" | awk 'NF % 2 { bad = 1 }
    { for (i = 1; i <= NF / 2; ++i) { d = $i - $(i + NF / 2); if (d < 0) d = -d; if (d > largest) largest = d } }
    END { print bad || !NR ? "not comparable" : largest + 0 }'
}

part_mesh_state() {
  local case=$source/cases/sphere_inflation.toml run=$work/run file
  "$gasjet" mesh case "$case" --out "$work/design.obj" >/dev/null
  expect 0 "" "$gasjet" run "$case" --out "$run" --quiet --set scene.end_time=8e-3 --set output.fields_every=2e-3
  expect 0 "^time 0.00[56][0-9]* s, of bag_00003.vtp$" "$gasjet" mesh state "$run" --time 6.1e-3 --out "$work/state.obj"
  points "$run/bag_00003.vtp" >"$work/kept"
  points "$work/state.obj" >"$work/written"
  [ "$(differ "$work/kept" "$work/written")" = 0 ] || fail "state.obj has other nodes than bag_00003.vtp"
  for file in k stl vtp; do expect 0 "closed control volume: yes" "$gasjet" mesh state "$run" --time 6e-3 --out "$work/state.$file"; done
  points "$work/state.vtp" >"$work/written"
  [ "$(differ "$work/kept" "$work/written")" = 0 ] || fail "state.vtp has other nodes than bag_00003.vtp"

  # The next run starts with the stresses of this one: both are rounding of the modulus, 60 MPa, apart.
  sed 's|^mesh = .*|mesh = { file = "design.obj", initial_file = "state.obj" }|' "$case" >"$work/next.toml"
  expect 0 "" "$gasjet" mesh convert "$work/state.obj" --length-unit 1e3 --out "$work/large.obj"
  expect 2 "initial_file: the initial shape has 1.13e.06 m2 of skin, the design shape 1.13 m2: length_unit is that of both" \
    "$gasjet" check "$work/next.toml" --set "membrane.mesh.initial_file=\"$work/large.obj\""
  expect 0 "" "$gasjet" run "$work/next.toml" --out "$work/next" --quiet --set scene.end_time=1e-4 --set output.fields_every=1e-4
  values "$run/bag_00003.vtp" principal_stress_Pa >"$work/kept"
  values "$work/next/bag_00000.vtp" principal_stress_Pa >"$work/continued"
  awk -v d="$(differ "$work/kept" "$work/continued")" 'BEGIN { exit !(d != "not comparable" && d < 1e-6) }' ||
    fail "stresses are not continued: $(differ "$work/kept" "$work/continued")"
  awk '$1 > 1e5 { exit 1 }' "$work/kept" && fail "the bag has no stress that could be continued"

  # Without fields: the frames, within what they say.
  expect 0 "" "$gasjet" run "$case" --out "$work/framed" --quiet --set scene.end_time=8e-3 --set output.frames=4
  expect 0 "^coordinates are off by [0-9.]*e-06 m at most$" "$gasjet" mesh state "$work/framed" --time 6e-3 --out "$work/framed.obj"
  points "$run/bag_00003.vtp" >"$work/kept"
  points "$work/framed.obj" >"$work/written"
  # Panels keep their names, by fields and by frames; a damaged header costs the names alone.
  case=$source/cases/passenger_pendulum.toml
  "$gasjet" run "$case" --out "$work/panels" --quiet --set scene.end_time=1e-4 --set output.fields_every=1e-4
  "$gasjet" mesh case "$case" --out "$work/cut.obj" >/dev/null
  for file in fields frames; do
    [ $file = fields ] || rm "$work/panels/fields.pvd"
    expect 0 "^panel vent: 4 elements" "$gasjet" mesh state "$work/panels" --time 0 --out "$work/named.obj"
    cmp <(grep '^[gf]' "$work/cut.obj") <(grep '^[gf]' "$work/named.obj") || fail "panels by $file"
  done
  sed -i 's/"panel_names":\[[^]]*\]/"panel_names":"main"/' "$work/panels/frames.bin"
  expect 0 "^panel panel_0: 2744 elements" "$gasjet" mesh state "$work/panels" --time 0 --out "$work/named.obj"
  : >"$run/frames.bin"
  expect 0 "^panel panel_0: 1280 elements" "$gasjet" mesh state "$run" --time 6e-3 --out "$work/named.obj"
  awk -v d="$(differ "$work/kept" "$work/written")" 'BEGIN { exit !(d != "not comparable" && d < 1e-5) }' || # half a step of 0.6 m / 65535
    fail "the frame is off by $(differ "$work/kept" "$work/written") m"

  expect 2 "^gasjet: --time 0.5: .*fields.pvd has times from 0 to 0.008" "$gasjet" mesh state "$run" --time 0.5 --out "$work/bad.k"
  expect 2 "^gasjet: --time 0.5: .*frames.bin has times from 0 to 0.008" "$gasjet" mesh state "$work/framed" --time 0.5 --out "$work/bad.k"
  expect 2 "nan: a finite number from 0 is allowed" "$gasjet" mesh state "$run" --time nan --out "$work/bad.k"
  expect 2 "has neither fields.pvd nor frames.bin" "$gasjet" mesh state "$work" --time 0 --out "$work/bad.k"
  for file in bad.msh bad.vtk; do expect 2 "--out .*/$file: the name of a state ends with .obj, .stl, .vtp, or LS-DYNA keyword" "$gasjet" mesh state "$run" --time 0 --out "$work/$file"; done
  sed -i 's/^\(<Piece.*\)NumberOfPolys="1280"/\1NumberOfPolys="12800000"/' "$run/bag_00001.vtp"
  expect 2 "bag_00001.vtp: NumberOfPolys is 12800000, which the file cannot hold" "$gasjet" mesh state "$run" --time 2e-3 --out "$work/bad.k"
  sed -i '0,/Name="Points"/s//Name="Dots"/' "$run/bag_00002.vtp"
  expect 2 "bag_00002.vtp: .*Points.* is missing: it is damaged" "$gasjet" mesh state "$run" --time 4e-3 --out "$work/bad.k"
  sed -i '/Name="connectivity"/{n;s/[0-9]*/99999/}' "$run/bag_00004.vtp"
  expect 2 "bag_00004.vtp: node 99999 is out of range" "$gasjet" mesh state "$run" --time 8e-3 --out "$work/bad.k"
  [ -e "$work/bad.k" ] || [ -e "$work/bad.msh" ] && fail "bad input wrote a mesh"
}
