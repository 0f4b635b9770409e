# SPDX-License-Identifier: Apache-2.0
"""The page of `gasjet report`, without a browser (report_page_test.py has one)."""
import os
import re
import shutil
from pathlib import Path

import pytest
from command import change, expect, ok, read, refused, table, write, write_table

PASSENGER, PAGE = "cases/passenger_pendulum.toml", "--out page.html"


@pytest.fixture
def bag():
    ok(f"run {PASSENGER} --out bag --quiet --set scene.end_time=1e-3 --set output.frames=4")


def test_report(bag):
    expect(0, "page.html: [0-9.]+ MB", f"report bag {PAGE}")
    assert not re.search('(src|href)="?(http|//)', read("page.html")) and "@@" not in read("page.html")
    # What is missing makes the page smaller, and it says so.
    missing = ("frames.bin", "energy.csv", "check.json")
    shutil.copytree("bag", "bad")
    for name in missing:
        os.remove(f"bad/{name}")
    expect(0, "MB", f"report bad {PAGE}")
    for name in missing:
        assert f"{name} is missing: no" in read("page.html")
    # A long history is thinned, and no peak is lost.
    write("long.csv", "time_s,pressure_Pa", *(f"{i * 1e-6},{123456.789 if i == 77777 else 1e5}" for i in range(100000)))
    expect(0, "MB", f"report long.csv {PAGE}")
    assert re.search("thinned to 400[0-9] of 100000 rows", read("page.html")) and "123456.789" in read("page.html")
    # output.frames = 0 leaves the frames out; those of the run before go.
    ok(f"run {PASSENGER} --out bag --quiet --set scene.end_time=1e-4 --set output.frames=0")
    assert not os.path.exists("bag/frames.bin")
    refused("output.frames: is -1, allowed: a whole number from 0 to 10000", f"run {PASSENGER} --out none --set output.frames=-1")
    # Of a rigid target, too; it is no bag for meshes of states.
    ok("run cases/plate_jet.toml --out plate --quiet")
    refused("plate/frames.bin: is of a rigid target, needed: a run with a bag", "mesh state plate --time 0 --out plate.obj")
    os.remove("plate/frames.bin")
    expect(0, "MB", f"report plate {PAGE}")
    assert "frames.bin is missing: no pictures" in read("page.html")
    refused("output.frames: the scene has no membrane and no target", "run cases/rigid_tank.toml --out none --set output.frames=10")


def test_report_bad_input(bag):
    os.mkdir("empty")
    Path("nothing.csv").touch()
    for says, words in (
            ("nowhere: no such folder or file", f"nowhere {PAGE}"), ("RESULTS.*required", PAGE), ("out.*required", "bag"),
            ("empty: is not a result: it has no history.csv, ensemble.csv or ladder.json", f"empty {PAGE}"),
            ("rigid_tank.toml:[0-9]+:1: time_s: must be one of the columns", f"cases/rigid_tank.toml {PAGE}"),
            ("bag/frames.bin: is a part of a result, allowed: its folder or a CSV file", f"bag/frames.bin {PAGE}"),
            # The page never takes the place of a result.
            ("--out .*is a folder", "bag --out bag"), ("--out .*frames.bin: a page ends with .html", "bag --out ./bag/frames.bin"),
            ("page.html: not writable .No such file", "bag --out nowhere/page.html"),
            ("nothing.csv:1:1: has no header row", f"nothing.csv {PAGE}")):
        refused(says, f"report {words}")


OTHER_RUN = (b'"run":( ?)"[0-9a-f]*"', rb'"run":\1"0123456789abcdef"')


@pytest.mark.parametrize("file, pattern, new, says", [
    ("history.csv", rb",[^,]*\n\Z", b",nan\n", "history.csv:[0-9]+:[0-9]+: plate_force_N: 'nan' is not a finite number"),
    ("energy.csv", rb",[^,]*\n\Z", b"\n", "energy.csv:[0-9]+:1: has [0-9]+ columns, but the header [0-9]+"),
    ("history.csv", rb"(.*\n)\Z", rb"\1\1", "history.csv:[0-9]+:1: time_s: .* does not rise"),
    ("history.csv", rb"(?m)^[0-9].*\n", b"", "history.csv:[0-9]+:1: has no rows"),
    # Cut between two rows.
    ("history.csv", rb".*\n\Z", b"", "ends at .* s, but .*incomplete"), ("energy.csv", rb".*\n\Z", b"", "ends at .* s, but .*incomplete"),
    # Damaged frames and JSON.
    ("frames.bin", rb"(?s).\Z", b"", "frames.bin: has [0-9]+ bytes of frames, needed: whole frames of [0-9]+ bytes"),
    ("frames.bin", b'"nodes":1374', b'"nodes":1373', "frames.bin: its header contradicts itself"),
    ("frames.bin", rb'"triangles":\[\[[0-9]*', b'"triangles":[[1374', "frames.bin: its header contradicts itself"),
    ("frames.bin", b'"straps"', b'"Straps"', "frames.bin: its header is incomplete"),
    ("frames.bin", rb"(?s)\A.*\Z", b"something else\n", 'frames.bin: does not begin as "gasjet frames" of format 1'),
    ("summary.json", rb"(?s)\A(.{100}).*\Z", rb"\1", "summary.json: is not a JSON object, or is incomplete"),
    ("summary.json", rb"(?s)\A.*\Z", b'{"status": 1}', "bad: its JSON is not from gasjet"),
    # A folder of two runs, and one whose run has not ended.
    ("summary.json", *OTHER_RUN, "summary.json: is of the run '0123456789abcdef', but its folder of"),
    ("frames.bin", *OTHER_RUN, "frames.bin: is of the run '0123456789abcdef', but its folder of"),
    ("check.json", *OTHER_RUN, "check.json: is of the run '0123456789abcdef', but its folder of"),
    ("gasjet.status", b"(?m)^status: done", b"status: running", "history.csv: its run has not ended"),
], ids=lambda value: "" if isinstance(value, bytes) else value[:30])
def test_report_damaged(bag, file, pattern, new, says):
    path = Path("bag", file)
    whole = path.read_bytes()
    path.write_bytes(re.sub(pattern, new, whole, count=0 if b"(?m)" in pattern else 1))
    assert path.read_bytes() != whole
    os.rename("bag", "bad")
    refused(says, f"report bad {PAGE}")
    if file == "frames.bin" and "its folder" in says:
        refused(says, "mesh state bad --time 0 --out bag.obj")


def test_report_damaged_frames(bag):
    """Cut between two frames; and files of two runs where no status tells runs apart."""
    frames = Path("bag/frames.bin")
    whole = frames.read_bytes()
    frames.write_bytes(whole[:-int(re.search(rb'"frame_bytes":([0-9]+)', whole)[1])])
    refused("frames.bin: ends at .* s, but the run at .* incomplete", f"report bag {PAGE}")
    os.remove("bag/gasjet.status")
    frames.write_bytes(re.sub(rb'"run":"[^"]*"', b'"run":"another"', whole, count=1))
    refused("frames.bin: is of the run 'another', but the table beside it", f"report bag {PAGE}")
    frames.write_bytes(whole)
    change("bag/energy.csv", ("^# run: .*", "# run: another"))
    refused("energy.csv: is of the run 'another', but the table beside it", f"report bag {PAGE}")


def test_report_bands():
    """Ensembles, and bands of all kinds."""
    ok("ensemble cases/sphere_inflation.toml --runs 2 --quiet --set scene.end_time=1e-3 --set membrane.mesh.levels=1 --out all")
    ensemble = "all/sphere_inflation"
    expect(0, "MB", f"report {ensemble} {PAGE}")

    def a_copy(without):
        shutil.rmtree("bad", ignore_errors=True)
        shutil.copytree(ensemble, "bad", ignore=shutil.ignore_patterns(without))

    a_copy("none")
    write("bad/ensemble.json", "{}")
    refused("ensemble.json: is not a result of gasjet ensemble", f"report bad {PAGE}")
    a_copy("gasjet.status")
    change("bad/ensemble.json", ('"run": "[^"]*"', '"run": "another"'))
    refused("ensemble.json: is of the run 'another', but the table beside it", f"report bad {PAGE}")
    a_copy("runs.csv")
    change("bad/ensemble.csv", (r".*\n\Z", ""))
    refused("ensemble.csv: ends at .* s, but the run at 0.001 s .see ensemble.json.: the file is incomplete", f"report bad {PAGE}")
    a_copy("none")
    change("bad/ensemble.csv", (r"(?s)..\Z", ""))
    refused("ensemble.csv: its last row has no end of line: the file is incomplete", f"report bad {PAGE}")
    refused("ensemble.csv: its last row has no end of line", f"compare bad/ensemble.csv {ensemble}/ensemble.csv")
    write("interval.csv", "time_s,force_low_N,force_high_N,force_N", "0,1,2,1", "1,2,2,2", "2,2,3,2")
    expect(0, "MB", f"report interval.csv {PAGE}")
    refused("--against .*interval.csv: force_low_N: a reference states its band as half width, in NAME_band",
            f"report {ensemble} --against interval.csv {PAGE}")
    change("interval.csv", ("^1,2,2,2", "1,3,2,2"))
    refused("interval.csv:3:1: force_low_N: 3 is above force_high_N, 2", f"report interval.csv {PAGE}")
    for width in ("force_band", "force_standard_error"):
        write("width.csv", f"time_s,force,{width}", "0,1,0", "1,2,-0.5")
        refused(f"width.csv:3:1: {width}: -0.5: is not a half width of 0 or more", f"report width.csv {PAGE}")
    # A history of another program is judged, too.
    tank = "cases/reference/tank_fill.csv"
    rows = table(tank)
    write_table("foreign.csv", {name: [row[name] for row in rows] for name in ("time_s", "pressure_Pa", "temperature_K")})
    expect(0, "MB", f"report foreign.csv --against {tank} --out foreign.html")
    os.mkdir("ladder")
    write("ladder/ladder.json", "{}")
    refused("--against: .* is a ladder, allowed: a run, an ensemble or a history", f"report ladder --against {tank} --out foreign.html")
