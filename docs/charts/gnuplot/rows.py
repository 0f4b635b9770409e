#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Rows of a table as a chart draws them, comma-separated on standard output: below, a function a kind of chart.
usage: docs/charts/gnuplot/rows.py KIND TABLE.csv ARGUMENT..."""
import csv
import math
import re
import sys

DEGREES = 180 / math.pi


def read(path):
    with open(path, encoding="utf-8", newline="") as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def numbers(row, *columns):
    return [float(row[column]) for column in columns]


def parted(rows, group_of, gap, step=1, first=0):
    """Each row with its place y; `gap` is added where the group changes."""
    y, before = first, None
    for row in rows:
        if before is not None:
            y += step + (gap if group_of(row) != before else 0)
        before = group_of(row)
        yield y, row


def chosen(rows, *wanted):
    """The rows that have each COLUMN=VALUE."""
    pairs = [text.split("=", 1) for text in wanted]
    return [row for row in rows if all(row[column] == value for column, value in pairs)]


def where(rows, *wanted):
    return [row.values() for row in chosen(rows, *wanted)]


def rising(rows, column, *wanted):
    """The same by the numbers of a column."""
    return [row.values() for row in sorted(chosen(rows, *wanted), key=lambda row: float(row[column]))]


def filled(rows, x, y):
    """The numbers of two columns, of the rows that have both."""
    return [[row[x], row[y]] for row in rows if row[y] and row[x].isdecimal()]


def cell(rows, column, *wanted):
    return [[row[column]] for row in chosen(rows, *wanted)]


def largest_change(rows, pattern):
    """Of what the jet adds to the angle without friction, against the scene as shipped [rad], among the changes that the pattern finds."""
    rows = chosen(rows, "quantity=final_angle_rad", "scene=without friction", "jet=with")
    shipped, = numbers(chosen(rows, "change=as shipped")[0], "difference")
    return [[max(abs(float(row["difference"]) - shipped) for row in rows if re.search(pattern, row["change"]))]]


def work_precision(rows, quantity):
    """y, label, deviation from the last of the group (gas: of step) [%], two standard errors, CPU time [s]"""
    rows = [row for row in rows if row["quantity"] == quantity]
    last = {row["varied"]: float(row["mean"]) for row in rows}
    labels = {"step": "step {} of critical", "mesh": "{} elements", "gas": "gas {}"}
    for y, row in parted(rows, lambda row: row["varied"], 0.6, first=1):
        mean, error, own = numbers(row, "mean", "error", "error_standard_error")
        group = "step" if row["varied"] == "gas" else row["varied"]
        yield (y, labels[row["varied"]].format(row["value"].replace("_", "-")), 100 * (mean / last[group] - 1), 200 * own if error > 0 else 0, row["cpu_s"])


def convergence(rows, quantity):
    """y, label, deviation [%] of the mean with jet from that of the default (amplitude of 1e-4 m), two standard errors,
    the same without jet; friction is physics: its row is in the table alone"""
    rows = [row for row in rows if row["quantity"] == quantity and row["varied"] != "friction"]
    default = next(row for row in rows if row["varied"] == "seed" and row["value"] == "1e-4")
    jet, bare = numbers(default, "mean_jet", "mean_no_jet")
    labels = {"seed": "amplitude {} m", "step": "step {} of critical", "contact": "contact stiffness × {}",
              "contact_10970": "stiffness × {} on 10970 elements", "mesh": "{} elements"}
    for y, row in parted(rows, lambda row: row["varied"], 0.55):
        with_jet, its_error, without, error = numbers(row, "mean_jet", "standard_error_jet", "mean_no_jet", "standard_error_no_jet")
        yield (y, labels[row["varied"]].format(row["value"]), 100 * (with_jet / jet - 1), 200 * its_error / jet, 100 * (without / bare - 1),
               200 * error / bare)


def effects(rows, quantity, factor):
    """y, label, what the jet adds, two standard errors"""
    rows = [row for row in rows if row["quantity"] == quantity]
    for y, row in parted(rows, lambda row: row["input"], 0.4, first=1):
        mean, error, bare, its_error = numbers(row, "mean_jet", "standard_error_jet", "mean_no_jet", "standard_error_no_jet")
        name, unit = (re.split(r" *[][]", row["input"]) + [""])[:2]
        label = " ".join(filter(None, [name, row["value"] if row["value"] != "-" else "", unit]))
        yield y, label, float(factor) * (mean - bare), float(factor) * 2 * math.hypot(error, its_error)


def ladder(rows, kind, reference):
    """y, name, error [%], two standard errors, CPU time [s] of the rungs, the dearest first; KIND: front, other, all"""
    rows = sorted(rows, key=lambda row: -float(row["cpu_s"]))
    for y, row in enumerate(rows, 1):
        if kind == "all" or (kind == "front") == (float(row["front"]) > 0):
            error, its_error = numbers(row, "error", "error_se")
            yield y, row["rung"], 100 * error / float(reference), 200 * its_error / float(reference), row["cpu_s"]


def sobol(rows, quantity):
    """label, first order (0 if the estimate is below), total with its interval"""
    for row in rows:
        if row["quantity"] == quantity:
            yield row["factor"], max(float(row["first_order"]), 0), row["total"], row["total_low"], row["total_high"]


def distances(rows, friction, outlet):
    """distance, what the jet adds [degrees], two standard errors"""
    for row in rows:
        if (row["friction"], row["outlet"], row["quantity"]) == (friction, outlet, "final_angle_rad"):
            difference, error = numbers(row, "difference", "difference_standard_error")
            yield row["centre to plate"], difference * DEGREES, 2 * error * DEGREES


def tornado(rows, scene):
    """label, lower and upper difference in degrees, their standard errors, the texts of both ends, kind (1 input, 2 model,
    3 numerics), of a scene of a study with the changes `KIND, NAME: END` and `as shipped`: the first for the scene as shipped,
    then the widest first. Each goes from as shipped to its ends; the text is that of an end alone."""
    ends, shipped = {}, None
    for row in chosen(rows, f"scene={scene}", "quantity=final_angle_rad"):
        if not row["difference"]:
            continue
        name, _, text = row["change"].partition(": ")
        end = (*(DEGREES * value for value in numbers(row, "difference", "difference_standard_error")), text)
        if name == "as shipped":
            shipped = (*end[:2], "")
        else:
            ends.setdefault(name, []).append(end)
    bars = {name: (min(values + [shipped]), max(values + [shipped])) for name, values in ends.items()}
    for name, (low, high) in [("input, as shipped", (shipped, shipped)), *sorted(bars.items(), key=lambda bar: bar[1][0][0] - bar[1][1][0])]:
        kind, _, label = name.partition(", ")
        yield label, low[0], high[0], low[1], high[1], low[2], high[2], 1 + ["input", "model", "numerics"].index(kind)


KINDS = {kind.__name__: kind for kind in (where, rising, filled, cell, work_precision, convergence, effects, ladder, sobol,
                                          distances, tornado, largest_change)}

if __name__ == "__main__":
    for line in KINDS[sys.argv[1]](read(sys.argv[2]), *sys.argv[3:]):
        print(",".join(f"{value:.6g}" if isinstance(value, float) else str(value) for value in line))
