#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws docs/figures/unfolding.svg: the cut through the middle of the bag of passenger_letter.toml at six times, from the frames of a
run (some 40 s). GASJET names another binary than build/gasjet. Needs matplotlib.

usage: docs/make/figures/draw_unfolding.py [RUN]    RUN: results of that case with frames each millisecond, which is then not run"""
import csv
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import matplotlib
import matplotlib.pyplot as plot
import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[3]
CASE = ROOT / "cases/passenger_letter.toml"
TIMES = (0, 2, 5, 10, 15, 30)  # [ms]
VIEWS = ((-0.015, 0.195, -0.13, 0.13), (-0.05, 0.58, -0.39, 0.39))  # [m] x and z of the rows: the upper one is three times as large
FOLDS = (-0.12, 0.12)  # [m] of the case
CUT = 1e-4  # [m] beside y = 0, where nodes may lie
PARTS = [("lower flap", "#009e73"), ("middle", "#0072b2"), ("upper flap", "#aa4499"), ("attachment", "#d55e00")]
INK, QUIET = "#222222", "#767676"


def gasjet(*arguments):
    subprocess.run([os.environ.get("GASJET", ROOT / "build/gasjet"), *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def read_frames(path):
    """What does not change; the numbers of each frame, and its nodes (n, 3) [m]."""
    with open(path, "rb") as file:
        head = json.loads(file.readline())
        parts = [("scalars", "<f8", len(head["scalars"])), ("nodes", "<u2", (head["nodes"], 3))]
        parts.append(("rest", "u1", head["frame_bytes"] - np.dtype(parts).itemsize))
        frames = np.frombuffer(file.read(), np.dtype(parts))
    for frame in frames:
        number = dict(zip(head["scalars"], frame["scalars"]))
        origin = np.array([number["x_m"], number["y_m"], number["z_m"]])
        yield head, number, origin + number["position_step_m"] * frame["nodes"]


def parts_of(head, folder):
    """The number in PARTS of each element, by its place in the design shape."""
    gasjet("mesh", "case", CASE, "--out", folder / "design.obj")
    design = np.array([line.split()[1:] for line in (folder / "design.obj").read_text().splitlines() if line.startswith("v ")], float)
    middles = design[np.array(head["triangles"])].mean(1)
    parts = np.digitize(middles[:, 2], FOLDS)
    parts[np.array(head["panels"]) == head["panel_names"].index("attachment")] = 3
    return parts


def section(nodes, triangles, parts):
    """Lines (x, z) of the plane y = CUT through the elements, chained; [(part, points)]."""
    lines = {}  # side of the mesh: [(part, other side)], sides as pairs of nodes
    place = {}
    for corners, part in zip(triangles, parts):
        ends = []
        for a, b in ((0, 1), (1, 2), (2, 0)):
            i, j = sorted((corners[a], corners[b]))
            low, high = nodes[i][1] - CUT, nodes[j][1] - CUT
            if (low < 0) != (high < 0):
                place[i, j] = nodes[i] + (nodes[j] - nodes[i]) * low / (low - high)
                ends.append((i, j))
        if ends:
            lines.setdefault(ends[0], []).append((part, ends[1]))
            lines.setdefault(ends[1], []).append((part, ends[0]))
    chains = []
    while any(lines.values()):
        # A chain begins where another part ends, if there is such a side.
        start = min((side for side in lines if lines[side]), key=lambda side: len({part for part, _ in lines[side]}) == 1 and len(lines[side]) == 2)
        part, side = lines[start][0][0], start
        chain = [start]
        while following := [other for kind, other in lines[side] if kind == part]:
            lines[side].remove((part, following[0]))
            lines[following[0]].remove((part, side))
            side = following[0]
            chain.append(side)
        chains.append((part, [(place[side][0], place[side][2]) for side in chain]))
    return chains


def draw(run, folder, picture):
    matplotlib.rc_file(ROOT / "docs/examples/examples.mplstyle")
    with open(run / "history.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    history = {name: [float(row[name]) for row in rows] for name in ("time_s", "volume_m3")}
    frames = list(read_frames(run / "frames.bin"))
    head = frames[0][0]
    parts = parts_of(head, folder)
    figure, panels = plot.subplots(2, 3, figsize=(8.4, 6.6), layout="constrained")
    for axes, time, view in zip(panels.flat, TIMES, np.repeat(VIEWS, 3, axis=0)):
        _, number, nodes = min(frames, key=lambda frame: abs(1e3 * frame[1]["time_s"] - time))
        axes.axvspan(view[0], 0, color=QUIET, linewidth=0)
        impactor = (number["impactor_x_m"], number["impactor_z_m"])
        axes.add_patch(plot.Circle(impactor, head["pendulum"]["radius_m"], facecolor="#dddddd", edgecolor=INK, linewidth=0.8))
        for part, points in section(nodes, head["triangles"], parts):
            axes.plot(*zip(*points), color=PARTS[part][1], linewidth=2.5 if part == 3 else 1.1, solid_joinstyle="round", zorder=3)
        volume = 1e3 * np.interp(number["time_s"], history["time_s"], history["volume_m3"])
        axes.set_title(f"{1e3 * number['time_s']:.0f} ms, {volume:.1f} l", fontsize=10)
        axes.set(aspect="equal", xlim=view[:2], ylim=view[2:])
        axes.locator_params(nbins=5)
        axes.grid(False)
    for axes in panels[-1]:
        axes.set_xlabel("x [m]")
    for axes in panels[:, 0]:
        axes.set_ylabel("z [m]")
    for axes in panels[:, 1:].flat:
        axes.set_yticklabels([])
    names = [plot.Line2D([], [], color=colour, label=name) for name, colour in PARTS]
    figure.legend(handles=names, loc="lower center", ncols=4)
    figure.get_layout_engine().set(rect=(0, 0.05, 1, 0.95), h_pad=0.1)
    drawn = io.StringIO()
    figure.savefig(drawn, format="svg", metadata={"Date": None})
    picture.write_text(re.sub(r"(\.[0-9]{2})[0-9]+", r"\1", drawn.getvalue()), encoding="utf-8")
    print(picture.relative_to(ROOT) if picture.is_relative_to(ROOT) else picture)


def main():
    with tempfile.TemporaryDirectory() as name:
        run = pathlib.Path(sys.argv[1]) if sys.argv[1:] else pathlib.Path(name) / "run"
        if not sys.argv[1:]:
            end = TIMES[-1]
            gasjet("run", CASE, "--out", run, "--quiet", "--set", f"scene.end_time={end}e-3", "--set", f"output.frames={end}")
        draw(run, pathlib.Path(name), ROOT / "docs/figures/unfolding.svg")


main()
