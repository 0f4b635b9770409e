# SPDX-License-Identifier: Apache-2.0
"""Ladders, ensembles and costs: many runs of one case; what was done before Ctrl-C or a kill is not done again, and the results are those
of one go."""
import os
import re
import shutil
import signal
import time
from pathlib import Path

import pytest
from command import (ROOT, as_json, ended, expect, has, load, ok, program, read, refused, same, started, status, stop, table, until, write,
                     write_script)
from plans import BAG as PASSENGER
from plans import SPHERE, TANK, rungs, write_slow

LADDER = f"ladder {TANK} --quantity pressure"
BAG = "ladder cases/jet_bag.toml --set membrane.mesh.levels=2 --quantity pressure"


def chart_is_of(folder):
    """The picture numbers and names the rungs that the table has on the front."""
    front = {f"{row['front']}  {row['rung']}" for row in table(f"{folder}/ladder.csv") if int(row["front"] or 0) > 0}
    assert front and set(re.findall(r">([0-9]+  [^<]*)<", read(f"{folder}/ladder.svg"))) == front


def test_ladder():
    expect(0, "cheapest within 2 %: ", f"{LADDER} --out tank")
    chart_is_of("tank")
    ok("run tank/cheapest.toml --out run --quiet")
    assert table("run/history.csv")[-1]["time_s"] == "0.1" and table("run/history.csv")[-1]["pressure_Pa"].startswith("586098.3333")
    expect(0, "jet off .* inside", f"{BAG} --out bag --tolerance 10%")
    assert {"rigid tank", "volume by pressure"} <= {row["rung"] for row in table("bag/ladder.csv")}
    chart_is_of("bag")
    assert has("bag/ladder.json", '"verdict": "inside"')
    ok("run bag/cheapest.toml --out run --quiet")
    expect(4, "undecided: no rung", f"{BAG} --out bag --tolerance 1e-5 --hold pieces")
    assert not os.path.exists("bag/cheapest.toml")  # of an earlier ladder
    # Seeds hardly scatter this pressure: single runs, unless more are allowed where a verdict is open.
    held = "--tolerance 5% --hold mesh,pieces,step,gas"
    expect(0, "only: single runs", f"{BAG} --out single {held}")
    expect(4, "means of 2 to 4 runs", f"{BAG} --out means {held} --runs 2 --most-runs 4")
    shutil.copy(TANK, "bag/cheapest.toml")
    expect(2, "--out .*bag: cheapest.toml exists, but gasjet did not write it", f"{LADDER} --out bag")
    assert read("bag/cheapest.toml") == read(TANK)
    assert ok(f"{LADDER} --out tank --quiet").said == ""


def test_ladder_charts():
    """Without gnuplot, and with one that ends badly."""
    os.mkdir("none")
    os.mkdir("bad")
    write_script("bad/gnuplot", "#!/bin/sh\necho half >ladder.svg\nexit 1\n")
    for path in ("none", "bad"):
        expect(0, "no chart: gnuplot.*; its commands are in .*tank/ladder.gp", f"{LADDER} --quiet --out tank", env={"PATH": os.path.abspath(path)})
        assert not os.path.exists("tank/ladder.svg")
    assert has("tank/ladder.gp", "^plot")
    # One that never ends goes with Ctrl-C.
    write_script("bad/gnuplot", "#!/bin/sh\n: >begun\nexec sleep 100\n")
    with open("hung", "w") as said:
        hung = started(f"{LADDER} --quiet --out tank", stdout=said, stderr=said, env={**os.environ, "PATH": f"{os.path.abspath('bad')}:{os.environ['PATH']}"})
    until(lambda: os.path.exists("tank/begun"))
    begin = time.monotonic()
    stop(hung)
    assert time.monotonic() - begin < 15 and "gnuplot did not end" in read("hung")


def test_ladder_undecided():
    at_ambient = "undecided: pressure_Pa is 101325 in the full case"
    ok(f"{LADDER} --quiet --out tank")
    expect(4, at_ambient, "ladder cases/tank_blowdown.toml --quantity pressure --quiet --out at_ambient")
    expect(4, at_ambient, f"{LADDER} --quiet --set inflator.0.start_time=5 --out tank")
    assert has("tank/ladder.json", '"reason": "pressure_Pa is') and not has("tank/ladder.csv", "(?i)(^|,)-?(nan|inf)")
    assert not os.path.exists("tank/ladder.gp")  # of an earlier ladder
    expect(3, 'rung "full".*limit', "ladder cases/tank_fixed_steps.toml --quantity pressure --set time.gas_step=4e-3 --quiet --out limit")
    # Interrupted: what was computed is kept, and says what it is.
    with open("said", "w") as said:
        run = started(f"ladder {PASSENGER} --quantity pendulum_angle --out tank", stdout=said, stderr=said)
    until(lambda: has("said"))
    assert stop(run) == 130
    assert re.search("interrupted: .*ladder.csv, run the same command to continue", read("said"))
    assert has("tank/ladder.csv", "^# status: interrupted") and load("tank/ladder.json")["status"] == "interrupted"
    ok(f"{LADDER} --out tank --quiet")
    assert not has("tank/ladder.csv", "^# status") and not os.path.exists("tank/journal.jsonl")


@pytest.mark.parametrize("says, words", [
    *(("--tolerance.*such as 0.02 or 2%", f"--tolerance={tolerance}") for tolerance in ("", "0", "-1%", "nan", "inf", "2%%", "two", "200%")),
    ("--quantity angle: the scene has none", "--quantity angle"), ("--hold mesh: .*allowed: gas", "--hold mesh"),
    ("--hold '': a name is empty, allowed: gas", "--hold gas,"), ("--unset scene.x: the case has no such key", "--unset scene.x"),
    ("--runs", "--runs 1"), ("--quantity is required", None)])
def test_ladder_bad_input(says, words):
    command = f"ladder {TANK} --out out"
    refused(says, command if words is None else f"{command} {words}" if "--quantity" in words else f"{command} --quantity pressure {words}")


def test_ladder_in_the_way():
    os.makedirs("way/ladder.csv")
    expect(2, "--out .*way: ladder.csv exists, but gasjet did not write it", f"{LADDER} --out way")


def costs(folder):
    """Rows of cost.csv by their variant: the stages are the step, the steps are the run, and the ratio is that of the runs."""
    rows = {row["variant"]: {name: float(value) for name, value in row.items() if re.fullmatch(r"[-+.0-9e]+", value)}
            for row in table(f"{folder}/cost.csv")}
    for row in rows.values():
        stages = sum(value for name, value in row.items() if re.fullmatch("S[0-9]+_.*_us|rest_us", name))
        assert stages == pytest.approx(row["us_per_step"], rel=1e-4) and 1e-6 * stages * row["steps"] == pytest.approx(row["cpu_s"], rel=1e-4)
        assert rows["as it is"]["cpu_s"] * row["ratio"] == pytest.approx(row["cpu_s"], rel=1e-4)
        assert 0 < row["cpu_s"] <= row["median_cpu_s"] <= row["largest_cpu_s"]
    return rows


COST = f"cost {PASSENGER} --set scene.end_time=0.006"


def test_cost():
    expect(0, "(?s)a run with jet over one without: .*3803 s / 2072 s = 1.84", f"{COST} --runs 3 --out cost")
    rows, tree = costs("cost"), "hidden elements by CGAL's tree"
    for variant in ("as it is", "without jet", "without hidden-element test", tree, "without pendulum and contact", "gas to 1e-6", "without files"):
        assert rows[variant]["runs"] == 3 and variant in read("cost/cost.txt")
    # A run of a variant is a run of the command: as many steps.
    ok(f"run {PASSENGER} --set scene.end_time=0.006 --unset inflator.0.jet --quiet --out run")
    assert load("run/summary.json")["steps"] == rows["without jet"]["steps"]
    # A stage costs only where it has work to do, and the slow route is slow in the test of hidden elements: nearly all of its run.
    assert rows["without jet"]["S6_jet_field_us"] == rows["without jet"]["S7_visibility_us"] == 0
    assert rows["without pendulum and contact"]["S4_contact_us"] == 0
    assert rows[tree]["S7_visibility_us"] > 5 * rows["as it is"]["S7_visibility_us"] > 0
    assert rows[tree]["rest_us"] < 0.2 * rows[tree]["us_per_step"]
    expect(0, "^without jet ", f"{COST} --runs 3 --quiet")


def test_cost_json():
    """Parts are differences of variants."""
    cost = as_json(f"{COST} --runs 3 --quiet --format json")
    least = {v["variant"]: v["cpu_s"]["least"] for v in cost["variants"]}
    for v in cost["variants"]:
        assert sum(v["stage_cpu_s"].values()) == pytest.approx(v["cpu_s"]["least"], abs=1e-9)
        assert len(v["cpu_s"]["runs"]) == 3 and min(v["cpu_s"]["runs"]) == v["cpu_s"]["least"]
    jet = cost["parts"]["jet"]
    assert jet["cpu_s"] == pytest.approx(least["as it is"] - least["without jet"], abs=1e-12)
    assert jet["by_steps_s"] + jet["by_cost_of_a_step_s"] == pytest.approx(jet["cpu_s"], abs=1e-12)
    assert sum(jet["stage_cpu_s"].values()) == pytest.approx(jet["cpu_s"], abs=1e-9)
    assert jet["run_ratio"] == pytest.approx(least["as it is"] / least["without jet"], abs=1e-9) and jet["stage_cpu_s"]["S7_visibility"] > 0
    assert set(cost["parts"]) == {"jet", "hidden-element test", "pendulum and contact", "files and rows", "gas"}
    assert cost["elements"] == 2744 and cost["left_out"] == []


def test_cost_scenes():
    # A scene without jet, pendulum or mesh.
    expect(0, "left out: without jet: the scene has none", f"cost {TANK} --runs 3 --out tank")
    assert "without jet" not in costs("tank")
    expect(0, "left out: without jet: the scene is nothing else", "cost cases/plate_jet.toml --runs 3")
    # What goes with the pendulum: channel classes, and sensors of its contact, without which the case is another one.
    quick = "--set scene.end_time=2e-4 --runs 3 --quiet"
    expect(0, "^without pendulum and contact ", f"cost {PASSENGER} --unset inflator.0.jet {quick} --set output.channel_classes=[60,180]")
    expect(0, "left out: without pendulum and contact: a sensor waits for the contact", f"cost cases/contact_vent.toml {quick}")
    expect(0, "(?s)^without self-contact .*\nself-contact ", f"cost {SPHERE} {quick} --set membrane.self_contact.thickness=1e-3")
    for says, words in (("no_such.toml: no such file", "no_such.toml"), ("--runs.*2.*3", f"{PASSENGER} --runs 2"), ("--runs", f"{PASSENGER} --runs many"),
                        ("--format", f"{PASSENGER} --format yaml"), ("fabric.thickness: is -1", f"{PASSENGER} --set fabric.thickness=-1")):
        refused(says, f"cost {words} --out none")
    shutil.copy(TANK, "tank.toml")
    refused("tank.toml", "cost tank.toml --runs 3 --out tank.toml")
    # A step above its bound: the message stands for the numbers.
    expect(3, "as it is: stage S.*is unstable: the limit", f"cost {SPHERE} --runs 3 --set time.step=1e-3")


ENSEMBLE = f"ensemble {SPHERE} --runs 10 --set scene.end_time=1e-2 --set membrane.mesh.levels=3"
TABLES = ("ensemble.csv", "quantities.csv")


def test_resume():
    # A journal cannot hold what is no number: such a run has failed.
    expect(3, "failed run, left out: pendulum_joint_force_N is not a finite number", "ensemble cases/ball_impact.toml --runs 2 --out no_number"
           " --set scene.end_time=1e-3 --set membrane.mesh.levels=1 --set pendulum.mass=1e307")
    ok(f"{ENSEMBLE} --quiet --out whole")
    for how in (signal.SIGINT, signal.SIGKILL):
        folder = how.name
        run = started(f"{ENSEMBLE} --out {folder}")
        until(lambda: has(f"{folder}/sphere_inflation/journal.jsonl", '"run":'))
        code = stop(run, how)
        if how == signal.SIGINT:
            assert code == 130 and status(folder) == "interrupted"
            assert has(f"{folder}/sphere_inflation/ensemble.csv", "^# status: interrupted, [1-9] of 10 runs")
            ended(2, "was interrupted before all runs were done", program(ROOT / "scripts/plot.py", "ensemble", "plot", f"{folder}/sphere_inflation"))
        expect(0, "continues after [1-9] finished runs", f"{ENSEMBLE} --out {folder}")
        same("whole/sphere_inflation", f"{folder}/sphere_inflation", *TABLES)
        mine, other = (load(f"{f}/sphere_inflation/ensemble.json") for f in ("whole", folder))
        assert mine["build"].pop("date") and other["build"].pop("date") and mine == other
        assert status(folder) == "done" and not os.path.exists(f"{folder}/sphere_inflation/journal.jsonl")
    # Another ensemble takes nothing over.
    run = started(f"{ENSEMBLE} --out other")
    until(lambda: has("other/sphere_inflation/journal.jsonl", '"run":'))
    stop(run)
    expect(0, "quantity", f"{ENSEMBLE} --out other --amplitude 2e-5")
    ok(f"{ENSEMBLE} --out fresh --amplitude 2e-5 --quiet")
    same("fresh/sphere_inflation", "other/sphere_inflation", *TABLES)


def test_resume_long_names():
    long = "n" * 300
    refused("File name too long", f"{ENSEMBLE} --out {long}")
    refused("File name too long", f"study run cases/studies/runs_needed.toml --out {long}")
    refused("has no plan.toml: name a folder of", f"study merge {long}")


def test_resume_shares():
    """In shares, of which one is cut off and one is damaged: the whole has the bytes of one go."""
    ok(f"{ENSEMBLE} --quiet --out whole")
    shared, shares = f"{ENSEMBLE} --out shared", Path("shared/sphere_inflation/shares")
    for share, runs in ((1, 4), (3, 3)):
        expect(0, f"share {share}_of_3: {runs} of {runs} runs have ended, 0 not done", f"{shared} --share {share}/3")
        assert read(shares / f"{share}_of_3/journal.jsonl").count('"run":') == runs
    os.truncate(shares / "3_of_3/journal.jsonl", os.path.getsize(shares / "3_of_3/journal.jsonl") - 10)
    lines = read(shares / "1_of_3/journal.jsonl").splitlines()  # an empty one, and that of the build, come first
    for pattern, new in (('"status":"done"', '"status":"gone"'), (r'"values":\[[^],]*,', '"values":['), (r'"values":\[[^],]*,', '"values":["1",'),
                         (r'"rows":\[\[[^]]*\],', '"rows":[[0.0],')):
        write(shares / "1_of_3/journal.jsonl", *lines[:2], re.sub(pattern, new, lines[2]), *lines[3:])
        expect(2, "shares/1_of_3/journal.jsonl:3:1: is damaged, not a run of the plan: remove the line", shared)
    write(shares / "1_of_3/journal.jsonl", *lines[:2])
    refused("--share 4/3: is not NUMBER/COUNT", f"{shared} --share 4/3")
    expect(2, "shares/[13]_of_3: is of another plan, case or build", f"{shared} --share 2/3 --amplitude 2e-5")
    expect(0, "continues after 2 finished runs", shared)
    same("whole/sphere_inflation", "shared/sphere_inflation", *TABLES)
    assert not shares.exists()
    # Results that are there stay when the shares are of another command.
    ok(f"{shared} --quiet --share 1/3 --amplitude 2e-5")
    expect(2, "shares/1_of_3: is of another plan, case or build", shared)
    same("whole/sphere_inflation", "shared/sphere_inflation", *TABLES)


def test_resume_ladder():
    ladder = f"{BAG} --tolerance 10%"
    run = started(f"{ladder} --out ladder")
    until(lambda: has("ladder/journal.jsonl", '"run":'))
    stop(run, signal.SIGKILL)
    kept = read("ladder/journal.jsonl")
    write("ladder/journal.jsonl", kept, '{"run":"seed 1"}')
    expect(2, "ladder/journal.jsonl:[0-9]+:1: is damaged", f"{ladder} --out ladder")
    write("ladder/journal.jsonl", kept)
    expect(0, "continues after [0-9]+ finished runs", f"{ladder} --out ladder")
    ok(f"{ladder} --out whole --quiet")
    assert rungs("whole") == rungs("ladder")
    assert sum(row["rung"].startswith("and ") for row in table("ladder/ladder.csv")) > 2


def test_resume_two_cases():
    """The first is done when the second is killed, and effects are of runs of both."""
    write_slow()
    against = f"ensemble {SPHERE} --against slow.toml --runs 4 --set scene.end_time=1e-2 --set membrane.mesh.levels=3"
    ok(f"{against} --quiet --out both")
    for how in (signal.SIGINT, signal.SIGKILL):
        for _ in range(5):  # on a busy machine it may end before this sees that it began
            shutil.rmtree("killed", ignore_errors=True)
            run = started(f"{against} --out killed")
            until(lambda: has("killed/slow/journal.jsonl", '"run":'), run)
            stop(run, how)
            if status("killed") != "done":
                break
        assert not os.path.exists("killed/effects.csv")
        expect(0, "(?s)sphere_inflation: continues after 4 finished runs.*slow: continues after [1-3] finished runs", f"{against} --out killed")
        same("both", "killed", "effects.csv", *(f"{case}/{name}.csv" for case in ("sphere_inflation", "slow") for name in ("ensemble", "quantities", "runs")))
