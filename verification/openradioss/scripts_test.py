# SPDX-License-Identifier: Apache-2.0
"""run.py, where OpenRadioss is missing, and time_history.py, on a time history that is written here."""
import math
import struct
import sys
from pathlib import Path

import pytest
from command import ended, program, table, write

HERE = Path(__file__).resolve().parent
pytestmark = pytest.mark.usefixtures("work")


def test_scripts():
    for code, says, words in ((77, "no OpenRadioss starter", "no_starter no_engine"), (77, "no OpenRadioss engine", "/bin/true no_engine"),
                              (77, "", ""), (2, "", "--speed 1 /bin/true /bin/true"), (2, "", "--out")):
        ended(code, says, program(HERE / "run.py", *words.split()))
    ended(77, "no OpenRadioss starter", program(HERE / "read_decks.py"))


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
    write("histories.csv", ended(0, "", program(sys.executable, "-B", HERE / "time_history.py", path, *marks)).out)
    return table("histories.csv")


@pytest.mark.parametrize("order", "<>")
@pytest.mark.parametrize("code", [3040, 3041, 3050])
def test_scripts_time_history(order, code):
    Path("runT01").write_bytes(time_history(order, code))
    rows = table_of("runT01")
    assert len(rows) == STATES
    for i, row in enumerate(rows):
        (mass, volume, pressure), (turn, *acceleration), impulse = values_at(i)
        force = [(a - b) / 0.5 for a, b in zip(impulse, values_at(max(i - 1, 0))[2])]
        wanted = {
            "time": 0.5 * i, "MONV 1 MASS": mass, "MONV 1 VOL": volume, "MONV 1 P": pressure, "RBODY 5 RY": turn,
            "RBODY 5 AX": acceleration[0], "RBODY 5 A": math.hypot(*acceleration), "INTER 7 FNX": force[0],
            "INTER 7 F": math.hypot(force[0] + force[3], force[1] + force[4], force[2] + force[5])
        }
        assert {name: float(row[name]) for name in wanted} == pytest.approx(wanted, rel=1e-8)
    assert list(table_of("runT01", "MONV")[0]) == ["time", "MONV 1 MASS", "MONV 1 VOL", "MONV 1 P"]
