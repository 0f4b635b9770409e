# SPDX-License-Identifier: Apache-2.0
"""Studies: plans, designs, shares, levels, and what is refused."""
import re
import shutil
import signal
from pathlib import Path

import pytest
from command import change, expect, has, limited, load, numbers, ok, refused, started, stop, table, until, write
from plans import BAG, TANK, bag_plan, euler_plan, factor, flow, level, means_of, plan, same_study, tank_plan, unstable_plan


def test_study():
    bag_plan(6, to="thrice.toml")
    expect(0, "12 of 12 runs: 12 done", "study run thrice.toml --out alone")
    expect(0, "12 of 12 runs: 12 done", "study run thrice.toml --out threads --threads 2")
    same_study("alone", "threads", "study.json")
    rows = [row for row in table("alone/results.csv") if row["jet"] == "yes"]
    assert [row["seed"] for row in rows] == list("123456") and {row["status"] for row in rows} == {"done"}
    # All seeds are common: the mean of the differences is the difference of the means.
    means = means_of("alone")
    difference = float(means["yes"]["mean"]) - float(means["no"]["mean"])
    assert difference != 0 and abs(float(means["yes"]["difference"]) - difference) < 1e-9 * float(means["no"]["mean"])
    assert means["yes"]["runs"] == means["yes"]["pairs"] == "6"
    # A run of the study is a run of the command.
    ok(f"run {BAG} --quiet --out run --set scene.end_time=0.004 --set membrane.perturbation=1e-4 --set membrane.perturbation_seed=3")
    assert load("run/summary.json")["peak"]["pressure_Pa"] == float(rows[2]["peak_pressure_Pa"])
    # Shares in any order, one of them twice and with another count in between.
    for share in ("3/3", "1/2", "1/3", "1/3", "2/3"):
        ok(f"study run thrice.toml --out shares --quiet --share {share}")
    expect(0, "12 of 12 runs", "study merge shares")
    same_study("alone", "shares", "study.json")
    assert load("shares/study.json")["study"] == "thrice"
    expect(0, "continues after 12 finished runs", "study run thrice.toml --out alone")
    # Killed: what had ended is there, what had not is computed, and an incomplete folder says so.
    bag_plan(40, to="long.toml")
    run, journal = started("study run long.toml --out killed --quiet"), "killed/shares/1_of_1/journal.jsonl"
    until(lambda: has(journal, '"run":2,'))
    expect(2, "another command is writing", "study run long.toml --out killed")
    stop(run, signal.SIGKILL)
    with open(journal, "a") as file:
        file.write('{"run":7,"status":"do')  # torn
    expect(4, "of 80 runs", "study merge killed")
    summary = load("killed/study.json")
    assert summary["status"] == "incomplete" and re.search(r"not run yet: .*point 1 \(.*\), 40 seeds", str(summary["notes"]))
    expect(0, "(?s)continues after .*80 of 80 runs: 80 done", "study run long.toml --out killed --threads 2")
    ok("study run long.toml --out whole --quiet --threads 2")
    same_study("whole", "killed")
    # A full disk costs the runs that do not fit.
    expect(3, "write failed", "study run thrice.toml --out full --quiet", preexec_fn=limited(file=1))
    expect(0, "12 of 12 runs", "study run thrice.toml --out full")
    same_study("alone", "full")


def test_study_designs():
    # p - p0 of a filled tank grows as the mass flow: exact at any point.
    tank_plan('design = "sobol_indices"', "points = 32", *flow("range = [0.05, 0.15]"), *factor("ambient.temperature", "range = [290, 300]"))
    expect(0, "128 of 128 runs", "study run plan.toml --out indices")
    shares = {row["factor"]: row for row in table("indices/sobol.csv")}
    for share in ("first_order", "total"):
        assert float(shares["inflator.0.mass_flow"][share + "_low"]) < 1 < float(shares["inflator.0.mass_flow"][share + "_high"])
        assert float(shares["ambient.temperature"][share + "_high"]) < 1e-6
    # The scale of a flow that is a number, and of a cumulative curve in grams: both are the pressure's only factors.
    scale = factor("inflator.0.mass_flow.scale", 'name = "scale"', "range = [0.9, 1.1]")
    tank_plan('design = "sobol_indices"', "points = 32", *scale, *factor("inflator.0.mass_flow.offset", "range = [0, 1e-9]"))
    expect(0, "128 of 128 runs", "study run plan.toml --out scales")
    shares = {row["factor"]: row for row in table("scales/sobol.csv")}
    assert float(shares["scale"]["first_order_low"]) < 1 < float(shares["scale"]["first_order_high"])
    cumulative = ("inflator.0.mass_flow={ time = [0, 30, 80], value = [0, 50, 81], cumulative = true, units = { time = 'ms', value = 'g' } }")
    plan('quantities = ["gas_mass_kg"]', f'set = ["{cumulative}"]', *factor("inflator.0.mass_flow.scale", "values = [0.5, 1, 1.5]"),
              *factor("inflator.0.mass_flow.time_scale", "values = [0.5, 1]"))
    expect(0, "6 of 6 runs: 6 done", "study run plan.toml --out masses")
    masses = [float(row["gas_mass_kg"]) for row in table("masses/results.csv")]
    air = 101325 * 0.06 / (296.8 * 293.15)
    assert masses == pytest.approx([air + 0.081 * share for share in (0.5, 0.5, 1, 1, 1.5, 1.5)], rel=1e-12)
    tank_plan('design = "latin_hypercube"', "points = 20", *flow('name = "flow"', "range = [0.05, 0.15]"), "[analysis]", "response_surface = true")
    expect(0, "20 of 20 runs", "study run plan.toml --out surface")
    terms = {row["term"]: float(row["coefficient"]) for row in table("surface/surface.csv")}
    # From end to end of the range: p at a flow of 0 is the constant less twice the slope.
    assert terms["flow"] > 1e4 and abs(terms["flow * flow"]) < 1e-9 * terms["flow"]
    assert terms["1"] - 2 * terms["flow"] == pytest.approx(101325, abs=1e-2)
    tank_plan('design = "latin_hypercube"', "points = 9", *factor("ambient.temperature", "range = [290, 300]"), "[analysis]",
              "response_surface = true")
    expect(0, "surface.csv, pressure_Pa: no surface, it does not vary", "study run plan.toml --out flat")
    # A quantity that no run has: the bag does not touch.
    plan('set = ["scene.end_time=5e-4"]', 'quantities = ["first_contact_s"]', 'design = "latin_hypercube"', "points = 9",
         *factor("vent.0.area", "range = [1e-3, 2e-3]"), "[analysis]", "response_surface = true", case="cases/contact_vent.toml")
    expect(0, "surface.csv, first_contact_s: no surface, the 0 of 9 points", "study run plan.toml --out untouched")
    # Points of a file, written by another program.
    write("points.csv", "flow,other", "0.05,1", "0.1,2")
    tank_plan('design = "file"', 'file = "points.csv"', *flow('name = "flow"'))
    expect(0, "2 of 2 runs", "study run plan.toml --out file")
    ok(f"run {TANK} --quiet --out run --set inflator.0.mass_flow=0.1")
    row = table("file/results.csv")[1]
    assert (row["flow"], row["status"], float(row["pressure_Pa"])) == ("0.1", "done", numbers("run/history.csv")["pressure_Pa"][-1])
    # A point that leaves its domain is a row with its reason, and no mean has it.
    unstable_plan()
    expect(3, "1 done, 0 inaccurate, 1 failed", "study run plan.toml --out failed")
    row = table("failed/results.csv")[1]
    assert (row["time.step"], row["status"]) == ("0.001", "failed") and "is unstable: the limit" in row["message"]
    assert load("failed/study.json")["in_no_mean"] == 1


def test_study_designs_of_sizes():
    tank_plan(*factor("output.history_every", "values = [0.02, 0.01, 0.005]"), "[analysis]", 'convergence = "output.history_every"')
    told = "convergence.csv, pressure_Pa: no order, the means do not differ beyond .*rounding"
    expect(0, told, "study run plan.toml --out limit")
    assert re.search(told, str(load("limit/study.json")["notes"]))
    assert list(table("limit/convergence.csv")[0].values()) == ["pressure_Pa", "", "", "", "", "", "3"]
    euler_plan()
    expect(0, "3 of 3 runs", "study run plan.toml --out euler")
    assert 0.9 < float(table("euler/convergence.csv")[0]["order"]) < 1.1


def test_study_designs_stop():
    """A stop rule spends seeds where they are needed."""
    bag_plan(4, "[stop]", 'quantity = "peak_pressure_Pa"', "sign_error_rate = 0.01", "most_seeds = 32")
    expect(0, "(?s)8 of 8 runs.*^stop rule: 1 decided, 0 not decided", "study run plan.toml --out sign")
    assert load("sign/study.json")["decided"] == 1
    change("plan.toml", ("^sign_error.*", "standard_error = 1e-9"), ("^most.*", "most_seeds = 8"))
    expect(0, r"stop rule: 0 decided, 2 not decided\nnot decided after 8 seeds: point 0 .yes., peak_pressure_Pa\n"
           "not decided after 8 seeds: point 1 .no., peak", "study run plan.toml --out error")
    expect(0, "16 of 16 runs", "study merge error")
    assert load("error/study.json")["not_decided"] == 2
    refused("--share 1/2: a stop rule needs all runs", "study run plan.toml --out error --share 1/2")


def test_study_levels():
    # A level with fewer seeds and its own amplitude: its runs are those of the command.
    plan('set = ["scene.end_time=0.004"]', 'quantities = ["peak_pressure_Pa"]', "seeds = 3", "[[factor]]", 'name = "nodes"', *level("usual"),
         *level("few", "seeds = 2", "amplitude = 1e-6"), case=BAG)
    expect(0, "2 points, 1 factors, 5 runs", "study run plan.toml --check")
    expect(0, "5 of 5 runs: 5 done", "study run plan.toml --out levels")
    for share in ("2/2", "1/2"):
        ok(f"study run plan.toml --out shares --quiet --share {share}")
    expect(0, "5 of 5 runs", "study merge shares")
    same_study("levels", "shares", "study.json")
    few = table("levels/means.csv")[1]
    assert (few["nodes"], few["runs"], few["left_out"]) == ("few", "2", "0")
    peaks = {(row["nodes"], row["seed"]): float(row["peak_pressure_Pa"]) for row in table("levels/results.csv")}
    for nodes, seed, amplitude in (("usual", "3", 1e-4), ("few", "2", 1e-6)):
        ok(f"run {BAG} --quiet --out run --set scene.end_time=0.004 --set membrane.perturbation={amplitude} --set membrane.perturbation_seed={seed}")
        assert load("run/summary.json")["peak"]["pressure_Pa"] == peaks[nodes, seed]


def test_study_levels_quantities():
    """Numbers over the rows of the history, and of the energies at its end."""
    plan('quantities = ["max(pressure_Pa)", "min(pressure_Pa)", "integral(pressure_Pa)", "inflow_enthalpy_J"]', *flow("values = [0.1]"))
    expect(0, "1 of 1 runs", "study run plan.toml --out rows")
    ok(f"run {TANK} --quiet --out run --set inflator.0.mass_flow=0.1")
    history, row = numbers("run/history.csv"), {name: value for name, value in table("rows/results.csv")[0].items()}
    time, pressure = history["time_s"], history["pressure_Pa"]
    assert len(time) > 2 and float(row["max(pressure_Pa)"]) == max(pressure) > min(pressure) == float(row["min(pressure_Pa)"])
    area = sum((t1 - t0) * (p0 + p1) / 2 for t0, t1, p0, p1 in zip(time, time[1:], pressure, pressure[1:]))
    assert float(row["integral(pressure_Pa)"]) == pytest.approx(area, rel=1e-12)
    assert float(row["inflow_enthalpy_J"]) == numbers("run/energy.csv")["inflow_enthalpy_J"][-1]
    change("plan.toml", (r"max\(", "mean("))
    refused('has "mean.pressure_Pa.", which the scene does not have; allowed: .*integral.. of a column', "study run plan.toml --out none")


def test_study_plans():
    """The plans that ship: each is taken, and the stiffness that they give to finer meshes is that of the case."""
    shutil.copytree("cases", "shorter")  # because a check computes two runs
    for file in (*Path("shorter").glob("*.toml"), *Path("shorter/studies").glob("*.toml")):
        text = re.sub("(?m)^end_time = [0-9.e-]+", "end_time = 1e-4", file.read_text())
        file.write_text(re.sub("scene.end_time=[0-9.e-]+", "scene.end_time=1e-4", text))
    plans = sorted(Path("shorter/studies").glob("*.toml"))
    for file in plans:
        if file.name == "mesh_parts.toml":  # its meshes are made before
            expect(2, 'factor.0: with "none" the case is refused: .*none_design.obj', f"study run {file} --check")
        else:
            expect(0, "points, .* factors, .* runs", f"study run {file} --check")
    stiffness = float(re.search("^contact stiffness: ([^ ]*)", ok(f"check {BAG}").out, re.MULTILINE)[1])
    given = {float(value) for file in plans for value in re.findall("contact={stiffness=([^,}]*)", file.read_text())}
    assert given and {value / stiffness for value in given} <= {0.5, 1, 4}


HEAT = factor("inflator.0.temperature", "values = [300, 400, 500]")
SURFACE = ("[analysis]", "response_surface = true")
AT = "plan.toml"


@pytest.mark.parametrize("says, lines", [
    (f'{AT}:4:1: factor.0: with "1" the case is refused: .*mas_flow', factor("inflator.0.mas_flow", "values = [1, 2]")),
    (f'{AT}:4:1: factor.0: with "-2" the case is refused: .*mass_flow: is -2', flow("values = [1, -2]")),
    (f'{AT}:5:1: factor.0: with "-0.9.*" the case is refused', ('design = "sobol"', *flow("range = [-1, 2]"))),
    (f"{AT}:7:1: factor.0.range: is not a range", ('design = "sobol"', *flow("range = [2, 1]"))),
    (f"{AT}:4:1: study.design: needs a range", ('design = "sobol"', *flow("values = [1, 2]"))),
    (f'{AT}:4:1: study.design: is "random", allowed: one of', ['design = "random"']),
    (f"{AT}:4:1: study.set: gas.foo=1: gas.foo: unknown key", ['set = ["gas.foo=1"]']),
    (f"{AT}:4:1: study.unset: gas.foo: the case has no such key", ['unset = ["gas.foo"]']),
    (f"{AT}:4:1: study.seeds: perturb the nodes of a membrane, but the scene has none", ["seeds = 4"]),
    (f"{AT}:6:1: factor.0.values: is not an array with at least one value", flow("values = []")),
    (f'{AT}:4:1: factor.0: has the level "1" twice', flow("values = [1, 1.0]")),
    (rf"{AT}:5:1: factor.0.kye: unknown key, .*; is 'key' meant\?", ["[[factor]]", 'kye = "inflator.0.mass_flow"']),
    ('stop.quantity: is "mass", allowed: one of the study\'s quantities pressure_Pa', ["[stop]", 'quantity = "mass"']),
    ('analysis.base.factor: is "x", but the plan has no factors', ["[analysis]", 'base = { factor = "x", level = "y" }']),
    ('analysis.base.factor: is "x", allowed: one of the factors inflator.0.mass_flow$',
     (*flow("values = [1, 2]"), "[analysis]", 'base = { factor = "x", level = "y" }')),
    # An analysis that cannot be made of the points.
    (f"{AT}:8:1: analysis.response_surface: of 1 factors has 3 terms and needs 4 points or more, the plan has 3",
     (*flow("values = [1, 2, 3]"), *SURFACE)),
    (f"{AT}:5:1: analysis.response_surface: needs factors", SURFACE),
    ("analysis.response_surface: has 10 terms that the points do not distinguish: use three",
     (*flow("values = [1, 2]"), *HEAT, *factor("tank.volume", "values = [1, 2, 3]"), *SURFACE)),
    ("analysis.convergence: needs 3 points or more that differ in the size only",
     ('design = "list"', *flow("values = [1, 1.5, 2]"), *HEAT, "[analysis]", 'convergence = "inflator.0.temperature"')),
    (f"{AT}:12:1: analysis.base: pairs no points: it needs two that differ in inflator.0.temperature only",
     ('design = "list"', *flow("values = [1, 1.5, 2]"), *HEAT, "[analysis]", 'base = { factor = "inflator.0.temperature", level = "400" }')),
    ('analysis.base.level: is "40", which the factor does not have: it has "300", "400", "500"',
     ('design = "list"', *flow("values = [1, 1.5, 2]"), *HEAT, "[analysis]", 'base = { factor = "inflator.0.temperature", level = "40" }')),
    ("analysis.response_surface: needs factors that are numbers, way has levels", ("[[factor]]", 'name = "way"', *level("a"), *level("b"), *SURFACE)),
    (f"{AT}:5:1: study.points: is 7, allowed: a whole number from 8 to 1000000", ('design = "sobol_indices"', "points = 7", *flow("range = [1, 2]"))),
    # Columns and keys are each of one factor.
    *((f'{AT}:6:1: factor.0.name: is "{name}", which is another column of the results', flow(f'name = "{name}"', "values = [1, 2]"))
      for name in ("seed", "quantity", "standard_error", "runs", "pressure_Pa")),
    (f"{AT}:8:1: factor.1.key: sets again what inflator.0.mass_flow sets", (*flow("values = [1, 2]"), *flow('name = "again"', "values = [3, 4]"))),
    # Larger than memory is.
    ("study.design: has 16000000 points or more of 1 runs each, allowed: at most 10000000 runs",
     (*flow(f"values = {list(range(1, 4001))}"), *factor("inflator.0.temperature", f"values = {list(range(300, 4300))}"))),
    *((f'{AT}:4:1: study.name: is ".*", allowed: a file name', [f'name = "{name}"'])
      for name in ("../x", "/x", "a/b", ".", "..", "", r"a\nb", "x" * 256)),
    (f"{AT}:4:1: study.unknown: unknown key", ["unknown = 1"]),
    (f"{AT}:6:1: factor.0.level.0: has seeds or an amplitude, which need study.seeds", ("[[factor]]", 'name = "a"', *level("b", "seeds = 2"))),
], ids=lambda value: value[:50] if isinstance(value, str) else "")
def test_study_bad(says, lines):
    tank_plan(*lines)
    refused(says, "study run plan.toml --out none")


def test_study_bad_seeds():
    plan('quantities = ["peak_pressure_Pa"]', "seeds = 1000000", 'design = "sobol_indices"', "points = 8",
         *factor("gas.initial.temperature", "range = [290, 300]"), case="cases/sphere_inflation.toml")
    refused("study.design: has 24 points or more of 1000000 runs each", "study run plan.toml --out none")
    bag_plan(4, "[stop]", 'quantity = "peak_pressure_Pa"', "standard_error = 1")
    for setting, says in (("seeds = 5", "factor.0.level.0.seeds: is 5, allowed: a whole number from 1 to 4"),
                          ('set = ["membrane.perturbation=1e-3"]', 'level.0.set: has "membrane.perturbation=1e-3", but seeds set the perturbation'),
                          ("seeds = 2", 'stop: decides on seeds, but the level "yes" has some of its own')):
        change("plan.toml", ('^name = "yes"', rf"\g<0>\n{setting}"), to="bad.toml")
        refused(says, "study run bad.toml --out none")


def test_study_bad_folders():
    plan('quantities = ["final_angle_rad"]')
    refused('plan.toml:3:1: study.quantities: has "final_angle_rad", which the scene does not have', "study run plan.toml --out none")
    plan(case="none.toml")
    refused("none.toml: no such file", "study run plan.toml --out none")
    tank_plan()
    for share in ("0/3", "4/3", "1", "1/0", "a/b", "1/2/3"):
        refused(f"--share {share}: is not NUMBER/COUNT", f"study run plan.toml --share {share}")
    for command in ("study run", "ladder --quantity pressure", "ensemble", "cost"):
        refused("/dev/null: is not a regular file: .* copy it to a file first", f"{command} /dev/null --out none")
    refused("has no plan.toml: name a folder of", "study merge cases")
    expect(0, "1 points, 0 factors, 1 runs", "study run plan.toml --check")
    # One folder, one plan.
    ok("study run plan.toml --out one")
    tank_plan(*flow("values = [0.1, 0.2]"), to="other.toml")
    expect(2, "is another plan than .*: name another folder", "study run other.toml --out one")
