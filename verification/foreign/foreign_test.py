#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the inputs of others: each folder here with an expect.toml, and checks what the file says.

usage: foreign_test.py GASJET SOURCE_DIR [FOLDER...]

The commands of a folder run one after the other in a scratch copy of it. README.md has the keys of expect.toml.
Prints the number of runs; exit 1 with a line for each expectation that does not hold.
"""

import concurrent.futures
import csv
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import tomllib

KEYS = {"command", "exit", "says", "says_not", "summary", "history", "file"}
SECONDS = 120  # of one command


def history_value(path, row):
    """The value of a column at a time, or in the last row."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    if row["at"] == "last":
        return float(rows[-1][row["column"]])
    return next(float(r[row["column"]]) for r in rows if abs(float(r["time_s"]) - row["at"]) < 1e-9)


def faults_of_results(run, folder):
    """Expectations of the result folder and of files that do not hold."""
    if run.get("summary"):
        summary = json.loads((folder / "out/summary.json").read_text())
        for path, wanted in run["summary"].items():
            value = summary
            for key in path.split("."):
                value = value[int(key)] if isinstance(value, list) else value[key]
            if not (wanted[0] <= value <= wanted[1] if isinstance(wanted, list) else value == wanted):
                yield f"summary.json: {path} is {value}, wanted {wanted}"
    for row in run.get("history", []):
        value = history_value(folder / "out/history.csv", row)
        if not abs(value - row["value"]) <= row["rel"] * abs(row["value"]) + row.get("abs", 0.0):
            yield f"history.csv: {row['column']} at {row['at']} is {value}, wanted {row['value']}"
    for file in run.get("file", []):
        text = (folder / file["name"]).read_text(errors="replace")
        for pattern in file["has"]:
            if not re.search(pattern, text, re.MULTILINE):
                yield f"{file['name']}: lacks /{pattern}/"


def faults_of(run, folder, gasjet, root):
    """All expectations of a run that do not hold."""
    if unknown := set(run) - KEYS:
        return [f"expect.toml: unknown keys {sorted(unknown)}"]
    words = shlex.split(run["command"].replace("{root}", str(root)))
    if words[0] == "run" and "--out" not in words:
        words += ["--out", "out"]
    try:
        done = subprocess.run([gasjet, *words], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return [f"not done after {SECONDS} s"]
    text = (done.stdout + done.stderr).decode(errors="replace")
    wanted = run.get("exit", 0)
    faults = [f"exit code {done.returncode}, wanted {wanted}"] if done.returncode != wanted else []
    faults += [f"does not say /{p}/" for p in run.get("says", []) if not re.search(p, text, re.MULTILINE)]
    faults += [f"says /{p}/" for p in run.get("says_not", []) if re.search(p, text, re.MULTILINE)]
    try:
        faults += faults_of_results(run, folder)
    except (OSError, KeyError, IndexError, StopIteration, ValueError) as error:
        faults.append(f"no such result: {error!r}")
    return faults and [*faults, "it said: " + text[-600:].strip()]


def faults_in(folder, gasjet, root):
    """The number of runs of a folder, and its faults with their command."""
    expected = tomllib.loads((folder / "expect.toml").read_text())
    faults = [f"{folder.name}: expect.toml lacks {key}" for key in ("source", "licence", "run") if not expected.get(key)]
    with tempfile.TemporaryDirectory() as scratch:
        copy = pathlib.Path(scratch, folder.name)
        shutil.copytree(folder, copy)
        for run in expected.get("run", []):
            shutil.rmtree(copy / "out", ignore_errors=True)
            faults += [f"{folder.name}: {run['command']}: {fault}" for fault in faults_of(run, copy, gasjet, root)]
    return len(expected.get("run", [])), faults


def main():
    gasjet, root = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    folders = sorted(p.parent for p in (root / "verification/foreign").glob("*/expect.toml"))
    if wanted := sys.argv[3:]:
        folders = [f for f in folders if f.name in wanted]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(lambda folder: faults_in(folder, gasjet, root), folders))
    for _, faults in results:
        for fault in faults:
            print(fault)
    runs = sum(count for count, _ in results)
    print(f"{runs} runs of {len(folders)} folders, {sum(bool(f) for _, f in results)} folders with faults")
    sys.exit(1 if runs == 0 or any(f for _, f in results) else 0)


if __name__ == "__main__":
    main()
