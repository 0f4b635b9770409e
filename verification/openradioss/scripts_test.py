# SPDX-License-Identifier: Apache-2.0
"""Tests of run.sh, where OpenRadioss is missing, and of time_history.py, on a time history that is written here.

usage: scripts_test.py    exit code 1: a check fails
"""
import csv
import io
import math
import pathlib
import struct
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


def check(is_so, what):
    if not is_so:
        sys.exit(f"scripts_test.py: {what}")


def run_script(*arguments):
    return subprocess.run([HERE / "run.sh", *arguments], capture_output=True, text=True)


def check_run_script(folder):
    absent = run_script(folder / "no_starter", folder / "no_engine")
    check(absent.returncode == 77 and "no OpenRadioss starter" in absent.stderr, f"no starter: {absent}")
    engine = run_script("/bin/true", folder / "no_engine")
    check(engine.returncode == 77 and "no OpenRadioss engine" in engine.stderr, f"no engine: {engine}")
    check(run_script().returncode == 77, "no arguments")
    check(run_script("--speed", "1", "/bin/true", "/bin/true").returncode == 2, "unknown option")
    check(run_script("--out").returncode == 2, "an option without its value")


class History:
    """Records as the program writes them: each between two numbers that say how long it is, in the byte order asked for."""

    def __init__(self, order):
        self.order, self.data = order, b""

    def record(self, payload):
        length = struct.pack(self.order + "i", len(payload))
        self.data += length + payload + length

    def whole(self, *numbers, before=b""):
        self.record(before + struct.pack(f"{self.order}{len(numbers)}i", *numbers))

    def reals(self, *numbers):
        self.record(struct.pack(f"{self.order}{len(numbers)}f", *numbers))


BLOCKS = ((107, (1,), (1, 2, 3)), (103, (5,), (8, 25, 26, 27)), (101, (7,), (1, 2, 3, 4, 5, 6)))
STATES = 4


def values_at(i):
    """Of each block at the time 0.5 i, exact in four bytes: mass, volume, pressure; turn and acceleration; impulses."""
    return ((1.0 + i, 0.5 * i, 100.0 - i), (0.25 * i, 3.0, 4.0 * i, 12.0), (2.0 * i * i, 0.0, -4.0 * i, 0.0, 1.0 * i, 0.0))


def time_history(order, code):
    history = History(order)
    history.record(struct.pack(order + "i", code) + b" " * 80)
    history.record(b" " * 80)
    if code >= 3050:
        history.whole(1)
        history.record(b" " * 12)
    history.whole(1, 1, 1, 1, len(BLOCKS), 2)  # parts, materials, properties, subsets, groups, of the run
    history.whole(1, 2)
    history.record(b" " * 60 + struct.pack(order + "i", 2))  # a part with two variables
    history.whole(1, 2)
    for _ in range(2):
        history.record(b" " * 44)
    history.whole(1, 0, 0, 1, 0, before=b"")  # a subset with one part inside
    history.whole(1)
    for kind, ids, codes in BLOCKS:
        history.record(struct.pack(order + "5i", 1, kind, 0, len(ids), len(codes)) + b" " * 40)
        for number in ids:
            history.record(struct.pack(order + "i", number) + b" " * 40)
        history.whole(*codes)
    for i in range(STATES + 1):
        history.reals(0.5 * i)
        history.reals(1.0, 2.0)  # of the run
        history.reals(3.0, 4.0)  # of the parts
        for values in values_at(i):
            history.reals(*values)
    return history.data[:-10]  # in the last state the run was stopped


def table_of(path, *marks):
    done = subprocess.run([sys.executable, "-B", HERE / "time_history.py", path, *marks], capture_output=True, text=True)
    check(done.returncode == 0, f"{path}: {done}")
    return list(csv.DictReader(io.StringIO(done.stdout)))


def check_history(path):
    rows = table_of(path)
    check(len(rows) == STATES, f"{path}: {len(rows)} states")
    for i, row in enumerate(rows):
        (mass, volume, pressure), (turn, *acceleration), impulse = values_at(i)
        before = values_at(max(i - 1, 0))[2]
        force = [(a - b) / 0.5 for a, b in zip(impulse, before)]
        wanted = {
            "time": 0.5 * i, "MONV 1 MASS": mass, "MONV 1 VOL": volume, "MONV 1 P": pressure, "RBODY 5 RY": turn,
            "RBODY 5 AX": acceleration[0], "RBODY 5 A": math.hypot(*acceleration), "INTER 7 FNX": force[0],
            "INTER 7 F": math.hypot(force[0] + force[3], force[1] + force[4], force[2] + force[5])
        }
        for name, value in wanted.items():
            check(abs(float(row[name]) - value) <= 1e-8 * abs(value), f"{path}, state {i}: {name} is {row[name]} instead of {value}")
    check(list(table_of(path, "MONV")[0]) == ["time", "MONV 1 MASS", "MONV 1 VOL", "MONV 1 P"], f"{path}: marks")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        check_run_script(folder)
        for order in "<>":
            for code in (3040, 3041, 3050):
                path = folder / f"{'little' if order == '<' else 'big'}_{code}_T01"
                path.write_bytes(time_history(order, code))
                check_history(path)
    print("scripts_test.py: all as wanted")


if __name__ == "__main__":
    main()
