#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Shows that the tests can fail: applies each mutation of a list to a copy of the work tree, one at a time, and expects its test to
turn red there.
usage: scripts/tests/mutate.py [--list FILE] [--only REGEX] [--scratch FOLDER] [--results CSV] [--minutes N]
  --list FILE       in place of verification/mutations.tsv: what scripts/tests/random_mutations.py wrote
  --only REGEX      only the lines of the list that match
  --scratch FOLDER  keep copy and build there; a later call builds incrementally
  --results CSV     keep the verdicts there, and which test noticed; a later call goes on where this one ended
  --minutes N       begin no mutation after so long
A line of a list names a test, a file and a sed expression. `@gas coupled` in place of a test: any fast test of these folders of
verification/. A test that hangs has noticed.
Exit code: 0 all mutations killed; 1 some survived or could not be tried; 2 bad arguments."""

import argparse
import csv
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
LONGEST = 300  # [s] of a test
JOBS = os.cpu_count() or 1
COLUMNS = ["verdict", "by", "seconds", "file", "expression"]


def output(*command):
    return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True).stdout


def succeeds(*command, timeout=3600):
    try:
        return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, timeout=timeout).returncode == 0
    except subprocess.TimeoutExpired:
        return False


class Copy:
    """Source, build and tests in the scratch folder."""

    def __init__(self, scratch):
        self.source, self.build = scratch / "source", scratch / "build"
        self.source.mkdir(parents=True, exist_ok=True)

    def update(self):
        """Touches only files that differ, so that a kept build stays incremental."""
        listed = output("git", "-c", "safe.directory=*", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard")
        names = {name for name in listed.split("\0") if name and (ROOT / name).is_file()}
        for path in self.source.rglob("*"):
            if path.is_file() and str(path.relative_to(self.source)) not in names:
                path.unlink()
        for name in names:
            content, path = (ROOT / name).read_bytes(), self.source / name
            if name == "cmake/GasjetLibrary.cmake":  # then a mutant of a library's source links no test anew
                content = content.replace(b"add_library(${target} STATIC", b"add_library(${target} SHARED")
            if not path.exists() or path.read_bytes() != content:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(content)
                shutil.copymode(ROOT / name, path)

    def configure(self):
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        return succeeds("cmake", "-S", self.source, "-B", self.build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DGASJET_WERROR=OFF",
                        "-DCMAKE_CXX_FLAGS_RELEASE=-O1", "-DCMAKE_UNITY_BUILD=OFF", "-DCMAKE_LINK_DEPENDS_NO_SHARED=ON", "-DGASJET_INSTALL=OFF",
                        *launcher)

    def make(self, *targets):
        return succeeds("cmake", "--build", self.build, f"-j{JOBS}", *(["--target", *targets] if targets else []))

    def targets(self, test):
        """What a build must have for the test."""
        if test.startswith("@"):
            return ["gasjet"] + [f"verification/{family}/all" for family in test[1:].split()]
        listed = json.loads(output("ctest", "--test-dir", self.build, "--show-only=json-v1", "-R", test))["tests"]
        words = {pathlib.Path(word) for one in listed for word in one.get("command", []) if os.access(word, os.X_OK)}
        return sorted(str(word.relative_to(self.build)) for word in words if word.is_file() and word.is_relative_to(self.build))

    def first_failure(self, test):
        """The name of a test that fails; empty: all pass. ctest begins with those that failed before."""
        selections = [(self.build / "verification" / family, "-L", "fast") for family in test[1:].split()]
        for folder, *which in selections if test.startswith("@") else [(self.build, "-R", test)]:
            failed = folder / "Testing/Temporary/LastTestsFailed.log"
            if not succeeds("ctest", "--test-dir", folder, *which, "--no-tests=error", "--stop-on-failure", "--timeout", str(LONGEST), f"-j{JOBS}"):
                return failed.read_text().split("\n")[0].partition(":")[2] if failed.exists() else test
        return ""


def try_mutation(copy, test, file, expression):
    """(verdict, by which test). The restored file is compiled with the next mutation."""
    path = copy.source / file
    if not path.is_file():
        return "no such file", ""
    before = path.read_bytes()
    try:
        if not succeeds("sed", "-i", "-e", expression, path):
            return "sed refuses the expression", ""
        if path.read_bytes() == before:
            return "sed changed nothing", ""
        if not copy.make(*copy.targets(test)):
            return "does not compile", ""
        by = copy.first_failure(test)
        return ("killed", by) if by else ("SURVIVED", "")
    finally:
        path.write_bytes(before)


def arguments():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1])
    parser.add_argument("--list", type=pathlib.Path, default=ROOT / "verification/mutations.tsv")
    parser.add_argument("--only", type=re.compile, default=re.compile(""))
    parser.add_argument("--scratch", type=pathlib.Path)
    parser.add_argument("--results", type=pathlib.Path)
    parser.add_argument("--minutes", type=float, default=float("inf"))
    options = parser.parse_args()
    if not options.list.is_file():
        parser.error(f"--list '{options.list}' is not a file")
    lines = [line for line in options.list.read_text().splitlines() if line.strip() and not line.startswith("#") and options.only.search(line)]
    if not lines:
        parser.error(f"no line of {options.list} matches --only '{options.only.pattern}'")
    return options, [line.split("\t")[:3] for line in lines]


def run(options, lines, scratch):
    copy = Copy(scratch)
    copy.update()
    if not copy.configure() or not copy.make():
        sys.exit(f"mutate.py: {copy.build}: the tree without mutation cannot be built")
    end, rows = time.monotonic() + 60 * options.minutes, []
    if options.results and options.results.exists():
        rows = list(csv.DictReader(options.results.open()))
    known = {(row["file"], row["expression"]) for row in rows}
    red = {test: copy.first_failure(test) for test in dict.fromkeys(line[0] for line in lines)}
    for test, file, expression in lines:
        if (file, expression) in known or time.monotonic() > end:
            continue
        start = time.monotonic()
        verdict, by = ("test fails or is missing without mutation", red[test]) if red[test] else try_mutation(copy, test, file, expression)
        print(f"{verdict:10} {test} | {file} | {expression}", flush=True)
        rows.append(dict(zip(COLUMNS, [verdict, by, f"{time.monotonic() - start:.0f}", file, expression])))
        if options.results:
            with options.results.open("w", newline="") as out:
                writer = csv.DictWriter(out, COLUMNS)
                writer.writeheader()
                writer.writerows(rows)
    killed = sum(row["verdict"] == "killed" for row in rows)
    tried = killed + sum(row["verdict"] == "SURVIVED" for row in rows)
    print(f"{killed} of {tried} mutations killed ({100 * killed / max(tried, 1):.1f} %), {len(rows) - tried} could not be tried")
    return 0 if killed == len(rows) == len(lines) else 1


def main():
    options, lines = arguments()
    with tempfile.TemporaryDirectory() as scratch:
        sys.exit(run(options, lines, (options.scratch or pathlib.Path(scratch)).resolve()))


if __name__ == "__main__":
    main()
