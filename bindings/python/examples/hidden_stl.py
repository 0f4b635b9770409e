# SPDX-License-Identifier: Apache-2.0
"""Which triangles of an STL file does a point see?
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
source = [float(x) for x in sys.argv[2:8]]
lit = gasjet.visible(nodes, triangles, source[:3], source[3:])
print(f"{len(triangles)} triangles, {lit.sum()} seen from {source[:3]}")
