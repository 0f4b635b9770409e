# SPDX-License-Identifier: Apache-2.0
"""The sealed pillow at rest under two laws: Gasjet's, and the one that LAW19 has for fabric.

usage: pillow_at_rest.py GASJET [POISSON_RATIO]    needs python3-numpy; takes some minutes

Gasjet runs the pillow to rest. Its shape, gas mass and pressure are the start of a second solution, which is this script's own: dynamic
relaxation of the same mesh, with the pressure on the adiabat through that state. It must stay there under Gasjet's law; that is the check. Then
it comes to rest under
- relaxed: Cauchy stress linear in logarithmic strain, without the second-order term of Gasjet's law, no stress across wrinkles;
- cut: the same in the plane, each compressive principal stress cut to 1e-3 as RCOMP of LAW19, the tensile one as it was.
Prints the volume of each over that of Gasjet, less 1, and the largest force that is left [N].
"""
import csv
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
YOUNG, THICKNESS, DENSITY, AMBIENT, GAMMA = 60e6, 0.5e-3, 620.0, 101325.0, 1.4
CUT = 1e-3


def read_obj(path):
    nodes, triangles = [], []
    for line in open(path):
        words = line.split()
        if words and words[0] == "v":
            nodes.append([float(word) for word in words[1:4]])
        if words and words[0] == "f":
            triangles.append([int(word) - 1 for word in words[1:4]])
    return np.array(nodes), np.array(triangles)


def kirchhoff(law, nu, e1, e2):
    """Principal Kirchhoff stresses of the principal logarithmic strains e1 >= e2."""
    plane, shear = YOUNG / (1 - nu), YOUNG / (1 + nu)
    m, r = (e1 + e2) / 2, (e1 - e2) / 2
    if law == "cut":
        stresses = (plane * m + shear * r, plane * m - shear * r)
        return [np.where(s < 0, CUT * s, s) * np.exp(e1 + e2) for s in stresses]
    if law == "gasjet":
        narrow = (1 - np.sqrt(1 - (1 - nu * nu) * np.maximum(e1, 0))) / (1 - nu)
        square = 1.0
    else:
        narrow, square = np.maximum(e1, 0) * (1 + nu) / 2, 0.0
    wrinkled = r > narrow
    m, r = np.where(wrinkled, e1 - narrow, m), np.where(wrinkled, narrow, r)
    middle, j = plane * m + square * shear * r * r, np.exp(2 * m)
    return np.where(e1 > 0, j * (middle + shear * r), 0), np.where((e1 > 0) & ~wrinkled, j * (middle - shear * r), 0)


class Pillow:
    def __init__(self, sewn, triangles, nu, gauge_of):
        self.triangles, self.nu, self.gauge_of = triangles, nu, gauge_of
        a, b, c = (sewn[triangles[:, k]] for k in range(3))
        ab, ac = b - a, c - a
        normal = np.cross(ab, ac)
        length, twice = np.linalg.norm(ab, axis=1), np.linalg.norm(normal, axis=1)
        first = ab / length[:, None]
        second = np.cross(normal, ab)
        second /= np.linalg.norm(second, axis=1)[:, None]
        c1, c2 = (ac * first).sum(1), (ac * second).sum(1)
        self.b1, self.b2, self.c2 = 1 / length, -c1 / (length * c2), 1 / c2
        self.volume = THICKNESS * twice / 2
        self.mass = np.bincount(triangles.ravel(), np.repeat(DENSITY * self.volume / 3, 3))
        self.step = 0.06 * np.sqrt(2 * twice.min() * DENSITY * (1 - nu) / YOUNG)

    def forces(self, x, law):
        corners = [x[self.triangles[:, k]] for k in range(3)]
        ab, ac = corners[1] - corners[0], corners[2] - corners[0]
        f1, f2 = ab * self.b1[:, None], ab * self.b2[:, None] + ac * self.c2[:, None]
        c11, c22, c12 = (f1 * f1).sum(1), (f2 * f2).sum(1), (f1 * f2).sum(1)
        mean, half = (c11 + c22) / 2, (c11 - c22) / 2
        radius = np.maximum(np.hypot(half, c12), 1e-300)
        square_1, square_2 = mean + radius, np.maximum(mean - radius, 1e-3)
        t1, t2 = kirchhoff(law, self.nu, np.log(square_1) / 2, np.log(square_2) / 2)
        s1, s2 = t1 / square_1, t2 / square_2
        middle, spread = (s1 + s2) / 2, (s1 - s2) / 2 / radius
        s11, s22, s12 = ((middle + spread * half)[:, None], (middle - spread * half)[:, None], (spread * c12)[:, None])
        n1, n2 = f1 * s11 + f2 * s12, f1 * s12 + f2 * s22
        on_b = -self.volume[:, None] * (n1 * self.b1[:, None] + n2 * self.b2[:, None])
        on_c = -self.volume[:, None] * n2 * self.c2[:, None]
        areas = np.cross(ab, ac) / 2
        volume = (corners[0] * areas).sum() / 3
        pressure = self.gauge_of(volume) * areas / 3
        parts = (pressure - on_b - on_c, pressure + on_b, pressure + on_c)
        force = np.zeros_like(x)
        for k in range(3):
            for part, corner in zip(parts, self.triangles.T):
                force[:, k] += np.bincount(corner, part[:, k], len(x))
        return force, volume

    def relax(self, x, law, steps=4000, kept=0.97):
        velocity = np.zeros_like(x)
        for _ in range(steps):
            force, volume = self.forces(x, law)
            velocity = kept * (velocity + self.step * force / self.mass[:, None])
            x = x + self.step * velocity
        return volume, np.abs(force).max()


def main():
    gasjet, nu = sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 0.3
    case = HERE / "pillow.toml"
    settings = [f"fabric.poisson_ratio={nu}", "membrane.mass_damping=400", "scene.end_time=0.3", "output.history_every=1e-3", "output.fields_every=0.3"]
    options = [word for setting in settings for word in ("--set", setting)]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        quiet = {"stdout": subprocess.DEVNULL, "check": True}
        subprocess.run([gasjet, "run", case, *options, "--quiet", "--out", folder / "run"], **quiet)
        subprocess.run([gasjet, "mesh", "case", case, "--out", folder / "sewn.obj"], **quiet)
        subprocess.run([gasjet, "mesh", "state", folder / "run", "--time", "0.3", "--out", folder / "rest.obj"], **quiet)
        with open(folder / "run" / "history.csv") as file:
            end = list(csv.DictReader(line for line in file if not line.startswith("#")))[-1]
        sewn, triangles = read_obj(folder / "sewn.obj")
        rest, _ = read_obj(folder / "rest.obj")
    pressure, at_rest = float(end["pressure_Pa"]), float(end["volume_m3"])
    print(f"gasjet: {at_rest:.9g} m3 at {pressure:.9g} Pa, {float(end['gas_mass_kg']):.6g} kg")
    pillow = Pillow(sewn, triangles, nu, lambda volume: pressure * (at_rest / volume)**GAMMA - AMBIENT)
    for law in ("gasjet", "relaxed", "cut"):
        volume, left = pillow.relax(rest, law)
        print(f"{law}: {volume / at_rest - 1:.3e}, {left:.1e} N", flush=True)


if __name__ == "__main__":
    main()
