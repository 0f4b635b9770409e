# SPDX-License-Identifier: Apache-2.0
"""Which errors the passenger references catch, and from how many runs on: puts each error of docs/make/charts/detection_changes.tsv into the
program's case (or source), makes 1, 2, 4, 8 and 16 runs with seeds of their own, and judges them by `gasjet compare`. Four such
tries of 1 to 4 runs, three of 8 and two of 16; caught are errors that all tries find outside.
Lines of detection.csv: error, reference, number of runs from which on it is caught (none: not by 16), and of those runs
the column that is farthest outside, in units of what band and chance allow. Runs are kept in results/detection, and not made again."""
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

from common import ROOT, gasjet, head_of, output

WORK = ROOT / "results/detection"
REFERENCES = ("passenger_jet", "passenger_sharp_jet")
TRIES = {1: 4, 2: 4, 4: 4, 8: 3, 16: 2}  # runs: tries


def whole(folder):
    """Its run has come to its end."""
    status = folder / "gasjet.status"
    return status.is_file() and re.search("^status: (done|inaccurate)", status.read_text(encoding="utf-8"), flags=re.M)


def history(program, case, folder, runs, seed, options, threads):
    """The file of this run, or of the mean of runs from this seed on; exit code 3: a run is inaccurate."""
    common = ["--quiet", "--threads", threads, "--set", "output.frames=0", *options]
    if runs == 1:
        file = folder / str(seed) / "history.csv"
        command = ["run", case, "--out", file.parent, "--set", "membrane.perturbation=1e-4", "--set", f"membrane.perturbation_seed={seed}"]
    else:
        file = folder / f"{runs}.{seed}" / pathlib.Path(case).stem / "ensemble.csv"
        command = ["ensemble", case, "--out", file.parents[1], "--runs", runs, "--first-seed", seed]
    if not whole(file.parent):
        output(program, *command, *common, allowed=(0, 3), cwd=ROOT)
    return file


def judge(file, reference):
    """The column that is farthest outside and its share, if there is one. Left out are the joint's force, which would tell the mass
    by which the contact force is scaled, and numbers of elements, which are not of physics."""
    verdict = json.loads(output(gasjet(), "compare", file, reference, "--format", "json", allowed=(0, 1, 4)))
    shares = [(1e9 if one["share_of_band"] is None else one["share_of_band"], name) for name, one in verdict["quantities"].items()
              if "outside" in one["verdict"] and not re.search("_elements$|joint_force", name)]
    return max(shares, key=lambda pair: pair[0], default=None)


def detect(program, folder, name, options, threads):
    """Runs, column, share of an error against a reference."""
    reference = ROOT / f"cases/reference/{name}.csv"
    for runs, tries in TRIES.items():
        for number in range(tries):
            file = history(program, head_of(reference)["case"], folder, runs, 10000 + 100 * runs + number * runs, options, threads)
            found = judge(file, reference)
            if not found:
                break
        if found:
            return runs, f"{found[1]},{found[0]:.2g}"
    return float("inf"), "—,"


def changed_program(folder, file, expression, threads):
    """A program with this change of the source, an expression of sed's."""
    tree = WORK / f"source.{folder}"
    program = tree / "build/gasjet"
    if not program.exists():
        tree.mkdir(parents=True, exist_ok=True)
        subprocess.run(f"git ls-files -z | xargs -0 cp --parents -t {shlex.quote(str(tree))}", shell=True, check=True, cwd=ROOT)
        output("sed", "-i", expression, tree / file)
        if (tree / file).read_bytes() == (ROOT / file).read_bytes():
            sys.exit(f"detection.py: the change of {file} does nothing")
        environment = {**os.environ, "CCACHE_BASEDIR": str(tree), "CCACHE_NOHASHDIR": "1"}
        output("cmake", "--preset", "release", "-DCMAKE_UNITY_BUILD=ON", cwd=tree, env=environment)
        output("cmake", "--build", "build", "--target", "gasjet", "-j", threads, cwd=tree, env=environment)
    return program


def lines(threads):
    WORK.mkdir(parents=True, exist_ok=True)
    found = {}  # of two signs of one error the one with more runs
    changes = (ROOT / "docs/make/charts/detection_changes.tsv").read_text(encoding="utf-8").splitlines()
    for number, line in enumerate((line for line in changes if not line.startswith("#")), 1):
        error, kind, *how = line.split("\t")
        folder = re.sub("[^a-zA-Z0-9]", "_", error) + str(number)
        program = changed_program(folder, *how, threads) if kind == "source" else gasjet()
        for reference in REFERENCES:
            this = (float("inf"), "not made,—,") if kind == "none" else detect(
                program, WORK / f"{folder}.{reference}", reference, how[0].split() if kind == "case" else [], threads)
            found[error, reference] = max(found.get((error, reference), (0, "")), this, key=lambda one: one[0])
            print(f"{error}, {reference}: {this[0]}, {this[1]}")
    yield "error,reference,caught_from_runs,column,share_of_chance"
    for (error, reference), (runs, column) in found.items():
        yield f"{error},{reference}," + (column if column.startswith("not made") else f"{'none' if runs == float('inf') else runs},{column}")
