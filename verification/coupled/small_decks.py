# SPDX-License-Identifier: Apache-2.0
"""A cube of fabric in a few cards, as an LS-DYNA keyword deck and as a Radioss starter deck, in kg, mm and ms."""
import json
import re
from pathlib import Path

from command import expect, ok, read

CORNERS = [(x, y, z) for z in (0, 100) for y in (0, 100) for x in (0, 100)]
FACES = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]


def row(*fields, width=10):
    return "".join(f"{'' if field is None else field:>{width}}" for field in fields) + "\n"


def lsdyna(airbag=None, more="", faces=FACES, units=True, segments="", material=None):
    """Ideal gas with R = 300 J/(kg K) at 101.325 kPa and 300 K, 10 g of it in 20 ms at 500 K, a vent of 200 mm2."""
    text = "*KEYWORD\n*TITLE\ncube\n" + ("*CONTROL_UNITS\n" + row("mm", "ms", "kg", "k") if units else "")
    text += "*CONTROL_TERMINATION\n" + row(20.0) + "*DATABASE_ABSTAT\n" + row(0.1)
    text += "*NODE\n" + "".join(row(i, width=8)[:-1] + row(*x, width=16) for i, x in enumerate(CORNERS, 1))
    text += "*ELEMENT_SHELL\n" + "".join(row(i, 7, *face, width=8) for i, face in enumerate(faces, 1))
    text += "*PART\nfabric of the cube\n" + row(7, 7, 7) + "*SECTION_SHELL\n" + row(7, 9) + row(*4 * (0.5,))
    text += material or ("*MAT_FABRIC\n" + row(7, 8e-7, 0.06, 0.06, None, 0.3, 0.3) + row(0.0230769, 0, 0, 1.0)
                         + row(0, 0, 0, 0, 0, 12) + row() + row())
    text += "*SET_PART_LIST\n" + row(3) + row(7) + segments
    text += "*DEFINE_CURVE_TITLE\ninflow\n" + row(1, 0, 1.0, 0.5) + row(0, 0.0, width=20) + row(10, 0.002, width=20) + row(20, 0.0, width=20)
    text += airbag or ("*AIRBAG_SIMPLE_AIRBAG_MODEL\n" + row(3, 1) + row(700.0, 1000.0, 500.0, 1, 0.5, 400.0, "1.01325e-4", "1.12583e-9") + row(0))
    return text + more + "*END\n"


def radioss(more="", faces=FACES, vent=200.0):
    """The same bag."""
    text = "#RADIOSS STARTER\n/BEGIN\ncube\n" + row(2022, 0) + 2 * row("kg", "mm", "ms", width=20)
    text += "/NODE\n" + "".join(row(i)[:-1] + row(*x, width=20) for i, x in enumerate(CORNERS, 1))
    text += "/PART/7\nfabric of the cube\n" + row(7, 7, 0) + "/SHELL/7\n" + "".join(row(i, *face) for i, face in enumerate(faces, 1))
    text += "/MAT/FABRI/7\nfabric\n" + row(8e-7, width=20) + row(0.06, 0.06, 0.3, width=20) + row(*3 * (0.0230769230769231,), width=20) + row(0.001, width=20)
    text += "/PROP/SH_ORTH/7\nfabric\n" + row(0, 4, 2) + row(*5 * (0.0,), width=20) + row(1, 0)[:-1] + row(0.5, 0.0, width=20) + row(1.0, 0.5, 0.2, 0.0, width=20)
    text += "/SURF/PART/3\nbag\n" + row(7)
    text += "/FUNCT/1\ninflow\n" + row(0, 0.0, width=20) + row(10, 0.001, width=20) + row(20, 0.0, width=20)
    text += "/FUNCT/2\nheat\n" + row(0, 500.0, width=20) + row(20, 500.0, width=20)
    text += "/MAT/GAS/MASS/4\nair\n" + row(8.31446261815324 / 300, width=20) + row(1000.0, 0, 0, 0, 0, width=20) + row(0, width=20)
    text += "/PROP/INJECT1/5\ninflator\n" + row(1, 1)[:-1] + row(1.0, width=20) + row(4, 1, 2, None)[:-1] + row(1.0, 1.0, width=20)
    text += "/MONVOL/AIRBAG1/1\nbag\n" + row(3, None)[:-1] + row(0.0, width=20) + row(*5 * (1.0,), width=20)
    text += row(4, None)[:-1] + row(1e-10, 1.01325e-4, 300.0, width=20) + row(1) + row(5, 0, 0, 0, 0, 0) + row(1, 0)
    text += row(0, 1)[:-1] + row(vent, 0.0, width=20) + row(0.0, 1e20, 0.0, 0.0, width=20) + 2 * (row(0, 0, 0, None)[:-1] + row(1.0, 1.0, 1.0, width=20))
    return text + more + "/END\n"


def engine(end=20.0):
    return f"/RUN/cube/1\n{end}\n/TFILE/4\n0.1\n"


def write(text, name="cube.k"):
    Path(name).write_text(text, encoding="utf-8")
    if name.endswith("_0000.rad"):
        Path(name.replace("_0000", "_0001")).write_text(engine(), encoding="utf-8")
    return name


def taken(text, name="cube.k", words="", out="case"):
    """The case of a deck as text, after a check that it runs."""
    ok(f"import {write(text, name)} --out {out} {words}")
    case = next(Path(out).glob("*.toml"))
    ok(f"check {case}")
    return re.sub(r"(?m) *#.*$", "", read(case))


def refused_deck(pattern, text, name="cube.k", words=""):
    """No case, but a report that names the card."""
    expect(2, pattern, f"import {write(text, name)} --out refused {words}")
    assert not list(Path("refused").glob("*.toml"))
    assert "## refused" in read("refused/import.md") and not json.loads(read("refused/import.json"))["written"]


def value(case, key):
    return float(re.search(rf"(?m)^{key} = ([-0-9.e+]+)", case)[1])
