# SPDX-License-Identifier: Apache-2.0
"""Tables that the programs of benchmarks/ measure. Times are CPU time on one core; some twenty minutes in all, on an idle machine.
  gas, tank_test, bag   work against precision
  jet_fidelity          error of the jet force against cost for each rung of the hidden-element test, on the paper's scene
  jet_overhead          single stages of the jet from 700 to a million elements, folded and inflated, each visibility route and
                        Embree side by side in one process
  membrane              one step of the bag in cache and from memory. Bytes are those that a step must move for each element, held
                        against what a copy of memory moves in the same run
  stability             maps of the stability atlas: stable or not over two parameters, each point a run, beside the formula
Each gives {name: (text of the CSV file, what its picture is drawn by)}."""
import csv
import os
import re
import subprocess

from common import ROOT, gnuplot_text, machine, output, provenance


def build(*targets):
    output(ROOT / "scripts/setup_debian12.sh", "libsundials-dev", "libembree-dev")  # the peers
    output("cmake", "--preset", "release", cwd=ROOT)
    output("cmake", "--build", "--preset", "release", "--target", *targets, "-j", os.cpu_count(), cwd=ROOT)


def program(name, *arguments):
    return output(ROOT / "build/benchmarks" / name, *arguments, cwd=ROOT, stderr=subprocess.DEVNULL)


def benchmark_rows(text):
    """The rows of a google-benchmark program without its means and those that failed."""
    rows = csv.DictReader(text[text.index("name,"):].splitlines())
    return [row for row in rows if row["error_occurred"] != "true" and not re.search("_(mean|median|stddev|cv)$", row["name"])]


def measured(rows, counters):
    """A line for each benchmark: the parts of its name, its least CPU time [us] over the repetitions, and these counters."""
    least = {}
    for row in rows:
        name = re.sub("/(iterations|repeats|min_time):.*", "", row["name"]).replace("/", ",")
        if name not in least or float(row["cpu_time"]) < float(least[name]["cpu_time"]):
            least[name] = row
    return [",".join([name, f"{float(row['cpu_time']) / 1e3:.4g}", *(f"{float(row[counter]):.4g}" for counter in counters)])
            for name, row in least.items()]


def measure(name, repetitions, seconds, notes, columns, counters):
    """The table of a google-benchmark program: repetitions of so many seconds each."""
    build(name, "gasjet")
    text = program(name, "--benchmark_format=csv", f"--benchmark_repetitions={repetitions}", f"--benchmark_min_time={seconds}")
    lines = [*(f"# {note}" for note in notes), columns, *measured(benchmark_rows(text), counters)]
    return provenance("one used") + "\n".join(lines) + "\n"


def gas():
    note = "CPU time: least mean of 5 times 20 ms; error: largest relative one of p and T (tiny volume: of p - p_a and T)"
    return {"gas_work_precision": (measure("gas_tank_benchmark", 5, 0.02, [note], "problem,solver,tolerance,cpu_us,error,evaluations,substeps",
                                           ["error", "evaluations", "substeps"]), {})}


def tank_test():
    notes = ["8 records; CPU time of one analysis, mean; error: r.m.s. over the points that are not masked, of the mass flow over its mean",
             "(average: of the product mdot T_s) and of the temperature (average: of the mean)"]
    return {"tank_test_work_precision": (measure("tank_test_benchmark", 1, 0, notes, "method,noise,readings,cpu_us,flow_error,temperature_error",
                                                 ["flow_error", "temperature_error"]), {})}


def bag():
    note = "two periods; CPU time: least of 5; error of the frequency against the closed form"
    return {"bag_work_precision": (measure("bag_benchmark", 5, 0, [note], "scene,mesh,share_of_critical_step,cpu_us,error,elements,steps",
                                           ["error", "elements", "steps"]), {})}


def jet_fidelity():
    build("jet_fidelity")
    return {"jet_fidelity": (machine("one thread used") + program("jet_fidelity"), {})}


def jet_overhead():
    build("jet_overhead")
    return {"jet_overhead": (machine("one thread used") + program("jet_overhead"), {})}


def membrane_lines(rows):
    copy, least = 0.0, {}
    for row in rows:
        if row["name"].startswith("BM_copy"):
            copy = max(copy, 0.3 / (float(row["cpu_time"]) * 1e-3))  # 150 MB read, 150 written
            continue
        key = int(float(row["elements"])), row["label"].replace(", woven", " woven")
        least.setdefault(key, []).append((float(row["cpu_time"]) * 1e6 / float(row["elements"]), row))
    for (elements, kernels), times in sorted(least.items()):
        time, element, node = min(time for time, _ in times), *(float(times[0][1][name]) for name in ("element_bytes", "node_bytes"))
        yield f"{elements},{kernels},{time:.1f},{element:.1f},{node:.1f},{element + node:.1f},{(element + node) / time:.1f},{copy:.1f}"


def membrane():
    build("gasjet", "membrane_benchmark")
    text = program("membrane_benchmark", "--benchmark_filter=BM_torus_step.*/threads:1/|BM_copy/150", "--benchmark_format=csv",
                   "--benchmark_repetitions=5", "--benchmark_min_time=0.05", "--benchmark_enable_random_interleaving=true")
    lines = ["# least processor time of 5 interleaved repetitions; bytes per element; copy: reads and writes of the fastest",
             "elements,kernels,ns_per_element,element_bytes,node_bytes,bytes,step_GB_s,copy_GB_s", *membrane_lines(benchmark_rows(text))]
    return {"membrane_cost": (provenance("one thread used") + "\n".join(lines) + "\n", None)}


def stability():
    build("stability_maps", "gasjet")
    tables = {}
    for name, label, formula, title in (
            ("sliver", "Shortest side over what it was", "bound of the step (M.12)", "A sliver in the mesh shortens the stable step"),
            ("gas", "Volume over that of the sphere", "bound of the step (M.12)", "A small volume of gas shortens the stable step"),
            ("lagged", "Time simulated [s]", "growth 1e5-fold by (M.20)", "A pressure that lags grows slowly at any step")):
        note = f"# points: {name}, stable over time (1) or grown 1e5-fold from a disturbance of 1e-10 (0); formula: {formula}\n"
        tables[f"stability_{name}"] = (provenance() + note + program("stability_maps", name),
                                       {"script": "stability_maps", "label": gnuplot_text(label), "formula": gnuplot_text(formula),
                                        "heading": gnuplot_text(title)})
    return tables


CHARTS = {chart.__name__: chart for chart in (gas, tank_test, bag, jet_fidelity, jet_overhead, membrane, stability)}
