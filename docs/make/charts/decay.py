# SPDX-License-Identifier: Apache-2.0
"""Tables of measured jets beside Witze's law and the model: the centreline of docs/data/jet_centreline.csv, and the widths of
docs/data/jet_half_width.csv. Velocities are over that of the outlet, distances over its diameter."""
import csv
import math

from common import ROOT, gasjet, output, provenance, rows_of

COEFFICIENTS = ("0.044", "0.066", "0.08")  # a cold sonic jet's, and those of outlet_type
TRIED = [round(0.001 * thousandths, 3) for thousandths in range(30, 121)]  # for the one that fits best
RANGES = ((2, 10), (6, 20))                # that it is fitted over
RULE = 0.057                               # a = RULE (1 - 0.16 M)/sqrt(density ratio): a fit to these three jets


def exact(name, column, **settings):
    """A column of a closed form, by distance: 1 to 20 diameters in steps of a half."""
    options = [f"--set={key}={value}" for key, value in settings.items()]
    said = output(gasjet(), "exact", name, "--times", "1:20:0.5", *options).splitlines()
    rows = csv.DictReader(line for line in said if not line.startswith("#"))
    return {float(row[rows.fieldnames[0]]): float(row[column]) for row in rows}


def model(a):
    return exact("round_jet", "centreline_velocity_m_s", radius=0.5, spread=a, outlet_velocity=1)


def witze(mach, density_ratio):
    return exact("witze_decay", "centreline_ratio", mach=mach, density_ratio=density_ratio)


def measured():
    """Of each set point: Mach number, density ratio, and velocity by distance."""
    points = {}
    for row in rows_of(ROOT / "docs/data/jet_centreline.csv"):
        key = row["set_point"], row["mach"], row["density_ratio"]
        points.setdefault(key, {})[float(row["x_over_d"])] = float(row["u_over_uj"])
    return points


def off(law, velocity, low, high):
    """Root mean square of the relative differences over a range of distances."""
    squares = [(law[x] / u - 1) ** 2 for x, u in velocity.items() if low <= x <= high]
    return math.sqrt(sum(squares) / len(squares))


def centreline():
    models = [model(a) for a in COEFFICIENTS]
    yield "set_point,x_over_d,measured,witze," + ",".join(f"a_{a}" for a in COEFFICIENTS)
    for (name, mach, density_ratio), velocity in measured().items():
        law = witze(mach, density_ratio)
        for x, u in velocity.items():
            yield f"{name},{x:g},{u:g},{law[x]:.4f}," + ",".join(f"{one[x]:.4f}" for one in models)


def fits():
    """Root mean squares over each range: of Witze's law, the best coefficient, that of the rule, and COEFFICIENTS. slope_a: the
    coefficient whose V0/Vmax grows as measured from 15 to 20 diameters, by a/0.48 a diameter."""
    models = {a: model(a) for a in TRIED}
    yield ("set_point,mach,density_ratio,from_d,to_d,off_witze,best_a,off_best,rule_a,off_rule,slope_a,"
           + ",".join(f"off_{a}" for a in COEFFICIENTS))
    for (name, mach, density_ratio), velocity in measured().items():
        law, rule = witze(mach, density_ratio), RULE * (1 - 0.16 * float(mach)) / math.sqrt(float(density_ratio))
        by_rule, slope = model(rule), 0.48 * (1 / velocity[20] - 1 / velocity[15]) / 5
        for low, high in RANGES:
            best = min(TRIED, key=lambda a: off(models[a], velocity, low, high))
            numbers = [off(models[float(a)], velocity, low, high) for a in COEFFICIENTS]
            yield (f"{name},{mach},{density_ratio},{low},{high},{off(law, velocity, low, high):.4f},{best:.3f},"
                   f"{off(models[best], velocity, low, high):.4f},{rule:.4f},{off(by_rule, velocity, low, high):.4f},{slope:.3f},"
                   + ",".join(f"{number:.4f}" for number in numbers))


def widths():
    """Half-velocity widths; the model's, sqrt(ln 2) R, of the momentum of the outlet at the measured velocity on the axis."""
    yield "set_point,density_ratio,x_over_d,measured,model,model_times_root_density_ratio"
    for row in rows_of(ROOT / "docs/data/jet_half_width.csv"):
        width = math.sqrt(math.log(2)) * math.sqrt(2) * 0.5 / float(row["u_over_uj"])
        yield (f"{row['set_point']},{row['density_ratio']},{row['x_over_d']},{row['half_width_over_d']},{width:.3f},"
               f"{width * math.sqrt(float(row['density_ratio'])):.3f}")


def tables():
    """By name: the CSV files of docs/charts."""
    made = {"jet_decay_sonic": centreline, "jet_decay_fits": fits, "jet_decay_widths": widths}
    return {name: provenance() + "".join(line + "\n" for line in lines()) for name, lines in made.items()}
