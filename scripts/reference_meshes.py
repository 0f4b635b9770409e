# SPDX-License-Identifier: Apache-2.0
"""Meshes of the reference scenes as OBJ files, for reference_set.py. Normals point outwards."""
import math


class Mesh:
    """An OBJ file; a point that comes again is the same node."""

    def __init__(self, title):
        self.lines, self.nodes = [f"# {title}, by scripts/reference_set.py"], {}

    def node(self, *point):
        text = " ".join(f"{value:.9g}" for value in point)
        if text not in self.nodes:
            self.nodes[text] = len(self.nodes) + 1
            self.lines.append(f"v {text}")
        return self.nodes[text]

    def write(self, path, **parts):
        for name, faces in parts.items():
            self.lines += [f"g {name}", *(f"f {a} {b} {c}" for a, b, c in faces)]
        path.write_text("\n".join(self.lines) + "\n", encoding="utf-8")


def disc(path, rings):
    """Radius 0.3 in z = 0, over a cone with its apex 3 m below. Normals point outwards."""
    mesh, faces = Mesh(f"disc, cells = {rings}"), []

    def ring(k, i):
        angle, radius = 8 * math.atan2(1, 1) * (i % (6 * k)) / (6 * k), 0.3 * k / rings
        return mesh.node(radius * math.cos(angle), radius * math.sin(angle), 0)
    for k in range(1, rings + 1):
        for s in range(6):
            for j in range(k):
                inner = mesh.node(0, 0, 0) if k == 1 else ring(k - 1, s * (k - 1) + j)
                faces.append((inner, ring(k, s * k + j), ring(k, s * k + j + 1)))
                if j < k - 1:
                    faces.append((inner, ring(k, s * k + j + 1), ring(k - 1, s * (k - 1) + j + 1)))
    cone = [(mesh.node(0, 0, -3), ring(rings, i + 1), ring(rings, i)) for i in range(6 * rings)]
    mesh.write(path, membrane=faces, cone=cone)


def baffle(path, cells):
    """Box of 1 x 1.2 x 1.2 m with so many cells a metre (a multiple of 10), less a slab from the floor up to z = 0 one cell thick at
    x = 0.5. Normals point outwards."""
    mesh, faces, width = Mesh(f"baffle, cells = {cells}"), [], round(1.2 * cells)

    def has_gas(i, j, k):
        return 0 <= i < cells and 0 <= j < width and 0 <= k < width and not (i == cells / 2 and k < width / 2)

    def face(cell, axis, direction):
        """Towards the neighbour: the corners in the order whose normal points that way, cut by a diagonal."""
        corner = list(cell)
        corner[axis] += direction > 0
        around = []
        for b, c in ((0, 0), (1, 0), (1, 1), (0, 1)):
            at = list(corner)
            at[(axis + 1) % 3] += b
            at[(axis + 2) % 3] += c
            around.append(mesh.node(at[0] / cells, (at[1] - width / 2) / cells, (at[2] - width / 2) / cells))
        p, q, r, s = around if direction > 0 else (around[0], around[3], around[2], around[1])
        faces.extend([(p, q, r), (p, r, s)])
    for i in range(cells):
        for j in range(width):
            for k in range(width):
                for direction in (-1, 1) if has_gas(i, j, k) else ():
                    for axis in range(3):
                        beside = [i, j, k]
                        beside[axis] += direction
                        if not has_gas(*beside):
                            face((i, j, k), axis, direction)
    mesh.write(path, box=faces)
