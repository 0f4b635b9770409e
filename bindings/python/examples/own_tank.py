# SPDX-License-Identifier: Apache-2.0
"""A tank program of one's own, explicit Euler, judged by a closed form at two steps; a picture where matplotlib is installed."""
import numpy as np

import gasjet

R, CP, P_AIR = 296.8, 1038.8, 101325.0
VOLUME, AREA, END = 0.06, 1e-3, 0.3


def own_tank(step):
    """Pressure of nitrogen that leaves a tank through a hole, at every step."""
    mass, energy = 5e5 * VOLUME / (R * 600.0), 5e5 * VOLUME * (CP / R - 1.0)
    times, pressures = [0.0], [5e5]
    while times[-1] < END - step / 2:
        temperature = energy / (mass * (CP - R))
        flow = gasjet.orifice(AREA, pressures[-1], temperature, R, CP, P_AIR)
        mass -= step * flow
        energy -= step * flow * CP * temperature
        times.append(len(times) * step)
        pressures.append(energy / (CP / R - 1.0) / VOLUME)
    return {"time_s": times, "pressure_Pa": pressures}


times = np.linspace(0.0, END, 301)
exact = gasjet.exact("blowdown", times=times)["pressure_Pa"]
reference = {"time_s": times, "pressure_Pa": exact, "pressure_Pa_band": 2e-3 * exact}
runs = {step: own_tank(step) for step in (1e-3, 1e-4)}
for step, run in runs.items():
    judged = gasjet.compare(run, reference)["quantities"]["pressure_Pa"]
    print(f"step {step:g} s: {judged['verdict']}, off by {judged['max_error']['value']:.0f} Pa")

try:
    import matplotlib.pyplot as plot
except ImportError:
    print("no picture: matplotlib is not installed")
else:
    figure, (left, right) = plot.subplots(1, 2, layout="constrained")
    left.plot(1e3 * times, exact / 1e3, "0.7", linewidth=5, label="closed form")
    left.set(xlabel="Time [ms]", ylabel="Pressure [kPa]")
    right.fill_between(1e3 * times, -0.2, 0.2, color="0.8", label="band")
    for (step, run), style in zip(runs.items(), ("-", "--")):
        off = np.interp(times, run["time_s"], run["pressure_Pa"]) / exact - 1.0
        left.plot(1e3 * np.array(run["time_s"]), np.array(run["pressure_Pa"]) / 1e3, style)
        right.plot(1e3 * times, 100.0 * off, style, label=f"step {step:g} s")
    right.set(xlabel="Time [ms]", ylabel="Own tank off by [%]", ylim=(-0.7, 0.25))
    left.legend()
    right.legend(loc="lower left")
    figure.savefig("own_tank.svg")
