# SPDX-License-Identifier: Apache-2.0
"""Holes that `gasjet mesh convert` and cases close, and bags that begin flat."""
import json
import re

import pytest
from command import change, expect, numbers, ok, read, refused, write

CLOSED = "closed control volume: yes"


@pytest.fixture
def driver():
    expect(0, "2352 elements", "mesh driver --out design.k --initial open.obj")


def test_mesh_caps(driver):
    """Holes where the module's patch and the vents were are listed, and closed to the same bag."""
    gone, lines = False, []
    for line in read("open.obj").splitlines():
        if line.startswith("g "):
            gone = line[2:] in ("attachment", "vent_left", "vent_right")
        if not gone:
            lines.append(line)
    write("holed.obj", *lines)
    place = r"0.00131 m2 around \(0.00917, -?0.186, 0.00648\) m, 0.00011 m off its plane$"
    listed = rf"^hole 1: 12 nodes, 0.311 m long, 0.0075 m2 around \(0, 0, 0\) m, 0 m off its plane\nhole 2: 6 nodes, 0.162 m long, {place}"
    refused("holed.obj: is not a closed control volume.*; --cap NAME closes holes", "mesh convert holed.obj")
    expect(0, listed, "mesh convert holed.obj --report")
    expect(0, "^panel mouth closes hole 1: 12 nodes", "mesh convert holed.obj --cap vents --cap mouth=1 --out capped.obj")
    report = ok("mesh convert capped.obj").out
    for says in ("volume 0.0059362 m3", "panel vents: 8 elements, 0.00261", CLOSED, "panel mouth: 10 elements, 0.0075 m2"):
        assert says in report
    expect(0, "panel lid: 42 elements", "mesh convert holed.obj --cap lid --refine 1")  # rims alone are refined
    for says, options in (("0.311 m long.* is longer than 0.2 m, the longest to be closed", "--cap all --cap-length 0.2"),
                          ("there is no hole 4; the surface has 3", "--cap vent=4"), ("hole 2 is closed twice", "--cap a=2 --cap b=2"),
                          ('has a panel "back" already', "--cap back"), ('there is no node set "x"', "--cap vent=x"), ("allowed: NAME, or NAME= with the number", "--cap vent="),
                          ("--cap-length needs --cap", "--cap-length 1")):
        refused(says, f"mesh convert holed.obj {options} --out bad.obj")
    # In a case they are null panels.
    ok("mesh convert holed.obj --report --out used.obj")  # without the nodes inside the holes
    change("cases/sphere_inflation.toml", ("^mesh = .*", 'mesh = { file = "used.obj", cap = true }'), to="capped.toml")
    checked = ok("check capped.toml")
    for number, nodes in ((1, 12), (2, 6), (3, 6)):
        assert f"panel cap_{number} closes hole {number}: {nodes} nodes" in checked.out
    assert 'nothing flows through the hole "cap_1" of 0.0075 m2' in checked.said
    ok("mesh case capped.toml --out from_case.k")
    expect(0, "volume 0.0059362 m3", "mesh convert from_case.k")
    refused("mesh.cap: the hole of 12 nodes.* is longer than 0.3 m", "check capped.toml --set membrane.mesh.cap_length=0.3")
    refused("cap_length: needs cap = true", "check capped.toml --set membrane.mesh.cap=false --set membrane.mesh.cap_length=1")
    refused("--cap NAME closes holes, as cap = true does in a case", "check capped.toml --set membrane.mesh.cap=false")


def test_mesh_caps_of_node_sets():
    """The rims of decks and of Gmsh's physical curves say which hole is which."""
    ring = [(x, y) for x, y in ((0, 0), (0.2, 0), (0.3, 0.2), (0.1, 0.3), (-0.1, 0.2))]
    nodes = [(x, y, z) for z in (0.0, 0.4) for x, y in ring]
    walls = [(i, (i + 1) % 5, (i + 1) % 5 + 5, i + 5) for i in range(5)]
    ten = lambda *numbers: "".join(f"{n:>10}" for n in numbers)
    node_cards = ["*NODE"] + [f"{i + 1},{x},{y},{z}" for i, (x, y, z) in enumerate(nodes)]
    shells = ["*ELEMENT_SHELL"] + [",".join(map(str, (i + 1, 1, *(n + 1 for n in wall)))) for i, wall in enumerate(walls)]
    write("tube.k", "*KEYWORD", *node_cards, *shells, "*SET_NODE_LIST_TITLE", "gas mouth", ten(7), ten(1, 2, 3, 4, 5, 99),
          "*SET_NODE", ten(8), ten(6, 7, 8, 9), ten(10), "*SET_NODE_LIST", ten(9), ten(1, 6), "*END")
    write("tube_0000.rad", "/BEGIN", "tube", "/NODE", *(f"{i + 1:>10}{x:>20}{y:>20}{z:>20}" for i, (x, y, z) in enumerate(nodes)), "/SHELL/1",
          *(ten(i + 1, *(n + 1 for n in wall)) for i, wall in enumerate(walls)), "/GRNOD/NODE/7", "gas mouth", ten(1, 2, 3, 4, 5), "/GRNOD/NODE/8", "",
          ten(6, 7, 8, 9, 10), "/END")
    lines = [(5, (i + 1, (i + 1) % 5 + 1)) for i in range(5)] + [(6, (i + 6, (i + 1) % 5 + 6)) for i in range(5)]
    write("tube.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n1 5 \"gas mouth\"\n$EndPhysicalNames\n$Nodes\n10",
          *(f"{i + 1} {x} {y} {z}" for i, (x, y, z) in enumerate(nodes)), "$EndNodes\n$Elements\n15",
          *(f"{i + 1} 1 2 {group} {group} {a} {b}" for i, (group, (a, b)) in enumerate(lines)),
          *(f"{i + 11} 3 2 1 1 {' '.join(str(n + 1) for n in wall)}" for i, wall in enumerate(walls)), "$EndElements")
    for file, other in (("tube.k", "set_8"), ("tube_0000.rad", "set_8"), ("tube.msh", "physical_6")):
        reported = ok(f"mesh convert {file} --report").out
        assert re.search(r"hole \d: 5 nodes.*; node set gas_mouth$", reported, re.MULTILINE)
        assert re.search(rf"hole \d: 5 nodes.*; node set {other}$", reported, re.MULTILINE)
        ok(f"mesh convert {file} --cap mouth=gas_mouth --cap vent={other} --out closed.k")
        expect(0, "panel mouth: 3 elements, 0.08 m2", "mesh convert closed.k")
        change("cases/sphere_inflation.toml", ("^mesh = .*", f'mesh = {{ file = "{file}", cap = true }}'), to="tube.toml")
        checked = ok("check tube.toml").out
        assert "panel gas_mouth closes hole" in checked and f"panel {other} closes hole" in checked
    refused('there is no node set "lid"; the file has gas_mouth, set_8, set_9', "mesh convert tube.k --cap lid=lid")
    refused('node set "set_9" has all nodes of no hole', "mesh convert tube.k --cap lid=set_9")


def test_flat_bag_with_a_jet_along_it(driver):
    """Two sheets without a gap are pressed apart; a jet between them opens the bag, and all balances hold."""
    write("flat.toml", """[scene]
name = "flat"
end_time = 0.008
[gas]
thermodynamics = "constant"
initial = { composition = { N2 = 1.0 } }
[[inflator]]
composition = { N2 = 1.0 }
mass_flow = { time = [0.0, 0.002, 0.02], value = [0.0, 0.8, 0.0] }
temperature = 500.0
[inflator.jet]
shape = "round"
radius = 0.012
centre = [0.0005, -0.27, 0.0]
axis = [0.0, 1.0, 0.0]
decay_coefficient = 0.08
temperature = "stagnation"
outlet = "pressure_matched"
[fabric]
young_modulus = 60e6
poisson_ratio = 0.3
density = 620.0
thickness = 0.5e-3
leak_law = "none"
[membrane]
mesh = { file = "design.k" }
fixed_panels = ["attachment"]
[[membrane.fold]]
type = "press"
gap = 1e-3""")
    warned = ok("check flat.toml").said
    assert "its outlet is wider than the bag at the start, 0.001 m thick there" in warned
    ok("run flat.toml --quiet --out flat")
    ok("mesh state flat --time 0.008 --out state.vtp")
    expect(0, "panel panel_0: 1176 elements", "mesh convert state.vtp")
    assert max(numbers("flat/history.csv")["jet_force_N"]) > 50.0
    residual = json.loads(read("flat/summary.json"))["residual"]
    assert residual["mass_rel"] < 1e-12 and residual["momentum_rel"] < 1e-12 and abs(residual["energy_rel"]) < 1e-4
    change("flat.toml", (r"\[\[membrane.fold[^$]*", ""), to="unpressed.toml")
    refused('type = "press" parts the sheets by a gap', "check unpressed.toml")
