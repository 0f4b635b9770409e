#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What run_external.sh writes follows its schemas, and the schemas refuse what does not.
usage: schemas_test.py GASJET SOURCE_DIR"""
import copy
import json
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml
from pathlib import Path

try:
    from jsonschema import Draft202012Validator as Validator
except ImportError:
    print("SKIPPED, jsonschema is missing (package python3-jsonschema)")
    sys.exit(0)

gasjet, source = Path(sys.argv[1]), Path(sys.argv[2])
failures = []


def check(holds, what):
    if not holds:
        failures.append(what)


def validator(name):
    schema = json.loads((source / "verification/schemas" / name).read_text())
    Validator.check_schema(schema)
    return Validator(schema)


def changed(value, *path_and_value):
    """A copy in which the item at the path is another one, or left out if that is None."""
    *path, last, new = path_and_value
    whole = copy.deepcopy(value)
    part = whole
    for key in path:
        part = part[key]
    if new is None:
        del part[last]
    else:
        part[last] = new
    return whole


def judge(folder, command):
    """Scenes by name, report and JUnit file of run_external.sh for a shell command that gets $scene and $history."""
    script = Path(folder) / "program"
    script.write_text(f"#!/bin/bash\nscene=$1 history=$2\n{command}\n")
    script.chmod(0o755)
    out = Path(folder) / "out"
    code = subprocess.run([source / "verification/run_external.sh", "--out", out, script], env=os.environ | {"GASJET": str(gasjet)},
                          stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False).returncode
    report = json.loads((out / "report.json").read_text())
    scenes = {s["scene"]: json.loads((out / (s["scene"] + ".json")).read_text()) for s in report["scenes"]}
    return code, scenes, report, xml.parse(out / "junit.xml").getroot()


# Gives back the reference itself, fails once, and leaves out the scenes with a pendulum.
PROGRAM = f"""
name=$(sed -n 's/^  "scene": "\\(.*\\)",$/\\1/p' "$scene")
case $name in pendulum_swing) exit 77 ;; tank_fill) echo 'a "bad" <day> \\ & more'; exit 3 ;; esac
cp "{source}/cases/reference/$name.csv" "$history"
"""

scene_schema, report_schema = validator("scene.schema.json"), validator("report.schema.json")
with tempfile.TemporaryDirectory() as folder:
    code, scenes, report, junit = judge(folder, PROGRAM)

check(code == 2, f"exit code {code}, 2 expected")
check(len(scenes) == len(list((source / "cases/reference").glob("*.csv"))), f"{len(scenes)} scenes")
for name, scene in scenes.items():
    check(scene_schema.is_valid(scene), f"{name}: {[e.message for e in scene_schema.iter_errors(scene)]}")
version = subprocess.run([gasjet, "--version"], capture_output=True, text=True, check=True).stdout
check(version.startswith(f"gasjet {scenes['tank_fill']['version']} ({scenes['tank_fill']['commit']},"), "version and commit of the program")
bag = scenes["passenger_jet"]
for wrong in [changed(bag, "version", None), changed(bag, "commit", None), changed(bag, "commit", "main"), changed(bag, "format", 2),
              changed(bag, "times", []), changed(bag, "times", ["0"] * 3), changed(bag, "columns", []), changed(bag, "mesh_keyword", None),
              changed(bag, "mesh", None), changed(bag, "colour", "red"), changed(bag, "settings", "scene", "end_time", "0.1"),
              changed(bag, "settings", "scene", None), changed(bag, "settings", "colour", {}), changed(bag, "settings", "inflator", {}),
              changed(bag, "derived", "bag", "straps", 0, "to_m", [0.0, 1.0]), changed(bag, "species", "N2", "molar_mass_kg_mol", None)]:
    check(not scene_schema.is_valid(wrong), f"scene.schema.json allows {json.dumps(wrong)[:300]}")

check(report_schema.is_valid(report), f"report.json: {[e.message for e in report_schema.iter_errors(report)]}")
index = {s["scene"]: i for i, s in enumerate(report["scenes"])}
for wrong in [changed(report, "reference_data", None), changed(report, "verdict", "good"),
              changed(report, "scenes", index["tank_fill"], "comparison", report["scenes"][index["plate_jet"]]["comparison"]),
              changed(report, "scenes", index["plate_jet"], "comparison", {}), changed(report, "scenes", index["plate_jet"], "status", "failed"),
              changed(report, "scenes", index["plate_jet"], "comparison", "quantities", "jet_force_N", "verdict", "fine")]:
    check(not report_schema.is_valid(wrong), f"report.schema.json allows {json.dumps(wrong)[:300]}")

# Every column of every scene that is done is judged, once, in both reports.
check(report["verdict"] == "failed", f"verdict {report['verdict']}")
for name, scene in scenes.items():
    entry = report["scenes"][index[name]]
    suite = junit.find(f"testsuite[@name='{name}']")
    if entry["status"] == "judged":
        quantities = entry["comparison"]["quantities"]
        check({q for q in quantities if quantities[q]["verdict"] == "inside"} == set(scene["columns"]), f"{name}: columns of report.json")
        check([t.get("name") for t in suite] == [q for q in quantities if q in scene["columns"]], f"{name}: tests of junit.xml")
    check(suite.get("tests") == str(len(suite)), f"{name}: number of tests")
failed = junit.find("testsuite[@name='tank_fill']/testcase/error").get("message")
check(failed == report["scenes"][index["tank_fill"]]["message"], f"messages differ: {failed}")
check('a "bad" <day> \\ & more' in failed, f"message {failed}")
check(junit.find("testsuite[@name='pendulum_swing']/testcase/skipped") is not None, "a scene that is not done is skipped")

for failure in failures:
    print("FAILED:", failure)
print(f"{len(scenes)} scenes, {len(failures)} failures")
sys.exit(1 if failures else 0)
