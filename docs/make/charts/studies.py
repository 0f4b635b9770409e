# SPDX-License-Identifier: Apache-2.0
"""The tables that charts.py makes of a study's means.csv and timing.csv: a function for each plan of cases/studies
whose table is not means.csv itself. Each gives the lines of a CSV file; levels NAME = VALUE are two columns, of
VALUE alone the second is `-`."""
import math

from common import ROOT, rows_of

EFFECTS = ("value,quantity,mean_jet,standard_error_jet,mean_no_jet,standard_error_no_jet,runs,difference,standard_errors,decided")


def numbers(row, *columns):
    return [float(row[column]) for column in columns]


def two_columns(level):
    name, equals, value = level.partition(" = ")
    return f"{name},{value}" if equals else f"{level},-"


def effects(means, level):
    """What the jet changes: means and standard errors with and without jet, fewest runs of both, difference, in standard
    errors, decided (more than 5 of them, at least 16 runs)."""
    yield f"{level},{EFFECTS}"
    level, with_jet = list(means[0])[1], {}
    for row in means:
        key = row[level], row["quantity"]
        if not row["mean"]:
            continue  # of an event that did not occur
        if row["jet"] == "with":
            with_jet[key] = row
        elif key in with_jet:
            mean, error, runs = numbers(with_jet[key], "mean", "standard_error", "runs")
            bare, its_error, its_runs = numbers(row, "mean", "standard_error", "runs")
            both, fewest = math.sqrt(error ** 2 + its_error ** 2), min(runs, its_runs)
            off = abs(mean - bare) / both if both > 0 else 0
            yield (f"{two_columns(row[level])},{row['quantity']},{mean:.6g},{error:.3g},{bare:.6g},{its_error:.3g},{fewest:.0f},"
                   f"{mean - bare:.6g},{off:.3g},{'yes' if off > 5 and fewest >= 16 else 'no'}")


def jet_map(means):
    return effects(means, "input")


def ensemble_convergence(means):
    return effects(means, "varied")


def impulse_limits(means):
    yield "varied,value,scene,quantity,mean,standard_error,runs"
    level = list(means[0])[1]
    for row in means:
        mean, error = numbers(row, "mean", "standard_error")
        yield f"{two_columns(row[level])},{row['scene']},{row['quantity']},{mean:.6g},{error:.3g},{row['runs']}"


def first_contact_seed(means):
    yield "elements,seed_m,first_contact_s,standard_error_s,runs"
    for row in means:
        mean, error = numbers(row, "mean", "standard_error")
        yield f"{row['elements']},{row['seed_m']},{mean:.6g},{error:.3g},{row['runs']}"


def mesh_parts(means):
    """A row for each mesh; its elements are counted in the file that charts.py has made."""
    yield "part,elements,contact_impulse_Ns,standard_error_Ns,final_angle_rad,standard_error_rad,runs"
    impulses = {row["part"]: row for row in means if row["quantity"] == "contact_impulse_Ns"}
    for row in means:
        if row["quantity"] == "final_angle_rad":
            mesh = (ROOT / f"results/studies/mesh_parts/{row['part']}_design.obj").read_text(encoding="utf-8")
            elements = sum(line.startswith("f") for line in mesh.splitlines())
            impulse, its_error = numbers(impulses[row["part"]], "mean", "standard_error")
            angle, error = numbers(row, "mean", "standard_error")
            yield f"{row['part']},{elements},{impulse:.6g},{its_error:.3g},{angle:.6g},{error:.3g},{row['runs']}"


def weave(means):
    """A row for each bag; the pressure over the ambient 101325 Pa."""
    yield "fabric,refine,peak_overpressure_Pa,peak_volume_m3,peak_strap_force_N"
    value = {}
    for row in means:
        value[row["quantity"]] = float(row["mean"])
        if row["quantity"] == "max(strap_force_N)":
            yield (f"{row['fabric']},{row['refine']},{value['peak_pressure_Pa'] - 101325:.6g},{value['peak_volume_m3']:.6g},"
                   f"{value['max(strap_force_N)']:.6g}")


def runs_needed(means):
    """Scatter: standard deviation of a run; runs_for_1_percent: for two standard errors of 1 % of the mean; runs_for_effect: of
    5 % of the difference; two at least, since one has no standard error."""
    def needed(runs, ratio):
        return max(2, math.ceil(runs * ratio * ratio))
    yield "friction,jet,quantity,mean,scatter,runs,runs_for_1_percent,runs_for_effect"
    for row in means:
        mean, error, runs = numbers(row, "mean", "standard_error", "runs")
        effect = ""
        if row["difference"]:
            difference, its_error, pairs = numbers(row, "difference", "difference_standard_error", "pairs")
            effect = needed(pairs, 2 * its_error / (0.05 * difference))
        yield (f"{row['friction']},{row['jet']},{row['quantity']},{mean:.6g},{error * math.sqrt(runs):.3g},{row['runs']},"
               f"{needed(runs, 2 * error / (0.01 * mean))},{effect}")


def seconds_of(timing):
    """CPU time of a run of each point, the mean."""
    points = {}
    for row in timing:
        points.setdefault(row["point"], []).append(float(row["cpu_s"]))
    return {point: sum(times) / len(times) for point, times in points.items()}


def coupled_work_precision(means, timing):
    yield "# error: of the mean, against the last of the group (gas: of step), with its standard error"
    yield "varied,value,quantity,cpu_s,mean,standard_error,runs,error,error_standard_error"
    seconds, level = seconds_of(timing), list(means[0])[1]

    def group(row):
        return row[level].partition(" = ")[0], row["quantity"]
    last = {group(row): row for row in means}
    for row in means:
        best, its_error = numbers(last["step" if group(row)[0] == "gas" else group(row)[0], row["quantity"]], "mean", "standard_error")
        mean, error = numbers(row, "mean", "standard_error")
        yield (f"{two_columns(row[level])},{row['quantity']},{seconds[row['point']]:.4g},{row['mean']},{row['standard_error']},{row['runs']},"
               f"{abs(mean / best - 1):.3g},{math.sqrt(error ** 2 + its_error ** 2) / best:.3g}")


def speed_accuracy(means, timing):
    """The jet's effect; bias: less that of the finest meshes (limits in docs/charts/mesh_limits.csv), with its standard error;
    scatter of a pair of runs, with and without jet; CPU time [s] of a pair; pairs that a minute has, and the error of their mean:
    root of the squares of bias and standard error."""
    yield "variation,effect_rad,bias_rad,bias_error_rad,scatter_rad,cpu_s,pairs_in_a_minute,error_rad"
    limits = {row["scene"]: row for row in rows_of(ROOT / "docs/charts/mesh_limits.csv") if row["quantity"] == "final_angle_rad"}
    limit = float(limits["jet"]["limit"]) - float(limits["no_jet"]["limit"])
    limit_error = math.hypot(float(limits["jet"]["standard_error"]), float(limits["no_jet"]["standard_error"]))
    seconds, pair = seconds_of(timing), {}
    for row in means:
        pair[row["variation"]] = pair.get(row["variation"], 0) + seconds[row["point"]]
    for row in means:
        if row["jet"] == "with":
            size, error, pairs = numbers(row, "difference", "difference_standard_error", "pairs")
            scatter, bias, minute = error * math.sqrt(pairs), size - limit, int(60 / pair[row["variation"]])
            yield (f"{row['variation']},{size:.6g},{bias:.4g},{math.hypot(error, limit_error):.3g},{scatter:.4g},{pair[row['variation']]:.4g},"
                   f"{minute},{math.sqrt(bias ** 2 + scatter ** 2 / minute):.4g}")


def inflator_tolerances(folder):
    """A row for each quantity: its spread, and the share of the variance that each factor explains alone."""
    spread, effects = rows_of(folder / "spread.csv"), rows_of(folder / "effects.csv")
    factors = list(dict.fromkeys(row["factor"] for row in effects))
    statistics = ("mean", "standard_deviation", "percentile_5", "percentile_95")
    yield ",".join(["quantity", *statistics, *(f"{factor}_share" for factor in factors), "runs"])
    for quantity in dict.fromkeys(row["quantity"] for row in effects):
        values = {row["statistic"]: row for row in spread if row["quantity"] == quantity}
        shares = {row["factor"]: row["share"] for row in effects if row["quantity"] == quantity}
        yield ",".join([quantity, *(f"{float(values[name]['value']):.5g}" for name in statistics),
                        *(f"{float(shares[factor]):.3g}" for factor in factors), values["mean"]["runs"]])


PLANS = {plan.__name__: plan for plan in (jet_map, ensemble_convergence, impulse_limits, first_contact_seed, mesh_parts, weave, runs_needed)}
SPREADS = {plan.__name__: plan for plan in (inflator_tolerances,)}
TIMED = {plan.__name__: plan for plan in (coupled_work_precision, speed_accuracy)}


def table(name, folder):
    """The lines of the table of a study in this folder."""
    if name in PLANS:
        return list(PLANS[name](rows_of(folder / "means.csv")))
    if name in SPREADS:
        return list(SPREADS[name](folder))
    if name in TIMED:
        return list(TIMED[name](rows_of(folder / "means.csv"), rows_of(folder / "timing.csv")))
    file = folder / ("sobol.csv" if name == "what_to_measure" else "means.csv")
    return [line for line in file.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
