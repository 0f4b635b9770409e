#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tries the mutations that random_mutations.py wrote, and keeps which test noticed each. Goes on where an earlier call ended.
usage: scripts/tests/score_mutations.py LIST RESULTS SCRATCH [--minutes N]
  LIST         lines of random_mutations.py
  RESULTS      CSV, one row a mutation: killed, survived or no_program (the compiler refuses it), and by which test
  SCRATCH      folder of a clone of HEAD and its build; a later call builds incrementally
  --minutes N  begin no mutation after so long
The four libraries are shared ones in that build, so that a mutant of a source is one library linked anew. Each test program runs
until its first failure, those first that noticed most so far for their time. A program that hangs has noticed."""

import argparse
import collections
import concurrent.futures
import csv
import json
import os
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
LIBRARIES = {"libgas": "gasjet_gas", "libmembrane": "gasjet_membrane", "libjet": "gasjet_jet", "libcoupling": "gasjet_coupling"}
OTHERS = {"libgas/src/tank_test/": "gasjet_tank_test", "libjet/src/visibility/tree.cpp": "gasjet_jet_tree"}
LONGEST = 300  # [s] of a test program whose time is not known; else ten times that, and half a minute
JOBS = os.cpu_count() or 1


def succeeds(*command, timeout=3600):
    try:
        return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              timeout=timeout).returncode == 0
    except subprocess.TimeoutExpired:
        return False


class Tests:
    """Test programs of the folders of verification/."""

    def __init__(self, build):
        self.build = build
        self.noticed, self.seconds, self.whole, self.programs = collections.Counter(), {}, {}, {}

    def of(self, family):
        if family not in self.programs:
            listed = subprocess.run(["ctest", "--test-dir", self.build / "verification" / family, "-L", "fast", "--show-only=json-v1"],
                                    capture_output=True, text=True, check=True).stdout
            commands = [test.get("command", []) for test in json.loads(listed)["tests"]]
            self.programs[family] = list(dict.fromkeys(c[0] for c in commands if any("gtest" in word for word in c)))
        return sorted(self.programs[family], key=lambda p: -(self.noticed[p] + 1) / (self.seconds.get(p, 1.0) + 0.05))

    def passes(self, program):
        start = time.monotonic()
        longest = min(LONGEST, 30 + 10 * self.whole.get(program, LONGEST))
        passed = succeeds(program, "--gtest_fail_fast", "--gtest_brief=1", timeout=longest)
        self.seconds[program] = time.monotonic() - start
        if passed:
            self.whole[program] = self.seconds[program]
        return passed

    def first_failure(self, family):
        programs = self.of(family)
        with concurrent.futures.ThreadPoolExecutor(JOBS) as pool:
            for i in range(0, len(programs), JOBS):  # a program that fails spares those behind it
                some = programs[i:i + JOBS]
                for program, passed in zip(some, pool.map(self.passes, some)):
                    if not passed:
                        self.noticed[program] += 1
                        return os.path.basename(program)
        rest = ["ctest", "--test-dir", self.build / "verification" / family, "-L", "fast", "-E", "^[A-Za-z_/]+[.]", "--stop-on-failure",
                "--timeout", str(LONGEST), "--no-tests=ignore", f"-j{JOBS}"]
        return "" if succeeds(*rest) else f"ctest of {family}"


def prepare(scratch):
    source, build = scratch / "source", scratch / "build"
    if not source.exists():
        subprocess.run(["git", "clone", "-q", ROOT, source], check=True)
        rule = source / "cmake/GasjetLibrary.cmake"
        rule.write_text(rule.read_text().replace("add_library(${target} STATIC", "add_library(${target} SHARED"))
    if not (build / "build.ninja").exists():
        subprocess.run(["cmake", "-S", source, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1",
                        "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=10", "-DGASJET_BENCHMARKS=OFF",
                        "-DGASJET_BINDINGS=OFF", "-DGASJET_INSTALL=OFF"], check=True, stdout=subprocess.DEVNULL)
    if not succeeds("cmake", "--build", build, f"-j{JOBS}"):
        sys.exit(f"score_mutations.py: {build} cannot be built")
    return source, build


def build_mutant(build, file, families):
    top = file.split("/")[0]
    everything = ["gasjet"] + [f"verification/{family}/all" for family in families]
    other = [target for begin, target in OTHERS.items() if file.startswith(begin)]
    few = other or [LIBRARIES[top]] if top in LIBRARIES and file.endswith(".cpp") else everything
    return succeeds("cmake", "--build", build, f"-j{JOBS}", "--target", *few)


def try_one(source, build, tests, families, file, expression):
    path = source / file
    before = path.read_bytes()
    subprocess.run(["sed", "-i", "-e", expression, path], check=True)
    if path.read_bytes() == before:
        sys.exit(f"score_mutations.py: {file}: {expression} changes nothing: the list is of another commit")
    try:
        if not build_mutant(build, file, families):
            return "no_program", ""
        for family in families:
            if by := tests.first_failure(family):
                return "killed", by
        return "survived", ""
    finally:
        path.write_bytes(before)


def print_score(rows):
    counts = collections.Counter(row["verdict"] for row in rows)
    tried = counts["killed"] + counts["survived"]
    print(f"{counts['killed']} of {tried} noticed" + (f", {100 * counts['killed'] / tried:.1f} %" if tried else "") +
          f"; {counts['no_program']} that do not compile")
    for row in rows:
        if row["verdict"] == "survived":
            print(f"survived: {row['file']}: {row['expression']}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    for name in ("list", "results", "scratch"):
        parser.add_argument(name, type=pathlib.Path)
    parser.add_argument("--minutes", type=float, default=float("inf"))
    options = parser.parse_args()
    end = time.monotonic() + 60 * options.minutes
    options.scratch.mkdir(parents=True, exist_ok=True)
    source, build = prepare(options.scratch.resolve())
    tests = Tests(build)
    columns = ["verdict", "by", "seconds", "file", "expression"]
    if not options.results.exists():
        options.results.write_text(",".join(columns) + "\n")
    rows = list(csv.DictReader(options.results.open()))
    known = {(row["file"], row["expression"]) for row in rows}
    for line in options.list.read_text().splitlines():
        families, file, expression = line.split("\t")
        if (file, expression) in known or time.monotonic() > end:
            continue
        start = time.monotonic()
        verdict, by = try_one(source, build, tests, families.lstrip("@").split(), file, expression)
        row = dict(zip(columns, [verdict, by, f"{time.monotonic() - start:.0f}", file, expression]))
        rows.append(row)
        with options.results.open("a", newline="") as out:
            csv.DictWriter(out, columns).writerow(row)
    print_score(rows)


if __name__ == "__main__":
    main()
