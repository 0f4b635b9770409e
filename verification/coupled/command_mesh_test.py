# SPDX-License-Identifier: Apache-2.0
"""`gasjet mesh`: generators, conversions, meshes of decks and of states."""
import os
import re
import shutil
from pathlib import Path

import pytest
from command import arrays, change, expect, ok, read, refused, write

CLOSED = "closed control volume: yes"


@pytest.fixture
def driver():
    expect(0, "2352 elements", "mesh driver --out design.k --initial open.obj")


def test_mesh(driver):
    expect(0, "panel vent_left: 4 elements", "mesh driver --out again.k --set rings=14 --set radius=0.35")
    assert read("design.k") == read("again.k")  # the default options
    refused("design.k: is not a closed control volume, and nothing is written", "mesh convert design.k --out bad.k")
    expect(0, "closed control volume: no", "mesh convert design.k --report --out reported.k")
    assert read("design.k") == read("reported.k")
    expect(0, CLOSED, "mesh convert open.obj --out open.k")
    expect(0, CLOSED, "mesh convert open.k --out back.obj")
    assert read("open.obj") == read("back.obj")
    expect(0, "9396 elements.*volume 0.0059362", "mesh convert open.k --refine 1 --null-panel vent_left --null-panel vent_right")
    expect(0, "volume 5.9362e-12", "mesh convert open.k --length-unit 1e-3")
    expect(0, "longest extent: 699 m; set --length-unit", "mesh convert open.obj --length-unit 1e3")
    expect(0, "10970 elements", "mesh passenger --out fine.obj --refine 1 --set vent_depth_cell=5")
    expect(0, "panel attachment: 0.0075 m2", "check cases/driver_bag.toml")
    # As other programs write it.
    Path("marked.obj").write_text("\ufeff" + read("open.obj"))
    Path("returns.obj").write_text(read("open.obj").replace("\n", "\r"), newline="")
    for name in ("marked", "returns"):
        expect(0, CLOSED, f"mesh convert {name}.obj")
    change("open.obj", (r"^f (\d+) (\d+) (\d+)", r"f \1 \3 \2"), to="inverted.obj")
    refused("inward", "mesh convert inverted.obj")
    refused("wound outward, or --report; --outward turns elements", "mesh convert inverted.obj")
    expect(0, "inward", "mesh convert inverted.obj --report")
    expect(0, "^elements turned: 2352$", "mesh convert inverted.obj --outward --out outward.obj")
    expect(0, "^elements turned: 0$", "mesh convert outward.obj --outward")
    turned = re.sub("(?m)^f .*", lambda face: re.sub(r"\d+", lambda n: str(int(n[0]) + 1), face[0]), read("open.obj"))
    write("unused.obj", "v 9 9 9", turned)
    expect(0, "^nodes that no element uses, left out: 1$", "mesh convert unused.obj")
    Path("hole.obj").write_text("\n".join(read("open.obj").splitlines()[:-1]) + "\n")  # the last element has side 791-838 with that of the line above
    refused("3 boundary edges.* nodes 791-838 of elements in lines 3535;", "mesh convert hole.obj")


@pytest.mark.parametrize("says, command", [
    ("rings = 3, allowed: 4 to 100", "driver --out bad.k --set rings=3"), ("whole number", "driver --out bad.k --set rings=5.5"),
    ("unknown option, allowed: radius", "driver --out bad.k --set depth=0.1"), ("ends with .obj, .k, .key, .dyn or .stl", "driver --out bad.vtk"),
    ("ends with .obj", "driver --out bad.k --initial bad.xyz"), ("", "driver --out bad.k --refine 7"), ("--out.*is empty", "driver --out ''"),
    ("--initial .*would overwrite", "driver --out bad.k --initial ./bad.k"), ("bad.step: a mesh file ends with one of .obj", "convert bad.step"),
    ("lid", "convert open.obj --refine 1 --null-panel lid"), ("lid", "convert open.obj --null-panel lid"),
    ("--out .*would overwrite", "convert open.obj --out open.obj"),
    ("open.obj:[0-9]+:1: mesh: the element has an area out of the range of numbers", "convert open.obj --out bad.k --length-unit 1e-300"),
    ("open.obj:[0-9]+:1: mesh: the element has an area out of the range of numbers", "convert open.obj --length-unit 1e120"),
    *((f"{unit}: allowed: a finite number above 0", f"convert open.obj --length-unit {unit}") for unit in ("inf", "0", "mm"))])
def test_mesh_bad_input(driver, says, command):
    refused(says, f"mesh {command}")


def test_mesh_bad_files(driver):
    os.symlink("/dev/zero", "endless.obj")
    refused("endless.obj: is longer than 256 MiB", "mesh convert endless.obj")
    change("open.obj", ("^g vent_left", "g $vent"), to="dollar.obj")
    refused("--out .*dollar.k: panel_names: .*; a name must not be empty, have control characters, or begin with", "mesh convert dollar.obj --out dollar.k")
    write("number.k", "*KEYWORD", "*NODE", "1,0,0,zero", "*END")
    refused('number.k:3:7: "zero" is not a number', "mesh convert number.k")
    write("small.obj", "v 0 0 0", "v 1e-80 0 0", "v 0 1e-80 0", "f 1 2 3")  # squares of a fine mesh's areas underflow
    refused("small.obj: element [0-9]+: its area is zero", "mesh convert small.obj --report --out bad.k --refine 5")
    shutil.copytree("cases/bag_from_files", "bag_from_files")
    shutil.copy("cases/bag_from_files.toml", ".")
    refused("--out .*would overwrite .*design.obj", "mesh case bag_from_files.toml --out bag_from_files/design.obj")
    refused("--initial .*would overwrite .*start.obj", "mesh case bag_from_files.toml --out bad.k --initial bag_from_files/start.obj")
    for name in ("design", "start"):
        assert read(f"bag_from_files/{name}.obj") == read(f"cases/bag_from_files/{name}.obj")
    assert len(re.findall(r"membrane.mesh.(?:initial_)?file = ", ok("check bag_from_files.toml").out)) == 2


def test_mesh_formats(driver):
    # Each triangle of STL has corners of its own; seams of another program are open by a little.
    expect(0, CLOSED, "mesh convert open.obj --out open.stl")
    expect(0, "2352 elements, 1178 nodes, volume 0.00", "mesh convert open.stl")
    first = re.search(r"vertex (\S+)", read("open.stl"))
    Path("seam.stl").write_text(read("open.stl").replace(first[0], f"vertex {float(first[1]) + 5e-5!r}", 1))
    refused("not a closed control volume.* --merge DISTANCE joins nodes", "mesh convert seam.stl")
    expect(0, "^nodes merged within 0.0001 m: 1$", "mesh convert seam.stl --merge 1e-4")
    refused("not a closed control volume", "mesh convert seam.stl --merge 0")
    # An element that collapses leaves a node without one.
    write("spike.obj", read("open.obj"), "v 2 2 2", "v 2 2 2.0000001", "v 3 3 3", "f -3 -2 -1")
    expect(0, "^nodes that no element uses, left out: 2$", "mesh convert spike.obj --merge 1e-6")
    refused("leaves no element", "mesh convert open.stl --merge 10")
    refused("nan: allowed: a finite number from 0", "mesh convert open.stl --merge nan")
    pyramid = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n4 0 3 2 1\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4"
    write("pyramid.off", "OFF\n5 5 0", pyramid)
    write("pyramid.ply", "ply\nformat ascii 1.0\nelement vertex 5", *(f"property float {axis}" for axis in "xyz"), "element face 5",
          "property list uchar int vertex_indices\nend_header", pyramid)
    for name in ("pyramid.off", "pyramid.ply"):
        expect(0, "^quads split in two: 1$", f"mesh convert {name}")


def test_mesh_deck():
    """The bag of a whole deck comes back as its case has it: both its shapes."""
    case = "cases/passenger_sharp.toml"
    panels = " ".join(f"--panel {name}" for name in ("main", "side_left", "side_right", "attachment", "vent"))
    ok(f"mesh case {case} --out cut.k --initial start.k")
    report = lambda name: ok(f"mesh convert {name}.k --report").out
    for form, deck in (("lsdyna", "lsdyna/bag.k"), ("radioss", "radioss/bag_0000.rad")):
        ok(f"export {case} --format {form} --units kg-m-s --out {form}")
        refused("disconnected components", f"mesh convert {deck}")
        expect(0, r"^elements other than shells: .*(DISCRETE|SPRING) \([23]\)$",
               f"mesh convert {deck} {panels} --out back_cut.k --initial back_start.k")
        for shape in ("cut", "start"):
            assert report(f"back_{shape}") == report(shape), f"{form}: another shape came back"
        refused('"none" does not exist.* "main"', f"mesh convert {deck} --panel none")
        change("cases/sphere_inflation.toml", ("^mesh = .*", f'mesh = {{ file = "{deck}" }}'), to="whole.toml")
        refused("elements other than shells: .*--panel NAME", "check whole.toml")
    os.mkdir("parts")
    write("top.k", "*KEYWORD", "*INCLUDE", "parts/bag.k", "*END")
    shutil.copy("back_start.k", "parts/bag.k")
    expect(0, CLOSED, "mesh convert top.k")
    refused("--out .*would overwrite .*parts/bag.k", "mesh convert top.k --out parts/bag.k")
    os.remove("parts/bag.k")
    refused("top.k:3:1: include: .*parts/bag.k: is not a readable file", "mesh convert top.k")


def points(path):
    """Coordinates of a .vtp or .obj."""
    if path.endswith(".vtp"):
        return arrays(path)["Points"]
    return [float(x) for text in re.findall("(?m)^v (.*)", read(path)) for x in text.split()]


SPHERE, PASSENGER = "cases/sphere_inflation.toml", "cases/passenger_pendulum.toml"


def test_mesh_state():
    ok(f"run {SPHERE} --out run --quiet --set scene.end_time=8e-3 --set output.fields_every=2e-3")
    kept = points("run/bag_00003.vtp")
    expect(0, "^time 0.00[56][0-9]* s, of bag_00003.vtp$", "mesh state run --time 6.1e-3 --out state.obj")
    assert points("state.obj") == kept
    for end in ("k", "stl", "vtp"):
        expect(0, CLOSED, f"mesh state run --time 6e-3 --out state.{end}")
    assert points("state.vtp") == kept
    # Without fields: the frames, within what they say: half a step of 0.6 m / 65535.
    ok(f"run {SPHERE} --out framed --quiet --set scene.end_time=8e-3 --set output.frames=4")
    expect(0, "^coordinates have errors of at most [0-9.]*e-06 m$", "mesh state framed --time 6e-3 --out framed.obj")
    assert points("framed.obj") == pytest.approx(kept, abs=1e-5, rel=0)
    # The next run starts with the stresses of this one: both are rounding of the modulus, 60 MPa, apart.
    ok(f"mesh case {SPHERE} --out design.obj")
    change(SPHERE, ("^mesh = .*", 'mesh = { file = "design.obj", initial_file = "state.obj" }'), to="next.toml")
    ok("mesh convert state.obj --length-unit 1e3 --out large.obj")
    refused("initial_file: the initial shape has 1.13e.06 m2 of skin, the design shape 1.13 m2: length_unit is for both",
            "check next.toml --set membrane.mesh.initial_file=large.obj")
    ok("run next.toml --out next --quiet --set scene.end_time=1e-4 --set output.fields_every=1e-4")
    stress = arrays("run/bag_00003.vtp")["principal_stress_Pa"]
    assert max(stress) > 1e5 and arrays("next/bag_00000.vtp")["principal_stress_Pa"] == pytest.approx(stress, abs=1e-6, rel=0)
    # Bad input, and damaged files.
    for says, words in (("^gasjet: --time 0.5: .*fields.pvd has times from 0 to 0.008", "run --time 0.5 --out bad.k"),
                        ("^gasjet: --time 0.5: .*frames.bin has times from 0 to 0.008", "framed --time 0.5 --out bad.k"),
                        ("nan: allowed: a finite number from 0", "run --time nan --out bad.k"),
                        ("has neither fields.pvd nor frames.bin", ". --time 0 --out bad.k"),
                        *((f"--out .*{name}: the name of a state ends with .obj, .stl, .vtp, or LS-DYNA keyword", f"run --time 0 --out {name}")
                          for name in ("bad.msh", "bad.vtk"))):
        refused(says, f"mesh state {words}")
    for frame, time, edit, says in (
            (1, "2e-3", ('NumberOfPolys="1280"', 'NumberOfPolys="12800000"'), "NumberOfPolys is 12800000, more than the file can contain"),
            (2, "4e-3", ('Name="Points"', 'Name="Dots"'), ".*Points.* is missing: the file is damaged"),
            (4, "8e-3", (r'(Name="connectivity".*\n)\d+', r"\g<1>99999"), "node 99999 is out of range")):
        change(f"run/bag_0000{frame}.vtp", edit)
        refused(f"bag_0000{frame}.vtp: {says}", f"mesh state run --time {time} --out bad.k")
    Path("run/frames.bin").write_bytes(b"")
    expect(0, "^panel panel_0: 1280 elements", "mesh state run --time 6e-3 --out named.obj")


def test_mesh_state_panels():
    """Panels keep their names, by fields and by frames; a damaged header costs the names alone."""
    ok(f"run {PASSENGER} --out panels --quiet --set scene.end_time=1e-4 --set output.fields_every=1e-4")
    ok(f"mesh case {PASSENGER} --out cut.obj")
    named = lambda path: re.findall("(?m)^[gf] .*", read(path))
    for kind in ("fields", "frames"):
        expect(0, "^panel vent: 4 elements", "mesh state panels --time 0 --out named.obj")
        assert named("cut.obj") == named("named.obj"), kind
        Path("panels/fields.pvd").unlink(missing_ok=True)
    frames = Path("panels/frames.bin")
    frames.write_bytes(re.sub(rb'"panel_names":\[[^]]*\]', b'"panel_names":"main"', frames.read_bytes()))
    expect(0, "^panel panel_0: 2744 elements", "mesh state panels --time 0 --out named.obj")
