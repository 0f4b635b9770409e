# SPDX-License-Identifier: Apache-2.0
"""Files of the user's, in folders of results, beside them and in names."""
import os
import shutil
from pathlib import Path

from command import change, expect, has, load, ok, read, refused, write

TANK = "cases/rigid_tank.toml"


def test_own_files():
    mine = lambda *names: [write(name, "mine") for name in names]
    kept = lambda *names: all(read(name) == "mine\n" for name in names)
    os.mkdir("mine")
    mine("mine/notes.txt")
    refused("--out mine: contains files, but gasjet run did not create it: name another folder", f"run {TANK} --out mine")
    assert os.listdir("mine") == ["notes.txt"] and kept("mine/notes.txt")
    expect(0, "done", f"run {TANK} --out parts")
    parts = [f"parts/{name}.part" for name in ("summary.json", "history.csv", "bag.obj")]
    mine(*parts)
    expect(0, "done", f"run {TANK} --out parts")
    expect(0, "elements", "mesh passenger --out parts/bag.obj")
    assert kept(*parts)
    # What another command is writing into the same file, or the user's, keeps its own name beside it.
    before = read("parts/bag.obj")
    parts = ["parts/bag.obj.gasjet-part", "parts/page.html.gasjet-part"]
    mine(*parts)
    expect(0, "elements", "mesh passenger --out parts/bag.obj")
    expect(0, "MB", "report parts --out parts/page.html")
    assert read("parts/bag.obj") == before and "</html>" in read("parts/page.html").splitlines()[-1]
    assert kept(*parts) and sorted(map(str, Path("parts").glob("*.gasjet-part*"))) == parts
    for name in parts:
        os.remove(name)
    # What this run does not write again is removed.
    short = "run cases/jet_bag.toml --quiet --set scene.end_time=1e-3 --out replaced"
    ok(f"{short} --set output.fields_every=1e-3")
    ok(short)
    assert not os.path.exists("replaced/bag_00001.vtp")
    # A run that ends before its first frame: the same command takes its place.
    for _ in range(2):
        expect(3, "step 0: .* is not finite", "run cases/plate_jet.toml --set output.frames=3 --set inflator.0.mass_flow=1e305 --out failed")
    # The folder around an ensemble's results is the ensemble's too.
    ok("ensemble cases/sphere_inflation.toml --runs 2 --quiet --set scene.end_time=2e-4 --out around")
    refused("contains the results of gasjet ensemble: name another folder", f"run {TANK} --out around")
    # A study that is refused leaves nothing.
    write("plan.toml", "[study]", f'case = "{TANK}"', 'quantities = ["peak_pressure_Pa"]')
    refused("contains the results of gasjet run: name another folder", "study run plan.toml --out parts")
    os.mkdir("study")
    mine("study/results.csv")
    refused("--out study: contains files, but gasjet study did not create it", "study run plan.toml --out study")
    # Names of files that are no UTF-8.
    name = os.fsdecode(b"a\xff.csv")
    shutil.copy("cases/reference/tank_fill.csv", name)
    write("compare.json", ok("compare --format json", name, name).out)
    assert load("compare.json")
    # Lines that end with a carriage return alone.
    write("mac.csv", read("cases/reference/tank_fill.csv").replace("\n", "\r"))
    refused("mac.csv:1:[0-9]+: a carriage return within a line", "compare mac.csv mac.csv")


def test_own_files_decks():
    """A deck's folder is a folder of results."""
    deck = "export cases/jet_bag.toml --units kg-m-s --format"
    os.mkdir("deck")
    write("deck/export.md", "mine")
    refused("--out deck: contains files, but gasjet export did not create it", f"{deck} radioss --out deck")
    os.remove("deck/export.md")
    expect(0, "are in", f"{deck} radioss --out deck")
    expect(0, "are in", f"{deck} lsdyna --out deck")
    assert sorted(os.listdir("deck")) == ["bag.k", "export.json", "export.md", "gasjet.status"]
    ok(f"run {TANK} --quiet --out run")
    refused("contains the results of gasjet run", f"{deck} radioss --out run")
    expect(0, "a.x0ab: bag.k and export.md are in", f"{deck} lsdyna --out deck --set", 'scene.name="a\\nb"')
    assert has("deck/export.md", "^# a.x0ab as a deck of lsdyna")


def test_own_files_knots():
    """Half a million knots: whatever looks at them all looks at each once."""
    change(TANK, ("^mass_flow.*\n", ""), to="knots.toml")
    write("knots.csv", "time_s,flow", *(f"{i * 2e-7:.7f},1" for i in range(500000)))
    expect(0, "done", "run knots.toml --out knots --set", 'inflator.0.mass_flow={file="knots.csv",time_column="time_s",column="flow"}', timeout=100)
