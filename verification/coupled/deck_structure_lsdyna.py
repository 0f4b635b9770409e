# SPDX-License-Identifier: Apache-2.0
"""Reads LS-DYNA keyword decks for deck_structure.py: cards as the keyword manual has them, by columns. A blank field
is zero, which mostly stands for a default."""
import math
import re

from deck_numbers import blocks, fault

# The cards of a keyword after its header, in the manual's order. An item is a kind of value (i whole number,
# r number, s text, - nothing) with its width; a word before it says what it names, "=" before that what it defines.
EIGHT = "r10 r10 r10 r10 r10 r10 r10 r10"
TITLE = "i10 s70"
CARDS = {
    "TITLE": ["s80"],
    "CONTROL_UNITS": ["s10 s10 s10 s10"],
    "CONTROL_TERMINATION": ["r10 i10 r10 r10 r10 i10"],
    "CONTROL_TIMESTEP": ["r10 r10 i10 r10 r10 curve i10 i10 i10"],
    "CONTROL_ENERGY": ["i10 i10 i10 i10"],
    "DAMPING_GLOBAL": ["curve i10 r10 r10 r10 r10 r10 r10 r10"],
    "DAMPING_PART_MASS": ["part i10 curve i10 r10 i10"],
    "DAMPING_PART_STIFFNESS": ["part i10 r10"],
    "BOUNDARY_SPC_NODE": ["node i10 system i10 i10 i10 i10 i10 i10 i10"],
    "DEFINE_COORDINATE_VECTOR": ["=system i10 r10 r10 r10 r10 r10 r10 node i10"],
    "LOAD_RIGID_BODY": ["part i10 i10 curve i10 r10 system i10 node i10 node i10 node i10"],
    "MAT_DAMPER_VISCOUS": ["=material i10 r10"],
    "BOUNDARY_SPC_SET": ["nodes i10 i10 i10 i10 i10 i10 i10 i10"],
    "RIGIDWALL_PLANAR_ID": [TITLE, "nodes i10 nodes i10 i10 r10 r10 r10 r10", EIGHT],
    "MAT_NULL": ["=material i10 r10 r10 r10 r10 r10 r10 r10"],
    "MAT_FABRIC": ["=material i10 r10 r10 r10 -10 r10 r10 r10", EIGHT, EIGHT, "-10 r10 r10 r10 r10 r10 r10 r10",
                   "r10 r10 r10 -10 -10 -10 r10 i10"],
    "LOAD_SHELL_SET_ID": [TITLE, "shells i10 curve i10 r10 r10"],
    "MAT_RIGID": ["=material i10 r10 r10 r10 r10 r10 r10 s10", "r10 i10 i10", "r10 r10 r10 r10 r10 r10"],
    "MAT_SPRING_NONLINEAR_ELASTIC": ["=material i10 curve i10 curve i10"],
    "SECTION_SHELL": ["=section i10 i10 r10 i10 r10 r10 i10 i10", EIGHT],
    "SECTION_DISCRETE": ["=section i10 i10 r10 r10 r10 r10", "r10 r10"],
    "PART": ["s70", "=part i10 section i10 material i10 i10 i10 i10 i10 i10"],
    "PART_INERTIA": ["s70", "=part i10 section i10 material i10 i10 i10 i10 i10 i10", "r10 r10 r10 r10 i10 node i10",
                     "r10 r10 r10 r10 r10 r10", "r10 r10 r10 r10 r10 r10"],
    "ELEMENT_DISCRETE": ["=element i8 part i8 node i8 node i8 i8 r16 i8 r16"],
    "CONSTRAINED_JOINT_REVOLUTE_ID": [TITLE, "node i10 node i10 node i10 node i10 node i10 node i10 r10 r10"],
    "CONTACT_AUTOMATIC_NODES_TO_SURFACE_ID": [TITLE, "nodes i10 part i10 i10 i10 i10 i10 i10 i10",
                                              "r10 r10 r10 r10 r10 i10 r10 r10", EIGHT, "i10 r10 i10 r10 r10 i10 i10 i10"],
    "CONTACT_AIRBAG_SINGLE_SURFACE_ID": [TITLE, "parts i10 i10 i10 i10 i10 i10 i10 i10", "r10 r10 r10 r10 r10 i10 r10 r10", EIGHT,
                                         "i10 r10 i10 r10 r10 i10 i10 i10", "r10 i10 i10 i10 i10 i10 r10 r10", "i10 i10 r10 r10 r10 -10 r10 i10"],
    "DATABASE_BINARY_D3PLOT": ["r10 i10 i10 i10 i10"],
    "END": [],
}
for axis in "XYZ":
    CARDS["LOAD_BODY_" + axis] = ["curve i10 r10 curve i10 r10 r10 r10 i10"]
for history in ("GLSTAT", "MATSUM", "ABSTAT", "RBDOUT", "JNTFORC", "NODOUT", "RCFORC", "RWFORC", "DEFORC"):
    CARDS["DATABASE_" + history] = ["r10 i10 curve i10 i10"]
# Lists: the form of each line after those cards; "+" takes as many lines as there are.
LISTS = {
    "NODE": ([], "=node i8 r16 r16 r16 i8 i8"),
    "ELEMENT_SHELL": ([], "=element i8 part i8 node i8 node i8 node i8 node i8"),
    "AIRBAG_REFERENCE_GEOMETRY": ([], "node i8 r16 r16 r16"),
    "DEFINE_CURVE": (["=curve i10 i10 r10 r10 r10 r10 i10 i10"], "r20 r20"),
    "DEFINE_CURVE_TITLE": (["s80", "=curve i10 i10 r10 r10 r10 r10 i10 i10"], "r20 r20"),
    "CONSTRAINED_EXTRA_NODES_NODE": ([], "part i10 node i10 i10"),
    "SET_NODE_LIST": (["=nodes i10 r10 r10 r10 r10 s10"], " ".join(["node i10"] * 8)),
    "SET_SHELL_LIST": (["=shells i10 r10 r10 r10 r10"], " ".join(["element i10"] * 8)),
    "SET_PART_LIST": (["=parts i10 r10 r10 r10 r10"], " ".join(["part i10"] * 8)),
    "DATABASE_HISTORY_NODE": ([], " ".join(["node i10"] * 8)),
}
AIRBAG = [TITLE, "parts i10 i10 i10 r10 r10 r10 r10 r10", "r10 r10 r10 r10 r10 r10", "r10 curve i10 r10 curve i10 r10 curve i10 r10 curve i10",
          "i10 r10 i10 curve i10 curve i10 i10"]
GAS = ["curve i10 curve i10 -10 r10 r10 r10 r10 r10", "r10"]
THREADS = "curve i10 curve i10 curve i10 curve i10 curve i10 curve i10 r10"  # of a fabric by curves
BY_CURVES = (4, 14, -14, 24)  # its FORM
GREEN = 12  # FORM of Green-Lagrange strain
UNITS = ({"m", "mm"}, {"sec", "ms"}, {"kg", "mtrc_ton"}, {"k"})


def read_card(deck, where, line, form):
    """Values of a card; what it defines and names goes into `deck`."""
    values, at, word = [], 0, None
    for item in form.split():
        if not re.fullmatch(r"[irs-]\d+", item):
            word = item
            continue
        kind, width = item[0], int(item[1:])
        text = line[at:at + width].strip()
        at += width
        if kind == "-":
            if text:
                fault(where, f"'{text}' stands where nothing may")
            continue
        try:
            value = text if kind == "s" else (int(text or 0) if kind == "i" else float(text or 0))
        except ValueError:
            fault(where, f"'{text}' is no {'whole number' if kind == 'i' else 'number'} in columns {at - width + 1} to {at}")
            value = 0
        if word and word[0] == "=":
            deck.define(where, word[1:], value)
        elif word:
            deck.name(where, word, value)
        values.append(value)
        word = None
    if len(line) > at:
        fault(where, f"{len(line)} columns, {at} at most")
    return values


def airbag(deck, lines):
    cards = [read_card(deck, where, line, form) for (where, line), form in zip(lines, AIRBAG)]
    where, gases = lines[0][0], lines[len(AIRBAG):]
    if len(cards) < len(AIRBAG) or len(gases) != 2 * cards[4][2]:
        fault(where, f"an airbag of {len(lines)} lines")
        return
    if min(cards[2][:4]) <= 0 or cards[2][4] != 1:
        fault(where, "ambient temperature, pressure, density and gas constant above 0 are needed")
    initial = 0.0
    for i in range(0, len(gases), 2):
        values = read_card(deck, *gases[i], GAS[0])
        read_card(deck, *gases[i + 1], GAS[1])
        if [curve == 0 for curve in values[:2]] != [values[3] > 0] * 2:
            fault(gases[i][0], "a gas needs two curves, and the gas of the start none")
        if values[2] <= 0 or values[4] <= 0:
            fault(gases[i][0], "a gas needs a molar mass and a heat capacity")
        initial += values[3]
    if initial != 1.0:
        fault(where, f"{initial} of the initial gas")
    deck.counts["inflators"], deck.counts["vents"] = cards[4][2] - 1, int(cards[3][2] > 0 or cards[3][3] > 0) + int(cards[3][7] > 0)


def check_list(deck, keyword, rows):
    """Rows: (where, values) of a list."""
    if keyword == "NODE":
        for _, values in rows:
            deck.places[values[0]] = values[1:4]
    elif keyword.startswith("DEFINE_CURVE"):
        times = [values[0] for _, values in rows]
        if len(times) < 2 or any(b <= a for a, b in zip(times, times[1:])):
            fault(rows[0][0], "a curve needs two points or more at rising abscissae")
    elif keyword == "ELEMENT_SHELL":
        for where, values in rows:
            if len(set(values[2:6])) != 3 or values[4] != values[5]:
                fault(where, "a triangle has three nodes, the last one twice")
            deck.shell_parts.add(values[1])
        deck.counts["shells"] = deck.counts.get("shells", 0) + len(rows)
    elif keyword == "CONSTRAINED_EXTRA_NODES_NODE":
        for _, values in rows:
            deck.bodies.setdefault(values[0], set()).add(values[1])


def check_cards(deck, where, keyword, cards):
    if keyword == "CONTROL_UNITS":
        for value, allowed in zip(cards[0], UNITS):
            if value not in allowed:
                fault(where, f"{value} is no unit")
    elif keyword == "MAT_FABRIC":
        option, factor = cards[2][6], cards[2][2]
        if (option == 7) != (factor < 0):
            fault(where, "leakage by velocity needs a curve, and no other leakage has one")
        if factor < 0:
            deck.name(where, "curve", -int(factor))
        if (cards[2][5] in BY_CURVES) != (len(cards) == 6 and min(cards[5][:2]) > 0):
            fault(where, "a fabric by curves has those of warp and weft, and no other fabric has any")
        if (cards[2][5] == GREEN) != (cards[4][-1] == 1):
            fault(where, "strain from the design shape by ISREFG goes with FORM 12, and with no other")
        if cards[0][1] <= 0 or cards[0][2] <= 0 or cards[1][0] <= 0:
            fault(where, "density and moduli above 0 are needed")
    elif keyword == "MAT_RIGID" and cards[1][0] == -1.0:  # held in axes of its own
        deck.name(where, "system", cards[1][1])
    elif keyword == "CONSTRAINED_JOINT_REVOLUTE_ID":
        deck.joints.append((where, cards[1][:4]))
    elif keyword.startswith("PART"):
        deck.sections[cards[1][0]] = (where, cards[1][1])
    elif keyword == "SECTION_SHELL":
        deck.shells.add(cards[0][0])
        if min(cards[1][:4]) <= 0:
            fault(where, "a shell without thickness")
    if keyword == "PART_INERTIA" and min(cards[2][3], cards[3][0], cards[3][3], cards[3][5]) <= 0:
        fault(where, "mass and inertia above 0 are needed")


def read_block(deck, header, lines):
    where, keyword = header[0], header[1][1:]
    if keyword == "KEYWORD":
        return
    deck.filled |= keyword in ("AIRBAG_HYBRID_ID", "LOAD_SHELL_SET_ID")
    if keyword == "AIRBAG_HYBRID_ID":
        airbag(deck, lines)
    elif keyword in LISTS:
        first, form = LISTS[keyword]
        for (place, line), card in zip(lines, first):
            read_card(deck, place, line, card)
        rows = [(place, read_card(deck, place, line, form)) for place, line in lines[len(first):]]
        if not rows:
            fault(where, f"{keyword}: nothing in it")
            return
        check_list(deck, keyword, rows)
    elif keyword in CARDS:
        forms = CARDS[keyword]
        if keyword == "MAT_FABRIC" and len(lines) > 2 and float(lines[2][1][50:60] or 0) in BY_CURVES:
            forms = forms + [THREADS]
        if len(lines) != len(forms):
            fault(where, f"{keyword} has {len(lines)} lines, {len(forms)} are needed")
            return
        check_cards(deck, where, keyword, [read_card(deck, place, line, form) for (place, line), form in zip(lines, forms)])
    else:
        fault(where, f"{keyword}: an unknown keyword")


def check_whole(deck):
    for part, (where, section) in deck.sections.items():
        if (part in deck.shell_parts) != (section in deck.shells):
            fault(where, f"part {part} has elements of another kind than its section")
    for where, (a, b, c, d) in deck.joints:
        if {a, c} - deck.bodies.get(next(iter(deck.bodies), 0), set()):
            fault(where, "the joint's first body has not its nodes")
        for one, other in ((a, b), (c, d)):
            if one in deck.places and other in deck.places and math.dist(deck.places[one], deck.places[other]) > 0:
                fault(where, f"nodes {one} and {other} of the joint are apart")


def read_lsdyna(path, deck):
    deck.places, deck.bodies, deck.sections, deck.shells, deck.shell_parts, deck.joints = {}, {}, {}, set(), set(), []
    deck.filled = False
    for header, block in blocks(path, "*", "$", "*END"):
        read_block(deck, header, block)
    check_whole(deck)
    if not deck.filled:
        fault(path, "neither gas nor pressure")
    deck.counts["nodes"] = len(deck.places)
