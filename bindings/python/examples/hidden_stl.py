# SPDX-License-Identifier: Apache-2.0
"""Which triangles of an STL file does a point see? A picture where matplotlib is installed.
usage: hidden_stl.py FILE.stl X Y Z AX AY AZ       centre and axis of the source, in the file's unit"""
import struct
import sys

import numpy as np

import gasjet


def read_stl(path):
    """Nodes and triangles of an ASCII or binary STL file; equal corners become one node."""
    data = open(path, "rb").read()
    count = struct.unpack("<I", data[80:84])[0] if len(data) >= 84 else -1
    if len(data) == 84 + 50 * count:
        records = np.frombuffer(data[84:], np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("tag", "<u2")]))
        corners = records["corners"].astype(float).reshape(-1, 3)
    else:
        lines = data.decode().split("\n")
        corners = np.array([line.split()[1:4] for line in lines if line.strip().startswith("vertex")], float)
    nodes, numbers = np.unique(corners, axis=0, return_inverse=True)
    return nodes, numbers.reshape(-1, 3)


nodes, triangles = read_stl(sys.argv[1])
source = np.array(sys.argv[2:8], float)
lit = gasjet.visible(nodes, triangles, source[:3], source[3:])
print(f"{len(triangles)} triangles, {lit.sum()} seen from {source[:3].tolist()}")

try:
    import matplotlib.pyplot as plot
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection
except ImportError:
    print("no picture: matplotlib is not installed")
else:
    corners = nodes[triangles]
    inner = np.einsum("ij,ij->i", np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), corners[:, 0] - source[:3]) > 0
    colours = np.where(lit, "#f0c420", np.where(inner, "#0072b2", "#bbbbbb"))  # seen, hidden, seen from outside
    axes = plot.figure(figsize=(8, 8)).add_subplot(projection="3d", box_aspect=np.ptp(nodes, axis=0), elev=25, azim=-50)
    axes.add_collection3d(Poly3DCollection(corners, facecolors=colours, edgecolors="#555555", linewidths=0.2))
    axes.scatter(*source[:3], color="#d55e00", s=40, depthshade=False, zorder=1e6)
    axes.set(**{f"{name}lim": (low, high) for name, low, high in zip("xyz", nodes.min(0), nodes.max(0))})
    axes.set_axis_off()
    plot.savefig("hidden_stl.png", bbox_inches="tight", dpi=100)
