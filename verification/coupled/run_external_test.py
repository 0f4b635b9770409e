# SPDX-License-Identifier: Apache-2.0
"""run_external.py: a foreign program is inside; each of its defects is caught, as outside, as undecided or as a bad file. What it writes
follows its schemas, and the schemas refuse what does not."""
import copy
import os
import xml.etree.ElementTree as xml
from pathlib import Path

import pytest
from command import GASJET, ROOT, ended, has, load, ok, program, says, write, write_script

RUN_EXTERNAL, TANK = ROOT / "verification/run_external.py", Path(__file__).with_name("foreign_tank.py")


def external(code, pattern, *words, defect="", gasjet=GASJET):
    return ended(code, pattern, program(RUN_EXTERNAL, *words, env={"GASJET": gasjet, "DEFECT": defect}))


def judge(code, pattern, defect="", scenes="tank_fill,tank_blowdown", **how):
    return external(code, pattern, "--tolerance", "1e-5", "--scenes", scenes, TANK, defect=defect, **how)


def test_external():
    says("pendulum_swing: not done", judge(0, "tank_fill: inside", scenes="pendulum_swing,tank_fill"))
    says("  proved: pressure_Pa: wrong from digit 9 on, by ", judge(0, "tank_blowdown: inside"))
    judge(1, ": outside: ", "discharge")
    for defect in ("no_volume", "stops"):
        judge(4, ": undecided: ", defect)
    judge(4, "undecided: .* sampled too coarsely", "sparse", "tank_fill")
    judge(2, "tank_fill.csv:[0-9]+:[0-9]+: 'nan'", "nan")
    judge(2, "tank_fill: the program failed with exit code 3", "crash")
    dying = write_script("dying", f'#!/bin/sh\n[ "$1" != compare ] || exit 139\nexec "{GASJET}" "$@"\n')
    judge(2, "tank_fill: ", scenes="tank_fill", gasjet=dying)


def test_external_defects():
    for defect in ("gauge", "kilopascal", "celsius", "late", "gamma", "inflow", "ambient", "euler", "energy_in", "energy_out", "never_chokes"):
        judge(1, ": outside: ", defect)


def test_external_programs():
    external(2, "does none of the scenes", "--scenes", "pendulum_swing", TANK)
    # What no case says is handed over: the ends of the generator's straps, and three files of the mesh.
    looks = write_script("looks", """#!/usr/bin/python3
import json, os, sys
text = open(sys.argv[1]).read()
scene = json.loads(text)
meshes = [scene[name] for name in ("mesh", "mesh_keyword", "mesh_initial")]
whole = all(map(os.path.getsize, meshes)) and "ELEMENT_SHELL" in open(meshes[1]).read()
ends = text.count('"from_m"') + text.count('"to_m"')
sys.exit(77 if whole and ends == 4 and "jet_hidden_elements" in scene["columns"] else 1)
""")
    external(2, "passenger_jet: not done", "--scenes", "passenger_jet", looks)
    # A program that does not end is ended.
    endless = write_script("endless", "#!/bin/sh\nexec sleep 20\n")
    external(2, "tank_fill: the program took longer than 1 s .--out keeps", "--timeout", "1", "--scenes", "tank_fill", endless)
    external(2, "tank_fill: the program wrote no history: ", "--scenes", "tank_fill", "true")


@pytest.mark.parametrize("says, words", [
    ("--timeout 0: is not a whole number", "--timeout 0 false"), ("no scene 'tank'", "--scenes tank false"),
    ("needs the command", "--tolerance 0.1"), ("^run_external.py: unknown option --band; allowed before", "--band"),
    ("^run_external.py: no program '/no/such'", "/no/such"), ("--out /proc/none: the folder is not writable", "--out /proc/none false"),
    *((f"^run_external.py: --tolerance {share}: is not a share from 0 to 1", f"--tolerance {share} false") for share in "nan inf -1 1.5 x".split())])
def test_external_options(says, words):
    external(2, says, *words.split())


def test_external_surroundings():
    external(0, "^usage: run_external.py", "--help")
    external(2, "--tolerance : is not a share from 0 to 1", "--tolerance", "", "false")
    external(2, "no program .*none: build it first, or name it by the variable GASJET", "false", gasjet="none")


def test_external_tolerances():
    """A tolerance of one column of one scene; the last row that fits counts."""

    def judge_by(code, pattern, *rows, head="scene,column,tolerance", defect="inflow"):
        write("tolerances.csv", head, *rows)
        external(code, pattern, "--tolerance", "1e-5", "--tolerances", "tolerances.csv", "--scenes", "tank_fill,tank_blowdown", "--out", "judged", TANK,
                 defect=defect)

    judge_by(0, "tank_fill: inside", "tank_fill,*,0.002", "# of the vent", "tank_fill , temperature_K , 1e-3")
    assert {f"tank_fill.{end}" for end in ("json", "csv", "log", "txt", "rows.csv")} | {"report.json", "junit.xml"} <= set(os.listdir("judged"))
    judge_by(1, "tank_fill: outside: inflow_kg_s", "tank_fill,*,0.002", "tank_fill,inflow_kg_s,0")
    assert has("judged/junit.xml", '<failure type="outside"') and load("judged/report.json")["verdict"] == "outside"
    judge_by(1, "  outside: gas_mass_kg: ", "*,inflow_kg_s,0.01", "tank_blowdown,*,1e-5")
    for row, pattern in (("tank_fil,*,0", "3:1: scene: no scene"), ("tank_fill,vent_outflow_kg_s,0", "3:11: column: no column .* of tank_fill"),
                         ("*,pressure,0", "3:3: column: no column .* of any"), ("*,*,nan", "3:5: tolerance: .* is not a share from 0 to 1"),
                         ("*,*,2", "3:5: tolerance"), ("*,*", "3:1: has 2 fields")):
        judge_by(2, f"tolerances.csv:{pattern}", "*,*,0", row)
    judge_by(2, "tolerances.csv:1:1: is empty", head="")
    judge_by(2, "tolerances.csv:1:1: needed: the header scene,column,tolerance", head="scene,tolerance")
    external(2, "no such file", "--tolerances", "none.csv", TANK)


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


def validator(name):
    jsonschema = pytest.importorskip("jsonschema", reason="jsonschema is missing (package python3-jsonschema)")
    schema = load(ROOT / "verification/schemas" / name)
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


# Gives back the reference itself, fails once, and leaves out the scenes with a pendulum.
PROGRAM = f"""#!/bin/bash
name=$(basename "$1" .json)
case $name in pendulum_swing) exit 77 ;; tank_fill) echo 'a "bad" <day> \\ & more'; exit 3 ;; esac
cp "{ROOT}/cases/reference/$name.csv" "$2"
"""


def test_schemas():
    scene_schema, report_schema = validator("scene.schema.json"), validator("report.schema.json")
    external(2, "", "--out", "out", write_script("program", PROGRAM))
    report, junit = load("out/report.json"), xml.parse("out/junit.xml").getroot()
    scenes = {entry["scene"]: load(f"out/{entry['scene']}.json") for entry in report["scenes"]}
    assert len(scenes) == len(list(Path("cases/reference").glob("*.csv")))
    for scene in scenes.values():
        scene_schema.validate(scene)
    assert ok("--version").out.startswith(f"gasjet {scenes['tank_fill']['version']} ({scenes['tank_fill']['commit']},")
    bag = scenes["passenger_jet"]
    for wrong in (("version", None), ("commit", None), ("commit", "main"), ("format", 2), ("times", []), ("times", ["0"] * 3), ("columns", []),
                  ("mesh_keyword", None), ("mesh", None), ("colour", "red"), ("settings", "scene", "end_time", "0.1"), ("settings", "scene", None),
                  ("settings", "colour", {}), ("settings", "inflator", {}), ("derived", "bag", "straps", 0, "to_m", [0.0, 1.0]),
                  ("species", "N2", "molar_mass_kg_mol", None)):
        assert not scene_schema.is_valid(changed(bag, *wrong)), f"scene.schema.json allows {wrong}"
    report_schema.validate(report)
    index = {entry["scene"]: i for i, entry in enumerate(report["scenes"])}
    fill, plate = index["tank_fill"], index["plate_jet"]
    for wrong in (("reference_data", None), ("verdict", "good"), ("scenes", fill, "comparison", report["scenes"][plate]["comparison"]),
                  ("scenes", plate, "comparison", {}), ("scenes", plate, "status", "failed"),
                  ("scenes", plate, "comparison", "quantities", "jet_force_N", "verdict", "fine")):
        assert not report_schema.is_valid(changed(report, *wrong)), f"report.schema.json allows {str(wrong)[:300]}"
    # Every column of every scene that is done is judged, once, in both reports.
    assert report["verdict"] == "failed"
    for name, scene in scenes.items():
        entry, suite = report["scenes"][index[name]], junit.find(f"testsuite[@name='{name}']")
        if entry["status"] == "judged":
            quantities = entry["comparison"]["quantities"]
            assert {q for q in quantities if quantities[q]["verdict"] == "inside"} == set(scene["columns"]), name
            assert [test.get("name") for test in suite] == [q for q in quantities if q in scene["columns"]], name
        assert suite.get("tests") == str(len(suite))
    failed = junit.find("testsuite[@name='tank_fill']/testcase/error").get("message")
    assert failed == report["scenes"][fill]["message"] and 'a "bad" <day> \\ & more' in failed
    assert junit.find("testsuite[@name='pendulum_swing']/testcase/skipped") is not None
