# SPDX-License-Identifier: Apache-2.0
"""A guided disc meets a bag of one's own: fabric, gas, contact and rail are Gasjet's, the loop is not. Judged by its energy at two
steps; a picture where matplotlib is installed.

usage: own_impactor.py SPHERE.obj     a closed surface around the origin, seen from outside against the clock
"""
import sys

import numpy as np

import gasjet

P_AIR, OVERPRESSURE, END = 101325.0, 15e3, 0.04  # Pa, Pa, s
DISC = dict(radius=0.09, rim_radius=0.03)
THICKNESS, MODULUS, POISSON = 4e-4, 3e8, 0.3


def read(path):
    """Nodes [m] and triangles of an OBJ file."""
    with open(path, encoding="utf-8") as file:
        rows = [line.split() for line in file if line[:2] in ("v ", "f ")]
    return (np.array([row[1:4] for row in rows if row[0] == "v"], float),
            np.array([[corner.split("/")[0] for corner in row[1:4]] for row in rows if row[0] == "f"], int) - 1)


def impact(reference, triangles, steps):
    """Time [s], what the disc does, and the energies [J], at every step."""
    radius = np.linalg.norm(reference, axis=1).mean()
    below = np.flatnonzero(reference[:, 2] < -0.8 * radius)  # glued to a table
    fabric = gasjet.Membrane(reference, triangles, thickness=THICKNESS, density=800.0, young_modulus=MODULUS, poisson=POISSON,
                             fixed_nodes=below)
    mass = fabric.masses[:, None]
    # A sphere of fabric carries its pressure at this strain, p r (1 - nu) / (2 h E).
    x = (1.0 + OVERPRESSURE * radius * (1.0 - POISSON) / (2.0 * THICKNESS * MODULUS)) * reference
    v = np.zeros_like(x)
    body = gasjet.RigidBody((0.0, 0.0, x[:, 2].max() + DISC["rim_radius"] + 0.002), mass=6.0, rail=(0, 0, -1), velocity=(0, 0, -6.0))
    pad = gasjet.Contact(reference, triangles, masses=mass[:, 0], effective_mass=body.effective_mass(gasjet.Contact.reach(**DISC)),
                         stiffness=2e7, **DISC)
    skin = fabric.evaluate(x)
    tank = gasjet.Tank(gasjet.Gas("N2=1"), P_AIR + OVERPRESSURE, 300.0, skin["volume_m3"])
    dt, before, rows = END / steps, 0.0, []
    for n in range(steps + 1):
        gas = tank.state
        skin = fabric.evaluate(x, gas["gamma"], gas["pressure_Pa"])
        touch = pad.evaluate(x, body.centre, axes=body.axes)
        if dt > 2.0 / np.sqrt(4.0 / skin["critical_step_s"] ** 2 + touch["frequency_1_s2"] + body.frequency()):
            sys.exit(f"a step of {dt:g} s is unstable at {n * dt:g} s")
        force = skin["force_N"] + (gas["pressure_Pa"] - P_AIR) * skin["gradient_m2"] + touch["node_force_N"]
        after = v + 0.5 * (before + dt) * force / mass
        after[below] = 0.0
        way = body.state["displacement_m"]
        kick = body.advance(dt, touch["force_N"])
        fabric_kinetic = 0.5 * (mass * v * after).sum()
        rows.append((n * dt, way, -kick["velocity_m_s"][2], touch["force_N"][2],
                     gas["pressure_Pa"] - P_AIR, kick["kinetic_energy_J"], skin["strain_energy_J"] + fabric_kinetic + touch["energy_J"],
                     P_AIR * skin["volume_m3"] - tank.balance["work_J"]))
        v, before = after, dt
        x = x + dt * v
        tank.advance((n + 1) * dt, fabric.evaluate(x)["volume_m3"])
    return np.array(rows).T


nodes, elements = read(sys.argv[1])
drift = []
for steps in (1000, 2000):
    time, way, speed, push, pressure, disc, skin, gas = impact(nodes, elements, steps)
    total = disc + skin + gas - gas[0]
    drift.append(np.abs(total - total[0]).max() / total[0])
    print(f"step {END / steps:g} s: {way.max():.4f} m, {push.max():.0f} N, at the end {-speed[-1]:.3f} m/s back, energy off by {drift[-1]:.1e}")
print(f"half the step, {drift[0] / drift[1]:.1f} times less; head injury criterion {gasjet.head_injury_criterion(time, push / 6.0):.1f}")

try:
    import matplotlib.pyplot as plot
except ImportError:
    print("no picture: matplotlib is not installed")
else:
    time, way, push, pressure, disc, skin, gas = (column[::10] for column in (time, way, push, pressure, disc, skin, gas))
    figure, (left, right) = plot.subplots(1, 2, layout="constrained")
    left.plot(1e3 * way, push / 1e3, "0.3", label="force on the disc")
    left.plot(1e3 * way, pressure * np.pi * 0.09**2 / 1e3, "--", label="overpressure times its flat face")
    left.set(xlabel="Displacement of the disc [mm]", ylabel="Force [kN]")
    right.stackplot(1e3 * time, disc, skin - skin[0], gas - gas[0], labels=("disc", "fabric", "gas"), alpha=0.7)
    right.set(xlabel="Time [ms]", ylabel="Energy [J]")
    left.legend(loc="upper left")
    right.legend(loc="upper right")
    figure.savefig("own_impactor.svg")
