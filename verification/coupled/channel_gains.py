#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Judges the filtered accelerations of a run by the gain of SAE J211-1's filter, of a run whose acceleration is a sine.

usage: channel_gains.py FOLDER FREQUENCY
The gain at f is 1/(1 + (f/f_c)^4) with f_c = 2.0775 CFC, where the bilinear transform at 100 kHz bends the axis:
tan(pi f T) for f. At CFC/0.6 it is -3 dB.
"""
import csv
import math
import sys

INTERVAL = 1e-5  # [s]


def table(path):
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def main():
    folder, frequency = sys.argv[1], float(sys.argv[2])
    history, filtered = table(f"{folder}/history.csv"), table(f"{folder}/accelerations.csv")
    if filtered["time_s"] != history["time_s"]:
        sys.exit("the rows are at other times than those of the history")
    middle = slice(len(history["time_s"]) // 4, 3 * len(history["time_s"]) // 4)  # the ends have died away there
    size = max(map(abs, history["pendulum_cg_tangential_m_s2"][middle]))
    faults = 0
    for channel_class in (60, 180, 600, 1000):
        bent = math.tan(math.pi * frequency * INTERVAL) / math.tan(math.pi * 2.0775 * channel_class * INTERVAL)
        expected = 1 / (1 + bent**4)
        gain = max(filtered[f"pendulum_cg_acceleration_cfc{channel_class}_m_s2"][middle]) / size
        print(f"CFC {channel_class}: gain {gain:.6g}, {expected:.6g} expected")
        # Samples miss a peak by (pi f T)^2/2 at most: 5e-4 of both.
        faults += abs(gain / expected - 1) > 1e-3
        if frequency == channel_class / 0.6:
            faults += abs(gain - math.sqrt(0.5)) > 1e-3
    print("gains differ" if faults else "gains agree")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
