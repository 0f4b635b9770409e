# SPDX-License-Identifier: Apache-2.0
"""Velocity of a plane jet over its outlet's, in the plane across the slot; a picture where matplotlib is installed."""
import numpy as np

import gasjet

jet = gasjet.Jet((0, 0, 0), (1, 0, 0), short_side=0.02, long_side=0.2, long_direction=(0, 1, 0), decay_coefficient=0.108)
x, z = np.meshgrid(np.linspace(0.005, 0.6, 120), np.linspace(-0.15, 0.15, 61), indexing="ij")
speed = np.linalg.norm(jet.velocity(np.column_stack([x.ravel(), 0 * x.ravel(), z.ravel()])), axis=1).reshape(x.shape)
for column in (0, 20, 60, 119):
    line = speed[column]
    flux = np.trapz(line**2, z[column]) / 0.02  # of momentum, over that of the outlet
    print(f"x = {x[column, 0]:.3f} m: V_max/V0 = {line.max():.3f}, momentum flux {flux:.4f}")
try:
    import matplotlib.pyplot as plot
except ImportError:
    print("no picture: matplotlib is not installed")
else:
    plot.contourf(x, z, speed, 20)
    plot.colorbar(label="V / V0"), plot.xlabel("x [m]"), plot.ylabel("z [m]"), plot.savefig("jet_map.png", bbox_inches="tight")
