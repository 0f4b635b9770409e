# SPDX-License-Identifier: Apache-2.0
"""What a study says of its runs, beforehand, meanwhile and at the end; and studies whose files change, cannot be read or are damaged."""
import json
import os
import re
import shutil
from pathlib import Path

import pytest
from command import change, expect, fits, has, limited, line, load, ok, program, read, refused, started, table, until, write
from plans import BAG, TANK, bag_plan, euler_plan, factor, flow, level, means_of, plan, same_study, tank_plan, unstable_plan


def test_study_left_out():
    """Runs that are not done are in no mean, and the means say what they could change."""
    bag_plan(6)
    expect(0, "12 of 12 runs: 12 done", "study run plan.toml --out out")
    for row in means_of("out").values():
        assert row["left_out"] == "0" and row["mean_low"] == row["mean"] == row["mean_high"]
    assert "notes" not in load("out/study.json")
    journal = "out/shares/1_of_1/journal.jsonl"
    change(journal, ('(^.*"run":(2|4),.*)"done"', r'\1"failed"'))
    told = expect(3, "^runs in no mean: 2 of 12, at 1 of 2 points; .* moves by at most [0-9.]+ standard errors .peak_pressure_Pa at point 0.$",
                  "study merge out").said
    # From the rows of the runs: the two that are left out, as the least and as the greatest of the four others.
    left = [float(row["peak_pressure_Pa"]) for row in table("out/results.csv") if row["point"] == "0" and row["status"] == "done"]
    row = means_of("out")["yes"]
    mean, low, high = (float(row[name]) for name in ("mean", "mean_low", "mean_high"))
    assert (row["left_out"], row["runs"], len(left)) == ("2", "4", 4)
    assert low == pytest.approx((sum(left) + 2 * min(left)) / 6, rel=1e-12) and high == pytest.approx((sum(left) + 2 * max(left)) / 6, rel=1e-12)
    assert low < mean < high
    moves = f"at most {max(high - mean, mean - low) / float(row['standard_error']):.2g} standard errors"
    assert moves in told and moves in str(load("out/study.json")["notes"])
    # One run shows no spread.
    change(journal, ('(^.*"run":(7|8|9|10|11),.*)"done"', r'\1"inaccurate"'))
    expect(3, "runs in no mean: 7 of 12, at 2 of 2 points; .*; fewer than two other runs at 1 of these points", "study merge out")
    row = means_of("out")["no"]
    assert (row["runs"], row["left_out"]) == ("1", "5") and row["standard_error"] == row["mean_low"] == row["mean_high"] == ""


def test_study_cost():
    """What a study costs is told before it is paid, from runs of both ends."""
    bag_plan(6)
    before = os.listdir()
    told = expect(0, r"(?s)12 runs.*^about [0-9.]+ CPU s, an estimate from one run each: [0-9.]+ s at the first point, [0-9.]+ s at the last point",
                  "study run plan.toml --check").said
    assert os.listdir() == before
    expect(0, "12 of 12 runs", "study run plan.toml --out out")
    # Twelve times the mean of both, to the two digits that are printed; and what the runs took, within what a busy machine does.
    whole, first, last = map(float, re.search("about ([0-9.]+) CPU s.* ([0-9.]+) s at the first point, ([0-9.]+) s at the last", told).groups())
    took = sum(float(row["cpu_s"]) for row in table("out/timing.csv"))
    assert whole == pytest.approx(6 * (first + last), rel=0.1) and took / 4 < whole < 4 * took
    unstable_plan()
    expect(0, "^the run at the last point is failed: .*is unstable: the limit", "study run plan.toml --check")
    tank_plan()
    expect(0, "estimate from one run each: [0-9.e-]+ s at the first point$", "study run plan.toml --check")


def test_study_progress():
    """The progress of a share counts what the others end meanwhile."""
    bag_plan(40, end=0.04)
    with open("log", "w") as log:
        run = started("study run plan.toml --out out --share 1/2", stderr=log)
    until(lambda: has("out/shares/1_of_2/journal.jsonl", '"run":0,'))
    # 39 runs of another share, one of them twice, and one that is not whole yet.
    os.mkdir("out/shares/2_of_2")
    head = next(line for line in read("out/shares/1_of_2/journal.jsonl").splitlines() if "build" in line)
    done = {"cpu_s": 1, "status": "done", "steps": 1, "values": [1, 1]}
    lines = [head, *(json.dumps(done | {"run": run}, separators=(",", ":")) for run in (*range(1, 79, 2), 1))]
    Path("out/shares/2_of_2/journal.jsonl").write_text("\n".join([*lines, '{"cpu_s":1,"run":79']))
    assert run.wait() == 0, read("log")
    # A line's share of 40 runs is this share's own; per cent are rounded to half a one, 0.2 runs.
    others = [int(all_) - 0.4 * float(own) for own, all_ in re.findall(" ([0-9]+) %.* all shares ([0-9]+) of 80,", read("log"))]
    assert all(min(abs(n), abs(n - 39)) < 0.71 for n in others) and max(others) > 38, read("log")


def test_study_memory():
    """A point takes memory for its numbers, not for texts."""
    ranges = {"inflator.0.mass_flow": "0.05, 0.15", "inflator.0.temperature": "300, 500", "ambient.temperature": "290, 300",
              "ambient.pressure": "1e5, 1.02e5", "gas.initial.temperature": "280, 300", "tank.volume": "0.05, 0.07"}
    tank_plan('design = "latin_hypercube"', "points = 200000", *(text for key, r in ranges.items() for text in factor(key, f"range = [{r}]")))
    if not fits(60000):
        pytest.skip("a sanitizer takes more memory")
    # 60 MB of addresses are taken by the program, and 8 bytes by each of 1.2 million numbers.
    expect(0, "200000 points, 6 factors, 200000 runs", "study run plan.toml --check", preexec_fn=limited(150000))


def drawn(folder, name, *texts):
    """A picture, its commands and the texts in it."""
    assert has(f"{folder}/{name}.gp") and has(f"{folder}/{name}.svg"), load(f"{folder}/study.json")
    for text in texts:
        assert text in read(f"{folder}/{name}.svg"), f"no '{text}' in {name}.svg"
    assert f"{name}.svg" in read(f"{folder}/gasjet.status")


def data_of(commands, name):
    """Rows of a block of numbers in gnuplot's commands."""
    block = re.search(rf"(?ms)^\${name} << EOD\n(.*?)^EOD", read(commands))[1]
    return [[float(word) for word in text.split() if re.match("[-0-9.]", word)] for text in block.splitlines()]


def test_study_pictures():
    """Pictures show the numbers of the tables; names of the plan are texts in them, whatever they hold."""
    name = "'a' `touch made` {/Bold b} @c \"d\""
    tank_plan("[[factor]]", 'name = "gas"', *level("warm"), "[[factor.level]]", f"name = '''{name}'''", 'set = ["inflator.0.temperature=500"]',
              *flow("values = [0.3, 0.1, 0.2]"), "[analysis]", "pictures = true")
    expect(0, "6 of 6 runs: 6 done", "study run plan.toml --out means")
    drawn("means", "means", "pressure_Pa", "inflator.0.mass_flow", "warm", "'a' `touch made` {/Bold b} @c")
    assert not os.path.exists("made") and not os.path.exists("means/made")
    # A line for each gas, its points from the least flow to the greatest.
    rows = table("means/means.csv")
    expected = sorted([float(row["inflator.0.mass_flow"]), float(row["mean"])] for row in rows if row["gas"] == name)
    assert [row[:2] for row in data_of("means/means.gp", "means_0_1")] == expected and len(expected) == 3
    assert "notes" not in load("means/study.json")
    assert "set logscale" not in read("means/means.gp")  # an axis from 0.1 to 0.3
    # Without gnuplot the tables are the same, and a note says so.
    os.mkdir("none")
    shutil.copytree("means", "before")
    expect(0, "^means.svg: not drawn, gnuplot: No such file.*; its commands are in means.gp$", "study merge means", env={"PATH": "none"})
    assert not os.path.exists("means/means.svg") and read("means/means.csv") == read("before/means.csv")
    assert "means.svg: not drawn" in str(load("means/study.json")["notes"])
    expect(0, "6 of 6 runs", "study merge means")
    assert read("means/means.svg") == read("before/means.svg")
    # Points without numbers have rows with their names.
    tank_plan("[[factor]]", 'name = "way"', *level("50 % p"), *level("none", 'unset = ["inflator"]'), "[analysis]", "pictures = true")
    expect(0, "2 of 2 runs", "study run plan.toml --out rows")
    drawn("rows", "means", "50 % p", "none")


def test_study_pictures_of_designs():
    tank_plan('design = "sobol_indices"', "points = 16", *flow("range = [0.01, 0.15]", 'scale = "logarithmic"'),
              *factor("tank.volume", "range = [0.05, 0.07]"), "[analysis]", "pictures = true")
    expect(0, "64 of 64 runs", "study run plan.toml --out indices")
    drawn("indices", "means", "inflator.0.mass_flow")
    assert has("indices/means.gp", "^set logscale x$")
    drawn("indices", "sobol", "inflator.0.mass_flow", "tank.volume", "pressure_Pa", "of the factor alone", "with all others")
    shares = [[float(value) for value in list(row.values())[2:8]] for row in table("indices/sobol.csv")]
    assert [row[-6:] for row in data_of("indices/sobol.gp", "shares_0")] == shares
    euler_plan("pictures = true")
    expect(0, "3 of 3 runs", "study run plan.toml --out limit")
    fit = table("limit/convergence.csv")[0]
    drawn("limit", "convergence", "time.gas_step", "distance from the limit", f"order {float(fit['order']):.3g}")
    errors = {float(row["time.gas_step"]): abs(float(row["mean"]) - float(fit["limit"])) for row in table("limit/means.csv")}
    drawn_errors = dict(row[:2] for row in data_of("limit/convergence.gp", "errors_0"))
    assert drawn_errors == pytest.approx(errors, abs=1e-3, rel=0) and len(errors) == 3
    # A study without pictures leaves files of their names alone.
    change("plan.toml", ("^pictures.*\n", ""))
    expect(0, "3 of 3 runs", "study run plan.toml --out own")
    Path("own/means.svg").touch()
    expect(0, "3 of 3 runs", "study run plan.toml --out own")
    assert read("own/means.svg") == "" and not os.path.exists("own/means.gp")


def file_plan():
    """A tank with points of p.csv beside the plan, and a case of its own there."""
    shutil.copy(TANK, "tank.toml")
    write("p.csv", "flow", "0.1", "0.2")
    tank_plan('design = "file"', 'file = "p.csv"', *flow('name = "flow"'), case="tank.toml")


def test_study_inputs():
    """Outputs are never paired with other inputs than they were computed from."""
    file_plan()
    expect(0, "2 of 2 runs", "study run plan.toml --out out")
    for file, edit in (("p.csv", ("^0.2$", "0.3")), ("tank.toml", ("^volume = 0.06", "volume = 0.05")),
                       ("out/plan.toml", ("^.study.*", r"\g<0>\nseeds = 0"))):
        kept = read(file)
        change(file, edit)
        expect(2, f"{file}: is not as it was when the runs of .*out/shares/1_of_1/journal.jsonl:2:1 read it", "study merge out")
        Path(file).write_text(kept)
        expect(0, "2 of 2 runs", "study merge out")
    # A mesh that only a level names.
    shutil.copy("cases/clamped_disc.obj", "disc.obj")
    plan('set = ["scene.end_time=1e-3"]', *factor("membrane.mesh.file", f'values = ["clamped_disc.obj", "{os.getcwd()}/disc.obj"]'),
         case="cases/clamped_disc.toml", to="meshes.toml")
    expect(0, "2 of 2 runs", "study run meshes.toml --out meshes")
    write("disc.obj", read("disc.obj"), "# more")
    expect(2, "disc.obj: is not as it was", "study merge meshes")
    # A curve that one factor names, and that is read at no first level of the other.
    write("flow.csv", "time_s,flow", "0,1", "1,1")
    tank_plan("[[factor]]", 'name = "flow"', *level("own"), *level("file", r'set = ["inflator.0.mass_flow={file=\"flow.csv\", column=\"flow\"}"]'),
              "[[factor]]", 'name = "gas"', *level("none", 'unset = ["inflator"]'), *level("some"), case="tank.toml", to="pairs.toml")
    expect(0, "4 of 4 runs: 4 done", "study run pairs.toml --out pairs")
    change("flow.csv", ("^1,1$", "1,2"))
    expect(2, "flow.csv: is not as it was", "study merge pairs")


def test_study_inputs_journal():
    """A line that is none of a run of the plan."""
    file_plan()
    ok("study run plan.toml --out out")
    journal = Path("out/shares/1_of_1/journal.jsonl")
    kept, run = journal.read_text(), {"run": 0, "status": "done", "steps": 1, "cpu_s": 1, "values": [1]}
    for entry in ({**run, "run": -3}, {**run, "run": 2}, {**run, "status": "gone"}, {**run, "values": [1, 2]}, {**run, "values": ["1"]}, {"run": 3},
                  {"run": "0"}, {"build": 3}, 7):
        journal.write_text(kept + json.dumps(entry) + "\n")
        expect(2, "journal.jsonl:5:1: is damaged, not a run of the plan", "study merge out")
    journal.write_text(kept.replace('"inputs":', '"others":'))
    expect(2, "journal.jsonl:3:1: is a run without a line before it that names its files", "study merge out")
    journal.write_text(kept)
    expect(0, "2 of 2 runs", "study merge out")
    write("p.csv", "flow", "# none", "0.1", "-2")
    refused('^gasjet: .*p.csv:4:1: flow: with "-2" the case is refused: .*mass_flow: is -2', "study run plan.toml --check")
    # A folder that cannot be made says why. The administrator may write anywhere.
    file_plan()
    os.mkdir("closed", 0o555)
    other = [] if os.getuid() else ["setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"]
    done = program(*other, *line("study run plan.toml --out closed/below"))
    assert done.code == 2 and "--out closed/below: Permission denied" in done.said, done.what


def test_study_glitches():
    """What happens to the case or to the machine while a study runs is no result."""
    journal = "out/shares/1_of_1/journal.jsonl"
    ends = lambda: read(journal).count('\n{"cpu_s') if has(journal) else 0

    def meanwhile(happens, says):
        """With exit code 2, and no run is refused."""
        before = ends()
        with open("error", "w") as error:
            run = started("study run plan.toml --out out --quiet", stderr=error)
        until(lambda: ends() > before)
        happens()
        assert run.wait() == 2 and re.search(says, read("error")), read("error")
        assert has(journal, '"status":"done"') and not has(journal, '"status":"refused"')

    def another_case():
        write("new.toml", read(BAG), "# changed")
        os.replace("new.toml", "bag.toml")

    shutil.copy(BAG, "bag.toml")
    bag_plan(2, *factor("contact.friction", "values = [0.0, 0.1, 0.2, 0.3, 0.4]"), end=0.008, case="bag.toml")  # of each point's scene
    expect(0, "20 of 20 runs", "study run plan.toml --out whole")
    meanwhile(another_case, "bag.toml: changed while the study ran")
    expect(2, "of another plan, case or build", "study run plan.toml --out out")
    shutil.copy(BAG, "bag.toml")
    meanwhile(lambda: os.rename("bag.toml", "away.toml"), "bag.toml: (no such file|can no longer be read)")
    os.rename("away.toml", "bag.toml")
    expect(0, "20 of 20 runs: 20 done", "study run plan.toml --out out")
    same_study("whole", "out", "study.json")
    # A point's scene is read once, however few its runs are.
    plan('set = ["scene.end_time=0.004"]', 'quantities = ["peak_pressure_Pa"]', "seeds = 6", case="bag.toml")
    shutil.rmtree("out")
    meanwhile(lambda: os.rename("bag.toml", "away.toml"), "bag.toml: no such file")  # which the merge finds
    assert read(journal).count('"status":"done"') == 6
    # Memory is the machine's: rows of a million times need more than this limit.
    tank_plan('set = ["output.history_every=1e-7"]')
    if fits(60000):
        expect(3, "point 0, seed 0: out of memory: .* Run the same command with more memory to continue", "study run plan.toml --out memory", preexec_fn=limited(110000))
        expect(0, "1 of 1 runs: 1 done", "study run plan.toml --out memory")
