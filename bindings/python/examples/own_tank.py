# SPDX-License-Identifier: Apache-2.0
"""A tank program of one's own, explicit Euler, judged by a closed form at two steps."""
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
exact = gasjet.exact("blowdown", times=times)
reference = {"time_s": times, "pressure_Pa": exact["pressure_Pa"], "pressure_Pa_band": 2e-3 * exact["pressure_Pa"]}
for step in (1e-3, 1e-4):
    judged = gasjet.compare(own_tank(step), reference)["quantities"]["pressure_Pa"]
    print(f"step {step:g} s: {judged['verdict']}, off by {judged['max_error']['value']:.0f} Pa")
