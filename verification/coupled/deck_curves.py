# SPDX-License-Identifier: Apache-2.0
"""Judges the curves of a deck of `gasjet export` by those of its case: stress of fabric by measured curves, and the
pressure on a sheet. It reads the deck's text by itself and shares nothing with the writers.
The stress of a strip is nominal stress over stretch less 1, whatever measures the deck has.
"""
import csv
import os
import tomllib

FILES = {"radioss": "bag_0000.rad", "lsdyna": "bag.k"}
SHARE = {"radioss": 2e-6, "lsdyna": 1.01e-4}  # of the last stress: what a deck may be off by


def interpolate(points, x):
    """Linear, and straight on beyond the ends."""
    k = 1
    while k + 1 < len(points) and points[k][0] < x:
        k += 1
    (a, low), (b, high) = points[k - 1], points[k]
    return low + (high - low) * (x - a) / (b - a)


def numbers(lines):
    return [[float(v) for v in line.split()] for line in lines]


def blocks(text, mark, comment):
    """(header, lines) of each keyword, comments left out."""
    lines = [line for line in text.split("\n") if line and line[0] not in comment]
    starts = [i for i, line in enumerate(lines) if line.startswith(mark)]
    return [(lines[i], lines[i + 1:j]) for i, j in zip(starts, starts[1:] + [len(lines)])]


def deck_of(kind, path):
    """Points of each curve by its number; curves of warp and weft; moduli of both; curve of the pressure and its factor."""
    with open(path, encoding="ascii") as file:
        text = file.read()
    curves, threads, moduli, pressure = {}, None, None, None
    if kind == "radioss":
        for header, lines in blocks(text, "/", "#"):
            if header.startswith("/FUNCT/"):
                curves[int(header.split("/")[2])] = numbers(lines[1:])
            elif header.startswith("/MAT/FABR_A/"):
                threads, moduli = (int(lines[6][:10]), int(lines[7][:10])), (float(lines[2][:20]), float(lines[2][40:60]))
            elif header.startswith("/PLOAD/"):
                pressure = (int(lines[1][10:20]), float(lines[1][80:100]))
    else:
        for header, lines in blocks(text, "*", "$"):
            if header == "*DEFINE_CURVE":
                curves[int(lines[0][:10])] = numbers(lines[1:])
            elif header == "*MAT_FABRIC" and len(lines) == 6:
                threads, moduli = (int(lines[5][:10]), int(lines[5][10:20])), (float(lines[0][20:30]), float(lines[0][30:40]))
            elif header == "*LOAD_SHELL_SET_ID":
                pressure = (int(lines[1][10:20]), -float(lines[1][20:30]))  # above zero it acts against the normals
    return curves, threads, moduli, pressure


def case_curve(case, folder, name, abscissa):
    if isinstance(case[name], float):
        return [(0.0, case[name])]
    if "file" not in case[name]:
        return list(zip(case[name][abscissa], case[name]["value"]))
    with open(os.path.join(folder, case[name]["file"]), encoding="utf-8") as file:
        return [(float(row["strain"]), float(row[case[name]["column"]])) for row in csv.DictReader(file)]


def stress(kind, points, unit, strain):
    """Of a strip, nominal [Pa]."""
    if kind == "radioss":
        return unit * interpolate(points, strain)
    if strain < 0:  # left out by CSE
        return 0.0
    return unit * interpolate(points, strain + 0.5 * strain**2) * (1 + strain)


def judge_threads(kind, case, folder, deck, unit):
    curves, threads, moduli, _ = deck
    if not threads:
        return ["no fabric by curves"]
    faults = []
    for name, thread, modulus in zip(("warp_curve", "weft_curve"), threads, moduli):
        points = case_curve(case["fabric"], folder, name, "strain")
        last = points[-1]
        steepest = max((b[1] - a[1]) / (b[0] - a[0]) for a, b in zip(points, points[1:]))
        if abs(modulus * unit / steepest - 1) > 1e-4:  # fields of ten columns hold five digits
            faults.append(f"{name}: modulus {modulus * unit:g} Pa, the steepest piece has {steepest:g}")
        worst = 0.0
        for i in range(-200, 1001):
            strain = last[0] * i / 1000
            expected = interpolate(points, strain) if strain > 0 else 0.0
            worst = max(worst, abs(stress(kind, curves[thread], unit, strain) - expected) / last[1])
        if worst > SHARE[kind]:
            faults.append(f"{name}: off by {worst:.3g} of the last stress, {SHARE[kind]:g} is allowed")
    return faults


def judge_pressure(case, folder, deck, unit, time):
    curves, _, _, pressure = deck
    if not pressure:
        return ["no pressure"]
    points = case_curve(case["membrane"], folder, "overpressure", "time")
    end, faults = case["scene"]["end_time"], []
    largest = max(abs(value) for _, value in points)
    for i in range(401):
        t = end * i / 400
        expected = points[0][1] if t < points[0][0] else points[-1][1] if t >= points[-1][0] else interpolate(points, t)
        found = pressure[1] * unit * interpolate(curves[pressure[0]], t / time)
        if abs(found - expected) > 1e-9 * largest:
            faults.append(f"pressure at {t:g} s: {found:g} Pa, the case has {expected:g}")
    return faults[:3]


def judge_curves(kind, path, folder, unit, time):
    """Faults of the deck in the folder; units of the deck in Pa and s."""
    with open(path, "rb") as file:
        case = tomllib.load(file)
    deck = deck_of(kind, os.path.join(folder, FILES[kind]))
    faults, beside = [], os.path.dirname(path)
    if case["fabric"].get("law") == "curve":
        faults += judge_threads(kind, case, beside, deck, unit)
    if "overpressure" in case["membrane"]:
        faults += judge_pressure(case, beside, deck, unit, time)
    return faults
