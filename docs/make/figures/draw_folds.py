#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws docs/figures/folds.svg: a flat bag of two sheets in cross section, folded in the three ways by `gasjet mesh fold`.
The gap is larger than a real one, so that layers can be told apart. GASJET names another binary than build/gasjet.

usage: docs/make/figures/draw_folds.py"""
import os
import pathlib
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
CELLS, LENGTH, GAP = 200, 0.4, 4e-3  # cells along the bag; metres
BLUE, VERMILION, INK, QUIET = "#0072b2", "#d55e00", "#222222", "#767676"
FOLDS = [("letter", "-0.0705,0.0905"), ("accordion", "-0.0605,-0.1405"), ("roll", "-0.0605,-0.1405")]


def pillow(file):
    """Two sheets of CELLS x 4 cells, sewn at the rim. Returns the nodes along the middle, once round."""
    number, nodes, faces = {}, [], []

    def node(sheet, i, j):
        key = (0 if i in (0, CELLS) or j in (0, 4) else sheet, i, j)
        if key not in number:
            nodes.append((0, 0.01 * (j - 2), LENGTH * (i / CELLS - 0.5)))
            number[key] = len(nodes)
        return number[key]

    for sheet in (-1, 1):
        for i in range(CELLS):
            for j in range(4):
                a, b, c, d = (node(sheet, i + k, j + m) for k, m in ((0, 0), (1, 0), (1, 1), (0, 1)))
                # Diagonals run into the corners, where else they would join two seams.
                halves = [(a, b, c), (a, c, d)] if (i < CELLS / 2) == (j < 2) else [(a, b, d), (b, c, d)]
                group = "fixed" if sheet < 0 and abs(i - CELLS / 2) < 6 and j in (1, 2) else "skin"
                faces += [(group, half if sheet < 0 else half[::-1]) for half in halves]
    with open(file, "w", encoding="utf-8") as out:
        out.writelines(f"v {x} {y} {z}\n" for x, y, z in nodes)
        for group, face in faces:
            out.write(f"g {group}\nf {face[0]} {face[1]} {face[2]}\n")
    return [number[(0 if i in (0, CELLS) else s, i, 2)] for s in (-1, 1) for i in (range(CELLS + 1) if s < 0 else range(CELLS, -1, -1))]


def section(folder, how, at):
    around = pillow(folder / "bag.obj")
    gasjet = os.environ.get("GASJET", ROOT / "build/gasjet")
    subprocess.run([gasjet, "mesh", "fold", folder / "bag.obj", "--fixed", "fixed", "--press", f"--{how}", "--axis", "z", "--at", at,
                    "--gap", str(GAP), "--out", folder / "folded.obj"], check=True, stdout=subprocess.DEVNULL)
    nodes = [line.split()[1:] for line in (folder / "folded.obj").read_text().splitlines() if line.startswith("v ")]
    return [(float(nodes[n - 1][2]), float(nodes[n - 1][0])) for n in around]


def polyline(points, place, colour, width):
    steps = " ".join("{:.1f},{:.1f}".format(*place(*point)) for point in points)
    return f'<polyline points="{steps}" fill="none" stroke="{colour}" stroke-width="{width}" stroke-linejoin="round"/>'


def main():
    parts = []
    with tempfile.TemporaryDirectory() as name:
        for row, (how, at) in enumerate(FOLDS):
            base = 90 + 100 * row

            def place(along, height, base=base):
                return 420 + 1500 * along, base - 1500 * height

            points = section(pathlib.Path(name), how, at)
            parts.append(polyline([(-0.2, -0.002), (0.2, -0.002)], place, QUIET, 3))
            parts.append(polyline(points, place, BLUE, 1.6))
            parts.append(polyline([(-0.012, 0.0), (0.012, 0.0)], place, VERMILION, 4))
            parts.append(f'<text x="24" y="{base}" font-size="15" fill="{INK}">{how}</text>')
    parts.append(f'<text x="24" y="340" font-size="13" fill="{QUIET}">grey: plate; orange: attachment. The gap is {1e3 * GAP:.0f} mm here.</text>')
    svg = ('<svg xmlns="http://www.w3.org/2000/svg" width="840" height="360" viewBox="0 0 840 360" font-family="sans-serif">\n'
           '<rect width="100%" height="100%" fill="#ffffff"/>\n' + "\n".join(parts) + "\n</svg>\n")
    (ROOT / "docs/figures/folds.svg").write_text(svg, encoding="utf-8")
    print("docs/figures/folds.svg")


main()
