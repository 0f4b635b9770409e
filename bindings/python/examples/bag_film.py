# SPDX-License-Identifier: Apache-2.0
"""Runs a case and makes a film of its bag, coloured by what the jet sees, with matplotlib.
usage: bag_film.py CASE.toml FILM.gif [FRAMES [END_TIME in s]]"""
import json
import sys
import tempfile

import matplotlib.animation
import matplotlib.pyplot as plot
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

import gasjet

COLOURS = np.array(["#dddddd", "#0072b2", "#f0c420"])  # outside the jet; in it, but hidden; lit


def read_frames(path):
    """What does not change, and for each frame its time, positions (n, 3) [m] and jet mask."""
    with open(path, "rb") as file:
        head = json.loads(file.readline())
        nodes, elements = head["nodes"], head["elements"]
        parts = [("scalars", "<f8", len(head["scalars"])), ("nodes", "<u2", (nodes, 3)), ("speeds", "<u2", nodes),
                 ("pressures", "<u2", elements), ("strains", "<u2", elements), ("mask", "u1", elements)]
        parts.append(("fill", "u1", head["frame_bytes"] - np.dtype(parts).itemsize))
        return head, np.frombuffer(file.read(), np.dtype(parts))


case, film, count = sys.argv[1], sys.argv[2], int((sys.argv[3:] or [40])[0])
end = {"scene.end_time": float(sys.argv[4])} if sys.argv[4:] else {}
with tempfile.TemporaryDirectory() as folder:
    gasjet.run(case, {"output.frames": count - 1, **end}, out=folder)
    head, frames = read_frames(folder + "/frames.bin")
number = {name: frames["scalars"][:, i] for i, name in enumerate(head["scalars"])}
origin = np.column_stack([number["x_m"], number["y_m"], number["z_m"]])
nodes = origin[:, None, :] + number["position_step_m"][:, None, None] * frames["nodes"]
triangles = np.array(head["triangles"])

low, high = nodes.min((0, 1)), nodes.max((0, 1))
figure = plot.figure(figsize=(4, 3.2), layout="constrained")
axes = figure.add_subplot(projection="3d", elev=20, azim=-60)
axes.set_box_aspect(high - low, zoom=1.35)
axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
axes.set_axis_off()
bag = axes.add_collection3d(Poly3DCollection(nodes[0][triangles], edgecolors="#555555", linewidths=0.15))


def draw(frame):
    bag.set_verts(nodes[frame][triangles])
    bag.set_facecolors(COLOURS[frames["mask"][frame]])
    axes.set_title(f"{1e3 * number['time_s'][frame]:.1f} ms, {number['overpressure_Pa'][frame] / 1e3:.1f} kPa", y=1.0)


matplotlib.animation.FuncAnimation(figure, draw, len(frames)).save(film, matplotlib.animation.PillowWriter(fps=10))
print(f"{film}: {len(frames)} frames to {1e3 * number['time_s'][-1]:.1f} ms; lit at the end: {np.sum(frames['mask'][-1] == 2)} of {len(triangles)}")
