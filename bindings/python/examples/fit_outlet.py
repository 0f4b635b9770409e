# SPDX-License-Identifier: Apache-2.0
"""Finds the outlet's short side and the friction of the pendulum test from an angle curve, with SciPy.

usage: fit_outlet.py CASE HISTORY.csv      time_s and pendulum_angle_rad of HISTORY.csv are what is fitted
"""
import sys

import numpy as np
from scipy.optimize import least_squares

import gasjet

case, measured = sys.argv[1:3]
rows = [line for line in open(measured, encoding="utf-8") if not line.startswith("#")]
data = np.genfromtxt(rows, delimiter=",", names=True)
start = np.array([0.07, 0.2])  # short side [m], friction [-]


def angles(parameters):
    """Angle at the measured times. The scene is chaotic: the mean of two runs moves less than one."""
    short_side, friction = parameters * start
    histories = [
        gasjet.run(case, set={
            "inflator.0.jet.short_side": short_side,
            "contact.friction": friction,
            "membrane.perturbation": 1e-4,
            "membrane.perturbation_seed": seed,
            "output.frames": 0,
        }).history
        for seed in range(1, 3)
    ]
    return np.mean([np.interp(data["time_s"], h["time_s"], h["pendulum_angle_rad"]) for h in histories], axis=0)


# Differences of 5 %: smaller ones would measure the scatter.
fit = least_squares(lambda p: angles(p) - data["pendulum_angle_rad"], [1.0, 1.0], diff_step=0.05, bounds=(0.4, 2.0),
                    xtol=1e-2, ftol=1e-3)
short_side, friction = fit.x * start
worst = np.abs(fit.fun).max() / data["pendulum_angle_rad"].max()
print("short side %.4f m, friction %.3f after %d runs" % (short_side, friction, 2 * (fit.nfev + 2 * (fit.njev or 0))))
singular = np.linalg.svd(fit.jac, compute_uv=False)
print("one combination of the two is fixed %.0f times as well as the other" % (singular[0] / singular[1]))
print("worst distance %.1e of the largest angle" % worst)
