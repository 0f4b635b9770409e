#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A small foreign program for verification/run_external.py: a tank with one inflator or one vent, by Runge-Kutta steps of 0.1 ms. The
variable DEFECT makes it wrong in one way; the test expects each to be caught.
usage: foreign_tank.py SCENE.json HISTORY.csv"""
import json
import math
import os
import sys

DEFECT = os.environ.get("DEFECT", "")


class Tank:
    def __init__(self, settings, species):
        initial, ambient, self.volume = settings["gas"]["initial"], settings["ambient"], settings["tank"]["volume"]
        (name,) = initial["composition"]
        self.gas_constant, self.cp = species[name]["gas_constant_J_kg_K"], species[name]["constant_cp_J_kg_K"]
        self.cv = self.cp - self.gas_constant
        self.gamma = 1.39 if DEFECT == "gamma" else self.cp / self.cv
        self.ambient = 1e5 if DEFECT == "ambient" else ambient["pressure"]
        vent, inflator = ((settings.get(key) or [{}])[0] for key in ("vent", "inflator"))
        self.area = vent.get("area", 0.0) * vent.get("discharge_coefficient", 1.0) * (0.99 if DEFECT == "discharge" else 1)
        self.inflow = inflator.get("mass_flow", 0.0) * (0.999 if DEFECT == "inflow" else 1)
        self.inflow_temperature = inflator.get("temperature", 0.0)
        self.mass = initial["pressure"] * self.volume / (self.gas_constant * initial["temperature"])
        self.energy = self.mass * self.cv * initial["temperature"]

    def point(self, mass, energy):
        """Temperature and pressure."""
        temperature = energy / (mass * self.cv)
        return temperature, mass * self.gas_constant * temperature / self.volume

    def outflow(self, mass, energy):
        temperature, pressure = self.point(mass, energy)
        if self.area == 0 or pressure <= self.ambient:
            return 0.0
        g, ratio = self.gamma, self.ambient / pressure
        critical = (2 / (g + 1)) ** (g / (g - 1))
        if ratio < critical and DEFECT != "never_chokes":
            ratio = critical
        speed = math.sqrt(2 * g / (g - 1) * (ratio ** (2 / g) - ratio ** ((g + 1) / g)))
        return self.area * pressure / math.sqrt(self.gas_constant * temperature) * speed

    def rates(self, mass, energy):
        out, temperature = self.outflow(mass, energy), self.point(mass, energy)[0]
        into = self.inflow * (self.cv if DEFECT == "energy_in" else self.cp) * self.inflow_temperature
        return self.inflow - out, into - out * (self.cv if DEFECT == "energy_out" else self.cp) * temperature

    def step(self, h):
        state = self.mass, self.energy
        at = lambda share, slope: self.rates(*(x + share * h * k for x, k in zip(state, slope)))
        slopes = [self.rates(*state)]
        for share in (0.5, 0.5, 1.0):
            slopes.append(at(share, slopes[-1]))
        weights = (1, 0, 0, 0) if DEFECT == "euler" else (1 / 6, 1 / 3, 1 / 3, 1 / 6)
        self.mass, self.energy = (x + h * sum(w * k for w, k in zip(weights, ks)) for x, ks in zip(state, zip(*slopes)))

    def row(self, time):
        temperature, pressure = self.point(self.mass, self.energy)
        wrong = {"gauge": pressure - self.ambient, "kilopascal": pressure / 1000}
        row = {"time_s": time + (1e-3 if DEFECT == "late" else 0), "pressure_Pa": wrong.get(DEFECT, pressure),
               "temperature_K": temperature - (273.15 if DEFECT == "celsius" else 0), "volume_m3": self.volume, "gas_mass_kg": self.mass,
               "inflow_kg_s": self.inflow, "vent_outflow_kg_s": self.outflow(self.mass, self.energy)}
        if DEFECT == "nan" and time > 0.05:
            row["pressure_Pa"] = math.nan
        if DEFECT == "no_volume":
            del row["volume_m3"]
        return row


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        text = file.read()
    if '"tank"' not in text or any(f'"{other}"' in text for other in ("fabric", "file", "amplitude", "nasa7")):
        sys.exit(77)
    if DEFECT == "crash":
        sys.exit(3)
    scene = json.loads(text)
    tank, times = Tank(scene["settings"], scene["species"]), scene["times"]
    if DEFECT == "stops":
        times = times[:len(times) // 2]
    rows = [tank.row(times[0])]
    for i, (before, now) in enumerate(zip(times, times[1:]), 1):
        steps = math.ceil((now - before) / (1e-3 if DEFECT == "euler" else 1e-4) - 1e-6)
        for _ in range(steps):
            tank.step((now - before) / steps)
        if DEFECT != "sparse" or i % 20 == 0 or now == times[-1]:
            rows.append(tank.row(now))
    with open(sys.argv[2], "w", encoding="ascii") as file:
        print(*rows[0], sep=",", file=file)
        for row in rows:
            print(*(f"{value:.12g}" for value in row.values()), sep=",", file=file)


if __name__ == "__main__":
    main()
