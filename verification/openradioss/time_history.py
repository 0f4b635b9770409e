# SPDX-License-Identifier: Apache-2.0
"""Time history of OpenRadioss (T01, as /TFILE/4 writes it) as CSV: time_history.py T01 [MARK...]

Forces of contacts, walls and bodies stand in the file as impulses since the start; here they are forces, mean ones since the
row before. A column is called by block, object and variable: `MONV 1 P`, `RBODY 1 VRY`. Magnitudes are added: `RBODY 1 A`, the acceleration,
and `INTER 1 F`, the force, normal and tangential part together. MARK keeps the columns that begin with it.
Numbers in the file have four bytes, so they are good to 6e-8. Units are those of the deck.
"""
import math
import struct
import sys

# Blocks by their kind in the file, and the variables of each by their number there, from 1.
KINDS = {0: "NODE", 101: "INTER", 102: "RWALL", 103: "RBODY", 104: "SECT", 107: "MONV"}
VARIABLES = {
    "NODE": "DX DY DZ VX VY VZ AX AY AZ X Y Z".split(),
    "INTER": "FNX FNY FNZ FTX FTY FTZ |FNX| |FNY| |FNZ| ||FN|| |FX| |FY| |FZ| ||F||".split(),
    "RWALL": "FNX FNY FNZ FTX FTY FTZ".split(),
    "RBODY": ("FX FY FZ MX MY MZ RX RY RZ FXI FYI FZI MXI MYI MZI X Y Z DX DY DZ VX VY VZ AX AY AZ VRX VRY VRZ "
              "ARX ARY ARZ MASS IXX IYY IZZ IXY IYZ IZX STATUS").split(),
    "MONV": "MASS VOL P A T AO UO AC UC CP CV GAMA DTBAG NFV MASS-IN ENTHA-IN ENER-INT WORK UPCRIT".split(),
}


class Reader:
    """Records, each between two numbers that say how long it is."""

    def __init__(self, data):
        self.data, self.at = data, 0
        self.order = ">" if data[:4] == struct.pack(">i", 84) else "<"

    def next(self):
        end = self.at + 4
        if end > len(self.data):
            return None
        (length,) = struct.unpack(self.order + "i", self.data[self.at:end])
        payload = self.data[end:end + length]
        if len(payload) < length:
            return None  # the run was stopped in it
        self.at = end + length + 4
        return payload

    def whole(self, payload=None):
        payload = self.next() if payload is None else payload
        return struct.unpack(f"{self.order}{len(payload) // 4}i", payload)

    def reals(self):
        payload = self.next()
        return None if payload is None else struct.unpack(f"{self.order}{len(payload) // 4}f", payload)


def names_of(kind, codes):
    kind = KINDS.get(kind, str(kind))
    known = VARIABLES.get(kind, [])
    return kind, [known[code - 1] if 0 < code <= len(known) else str(code) for code in codes]


def head(reader):
    """What stands before the first state: lengths of its records ahead of the blocks, and the blocks."""
    code = reader.whole()[0]
    reader.next()
    if code >= 3050:
        for _ in range(reader.whole()[0]):
            reader.next()
    parts, materials, properties, subsets, groups, of_run = reader.whole()
    if of_run:
        reader.next()
    of_parts = of_subsets = 0
    for _ in range(parts):
        count = reader.whole(reader.next()[-4:])[0]
        of_parts += count
        if count:
            reader.next()
    for _ in range(materials + properties):
        reader.next()
    for _ in range(subsets):
        _, _, children, inside, count = reader.whole(reader.next()[:20])
        of_subsets += count
        for needed in (children, inside, count):
            if needed:
                reader.next()
    blocks = []
    for _ in range(groups):
        _, kind, _, objects, count = reader.whole(reader.next()[:20])
        ids = [reader.whole(reader.next()[:4])[0] for _ in range(objects)]
        kind, names = names_of(kind, reader.whole() if count else [])
        if ids and names:
            blocks.append([f"{kind} {id} {name}" for id in ids for name in names])
    return sum(1 for length in (of_run, of_parts, of_subsets) if length), blocks


def read(path):
    """Names of the columns, the time first, and a row a state."""
    with open(path, "rb") as file:
        reader = Reader(file.read())
    skipped, blocks = head(reader)
    rows = []
    while (time := reader.reals()) is not None:
        for _ in range(skipped):
            reader.next()
        values = [reader.reals() for _ in blocks]
        if None in values:
            break
        rows.append([time[0]] + [v for names, block in zip(blocks, values) for v in block[:len(names)]])
    return ["time"] + [name for names in blocks for name in names], rows


def forces_of_impulses(names, rows):
    """Divides the growth of each impulse by that of the time."""
    for i, name in enumerate(names):
        kind, variable = name.split(" ")[0], name.rsplit(" ", 1)[-1]
        if not (kind in ("INTER", "RWALL") and variable[:2] in ("FN", "FT") or kind == "RBODY" and variable[0] in "FM" and variable != "MASS"):
            continue
        before, last = 0.0, rows[0][0]
        for row in rows:
            impulse, step = row[i], row[0] - last
            row[i] = (impulse - before) / step if step > 0.0 else 0.0
            before, last = impulse, row[0]


def add_magnitudes(names, rows):
    """Columns of the lengths of vectors, whose components are sums of columns."""
    at = {name: i for i, name in enumerate(names)}
    for block in sorted({name.rsplit(" ", 1)[0] for name in names if " " in name}):
        for name, parts in (("A", ("A",)), ("F", ("FN", "FT"))):
            columns = [[at.get(f"{block} {part}{axis}") for part in parts] for axis in "XYZ"]
            if block.startswith(("RBODY", "INTER")) and all(i is not None for column in columns for i in column):
                names.append(f"{block} {name}")
                for row in rows:
                    row.append(math.hypot(*(sum(row[i] for i in column) for column in columns)))


def main():
    path, marks = sys.argv[1], tuple(sys.argv[2:])
    names, rows = read(path)
    rows = [row for i, row in enumerate(rows) if i == 0 or row[0] > rows[i - 1][0]]  # the last state may be there twice
    forces_of_impulses(names, rows)
    add_magnitudes(names, rows)
    kept = [i for i, name in enumerate(names) if i == 0 or not marks or name.startswith(marks)]
    if len(kept) < 2 or len(rows) < 2:
        sys.exit(f"{path}: has {len(rows)} states and the columns {', '.join(names)}")
    print(",".join(names[i] for i in kept))
    for row in rows:
        print(",".join(f"{row[i]:.9g}" for i in kept))


if __name__ == "__main__":
    main()
