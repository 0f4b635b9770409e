# SPDX-License-Identifier: Apache-2.0
"""A heated tank by scipy and by libgas: the same equations, two integrators; a picture where matplotlib is installed."""
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
times = np.linspace(0.0, 0.1, 51)
gas = gasjet.Gas.ideal(R, CP)
tank = gasjet.Tank(gas, 101325.0, 293.15, VOLUME)
tank.add_vent(1e-3)
tank.add_inflow(gas, [0.0, 1.0], [1.0, 1.0], [700.0, 700.0])
mass = np.array([start[0]] + [tank.advance(time)["gas_mass_kg"] for time in times[1:]])
by_scipy = {}
for tolerance in (1e-3, 1e-6, 1e-11):
    by_scipy[tolerance] = solve_ivp(rates, (0.0, 0.1), start, method="DOP853", t_eval=times, rtol=tolerance, atol=1e-14).y[0]
    off = np.abs(by_scipy[tolerance] / mass - 1.0).max()
    print(f"scipy at rtol {tolerance:g} and libgas differ by {off:.1e}")
print(f"mass at 0.1 s: {mass[-1]:.6f} kg")
if off > 1e-7:
    sys.exit("they differ")

try:
    import matplotlib.pyplot as plot
except ImportError:
    print("no picture: matplotlib is not installed")
else:
    figure, (left, right) = plot.subplots(1, 2, layout="constrained")
    left.plot(1e3 * times, 1e3 * mass, label="libgas")
    left.plot(1e3 * times[::5], 1e3 * by_scipy[1e-11][::5], "o", mfc="none", label="scipy")
    left.set(xlabel="Time [ms]", ylabel="Mass of gas [g]")
    for (tolerance, values), style in zip(by_scipy.items(), ("-", "--", ":")):
        right.semilogy(1e3 * times[1:], np.abs(values / mass - 1.0)[1:], style, label=f"rtol {tolerance:g}")
    right.set(xlabel="Time [ms]", ylabel="Difference of the masses")
    left.legend()
    right.legend()
    figure.savefig("scipy_tank.svg")
