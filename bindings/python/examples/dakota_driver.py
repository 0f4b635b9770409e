#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A driver for Dakota's fork interface: one evaluation is the mean over the seeds of a study with one point.

usage: dakota_driver.py CASE QUANTITY SEEDS PARAMETERS RESULTS

PARAMETERS is what Dakota writes in its standard format: `VALUE NAME` lines, where each name is a key of the case.
RESULTS gets the mean, for Dakota to read. A case that is refused or fails gives the word FAIL, which Dakota captures.
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

case, quantity, seeds, parameters, results = sys.argv[1:6]
words = [line.split() for line in open(parameters, encoding="utf-8")]
count = next(int(w[0]) for w in words if w[1:2] == ["variables"])
first = next(i for i, w in enumerate(words) if w[1:2] == ["variables"]) + 1
changes = ["%s=%s" % (name, value) for value, name in words[first:first + count]]

with tempfile.TemporaryDirectory() as folder:
    plan = pathlib.Path(folder, "plan.toml")
    plan.write_text("[study]\ncase = %s\nset = %s\nquantities = [%s]\nseeds = %d\n" % (
        json.dumps(str(pathlib.Path(case).resolve())), json.dumps(changes), json.dumps(quantity), int(seeds)), encoding="utf-8")
    run = subprocess.run(["gasjet", "study", "run", str(plan), "--out", folder + "/out", "--quiet"], check=False)
    answer = "FAIL"
    if run.returncode == 0:
        rows = [line for line in open(folder + "/out/means.csv", encoding="utf-8") if not line.startswith("#")]
        answer = next(csv.DictReader(rows))["mean"]
pathlib.Path(results).write_text("%s %s\n" % (answer, quantity), encoding="utf-8")
