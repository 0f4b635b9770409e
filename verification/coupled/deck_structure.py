# SPDX-License-Identifier: Apache-2.0
"""Reads the decks of `gasjet export` by the cards' own columns, as the programs do, and resolves every
reference between numbers. It shares nothing with the writers."""
import glob
import os
import re

from deck_numbers import FAULTS, Deck, blocks, fault
from deck_structure_lsdyna import read_lsdyna


def fields(where, line, form):
    """Splits a line by a form such as 'i10 r20 -10 s20'; a field that does not parse is a fault."""
    values, at = [], 0
    for item in form.split():
        kind, width = (item[0], int(item[1:]))
        text = line[at:at + width]
        at += width
        if kind == "-":
            if text.strip():
                fault(where, f"'{text}' stands where nothing may")
            continue
        if kind == "s":
            values.append(text.strip())
            continue
        try:
            values.append(int(text) if kind == "i" else float(text))
        except ValueError:
            fault(where, f"'{text}' is no {'whole number' if kind == 'i' else 'number'} in columns {at - width + 1} to {at}")
            values.append(0)
    if len(line) > at:
        fault(where, f"{len(line)} columns, {at} at most")
    return values


I10, R20 = "i10", "r20"
VECTOR = "r20 r20 r20"


def radioss_numbers(deck, kind, lines):
    for where, line in lines:
        if len(line) > 100 or len(line) % 10:
            fault(where, "fields of 10 columns, at most 10 of them, are needed")
        for at in range(0, len(line), 10):
            deck.name(where, kind, fields(where, line[at:at + 10], I10)[0])


def radioss_airbag(deck, lines):
    it = iter(lines)

    def card(form):
        where, line = next(it)
        return where, fields(where, line, form)

    where, v = card("i10 -10 r20")
    deck.name(where, "surface", v[0])
    card("r20 r20 r20 r20 r20")
    where, v = card("i10 -10 r20 r20 r20 i10 i10")
    deck.name(where, "gas", v[0])
    if v[2] <= 0 or v[3] <= 0:
        fault(where, "pressure and temperature above 0 are needed")
    where, (jets,) = card("i10")
    for _ in range(jets):
        where, v = card("i10 i10 i10 i10 i10 i10")
        deck.name(where, "injector", v[0])
    where, (vents, leaks) = card("i10 i10")
    for _ in range(vents):
        where, v = card("i10 i10 r20 r20 -20 s20")
        if v[2] <= 0:
            fault(where, "a vent without area")
        card("r20 r20 r20 r20 -10 i10")
        for _ in range(2):
            where, v = card("i10 i10 i10 -10 r20 r20 r20")
            for function in v[:3]:
                deck.name(where, "function", function)
    for _ in range(leaks):
        where, v = card("i10 i10 i10 -50 s20")
        deck.name(where, "surface", v[0])
        deck.porous.append((where, v[0]))
        form = v[1]
        if form not in (2, 3):
            fault(where, f"form {form} of a porous surface, which is not that of fabric")
        card("r20 r20 r20 r20 -10 i10")
        if form == 2:
            where, v = card("i10 -10 r20")
            deck.name(where, "function", v[0])
    for where, _ in it:
        fault(where, "a line that belongs to nothing")
    deck.counts["vents"], deck.counts["leaks"], deck.counts["inflators"] = vents, leaks, jets


RADIOSS_CARDS = {  # title line, then forms; a reference is written kind=field
    "MAT/VOID": (["r20 r20"], "law"),
    "MAT/FABRI": (["r20", VECTOR, VECTOR, "r20"], "law"),
    "MAT/FABR_A": (["r20", "r20 r20 r20 r20 r20", "r20 r20 r20 r20 -10 i10", "r20 r20 r20 -20 r20",
                    "i10 i10 r20 r20 r20 r20", "function i10 -10 r20", "function i10 -10 r20", "function i10 -10 r20",
                    "function i10 function i10 r20 r20 function i10 r20"], "law"),
    "LEAK/MAT": (["i10 -10 r20 r20", "r20 i10 -10 r20", "r20 r20"], "leak"),
    "MAT/GAS/MASS": (["r20", "r20 r20 r20 r20 r20", "r20"], "gas"),
    "PROP/VOID": (["r20"], "property"),
    "PROP/SH_ORTH": (["i10 i10 i10 i10 -20 r20", "r20 r20 r20 r20 r20", "i10 i10 r20 r20 i10 i10 i10",
                      "r20 r20 r20 r20 -10 i10"], "property"),
    "PROP/SH_FABR": (["i10 i10 i10 -30 r20", "r20 r20 r20 r20 r20", "i10 i10 r20 r20 -10 i10",
                      "r20 r20 r20 skew i10 i10 -10 i10", "r20 r20 r20 r20 law i10"], "property"),
    "PROP/KJOINT2": (["i10 r20 r20 r20 i10 skew i10 skew i10", "r20 i10 r20 r20", "r20 i10", "r20 r20 i10"], "property"),
    "SKEW/FIX": ([VECTOR, VECTOR, VECTOR], "skew"),
    "CLOAD": (["function i10 s10 skew i10 i10 group i10 -10 r20 r20"], "force"),
    "SKEW/MOV": (["node i10 node i10 node i10 s10"], "skew"),
    "PROP/SPRING": (["r20 -30 i10 i10 i10", "r20 r20 r20 r20 r20", "function i10 i10 i10 i10 i10 -10 r20 r20",
                     "r20 r20 r20 r20"], "property"),
    "PROP/INJECT1": (["i10 i10 r20", "gas i10 function i10 function i10 -10 r20 r20"], "injector"),
    "BCS": (["s10 skew i10 group i10"], "condition"),
    "RWALL/PLANE": (["node i10 i10 group i10 group i10", VECTOR, VECTOR, VECTOR], "wall"),
    "DAMP": (["r20 r20 group i10 skew i10 r20 r20"], "damping"),
    "GRAV": (["function i10 s10 skew i10 i10 group i10 -10 r20 r20"], "gravity"),
    "PLOAD": (["surface i10 function i10 i10 i10 i10 -10 r20 r20"], "load"),
    "RBODY": (["node i10 i10 skew i10 i10 r20 group i10 i10 i10 surface i10", VECTOR, VECTOR, "i10 i10 i10"], "body"),
    "INIVEL/TRA": (["r20 r20 r20 group i10 skew i10"], "velocity"),
    "INIVEL/ROT": (["r20 r20 r20 group i10 skew i10"], "velocity"),
    "PART": (["property i10 law i10 i10"], "part"),
    "INTER/TYPE7": (["group i10 surface i10 i10 i10 i10 -10 i10 i10 i10 i10", "r20 r20 r20 -20 i10",
                     "r20 r20 r20 r20 i10 i10", "r20 r20 r20 r20 r20", "s10 -20 i10 r20 r20 r20",
                     "i10 i10 r20 i10 i10 function i10 r20 i10"], "contact"),
}
REQUESTS = {"TH/MONV": "volume", "TH/RBODY": "body", "TH/INTER": "contact", "TH/RWALL": "wall"}


def card_with_names(deck, where, line, form):
    """A form in which a kind stands before the field that names a number of it."""
    plain, kinds, kind = [], {}, None
    values = 0
    for item in form.split():
        if not re.fullmatch(r"[irs-]\d+", item):
            kind = item
            continue
        plain.append(item)
        if item[0] != "-":
            if kind:
                kinds[values] = kind
            values += 1
        kind = None
    found = fields(where, line, " ".join(plain))
    for index, name in kinds.items():
        deck.name(where, name, found[index])


def radioss_block(deck, header, lines):
    where, key = header[0], header[1][1:].split("/")
    number = int(key[-1]) if key[-1].isdigit() else None
    keyword = "/".join(key[:-1] if number is not None else key)
    if keyword in ("BEGIN", "END"):
        return
    if keyword == "NODE":
        for place, line in lines:
            deck.define(place, "node", fields(place, line, "i10 r20 r20 r20")[0])
        deck.counts["nodes"] = len(deck.defined["node"])
    elif keyword in ("SH3N", "SPRING"):
        deck.name(where, "part", number)
        for place, line in lines:
            v = fields(place, line, "i10 i10 i10 i10" if keyword == "SH3N" else "i10 i10 i10")
            deck.define(place, "element", v[0])
            if len(set(v[1:])) != len(v) - 1:
                fault(place, "an element names a node twice")
            for node in v[1:]:
                deck.name(place, "node", node)
        deck.counts[keyword] = deck.counts.get(keyword, 0) + len(lines)
    elif keyword in ("GRNOD/NODE", "SURF/PART"):
        deck.define(where, "group" if keyword[0] == "G" else "surface", number)
        radioss_numbers(deck, "node" if keyword[0] == "G" else "part", lines[1:])
        deck.members[keyword, number] = [int(part) for _, line in lines[1:] for part in line.split()]
    elif keyword == "FUNCT":
        deck.define(where, "function", number)
        points = [fields(place, line, "r20 r20") for place, line in lines[1:]]
        if len(points) < 2 or any(b[0] <= a[0] for a, b in zip(points, points[1:])):
            fault(where, "a function needs two points or more at rising abscissae")
        deck.rising[number] = all(b[1] > a[1] for a, b in zip(points, points[1:]))
    elif keyword == "XREF":
        deck.name(where, "part", number)
        fields(*lines[1], "i10")
        for place, line in lines[2:]:
            deck.name(place, "node", fields(place, line, "i10 r20 r20 r20")[0])
    elif keyword == "MONVOL/AIRBAG1":
        deck.define(where, "volume", number)
        radioss_airbag(deck, lines[1:])
    elif keyword in REQUESTS:
        radioss_numbers(deck, REQUESTS[keyword], lines[2:])
    elif keyword in RADIOSS_CARDS:
        forms, kind = RADIOSS_CARDS[keyword]
        deck.define(where, kind, number)
        if len(lines) != 1 + len(forms):
            fault(where, f"{keyword} has {len(lines)} lines, {1 + len(forms)} are needed")
        for (place, line), form in zip(lines[1:], forms):
            card_with_names(deck, place, line, form)
        if kind in ("law", "property"):
            deck.keyword_of[kind, number] = keyword
        if keyword == "PART":
            deck.law_of[number] = int(lines[1][1][10:20])
            deck.parts.append((where, int(lines[1][1][:10]), deck.law_of[number]))
        elif keyword == "MAT/FABR_A":
            deck.threads += [(where, int(line[:10])) for _, line in lines[6:8]]
        elif keyword == "LEAK/MAT":
            deck.name(where, "law", number)
            factors = fields(*lines[-1], "r20 r20")
            if not 0 < factors[0] * factors[1] <= 1:
                fault(where, f"{factors[0] * factors[1]} of the fabric is open")
    else:
        fault(where, f"{keyword}: an unknown keyword")


def read_radioss(path, deck):
    for header, block in blocks(path, "/", "#", "/END"):
        radioss_block(deck, header, block)
    # Fabric by curves has a property of its own, and its functions rise everywhere.
    for where, prop, law in deck.parts:
        if (deck.keyword_of.get(("law", law)) == "MAT/FABR_A") != (deck.keyword_of.get(("property", prop)) == "PROP/SH_FABR"):
            fault(where, f"law {law} and property {prop} do not go together")
    for where, function in deck.threads:
        if not deck.rising.get(function, True):
            fault(where, f"function {function} falls, or is level")
    if not deck.defined.keys() & {"volume", "load"}:
        fault(path, "neither gas nor pressure")
    # A porous surface leaks by what the material of its parts says, and not at all without it.
    for where, surface in deck.porous:
        for part in deck.members.get(("SURF/PART", surface), []):
            deck.name(where, "leak", deck.law_of.get(part, 0))


def read_engine(path):
    with open(path, encoding="ascii") as file:
        text = file.read()
    for keyword in ("/RUN/", "/TFILE", "/DT", "/ANIM/DT"):
        if not re.search(rf"^{keyword}", text, re.M):
            fault(path, f"no {keyword}")


def read_deck(kind, path):
    """Counts of a deck, which is a file or a folder of one, and its faults."""
    FAULTS.clear()
    deck = Deck()
    files = sorted(glob.glob(os.path.join(path, "bag*"))) if os.path.isdir(path) else [path]
    for file in files:
        if kind == "lsdyna":
            read_lsdyna(file, deck)
        elif file.endswith("_0001.rad"):
            read_engine(file)
        else:
            read_radioss(file, deck)
    deck.resolve()
    return deck.counts, FAULTS[:10]
