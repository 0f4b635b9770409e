# SPDX-License-Identifier: Apache-2.0
"""What `gasjet check` forecasts beside what ladders measure: forecast.csv; and what those ladders say of a bag without a membrane:
without_membrane.csv. Ladders that results/forecast has are not run again; that of the paper's scene is the committed one."""
import json
import os
import re
import sys

from common import ROOT, gasjet, head_of, output, provenance, rows_of

FOLDER = ROOT / "results/forecast"
SCENES = {  # case: quantity of the ladder
    "rigid_tank": "pressure", "tank_triggers": "peak_pressure", "tank_blowdown": "temperature", "tank_backflow": "temperature",
    "tank_stiff": "peak_pressure", "plate_jet": "jet_force", "jet_slot_plate": "jet_force", "sphere_inflation": "peak_pressure",
    "jet_bag": "peak_pressure", "bag_leak_table": "peak_pressure", "bag_from_files": "peak_pressure", "driver_bag": "peak_pressure",
    "ball_impact": "contact_impulse", "contact_vent": "pendulum_angle", "passenger_pendulum": "pendulum_angle"}


def ladder(case, quantity, name, *options):
    """Its table; undecided, exit code 4, is an answer too."""
    table = FOLDER / name / "ladder.csv"
    if not table.is_file():
        output(gasjet(), "ladder", f"cases/{case}.toml", "--quantity", quantity, "--quiet", "--threads", os.cpu_count(), *options,
               "--out", FOLDER / name, allowed=(0, 4), cwd=ROOT)
    return table


def groups_of(report):
    """The sizes that check's JSON says, of several jets the largest. JSON has no word for infinity; check says "infinite"."""
    sizes = {}
    for part in json.loads(report)["forecast"]:
        name, value = re.sub("_[0-9]+$", "", part["name"]), part["value"]
        if value != "infinite" and not isinstance(value, (int, float)):
            sys.exit(f"forecast.py: value {value} of {part['name']} is no number")
        sizes[name] = max(sizes.get(name, float("-inf")), float("inf") if value == "infinite" else value)
    return sizes


def group_of(rung, quantity):
    """The group that speaks of what a rung leaves out or refines, if any."""
    on_pendulum = re.search("angle|contact|cg_acceleration", quantity)
    if rung.startswith("finest: mesh"):
        return "contact_mesh" if on_pendulum else None
    return {"jet off": "jet_on_impactor" if on_pendulum else "jet_on_bag", "outlet sonic": "below_sonic", "porosity off": "fabric_leak",
            "pieces 2": "jet_mesh" if on_pendulum else None, "gas tolerance 0.001": "gas_relaxation", "rigid tank": "fabric_stretch"}.get(rung)


def compared(scene, sizes, table):
    """Rows: scene, quantity, effect left out, group, its size, whether that matters (from 0.01 on; relaxations from 1 on), change
    of the quantity [%], its standard error, whether that is 1 % or more, agree (1, 0; empty: undecided)."""
    head = head_of(table)
    whole = abs(float(head["reference"]) - float(head.get("counted from", 0)))
    for row in rows_of(table):
        group = group_of(row["rung"], head["quantity"])
        if not int(row["runs"]) or group not in {*sizes, "gas_relaxation"}:
            continue
        size = sizes.get(group, 0)  # no relaxation where nothing flows out
        share, error = 100 * float(row["change"]) / whole, 100 * float(row["change_se"]) / whole
        says, seen = size >= (1 if group == "gas_relaxation" else 0.01), abs(share) >= 1
        undecided = abs(abs(share) - 1) < 2 * error
        yield [scene, head["quantity"], row["rung"].removeprefix("finest: "), group, "infinite" if size == float("inf") else f"{size:.3g}",
               "yes" if says else "no", f"{share:.3g}", f"{error:.2g}", "undecided" if undecided else "yes" if seen else "no",
               "" if undecided else str(int(says == seen))]


def totals(rows):
    sizes = [row for row in rows if row[3] != "gas_relaxation"]
    for name, some in (("all", rows), ("all sizes", sizes)):
        yield f"{name} that agree,,,,,,,,,{sum(row[9] == '1' for row in some)}"
        yield f"{name},,,,,,,,,{sum(row[9] != '' for row in some)}"


def forecast():
    rows = []
    for scene, quantity in SCENES.items():
        table = ROOT / "docs/charts/ladder_passenger.csv" if scene == "passenger_pendulum" else ladder(scene, quantity, scene)
        rows += compared(scene, groups_of(output(gasjet(), "check", f"cases/{scene}.toml", "--format", "json", cwd=ROOT)), table)
    return ["scene,quantity,effect,group,size,forecast,change_percent,change_se_percent,ladder,agree", *map(",".join, rows), *totals(rows)]


def without_membrane():
    """The rungs of that kind of five bags, the last the paper's as it is, where only the jet is varied."""
    yield "scene,rung,overpressure_Pa,change_percent,change_se_percent,cost_ratio"
    paper = ("passenger_pendulum_pressure", "--tolerance", "10%", "--hold", "mesh,pieces,step,gas,outlet,occlusion,compression,porosity,cp")
    for case in ("sphere_inflation", "jet_bag", "bag_leak_table", "driver_bag", "passenger_pendulum"):
        table = ladder(case, "peak_pressure", *(paper if case == "passenger_pendulum" else (case,)))
        head = head_of(table)
        zero = float(head.get("counted from", 0))
        size = float(head["reference"]) - zero
        for row in rows_of(table):
            if row["rung"] in ("full", "volume by pressure", "rigid tank"):
                yield (f"{case},{row['rung']},{float(row['value']) - zero:.6g},{100 * float(row['change']) / size:.3g},"
                       f"{100 * float(row['change_se']) / size:.2g},{float(row['cost_ratio']):.3g}")


def tables():
    """{name: text of the CSV file}"""
    return {name: provenance() + "\n".join(lines()) + "\n" for name, lines in (("forecast", forecast), ("without_membrane", without_membrane))}
