# SPDX-License-Identifier: Apache-2.0
"""How the cost of the paper's scene grows with its elements: each refinement cuts an element into four, up to 2.8 million. Whole runs as
long as they take less than a minute, which have every stage; beyond, some twenty steps alone, which have the skin's (S8, S9), the start and
the memory. Then the test for hidden elements alone, as the bag unfolds, beside its peers on the same meshes (`jet_overhead`). Lines of
growth.csv: CPU time and memory by elements, then the exponents between the first and the last of each column."""
import csv
import json
import math
import os
import subprocess

from benchmarks import build, program
from common import ROOT, gasjet

WORK = ROOT / "results/growth"
WHOLE, MOST = 2, 5  # refinements of whole runs, and of all
ROUTES = {"fast": "hidden_ms", "cgal_tree": "hidden_tree_ms", "embree": "hidden_embree_ms"}
LARGEST = 200_000  # elements with peers
FIRST_STEPS = 8e-4  # s of the scene on the shipped mesh; a finer one takes shorter steps
JET, STEP = ("S5_outlet", "S6_jet_field", "S7_visibility"), ("S8_advance", "S9_volume")


def measured(refine, *settings):
    """Summary of a run, its CPU seconds with the start, and its peak memory [kB]."""
    folder = WORK / str(refine)
    folder.mkdir(parents=True, exist_ok=True)
    words = [word for setting in (f"membrane.mesh.refine={refine}", "output.frames=0", *settings) for word in ("--set", setting)]
    process = subprocess.Popen([gasjet(), "run", "cases/passenger_pendulum.toml", "--out", folder, "--quiet", *words], cwd=ROOT, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if os.waitstatus_to_exitcode(status) not in (0, 3):  # 3: the energy of a few steps may not be judged
        raise SystemExit(f"growth: refine = {refine}: exit status {status}")
    return json.loads((folder / "summary.json").read_text(encoding="utf-8")), usage.ru_utime + usage.ru_stime, usage.ru_maxrss


def row_of(refine):
    first = FIRST_STEPS / 2**refine
    short, seconds, memory = measured(refine, f"scene.end_time={first}", f"output.history_every={first}")
    row = {"elements": 2744 * 4**refine, "start_s": seconds - short["cpu_s"], "memory_MB": memory / 1e3}
    run = measured(refine)[0] if refine <= WHOLE else short
    ms = {stage: 1e3 * value / run["steps"] for stage, value in run["stage_seconds"].items()}
    row["skin_ms"] = sum(ms[stage] for stage in STEP)
    if refine <= WHOLE:
        row |= {"step_ms": 1e3 * run["cpu_s"] / run["steps"], "jet_ms": sum(ms[stage] for stage in JET), "contact_ms": ms["S4_contact"],
                "steps": run["steps"], "run_s": run["cpu_s"]}
    return row


def hidden():
    """Of each number of elements, the time of the test for hidden elements by each route [ms]."""
    build("jet_overhead")
    times = {}
    for row in csv.DictReader(line for line in program("jet_overhead", LARGEST).splitlines() if not line.startswith("#")):
        if row["shape"] == "folded" and row["route"] in ROUTES:
            times.setdefault(int(row["elements"]), {})[ROUTES[row["route"]]] = float(row["visibility_us"]) / 1e3
    return times


def exponent(rows, column):
    first, *_, last = [row for row in rows if column in row]
    return math.log(last[column] / first[column]) / math.log(last["elements"] / first["elements"])


def lines():
    peers = hidden()
    rows = [row | peers.get(row["elements"], {}) for row in map(row_of, range(MOST + 1))]
    columns = list(rows[0])
    text = {int: str, float: "{:.4g}".format, type(None): lambda _: ""}
    yield ",".join(columns)
    for row in rows:
        yield ",".join(text[type(row.get(column))](row.get(column)) for column in columns)
    yield "exponent," + ",".join(f"{exponent(rows, column):.2f}" for column in columns[1:])
