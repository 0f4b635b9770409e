# SPDX-License-Identifier: Apache-2.0
"""Judges the numbers of decks of one case in several unit systems: those with a name, which stands above them.

Folders are named CASE.UNITS; the first is in kg-m-s. Each number of a deck times its unit is that of the first deck, and the first
deck has the numbers of the case.
"""

import re
import tomllib

SYSTEMS = {"kg-m-s": (1.0, 1.0, 1.0), "t-mm-s": (1e3, 1e-3, 1.0), "kg-mm-ms": (1.0, 1e-3, 1e-3)}  # kg, m, s
# Powers of mass, length and time.
LENGTH, TIME, MASS, AREA, PRESSURE = (0, 1, 0), (0, 0, 1), (1, 0, 0), (0, 2, 0), (1, -1, -2)
DENSITY, INERTIA, STIFFNESS, ENERGY = (1, -3, 0), (1, 2, 0), (1, 0, -2), (1, 2, -2)
SPECIFIC_ENERGY, ACCELERATION, MASS_FLOW = (0, 2, -2), (0, 1, -2), (1, 0, -1)
FILES = {"radioss": "bag_0000.rad", "lsdyna": "bag.k"}
NAMES = {
    "radioss": {"RHO_I": DENSITY, "E11": PRESSURE, "E22": PRESSURE, "G12": PRESSURE, "Thick": LENGTH, "THICK": LENGTH,
                "MW": MASS, "Cpa": SPECIFIC_ENERGY, "Cpb": SPECIFIC_ENERGY, "Pext": PRESSURE, "Avent": AREA, "Mass": MASS,
                "Jxx": INERTIA, "Kn": STIFFNESS, "GAPmin": LENGTH, "Fscale_Y": ACCELERATION, "XM": LENGTH, "K": STIFFNESS,
                "MASS": MASS},
    "lsdyna": {"RO": DENSITY, "EA": PRESSURE, "EB": PRESSURE, "GAB": PRESSURE, "E": PRESSURE, "YM": PRESSURE, "T1": LENGTH,
               "ENDTIM": TIME, "MW": MASS, "A": ENERGY, "B": ENERGY, "GC": ENERGY, "ATMOSP": PRESSURE, "ATMOSD": DENSITY,
               "A23": AREA, "TM": MASS, "IXX": INERTIA, "ZC": LENGTH, "SF": ACCELERATION, "XT": LENGTH},
}
OF_THE_CASE = {
    "radioss": {"RHO_I": "fabric.density", "E11": "fabric.young_modulus", "Thick": "fabric.thickness", "Pext": "ambient.pressure",
                "Mass": "pendulum.mass", "Jxx": "pendulum.inertia_cg"},
    "lsdyna": {"RO": "fabric.density", "EA": "fabric.young_modulus", "T1": "fabric.thickness", "ATMOSP": "ambient.pressure",
               "TM": "pendulum.mass", "IXX": "pendulum.inertia_cg", "ENDTIM": "scene.end_time"},
}
CURVES = {"radioss": (r"/FUNCT/\d+\nmass flow\n#.*\n", "/"), "lsdyna": (r"\*DEFINE_CURVE\n.*\n.*\n", "*")}


def numbers_of(text, kind):
    """Lists of the numbers below each name, and of the largest value of each curve."""
    found = {name: [] for name in NAMES[kind]}
    lines = text.split("\n")
    for head, line in zip(lines, lines[1:]):
        if head[:1] not in "#$" or line[:1] in "#$/*":
            continue
        start = 1
        for match in re.finditer(r"\S+", head[1:]):
            name, end = match.group(), match.end() + 1
            if name in found and line[start - 1 if start == 1 else start : end].strip():
                found[name].append(float(line[start - 1 if start == 1 else start : end]))
            start = end
    pattern, mark = CURVES[kind]
    found["curve"] = []
    for match in re.finditer(pattern, text):
        rows = text[match.end() : text.index(mark, match.end())].split("\n")
        found["curve"].append(max(abs(float(row[20:40])) for row in rows if row.strip() and row[0] not in "#$"))
    return found


def at_path(table, path):
    for key in path.split("."):
        table = table[key]
    return table


def judge_units(kind, case, folders):
    """Faults of the decks in the folders."""
    faults, first = [], None
    for folder in folders:
        mass, length, time = SYSTEMS[folder.rsplit(".", 1)[1]]
        with open(f"{folder}/{FILES[kind]}", encoding="ascii") as file:
            found = numbers_of(file.read(), kind)
        powers = dict(NAMES[kind], curve=MASS_FLOW)
        if kind == "lsdyna":
            found["curve"] = found["curve"][-2:-1]  # of the last inflator: mass flow, then temperature
        si = {name: [v * mass ** powers[name][0] * length ** powers[name][1] * time ** powers[name][2] for v in values]
              for name, values in found.items()}
        first = first or si
        for name, values in si.items():
            if not values or len(values) != len(first[name]):
                faults.append(f"{folder}: {name}: {len(values)} numbers, {len(first[name])} in the first deck")
            for mine, expected in zip(values, first[name]):
                if abs(mine - expected) > 1e-3 * abs(expected):  # fields of ten columns hold four digits or more
                    faults.append(f"{folder}: {name}: {mine:g} in SI units, {expected:g} in the first deck")
    with open(case, "rb") as file:
        table = tomllib.load(file)
    for name, path in OF_THE_CASE[kind].items():
        expected = at_path(table, path)
        if name == "ENDTIM":  # an interval of the histories longer, and a hundredth
            expected = 1.01 * expected + table["output"]["history_every"]
        if not any(abs(value - expected) <= 1e-3 * expected for value in first[name]):
            faults.append(f"{name}: {first[name]}, the case has {path}: {expected:g}")
    peak = max(table["inflator"][0]["mass_flow"]["value"])
    if not any(abs(value - peak) <= 1e-9 * peak for value in first["curve"]):
        faults.append(f"mass flow: {first['curve']}, the case has {peak}")
    return faults
