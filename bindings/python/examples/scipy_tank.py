# SPDX-License-Identifier: Apache-2.0
"""A heated tank by scipy and by libgas: the same equations, two integrators."""
import sys

import numpy as np

import gasjet

try:
    from scipy.integrate import solve_ivp
except ImportError:
    sys.exit("SKIPPED: scipy is not installed (package python3-scipy)")

R, CP, VOLUME = 296.8, 1038.8, 0.06


def rates(_, state):
    """Mass and internal energy of a tank with an inflow of 1 kg/s at 700 K and a hole."""
    mass, energy = state
    temperature = energy / (mass * (CP - R))
    out = gasjet.orifice(1e-3, mass * R * temperature / VOLUME, temperature, R, CP, 101325.0)
    return [1.0 - out, CP * 700.0 - out * CP * temperature]


start = [101325.0 * VOLUME / (R * 293.15), 101325.0 * VOLUME * (CP / R - 1.0)]
times = np.linspace(0.0, 0.1, 11)
by_scipy = solve_ivp(rates, (0.0, 0.1), start, method="DOP853", t_eval=times, rtol=1e-11, atol=1e-14)
gas = gasjet.Gas.ideal(R, CP)
tank = gasjet.Tank(gas, 101325.0, 293.15, VOLUME)
tank.add_vent(1e-3)
tank.add_inflow(gas, [0.0, 1.0], [1.0, 1.0], [700.0, 700.0])
mass = [start[0]] + [tank.advance(time)["gas_mass_kg"] for time in times[1:]]
off = np.abs(by_scipy.y[0] / mass - 1.0).max()
print(f"mass at 0.1 s: {mass[-1]:.6f} kg; scipy and libgas differ by {off:.1e}")
if off > 1e-7:
    sys.exit("they differ")
