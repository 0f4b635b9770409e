# SPDX-License-Identifier: Apache-2.0
"""Older monitored volumes of Radioss, and chambers, as cases."""
import json
import re

import pytest
from command import read
from small_decks import FACES, lsdyna, radioss, refused_deck, row, taken, value


def inline_volume(kind, volume, surface, area, temperature=300.0, exchange=""):
    """A monitored volume in the older form, with the gas of the cube: cp 1000 J/(kg K), R = 300 J/(kg K)."""
    gamma = 1000.0 / 700.0
    gas = row(repr(gamma), 1000.0, 0, 0, width=20)
    text = f"/MONVOL/{kind}/{volume}\nbag\n" + row(surface) + row(*5 * (0.0,), width=20) + row(None, 0.0, 1.01325e-4, temperature, width=20) + gas
    text += row(1) + gas + row(1, 1)[:-1] + row(1.0, width=20)[:-1] + row(2)[:-1] + row(1.0, width=20)[:-1] + row(0) + row(0, 0, 0, 0)
    text += row(1) + row(0)[:-1] + row(area, 0.0, 0.0, width=20) + row(1e30, 0.0, 0.0, width=20) + 2 * row(0, 0, 0, 0)
    return text + exchange


def test_import_of_inline_gas():
    """The older form of a volume says the same as the newer one."""
    wanted = taken(radioss(), "cube_0000.rad")
    newer = re.search(r"(?s)/MONVOL.*(?=/END)", radioss())[0]
    found = taken(radioss().replace(newer, inline_volume("AIRBAG", 1, 3, 200.0)), "cube_0000.rad")
    for key in ("molar_mass", "cp", "area", "pressure", "end_time"):
        assert value(found, key) == pytest.approx(value(wanted, key), rel=1e-12), key
    for line in ("mass_flow =", "temperature ="):
        assert re.search(f"(?m)^{line}.*", found)[0] == re.search(f"(?m)^{line}.*", wanted)[0]


def test_import_of_chambers():
    """Two cubes side by side, with a wall between them that is an element of each, as one chamber."""
    newer = re.search(r"(?s)/MONVOL.*(?=/END)", radioss())[0]
    wall = FACES[5]
    second = [tuple({2: 9, 4: 10, 6: 11, 8: 12}.get(n, {1: 2, 3: 4, 5: 6, 7: 8}.get(n)) for n in face) for face in FACES if face != FACES[4]]

    def deck(temperature):
        exchange = row(1) + row(2, 0)[:-1] + row(0.0, 1000.0, 1e30, 0.0, width=20)
        text = radioss(faces=[face for face in FACES if face != wall])
        text = text.replace("/MAT/FABRI/7", "".join(f"/PART/{part}\npart\n" + row(7, 7, 0) + f"/SHELL/{part}\n" + "".join(row(10 * part + i, *face)
                            for i, face in enumerate(faces)) for part, faces in ((8, [wall]), (9, [wall[::-1]]), (10, second))) + "/MAT/FABRI/7", 1)
        text = text.replace("/PART/7\n", "/NODE\n" + "".join(row(i)[:-1] + row(200, y, z, width=20) for i, (y, z) in
                            zip((9, 10, 11, 12), ((0, 0), (100, 0), (0, 100), (100, 100)))) + "/PART/7\n", 1)
        volumes = inline_volume("COMMU", 1, 4, 200.0, exchange=exchange) + inline_volume("COMMU", 2, 5, 0.0, temperature, exchange=exchange.replace("2", "1", 1))
        return text.replace(newer, volumes + "/SURF/PART/4\none\n" + row(7, 8) + "/SURF/PART/5\nother\n" + row(9, 10))

    refused_deck("choose one by --bag NUMBER, or make one chamber", deck(300.0), "cube_0000.rad")
    refused_deck("chambers that exchange gas", deck(300.0), "cube_0000.rad", "--bag 1")
    refused_deck("starts in another state", deck(310.0), "cube_0000.rad", "--merge-chambers")
    case = taken(deck(300.0), "cube_0000.rad", "--merge-chambers")
    report = json.loads(read("case/import.json"))
    assert report["counts"].pop("cards") == sum(report["counts"].values())
    assert [card["mapping"] for card in report["cards"] if card["card"].startswith("/MONVOL")] == ["exact", "exact"]
    assert "null_panels" not in case and "2 elements between them are left out" in read("case/import.md")
    assert case.count("[[inflator]]") == 2 and case.count("[[vent]]") == 1 and case.count("[[gas.species]]") == 1
    mesh = [tuple(map(float, line.split()[1:])) for line in read("case/bag.obj").splitlines() if line.startswith("v ")]
    faces = [[int(corner) - 1 for corner in line.split()[1:]] for line in read("case/bag.obj").splitlines() if line.startswith("f ")]
    assert len(faces) == 20
    volume = sum(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
                 for a, b, c in ([mesh[i] for i in face] for face in faces)) / 6
    assert volume == pytest.approx(2e-3)
    refused_deck("is for monitored volumes of Radioss", lsdyna(), words="--merge-chambers")
