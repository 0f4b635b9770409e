# SPDX-License-Identifier: Apache-2.0
"""What means lead to: weighted fits mean = limit + change x^order, of two tables.

mesh: the means of the paper's scene as its mesh is refined; x is the element's side over that of 2744 elements, three meshes. Of
order 1 to 2 that one is taken which the impulse without jet, whose errors are the smallest, fits best. standard_error: of the
limit, that order's own included; scatter: at that order; half_of_orders: half of what the limit moves by from order 1 to 2;
its_error: scatter and that together. chi_squared: of that order, one degree of freedom (none for the impulse without jet: the
order is its own; the last row sums up the others). Files: ensemble_convergence.csv, first_contact_seed.csv, from which comes first
contact without jet, since it needs an amplitude in proportion to the elements.

impulse: limits of impulse_limits.csv; x is 1/stiffness, or step or element side over the shipped case's. order: the best from
0.5 (stiffness) or 1 (mesh) to 2, for the step 2, the scheme's; 1.5 of two meshes, which leave it open. order_low, order_high: the
orders whose chi_squared is within 1 of the best one's; low, high: the limits within 1, at any of these orders. chi_squared has
`degrees` degrees of freedom. chi_squared_constant: of no change at all; chi_squared_log: of a change with log2 x, which has no
limit, by per_doubling with its error. Rows one_step: chi_squared of the means at the shorter step against those of the same
stiffness."""
import math
from collections import namedtuple

from common import rows_of

Fit = namedtuple("Fit", "limit limit_error change change_error chi2 chi2_constant")


def fit(points, order):
    """Of points (x, mean, error); order 0: change by log2 x."""
    def power(x):
        return x ** order if order > 0 else -math.log(x) / math.log(2)
    s0 = s1 = s2 = t0 = t1 = 0.0
    for x, mean, error in points:
        w, y = 1 / error ** 2, power(x)
        s0, s1, s2, t0, t1 = s0 + w, s1 + w * y, s2 + w * y * y, t0 + w * mean, t1 + w * y * mean
    d = s0 * s2 - s1 * s1
    limit, change, constant = (t0 * s2 - t1 * s1) / d, (t1 * s0 - t0 * s1) / d, t0 / s0
    return Fit(limit, math.sqrt(s2 / d), change, math.sqrt(s0 / d), sum(((mean - limit - change * power(x)) / error) ** 2 for x, mean, error in points),
               sum(((mean - constant) / error) ** 2 for _, mean, error in points))


def orders(first, last):
    """In hundredths."""
    while first <= last:
        yield first
        first += 0.01


def mesh_limits(convergence, seed):
    """The lines of mesh_limits.csv, from the rows of the two tables."""
    points = {}

    def add(scene, quantity, elements, mean, error):
        side = 1 if elements < 5000 else 0.5 if elements < 20000 else 0.25
        points.setdefault((scene, quantity), []).append((side, float(mean), float(error)))
    for row in convergence:
        if row["varied"] == "mesh":
            add("jet", row["quantity"], int(row["value"]), row["mean_jet"], row["standard_error_jet"])
            if row["quantity"] != "first_contact_s":
                add("no_jet", row["quantity"], int(row["value"]), row["mean_no_jet"], row["standard_error_no_jet"])
    for row in seed:
        add("no_jet", "first_contact_s", int(row["elements"]), row["first_contact_s"], row["standard_error_s"])

    sharpest, step = points["no_jet", "contact_impulse_Ns"], 0.05
    p = min(orders(1, 2), key=lambda order: fit(sharpest, order).chi2)
    bend = fit(sharpest, p + step).chi2 - 2 * fit(sharpest, p).chi2 + fit(sharpest, p - step).chi2
    order_error, others = step * math.sqrt(2 / bend), 0.0  # chi2 grows by 1 over it
    yield ("scene,quantity,order,order_error,limit,scatter,standard_error,half_of_orders,shipped_less_limit,its_error,chi_squared,"
           "limit_at_order_1,limit_at_order_2,chi_squared_at_order_1,chi_squared_at_order_2")
    for key, values in points.items():
        if key[1] in ("peak_pressure_Pa", "peak_volume_m3", "peak_cg_acceleration_m_s2"):
            continue
        first, second, best = fit(values, 1), fit(values, 2), fit(values, p)
        half = (second.limit - first.limit) / 2
        slope = (fit(values, p + step).limit - fit(values, p - step).limit) / (2 * step)
        others += best.chi2 if values is not sharpest else 0
        yield (f"{','.join(key)},{p:.2f},{order_error:.2g},{best.limit:.6g},{best.limit_error:.2g},"
               f"{math.sqrt(best.limit_error ** 2 + (slope * order_error) ** 2):.2g},{half:.2g},{best.change:.4g},"
               f"{math.sqrt(best.change_error ** 2 + half ** 2):.2g},{best.chi2:.2g},{first.limit:.6g},{second.limit:.6g},{first.chi2:.2g},"
               f"{second.chi2:.2g}")
    yield f"both,the_others,{p:.2f},{order_error:.2g},,,,,,,{others:.3g},,,,"


def impulse_limit(varied, points):
    """The row of one quantity, without its names."""
    two = len(points) < 3
    first = {"step": 2, "mesh": 1}.get(varied, 0.5)
    fits = [(order, fit(points, order)) for order in orders(first, 2.005)]
    at, best = (1.5, 0) if two else min(((order, one.chi2) for order, one in fits), key=lambda pair: pair[1])
    close = [(order, one, one.limit_error * math.sqrt(best + 1 - one.chi2)) for order, one in fits if one.chi2 <= best + 1]
    low, high = min(one.limit - reach for _, one, reach in close), max(one.limit + reach for _, one, reach in close)
    straight, own = fit(points, 0), fit(points, at)
    degrees = 0 if two else len(points) - (3 if first < 2 else 2)
    return (f"{at:.2f},{close[0][0]:.2f},{close[-1][0]:.2f},{own.limit:.6g},{low:.6g},{high:.6g},{0 if two else own.chi2:.3g},{degrees},"
            f"{own.chi2_constant:.3g},{0 if two else straight.chi2:.3g},{straight.change:.3g},{straight.change_error:.2g}")


def impulse_limits(rows):
    """The lines of impulse_limits_fits.csv, from the rows of impulse_limits.csv."""
    points, means, one_step = {}, {}, {}
    for row in rows:
        name, value = (row["scene"], row["quantity"]), float(row["value"])
        mean, error = float(row["mean"]), float(row["standard_error"])
        if row["varied"] == "one_step":
            one_step[name, value] = mean, error
            continue
        size = {"contact": lambda: 1 / value, "step": lambda: value / 0.8}.get(row["varied"], lambda: math.sqrt(2744 / value))()
        points.setdefault((row["varied"], *name), []).append((size, mean, error))
        if row["varied"] == "contact":
            means[name, value] = mean, error
    yield ("varied,scene,quantity,order,order_low,order_high,limit,low,high,chi_squared,degrees,chi_squared_constant,chi_squared_log,"
           "per_doubling,error_per_doubling")
    for key, values in points.items():
        yield f"{','.join(key)},{impulse_limit(key[0], values)}"
        if key[0] == "contact":
            pairs = [(means[key[1:], value], one_step[key[1:], value]) for value in (1, 4)]
            chi2 = sum((a - b) ** 2 / (its ** 2 + other ** 2) for (a, its), (b, other) in pairs)
            yield f"one_step,{key[1]},{key[2]},,,,,,,{chi2:.3g},2,,,,"


def comments(path):
    return [line for line in path.read_text(encoding="utf-8").splitlines() if line.startswith("#")]


def of_mesh(folder):
    """The lines of mesh_limits.csv in this folder of charts."""
    convergence, seed = folder / "ensemble_convergence.csv", folder / "first_contact_seed.csv"
    its = [f"# first contact without jet:{line[1:]}" for line in comments(seed) if line.startswith("# gasjet")]
    return [*comments(convergence), *its, *mesh_limits(rows_of(convergence), rows_of(seed))]


def of_impulse(folder):
    """The lines of impulse_limits_fits.csv in this folder of charts."""
    table = folder / "impulse_limits.csv"
    return [*comments(table), *impulse_limits(rows_of(table))]
