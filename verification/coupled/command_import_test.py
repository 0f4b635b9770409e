# SPDX-License-Identifier: Apache-2.0
"""Decks of other programs as cases."""
import json
import random
import re
from pathlib import Path

import pytest
from command import ROOT, expect, gasjet, numbers, ok, read
from small_decks import FACES, engine, lsdyna, radioss, refused_deck, row, taken, value, write

DECKS = {"radioss": "bag_0000.rad", "lsdyna": "bag.k"}


def test_import_numbers():
    """Numbers of a deck in kg, mm and ms in SI units, from both programs."""
    cases = taken(lsdyna()), taken(radioss(), "cube_0000.rad", out="other")
    for case in cases:
        near = {"end_time": 0.02, "young_modulus": 6e7, "poisson_ratio": 0.3, "density": 800, "thickness": 5e-4, "area": 2e-4, "cp": 1000,
                "molar_mass": 8.31446261815324 / 300, "history_every": 1e-4, "pressure": 101325}
        for key, wanted in near.items():
            assert value(case, key) == pytest.approx(wanted, rel=1e-5 if key == "temperature" else 1e-12), key
        assert "mass_flow = { time = [0.0, 0.01, 0.02], value = [0.0, 1.0, 0.0] }" in case
        assert float(re.search("temperature = ([0-9.]+) }", case)[1]) == pytest.approx(300, rel=1e-5)
    assert 'law = "saint_venant_kirchhoff"' in cases[0] and 'law = "hencky"' in cases[1]
    assert "v 0.1 0.1 0.1" in read("case/bag.obj") and "g fabric_of_the_cube" in read("case/bag.obj")


def test_import_spellings():
    """Commas, long fields, parameters and includes say the same as columns."""
    wanted = taken(lsdyna())
    control = "*CONTROL_TERMINATION\n" + row(20.0)
    assert taken(lsdyna().replace(control, "*CONTROL_TERMINATION\n20.0,0\n")) == wanted
    assert taken(lsdyna().replace(control, "*CONTROL_TERMINATION+\n" + row(20.0, width=20))) == wanted
    named = "*PARAMETER\n" + row("R end", 20.0) + "*CONTROL_TERMINATION\n" + row("&end")
    assert taken(lsdyna().replace(control, named)) == wanted
    formula = "*PARAMETER\n" + row("R half", 10.0) + "*PARAMETER_EXPRESSION\n" + f"{'R end':<10}2*(half+0)**1\n" + "*CONTROL_TERMINATION\n" + row("&end")
    assert taken(lsdyna().replace(control, formula)) == wanted
    write("*KEYWORD\n" + control + "*END\n", "end.inc")
    assert taken(lsdyna().replace(control, "*INCLUDE\nend.inc\n")) == wanted
    assert taken(lsdyna().replace("  0.06", "6.0D-2").replace("\n", "\r\n")) == wanted


def test_import_refusals():
    refused_deck("does not state its units", lsdyna(units=False))
    assert "end_time = 20.0" in taken(lsdyna(units=False), words="--units kg-m-s")
    expect(2, "units 'kg-mm' are not known", f"import {write(lsdyna())} --out x --units kg-mm")
    airbag = re.search(r"(?s)\*AIRBAG.*\*END", lsdyna())[0][:-4]
    refused_deck("has 2 airbags; choose one by --bag", lsdyna(more=airbag))
    taken(lsdyna(more=airbag), words="--bag 1")
    refused_deck("ID is 'x'", lsdyna(airbag="*AIRBAG_SIMPLE_AIRBAG_MODEL_ID\n" + row("x") + airbag.split("\n", 1)[1]))
    refused_deck("this kind of airbag is not mapped", lsdyna(airbag="*AIRBAG_PARTICLE\n" + row(3, 1)))
    refused_deck("is no set of parts", lsdyna(airbag=airbag.replace(row(3, 1), row(4, 1))))
    refused_deck("allowed: CP above CV", lsdyna(airbag=airbag.replace("     700.0", "    1700.0")))
    refused_deck("LOU = 3 has no counterpart", lsdyna(airbag=airbag.replace(row(0), row(3))))
    refused_deck("allowed: a number", lsdyna(airbag=airbag.replace("500.0", "5oo.0")))
    refused_deck("names the curve 1, which", lsdyna().replace(row(1, 0, 1.0, 0.5), row(2, 0, 1.0, 0.5)))
    refused_deck("has node 8, which the deck does not have", lsdyna().replace(f"{8:>8}{100:>16}", f"{9:>8}{100:>16}"))
    refused_deck("this material of the bag is not mapped", lsdyna(material="*MAT_FOAM\n" + row(7, 1e-6)))
    refused_deck("the file lost.inc is not there", lsdyna(more="*INCLUDE\nlost.inc\n"))
    refused_deck("not in the folder of the deck", lsdyna(more="*INCLUDE\n../lost.inc\n"))
    refused_deck("moves the deck's nodes", lsdyna(more="*INCLUDE_TRANSFORM\nlost.inc\n"))
    refused_deck("exchange gas", lsdyna(more="*AIRBAG_INTERACTION\n" + row(1, 2)))
    refused_deck("ties of nodes to other parts", lsdyna(more="*CONTACT_TIED_NODES_TO_SURFACE\n" + row(1, 2)))
    refused_deck("names the node set 8", lsdyna(more="*RIGIDWALL_PLANAR\n" + row(8, 0, 0) + row(0, 0, -1, 0, 0, 1)))
    refused_deck("move as prescribed", lsdyna(more="*BOUNDARY_PRESCRIBED_MOTION_NODE\n" + row(1, 1, 2, 1)))
    tether = "*ELEMENT_SHELL\n" + row(9, 8, 1, 2, 8, 7, width=8) + "*PART\ntether\n" + row(8, 7, 7)
    refused_deck("tethers", lsdyna(more=tether))
    rigid = "*ELEMENT_SHELL\n" + row(9, 8, 1, 2, 4, 3, width=8) + "*PART\nplate\n" + row(8, 7, 8) + "*MAT_RIGID\n" + row(8, 1e-6, 1.0, 0.3) + "{}" + row(0)
    refused_deck("can move, which has no counterpart", lsdyna(more=rigid.format(row(0.0, 0, 0))))
    assert "fixed_nodes = [1, 2, 3, 4]" in taken(lsdyna(more=rigid.format(row(1.0, 7, 7))))
    refused_deck("the end of the run is in the engine file", radioss(), "lost.rad")
    refused_deck("has 2 monitored volumes", radioss("/MONVOL/GAS/2\nother\n"), "cube_0000.rad")
    refused_deck("sets have each other as members", radioss().replace("/SURF/PART/3\nbag\n" + row(7), "/SURF/SURF/3\na\n" + row(4) + "/SURF/SURF/4\nb\n" + row(3)), "cube_0000.rad")
    refused_deck("this kind of monitored volume is not mapped", radioss().replace("AIRBAG1", "FVMBAG1"), "cube_0000.rad")
    refused_deck("allowed: /SENSOR/TIME", radioss("/SENSOR/ACCE/9\nfire\n").replace(row(5, 0, 0, 0, 0, 0), row(5, 9, 0, 0, 0, 0)), "cube_0000.rad")


def test_import_surfaces():
    """Holes, segments that close them, and nodes on edges of larger elements."""
    top = FACES[1]
    open_cube = [face for face in FACES if face != top]
    case = taken(lsdyna(faces=open_cube))
    assert 'null_panels = ["cap_1"]' in case and "0.2 of the fabric's area" in read("case/import.md")
    refused_deck("the control volume is open", lsdyna(faces=FACES[:2]))
    set_of_segments = "*SET_SEGMENT\n" + row(3) + "".join(row(*face) for face in FACES)
    airbag = "*AIRBAG_SIMPLE_AIRBAG_MODEL\n" + row(3, 0) + row(700.0, 1000.0, 500.0, 1, 0.5, 400.0, "1.01325e-4", "1.12583e-9") + row(0)
    case = taken(lsdyna(faces=open_cube, segments=set_of_segments, airbag=airbag))
    assert 'null_panels = ["segments"]' in case and "1 segments of the control volume have no shell" in read("case/import.md")
    # The bottom as two halves, whose common edge ends on edges of the sides.
    middle = "*NODE\n" + row(9, width=8)[:-1] + row(50, 0, 0, width=16) + row(10, width=8)[:-1] + row(50, 100, 0, width=16)
    halves = [face for face in FACES if face != FACES[0]] + [(1, 3, 10, 9), (9, 10, 4, 2)]
    taken(lsdyna(faces=halves, more=middle))
    assert "2 nodes lie on edges of larger elements" in read("case/import.md")
    assert "null_panels" not in read("case/cube.toml")
    refused_deck("separate surfaces", lsdyna(faces=FACES + [tuple(node + 10 for node in face) for face in FACES],
                 more="*NODE\n" + "".join(row(i + 10, width=8)[:-1] + row(*x, width=16) for i, x in enumerate([(900 + x, y, z) for z in (0, 9) for y in (0, 9) for x in (0, 9)], 1))))


def open_top(quads):
    """A cube whose top has nodes in its middle (13) and between its corners (9 to 12), and these quads of four."""
    top = [5, 9, 6, 10, 8, 11, 7, 12]
    below = {5: 1, 6: 2, 8: 4, 7: 3}
    faces = [FACES[0]]
    for i in range(0, 8, 2):
        a, middle, b = top[i], top[i + 1], top[(i + 2) % 8]
        faces += [(below[a], below[b], middle, middle), (below[a], middle, a, a), (below[b], b, middle, middle)]
    faces += [(top[i - 1], top[i], top[i + 1], 13) for i in (2 * quad for quad in quads)]
    places = [(50, 0, 100), (100, 50, 100), (50, 100, 100), (0, 50, 100), (50, 50, 100)]
    more = "*NODE\n" + "".join(row(i, width=8)[:-1] + row(*x, width=16) for i, x in enumerate(places, 9))
    return lsdyna(faces=faces, more=more)


def test_import_of_holes_that_meet():
    """Two holes that touch at a node have a cap each; sides that lie on each other are a slit."""
    assert "null_panels" not in taken(open_top((0, 1, 2, 3)))
    case = taken(open_top((0, 2)))
    assert 'null_panels = ["cap_1", "cap_2"]' in case
    assert read("case/import.md").count("a hole with 4 nodes at its rim") == 2 and read("case/import.md").count("of 0.0025 m2") == 2
    slit = [face for face in FACES if face != FACES[1]] + [(5, 6, 9, 7)]
    refused_deck("slit with 4 nodes", lsdyna(faces=slit, more="*NODE\n" + row(9, width=8)[:-1] + row(100, 100, 100, width=16)))


def test_import_of_elements_without_nodes():
    """A line of text among elements is an element without nodes, which is said."""
    deck = radioss().replace("/SHELL/7\n", "/SHELL/7\nnonsense\n").replace(row(0, 1)[:-1] + row(200.0, 0.0, width=20), row(3, 1)[:-1] + row(0.01, 0.0, width=20))
    assert value(taken(deck, "cube_0000.rad"), "area") == pytest.approx(6e-4)
    assert "1 elements with fewer than three different nodes are left out" in read("case/import.md")


def test_import_names_every_card():
    """Cards that nothing maps are listed, also of keywords that do not exist."""
    more = "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE\n" + row(1, 2) + "*NO_SUCH_CARD\n" + row(1) + "*DATABASE_GLSTAT\n" + row(1)
    more += "*SET_SEGMENT_GENERAL\n" + row(9) + "ALL\n*DEFINE_CURVE\n" + row(9) + row("x", 1, width=20)
    taken(lsdyna(more=more))
    assert "is not read" in read("case/import.md")
    deck = read("cube.k")
    for keyword in set(re.findall(r"(?m)^\*[A-Z_]+", deck)) - {"*END"}:
        assert f"`{keyword}`" in read("case/import.md"), keyword


def places_of(report, keyword):
    return {place for row in report["cards"] if row["card"] == keyword for place in row["places"]}


def test_import_counts_every_card():
    """Each card of a deck stands in the report at its place, and the counts add up; also of a deck that is refused."""
    for case in "strapped_sphere", "contact_vent":
        for form, deck in DECKS.items():
            ok(f"export {ROOT / f'cases/{case}.toml'} --format {form} --units kg-m-s --out {form}")
            lines = read(f"{form}/{deck}").split("\n")
            for change in ("", "lost"):
                text = "\n".join(lines) if not change else "\n".join(lines).replace("*CONTROL_TERMINATION", "*CONTROL_LOST").replace("/MONVOL/AIRBAG1", "/MONVOL/LOST")
                Path(form, deck).write_text(text, encoding="utf-8")
                gasjet(f"import {form}/{deck} --out again")
                report = json.loads(read("again/import.json"))
                mark = "*" if form == "lsdyna" else "/"
                cards = [(i, line.strip()) for i, line in enumerate(text.split("\n"), 1) if line.startswith(mark) and line.strip() != mark + "END"]
                for at, keyword in cards:
                    assert f"{deck}:{at}" in places_of(report, keyword), keyword
                assert report["counts"].pop("cards") == len(cards) == sum(report["counts"].values())
                assert f"{len(cards)} cards, each counted by the worst that it became" in read("again/import.md")
                assert report["written"] == (not change)


def test_import_of_what_stands_twice():
    """Of two cards with one number the first is left out; nodes at two places, cards after the end and a second end of the run are named."""
    curve = "*DEFINE_CURVE\n" + row(1, 0, 1.0, 1.0) + row(0, 0.0, width=20) + row(20, 0.004, width=20)
    case = taken(lsdyna(more=curve + "*NODE\n" + row(8, width=8)[:-1] + row(100, 100, 110, width=16)) + "*PART\nlost\n" + row(9, 7, 7) + "*TITLE\nlost\n")
    report = json.loads(read("case/import.json"))
    first = next(row for row in report["cards"] if row["card"] == "*DEFINE_CURVE_TITLE")
    assert (first["mapping"], first["how"]) == ("left out", "another card with this number follows, which is taken")
    assert "mass_flow = { time = [0.0, 0.02], value = [0.0, 4.0] }" in case and "v 0.1 0.1 0.11" in read("case/bag.obj")
    assert "1 nodes stand twice, at different places" in read("case/import.md") and "2 cards after it are not read" in read("case/import.md")
    assert taken(lsdyna().replace("*END\n", "*END+\n*TITLE\nlost\n")) == taken(lsdyna())
    again = radioss("/FUNCT/2\nheat\n" + row(0, 450.0, width=20) + row(20, 450.0, width=20)) + "/TITLE\nlost\n"
    assert "450.0" in taken(again, "cube_0000.rad") and "1 cards after it are not read" in read("case/import.md")
    refused_deck("is no set of parts", lsdyna().replace(row(3) + row(7), row(3) + 25 * "7," + "\n"))
    assert "is not read: has more than 24 fields" in read("refused/import.md")
    refused_deck("stands twice, allowed: once", lsdyna(more="*CONTROL_TERMINATION\n" + row(30.0)))


# End of the runs [s], and whether the Radioss deck has another law, Hencky's for St. Venant-Kirchhoff's. At strains e of
# up to 0.1 these differ by e^2 = 0.01, the volume by up to twice that, the pressure by 1.4 times as much: 0.03.
EXPORTED = {"ball_impact": (2e-3, True), "bag_from_files": (2e-3, False), "bag_leak_table": (2e-3, False), "contact_vent": (2e-3, False),
            "driver_bag": (2e-2, False), "driver_folded": (5e-4, False), "flattened_sphere": (2e-3, False), "half_cylinder": (2e-3, True),
            "measured_fabric": (2e-2, False), "passenger_sharp_no_jet": (2e-3, False), "sphere_inflation": (2e-3, False),
            "strapped_sphere": (2e-3, True)}


@pytest.mark.parametrize("name", EXPORTED)
def test_import_of_export(name):
    """The same history again from both decks, but for the digits of their fields and for Radioss' law."""
    end, other_law = EXPORTED[name]
    times = f"--set output.history_exact=true --set output.history_every={end / 10} --set output.frames=0 --set scene.end_time={end}"
    case = ROOT / f"cases/{name}.toml"
    ok(f"run {case} --out first {times}")
    first = numbers("first/history.csv")
    for form, deck in DECKS.items():
        ok(f"export {case} --format {form} --units kg-m-s --out {form}")
        ok(f"import {form}/{deck} --out {form}_again")
        ok(f"run {next(Path(form + '_again').glob('*.toml'))} --out {form}_second {times}")
        second = numbers(f"{form}_second/history.csv")
        hencky = form == "radioss" and 'law = "hencky"' in read(next(Path("radioss_again").glob("*.toml")))
        assert hencky or not (other_law and form == "radioss")
        limit = 0.03 if other_law and form == "radioss" else 1e-6
        for column in ("pressure_Pa", "temperature_K", "volume_m3", "gas_mass_kg"):
            largest = max(abs(x) for x in first[column])
            for a, b in zip(first[column], second[column], strict=True):
                assert abs(a - b) <= limit * largest, (form, column)


def test_import_of_initial_overpressure():
    """Gas that is there at time zero: the same mass and energy, also of a part of the bag's gas that is warmer."""
    case = ROOT / "cases/strapped_sphere.toml"
    for form, deck in DECKS.items():
        ok(f"export {case} --format {form} --units kg-mm-ms --out {form}")
        ok(f"import {form}/{deck} --out again")
        written = read(next(Path("again").glob("*.toml")))
        found = re.search(r"pressure = ([0-9.e+]+), temperature = ([0-9.]+) }", written)
        assert float(found[1]) == pytest.approx(121325, rel=2e-6) and float(found[2]) == pytest.approx(293.15, rel=2e-6), form
        assert "[[inflator]]" not in written and "there from the start" in read("again/import.md")
    # 0.5 g of the cube's gas, in 1 m3/1000 with p V / (R T) = 1.12583e-3 kg, at 400 K and cp / cv = 10 / 7.
    mass = "/FUNCT/1\ninflow\n" + row(0, 5e-4, width=20) + row(20, 5e-4, width=20) + "/FUNCT/2\nheat\n" + row(0, 400.0, width=20) + row(20, 400.0, width=20)
    deck = re.sub(r"(?s)/FUNCT/1.*?(?=/MAT/GAS)", mass, radioss()).replace("inflator\n" + row(1, 1)[:-1], "inflator\n" + row(1, 0)[:-1])
    case = taken(deck, "cube_0000.rad")
    there = 101325 * 1e-3 / (300 * 300)
    energy = 700 * there * 300 + 1000 * 5e-4 * 400
    found = re.search(r"pressure = ([0-9.e+]+), temperature = ([0-9.]+) }", case)
    assert float(found[2]) == pytest.approx(energy / (700 * (there + 5e-4)), rel=1e-9)
    assert float(found[1]) == pytest.approx(300 * energy / 700 / 1e-3, rel=1e-9)
    assert "flow in within" not in read("case/import.md")
    other = deck.replace("/PROP/INJECT1", "/MAT/GAS/MASS/9\nother\n" + row(0.04, width=20) + row(1000.0, 0, 0, 0, 0, width=20) + row(0, width=20) + "/PROP/INJECT1")
    assert "[[inflator]]" in taken(other.replace(row(4, 1, 2, None)[:-1], row(9, 1, 2, None)[:-1]), "cube_0000.rad")
    assert "0.0005 kg that are there at time zero flow in within" in read("case/import.md")


def test_import_of_plates_and_layers():
    """A plate that held nodes touch stays where it is; the limit of a thickness is that of the design shape."""
    ok(f"export {ROOT / 'cases/passenger_sharp_no_jet.toml'} --format radioss --units kg-m-s --out plate")
    ok("import plate/bag_0000.rad --out again")
    assert "point = [0.0, 0.0, 0.0]" in read("again/bag_0000.toml") and "moved back" not in read("again/import.md")
    ok(f"export {ROOT / 'cases/driver_folded.toml'} --format lsdyna --units kg-m-s --out layers")
    ok("import layers/bag.k --out again")
    assert "thickness = 0.002  # m" in read("again/bag.toml").split("[membrane.self_contact]")[1]


def test_import_of_damaged_decks():
    """No crash and no silence: exit code 0 or 2, and a report either way."""
    chance = random.Random(1)
    for name, text in ("cube.k", lsdyna()), ("cube_0000.rad", radioss()):
        for _ in range(150):
            damaged = bytearray(text.encode())
            for _ in range(chance.randint(1, 6)):
                at = chance.randrange(len(damaged))
                kind = chance.randrange(4)
                if kind == 0:
                    damaged[at] = chance.choice(b"0123456789.-+*/&$#, \n\xff\0eE")
                elif kind == 1:
                    del damaged[at:at + chance.randint(1, 200)]
                elif kind == 2:
                    damaged[at:at] = bytes(damaged[at - 80:at])
                else:
                    damaged[at:at] = chance.choice([b"\n*INCLUDE\ncube.k\n", b"\n/END\n", b"1e999", b"-", b"\n"])
            Path(name).write_bytes(damaged)
            write("", "cube_0001.rad") if chance.random() < 0.1 else Path("cube_0001.rad").write_text(engine(), encoding="utf-8")
            done = gasjet(f"import {name} --out damaged")
            assert done.code in (0, 2), done.what
            assert Path("damaged/import.md").exists() or done.code == 2
            assert bool(list(Path("damaged").glob("*.toml"))) == (done.code == 0), done.what
