# SPDX-License-Identifier: Apache-2.0
"""Plans and cases of many runs, and their tables."""
from command import change, same, table, write

TANK, BAG, SPHERE = (f"cases/{name}.toml" for name in ("rigid_tank", "passenger_pendulum", "sphere_inflation"))


def plan(*lines, case=TANK, to="plan.toml"):
    """Lines for [study], then tables."""
    write(to, "[study]", f'case = "{case}"', *lines)


def tank_plan(*lines, **how):
    """A tank, whose closed form is known."""
    plan('quantities = ["pressure_Pa"]', *lines, **how)


def factor(key, *lines):
    return "[[factor]]", f'key = "{key}"', *lines


def flow(*lines):
    return factor("inflator.0.mass_flow", *lines)


def level(name, *lines):
    return "[[factor.level]]", f'name = "{name}"', *lines


def bag_plan(seeds, *lines, end=0.004, case=BAG, to="plan.toml"):
    """The paper's scene, short, with and without its jet."""
    plan(f'set = ["scene.end_time={end}"]', 'quantities = ["peak_pressure_Pa", "first_contact_s"]', f"seeds = {seeds}", "[[factor]]",
         'name = "jet"', *level("yes"), *level("no", 'unset = ["inflator.0.jet"]'), "[analysis.base]", 'factor = "jet"', 'level = "no"', *lines,
         case=case, to=to)


def euler_plan(*lines):
    """Fixed steps of the classical method, to their limit."""
    plan('set = ["gas.initial.pressure=101325.0", "scene.end_time=0.002", "time.gas_method=euler"]', 'quantities = ["pressure_Pa"]',
         *factor("time.gas_step", "values = [2e-4, 1e-4, 5e-5]"), "[analysis]", 'convergence = "time.gas_step"', *lines,
         case="cases/tank_fixed_steps.toml")


def unstable_plan():
    """Of two points the last is above the limit of its step."""
    plan('set = ["scene.end_time=1e-3"]', *factor("time.step", "values = [1e-5, 1e-3]"), case=SPHERE)


def same_study(a, b, *more):
    """Two folders have the same tables, but for what a build that is not committed says of itself."""
    same(a, b, "results.csv", "means.csv", *more, but="run")


def means_of(folder, quantity="peak_pressure_Pa"):
    """Rows of means.csv by their level of the jet."""
    return {row["jet"]: row for row in table(f"{folder}/means.csv") if row["quantity"] == quantity}


def write_slow():
    """Another case for `--against`."""
    change(SPHERE, ("^name = .*sphere.*", 'name = "slow"'), ("^mass_flow = .*", "mass_flow = 0.1"), to="slow.toml")


def rungs(folder):
    """Rows of a ladder without costs, and without what costs decide: the front."""
    rows = table(f"{folder}/ladder.csv")
    kept = [name for i, name in enumerate(rows[0], 1) if i <= 6 or i == 9 or i >= 11]
    return [[row[name] for name in kept] for row in rows]
