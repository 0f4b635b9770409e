#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Imports public decks whose repository keeps their histories, runs what is written, and writes a table of the differences.

usage: scripts/import_judged.py GASJET FOLDER --out docs/import_judged.csv

FOLDER is a clone of https://github.com/OpenRadioss/OpenRadioss; nothing is downloaded here. The stored histories are those of
its own tests. `gasjet compare` gives the differences, as shares of the largest magnitude of the stored history. Nothing of a
case is changed, but for the variant `stored outflow`, which tells the causes of the differences apart: its vents pass what the
stored history let out, and its start is free of stress."""
import argparse
import csv
import io
import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "verification/openradioss"))
import time_history  # noqa: E402

TESTS = "qa-tests/miniqa"
# Name, deck, history, options of the import, chambers, ends of the windows [ms], variants. All are in kg, mm and ms.
DECKS = [
    ("jetting41b", "AIRBAG/jetting41b/data/JETV41B_0000.rad", "AIRBAG/jetting41b/reference/JETV41BT01", ["--merge-chambers"], 2, [5, 10], ["imported"]),
    ("LEAK_MAT LAW19", "LOIS/LEAK_MAT/run2_LAW19_quads/data/RBPLI_0000.rad", "LOIS/LEAK_MAT/run2_LAW19_quads/reference/RBPLIT01", [], 1, [40],
     ["imported", "stored outflow"]),
    ("LEAK_MAT LAW58", "LOIS/LEAK_MAT/run2_LAW58_quads/data/RBPLI_0000.rad", "LOIS/LEAK_MAT/run2_LAW58_quads/reference/RBPLIT01", [], 1, [40],
     ["imported", "stored outflow"]),
]
COLUMNS = ["pressure_Pa", "volume_m3", "temperature_K", "gas_mass_kg"]


def stored_rows(path, chambers):
    """A stored history in SI units. Chambers are one: sums of volume and mass, means of pressure by volume and temperature by mass."""
    names, rows = time_history.read(path)
    rows = [dict(zip(names, row)) for i, row in enumerate(rows) if i == 0 or row[0] > rows[i - 1][0]]
    for row in rows:
        parts = [{name: row[f"MONV {i} {name}"] for name in ("MASS", "VOL", "P", "T", "AO", "UO")} for i in range(1, chambers + 1)]
        volume, mass = sum(part["VOL"] for part in parts), sum(part["MASS"] for part in parts)
        yield {"time_s": row["time"] * 1e-3, "pressure_Pa": sum(part["P"] * part["VOL"] for part in parts) / volume * 1e9, "volume_m3": volume * 1e-9,
               "temperature_K": sum(part["T"] * part["MASS"] for part in parts) / mass, "gas_mass_kg": mass,
               "outflow_m3_s": sum(part["AO"] * part["UO"] for part in parts) * 1e-6}


def write(path, rows, end):
    with open(path, "w", newline="") as file:
        table = csv.DictWriter(file, ["time_s", *COLUMNS], lineterminator="\n", extrasaction="ignore")
        table.writeheader()
        table.writerows(row for row in rows if row["time_s"] <= end)


def with_stored_outflow(case, stored):
    """The case with one vent, whose area over time is what the stored outflow needs at the stored overpressure, and with the start's shape free of
    stress."""
    ambient = float(re.search(r"(?m)^pressure = ([0-9.e+-]+)", case)[1])
    knots = []
    for row in stored[1:]:
        over, density = row["pressure_Pa"] - ambient, row["gas_mass_kg"] / row["volume_m3"]
        if over > 1.0:
            knots.append((row["time_s"], row["outflow_m3_s"] / math.sqrt(2.0 * over / density)))
    vent = f"[[vent]]\narea = {{ time = {[0.0] + [t for t, _ in knots]}, value = {[knots[0][1]] + [area for _, area in knots]} }}\n\n"
    case = re.sub(r"(?s)\[\[vent\]\].*?(?=\n\[(?!\[vent))", "", case).replace("[fabric]", vent + "[fabric]", 1)
    return case.replace('file = "bag.obj", initial_file = "bag_start.obj"', 'file = "bag_start.obj"')


def ran(*words):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    if done.returncode not in (0, 1, 4):
        sys.exit(f"{' '.join(map(str, words))}: {done.stderr}{done.stdout}")
    return done.stdout


def judged(gasjet, tests, deck):
    name, deck, history, options, chambers, ends, variants = deck
    stored = list(stored_rows(tests / history, chambers))
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        ran(gasjet, "import", tests / deck, "--out", folder / "case", *options)
        case = next((folder / "case").glob("*.toml"))
        text = case.read_text()
        for variant in variants:
            case.write_text(with_stored_outflow(text, stored) if variant == "stored outflow" else text)
            results = folder / variant.replace(" ", "_")
            ran(gasjet, "run", case, "--out", results, "--quiet", "--set", "output.history_every=1e-5", "--set", "output.frames=0")
            for end in ends:
                write(folder / "stored.csv", stored, end * 1e-3)
                said = json.loads(ran(gasjet, "compare", results / "history.csv", folder / "stored.csv", "--columns", ",".join(COLUMNS), "--tolerance", "2%",
                                      "--format", "json", "--rows", folder / "rows.csv"))
                last = list(csv.DictReader(io.StringIO((folder / "rows.csv").read_text())))[-1]
                for column in COLUMNS:
                    found = said["quantities"][column]
                    size = abs(found["reference_peak"]["value"])
                    difference = float(last[column]) - float(last[f"{column}_reference"])
                    yield {"deck": name, "variant": variant, "until_ms": end, "column": column, "stored_peak": f"{size:.5g}", "at_the_end": f"{difference / size:.2g}",
                           "rms": f"{found['relative_error']:.2g}", "largest": f"{found['max_error']['value'] / size:.2g}", "largest_at_ms": f"{found['max_error']['time_s'] * 1e3:.3g}"}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("gasjet", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--out", type=Path, required=True)
    options = parser.parse_args()
    gasjet = options.gasjet.resolve()
    rows = [row for deck in DECKS for row in judged(gasjet, options.folder / TESTS, deck)]
    with open(options.out, "w", newline="") as file:
        file.write(f"# {ran(gasjet, '--version')}")
        file.write("# stored histories: qa-tests of https://github.com/OpenRadioss/OpenRadioss; shares of their largest magnitude\n")
        table = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


if __name__ == "__main__":
    main()
