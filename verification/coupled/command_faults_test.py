# SPDX-License-Identifier: Apache-2.0
"""Nothing is lost and nothing is wrong in silence when descriptors are closed, disks are full, runs are killed, folders are shared and
names are strange."""
import contextlib
import os
import random
import re
import shutil
import signal
import time
import xml.etree.ElementTree as xml
from pathlib import Path

import pytest
from command import (GASJET, ROOT, change, ended, expect, files, fits, has, limited, line, load, ok, program, read, refused, same, started,
                     status, stop, table, until, whole_rows, write)

TANK, ENDLESS = "cases/rigid_tank.toml", "run cases/passenger_pendulum_no_jet.toml --set scene.end_time=100 --set output.fields_every=1e-3"
WARNS = "run cases/passenger_pendulum.toml --set scene.end_time=2e-4"
TABLES = ("history.csv", "energy.csv")
PLOT = ROOT / "scripts/plot.py"


def redirected(command, how):
    """The command with redirections of a shell."""
    return program("bash", "-c", f'exec "$@" {how}', "-", *line(command))


def test_descriptors():
    ok(f"{WARNS} --out plain")
    for n, closed in enumerate(("2>&-", "2>/dev/full", "<&- 2>&-", "2>&- >/dev/null", ">&-", "<&- >&-", "<&- >&- 2>&-")):
        ended(0, "", redirected(f"{WARNS} --out closed{n}", closed))
        same("plain", f"closed{n}", *TABLES)
        assert status(f"closed{n}") == "done"
    assert redirected(f"{WARNS} --out lost", ">/dev/full").code == 3


def test_pipes():
    """Nobody reads what is told: the run goes on, and what only prints ends without a word."""
    reading, writing = os.pipe()
    os.close(reading)
    run = started(f"{WARNS} --out unread", stdout=writing, stderr=writing)
    os.close(writing)
    assert run.wait() == 141 and status("unread") == "done"
    long = "exact tank_fill --times 0:1000:0.01"
    ended(3, "write failed", redirected(long, ">/dev/full"))
    head = ended(0, "^141$", program("bash", "-c", '"$@" | head -n 1 >/dev/null; echo ${PIPESTATUS[0]}', "-", *line(long)))
    assert head.err == ""
    expect(3, "write failed", f"run {TANK} --set output.history_every=1e-5 --out cut --quiet", preexec_fn=limited(file=8, ignore=False))


def test_threads():
    """Threads that cannot start are told, not met."""
    if not fits(400000):
        pytest.skip("a sanitizer's program needs more memory")
    expect(3, "threads: is 200, but this system runs only [0-9]+ ", "ensemble cases/sphere_inflation.toml --runs 40 --threads 200"
           " --set scene.end_time=1e-4 --quiet --out threads", preexec_fn=limited(400000))


def test_killed():
    ok(f"run {TANK} --out run --quiet")  # a run before
    run = started(f"{ENDLESS} --out run")
    until(lambda: has("run/bag_00003.vtp"))
    expect(2, "--out .*run: another command is writing this folder", f"run {TANK} --out run")
    expect(2, "has not ended", "compare run/history.csv run/history.csv")
    time.sleep(1.2)  # rows are in the file after a second
    stop(run, signal.SIGKILL)
    assert whole_rows("run/history.csv") > 1
    fields = read("run/fields.pvd")
    assert fields.endswith("</VTKFile>\n")
    for name in re.findall('file="([^"]*)"', fields):
        assert "</VTKFile>" in read(f"run/{name}"), f"{name} is named and not whole"
    assert load("run/summary.json")["status"] == status("run") == "running"
    expect(2, r"history.csv: its run has not ended \(see gasjet.status\)", "compare run/history.csv run/history.csv")
    ended(2, "history.csv: its run has not ended", program(PLOT, "history", "plot", "run"))
    ok(f"run {TANK} --out run --quiet")
    assert sorted(os.listdir("run")) == ["check.json", "energy.csv", "gasjet.status", "history.csv", "summary.json"]


def test_killed_by_hangup():
    """SIGHUP ends a run as SIGTERM does, but where nohup ignores it."""
    run = started(f"{ENDLESS} --out hup")
    until(lambda: has("hup/bag_00001.vtp"))
    assert stop(run, signal.SIGHUP) == 130 and status("hup") == "interrupted"
    run = started(f"{ENDLESS} --out nohup", preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN))
    until(lambda: has("nohup/bag_00001.vtp"))
    run.send_signal(signal.SIGHUP)
    until(lambda: has("nohup/bag_00003.vtp"))
    assert stop(run, signal.SIGTERM) == 130


def run_id(folder):
    return re.search("^run: (.*)", read(f"{folder}/gasjet.status"), re.MULTILINE)[1]


def test_mixed():
    ok(f"run {TANK} --out a --quiet")
    ok(f"run {TANK} --out b --quiet --set scene.end_time=0.05")
    assert run_id("a") != run_id("b")
    for name in TABLES:
        assert f"\n# run: {run_id('a')}\n" in read(f"a/{name}")
    # The id follows from the contents, wherever they stand, and from files that the case names.
    short = "--quiet --set scene.end_time=1e-5"
    shutil.copy("cases/bag_from_files.toml", ".")
    shutil.copytree("cases/bag_from_files", "bag_from_files")
    ok(f"run bag_from_files.toml {short} --out here")
    ok(f"run cases/bag_from_files.toml {short} --out there")
    write("bag_from_files/design.obj", read("bag_from_files/design.obj"), "# another mesh")
    ok(f"run bag_from_files.toml {short} --out changed")
    assert run_id("here") == run_id("there") != run_id("changed")
    shutil.copy("b/history.csv", "a/history.csv")
    other = "history.csv: is of the run '[0-9a-f]{16}', but its folder of"
    expect(2, other, "compare a/history.csv b/history.csv")
    ended(2, other, program(PLOT, "history", "plot", "a"))
    refused("--out .*: contains the results of gasjet run: name another folder", f"ladder {TANK} --quantity pressure --out a")
    # A status file that names what is outside of its folder, or none of ours.
    write("precious", "precious")
    write("b/gasjet.status", read("a/gasjet.status").splitlines()[0], "command: run", "run: 0", "file: ../precious", "status: done")
    refused("summary.json exists, but gasjet did not write it", f"run {TANK} --out b")
    for file in (*Path("b").glob("*.csv"), *Path("b").glob("*.json")):
        file.unlink()
    expect(0, "done", f"run {TANK} --out b")
    assert read("precious") == "precious\n"
    write("b/gasjet.status", "mine")
    refused("gasjet.status: is not a status file of gasjet: move it away", f"run {TANK} --out b")
    # A folder of the user's in the place of a file.
    ok(f"run {TANK} --out before --quiet")
    shutil.copytree("before", "kept")
    os.remove("kept/energy.csv")
    os.makedirs("kept/energy.csv/mine")
    refused("energy.csv exists, but gasjet did not write it", f"run {TANK} --out kept --set scene.end_time=0.05")
    assert os.path.isdir("kept/energy.csv/mine")
    # Two files are of one computation if, and only if, they are of one id.
    ok(f"run {TANK} --out same --quiet --threads 2 --set scene.end_time=0.1")
    same("before", "same", *TABLES)


def test_full_disk():
    ok("mesh passenger --out bag.obj")
    before = read("bag.obj")
    refused("bag.obj: cannot be written", "mesh passenger --out bag.obj --refine 1", preexec_fn=limited(file=8))
    assert read("bag.obj") == before
    fine = f"run {TANK} --out run --set output.history_every=1e-5"
    expect(3, "(history|energy).csv: write failed", fine, preexec_fn=limited(file=64))
    assert whole_rows("run/history.csv") > 1 and status("run") == "failed"
    expect(0, "done", fine)
    expect(3, "energy.csv: write failed", f"run {TANK} --out end", preexec_fn=limited(file=6))  # as the last rows come
    assert load("end/summary.json")["status"] == status("end") == "failed"
    expect(3, "write failed", "run cases/sphere_inflation.toml --out fields --set scene.end_time=2e-4 --set output.fields_every=1e-4",
           preexec_fn=limited(file=8))
    assert not list(Path("fields").glob("*-part"))


# On a disk of its own: the step that fails is the exit code.
SMALL_DISK = '''mkdir disk before full && mount -t tmpfs -o size=96k none disk || exit 77
"$1" run cases/rigid_tank.toml --out disk/run --quiet || exit 1
"$1" run cases/rigid_tank.toml --out disk/run --set output.history_every=1e-5 >output 2>&1
[ $? = 3 ] || exit 2
cp -r disk/run/. full && rm -r disk/run
"$1" run cases/rigid_tank.toml --out disk/run --quiet || exit 3
"$1" mesh passenger --out disk/bag.obj >>output 2>&1
[ $? = 2 ] && [ ! -e disk/bag.obj ] || exit 4
head -c 200000 /dev/zero >disk/filling 2>/dev/null
"$2" history disk/plot disk/run >>output 2>&1
[ $? = 2 ] && [ ! -e disk/plot.png ] || exit 5'''


def test_small_disk():
    done = program("unshare", "-rm", "bash", "-c", SMALL_DISK, "-", GASJET, PLOT)
    if done.code in (1, 77):
        pytest.skip("unshare or mount is not allowed here")
    assert done.code == 0, f"{done.what} {read('output')}"
    assert re.search("history.csv: write failed|energy.csv: write failed|No space", read("output"))
    assert status("full") != "done" and not has("full/summary.json", '"status": "(running|done)"')
    assert whole_rows("full/history.csv") > 1


def test_names():
    """Names of scenes, files, folders and columns are texts, whatever they hold."""
    wild = """it's "$(touch OWNED)" `touch OWNED`; system("touch OWNED"); <é&>"""
    change(TANK, ('^name = "rigid_tank"', r'''name = "q'\\"\\n$(touch OWNED)`touch OWNED`<&>\\u00e9"'''), to=f"{wild}.toml")
    expect(0, "done", "run", f"./{wild}.toml", "--out", wild)
    assert load(f"{wild}/summary.json")["scene"] == "q'\"\n$(touch OWNED)`touch OWNED`<&>é"
    column = "it's $(touch OWNED)`touch OWNED`"
    write(f"{wild}.csv", f"time_s,{column},{column}_reference", "0,1,2", "1,2,3", "2,1,4")
    ended(0, "", program(PLOT, "compare", f"{wild} rows", f"{wild}.csv"))
    assert has(f"{wild} rows.svg")
    for folder in (wild, "x'; system(\"touch OWNED\"); #", "<touch OWNED; cat ", "|touch OWNED", "]]>"):  # as a file's name, and in a title
        if folder != wild:
            ok(f"run {TANK} --quiet --out", folder)
        ended(0, "", program(PLOT, "history", f"{folder}/plot", folder))
        xml.parse(f"{folder}/plot.svg")
        assert has(f"{folder}/plot.png")
    # A line break and bytes that are no UTF-8, in names of files and in options.
    folder = os.fsdecode(b"two\nlines \xff")
    shutil.copy(TANK, f"{folder}.toml")
    expect(0, "done", "run", f"{folder}.toml", "--out", folder)
    assert "time_s" in table(f"{folder}/history.csv")[0] and load(f"{folder}/summary.json")
    ended(2, "line break", program(PLOT, "history", "plot", folder))
    expect(0, "cheapest", "ladder --quantity pressure", f"{folder}.toml", "--out", f"{folder} ladder")
    assert load(f"{folder} ladder/ladder.json")
    expect(0, "done", "run --out cheapest", f"{folder} ladder/cheapest.toml")
    shutil.copy("cases/sphere_inflation.toml", f"{wild} ensemble.toml")
    ok("ensemble --runs 2 --quiet --set scene.end_time=2e-4", f"./{wild} ensemble.toml", "--out", f"{folder} ensemble")
    assert load(f"{folder} ensemble/{wild} ensemble/ensemble.json")
    assert "OWNED" not in map(os.path.basename, files())


def size(folder):
    """Of its files, together, while others write there."""
    total = 0
    for path in files(folder):
        with contextlib.suppress(FileNotFoundError):
            total += os.path.getsize(path)
    return total


def test_killed_anywhere():
    """Killed at any moment: the status is true, rows but the last are whole, and the next run has the bytes of one that was left alone."""
    scene = ("run cases/sphere_inflation.toml --quiet --set membrane.mesh.levels=3 --set scene.end_time=1e-2 --set output.fields_every=1e-3"
             " --out ")
    ok(scene + "alone")
    rng, length, cut_off = random.Random(7), size("alone"), 0
    for kill in range(16):
        if kill % 4:  # else over what the run before left
            shutil.rmtree("run", ignore_errors=True)
        run, so_far = started(scene + "run"), rng.uniform(0.0, 1.1) * length  # not a time: machines are slow, fast and busy
        while run.poll() is None and size("run") < so_far:
            time.sleep(1e-3)
        stop(run, signal.SIGKILL)
        if os.path.exists("run/gasjet.status") and status("run") == "done":
            same("alone", "run", *TABLES)
            continue
        cut_off += 1
        if os.path.exists("run/history.csv"):
            rows = [row for row in read("run/history.csv").splitlines()[:-1] if not row.startswith("#")]
            assert len({row.count(",") for row in rows}) <= 1, rows
        expect(2, "its run has not ended|no such file", "compare run/history.csv alone/history.csv")
    assert cut_off > 2, f"{cut_off} runs were killed before they had ended"
    ok(scene + "run")
    same("alone", "run", *TABLES)
    assert sorted(os.listdir("run")) == sorted(os.listdir("alone"))


def test_locale():
    """Where a comma separates decimals."""
    ended(0, "", program("localedef", "-i", "de_DE", "-f", "UTF-8", "./de_DE.UTF-8"))  # package locales
    comma = {"env": {"LOCPATH": os.getcwd(), "LC_ALL": "de_DE.UTF-8"}}
    assert program("bash", "-c", "printf %.1f 0,5", **comma).out == "0,5"
    for case in ("rigid_tank", "passenger_pendulum"):
        scene = f"run cases/{case}.toml --quiet --set scene.end_time=2e-3 --out"
        ok(f"{scene} plain_{case}")
        ok(f"{scene} comma_{case}", **comma)
        same(f"plain_{case}", f"comma_{case}", *TABLES)
        load(f"comma_{case}/summary.json")
    ok(f"run {TANK} --out fill --quiet", **comma)
    expect(0, "inside", "compare fill/history.csv cases/reference/tank_fill.csv", **comma)
    assert ok("exact tank_fill", **comma).out == ok("exact tank_fill").out
    for name, how in (("comma", comma), ("plain", {})):
        ok(f"mesh passenger --out {name}.obj", **how)
        ended(0, "", program(PLOT, "history", name, f"{name}_rigid_tank", **how))
    assert read("comma.obj") == read("plain.obj")
    assert read("comma.svg").replace("comma", "plain") == read("plain.svg")
