#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the shipped cases, long ones up to an earlier end, and compares the hashes of history.csv and energy.csv, without their
comments, with history_hashes.tsv.

A case has one hash, whatever the compiler and the processor are. So each program runs each case twice, the second time with
those functions of glibc that are for processors without AVX2 and FMA.
usage: history_hashes.py [--write] [--once] [--without REGEX] GASJET...
  --write          writes the rows of these cases, from the first program's runs
  --once           runs each case once, for a program that calls no glibc
  --without REGEX  leaves out the cases whose names match"""
import argparse
import concurrent.futures
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
CASES = HERE.parent.parent / "cases"
TABLE = HERE / "history_hashes.tsv"
HEAD = "# Of the lines without comments, the first 32 digits of SHA-256. history_hashes.py --write GASJET writes this file."
END_TIMES = {"passenger_letter": "0.0015", "driver_folded": "0.02"}  # [s] of cases whose whole runs take too long here
# By the names of glibc 2.33 and later, and by those before.
OLD_PROCESSOR = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX2_Usable,-FMA_Usable,-FMA4_Usable"}


def hash_of(file):
    lines = [line for line in file.read_bytes().splitlines(keepends=True) if not line.startswith(b"#")]
    return hashlib.sha256(b"".join(lines)).hexdigest()[:32]


def hashes_of(program, case, variables):
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out"
        shorter = ["--set", f"scene.end_time={END_TIMES[case]}"] if case in END_TIMES else []
        run = subprocess.run([program, "run", CASES / f"{case}.toml", "--quiet", "--out", out, *shorter],
                             env={**os.environ, **variables}, capture_output=True, text=True)
        if run.returncode != 0:
            return f"exit {run.returncode}: {run.stdout}{run.stderr}"
        return tuple(hash_of(out / name) for name in ("history.csv", "energy.csv"))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("programs", nargs="+", metavar="GASJET")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--once", action="store_true")
    parser.add_argument("--without", metavar="REGEX")
    arguments = parser.parse_args()
    cases = sorted(file.stem for file in CASES.glob("*.toml"))
    if arguments.without:
        cases = [case for case in cases if not re.search(arguments.without, case)]
    runs = [(str(pathlib.Path(program).resolve()), case, variables)
            for program in arguments.programs for variables in ([{}] if arguments.once else [{}, OLD_PROCESSOR]) for case in cases]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(lambda run: hashes_of(*run), runs))
    faults = [f"{case}: {result}" for (_, case, _), result in zip(runs, results) if isinstance(result, str)]
    table = [line.split("\t") for line in TABLE.read_text().splitlines()[2:]]
    expected = {case: tuple(hashes) for case, *hashes in table}
    if arguments.write and not faults:
        expected.update({case: result for (_, case, _), result in zip(runs[:len(cases)], results)})
        rows = ["\t".join((case, *hashes)) for case, hashes in sorted(expected.items())]
        TABLE.write_text("\n".join([HEAD, "case\thistory.csv\tenergy.csv", *rows]) + "\n")
    for (program, case, variables), result in zip(runs, results):
        if not isinstance(result, str) and result != expected.get(case):
            faults.append(f"{case}: {program}, {'old' if variables else 'this'} processor: other bits than in {TABLE.name}")
    if not arguments.without:
        faults += [f"{case}: in {TABLE.name}, but no case" for case in expected if case not in cases]
    print("\n".join(faults) or f"{len(cases)} cases, {len(runs)} runs: the same bits")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
