#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Imports public decks whose repository keeps their histories, runs what is written, and writes a table of the differences.

usage: scripts/import_judged.py GASJET FOLDER --out docs/import_judged.csv [--long]

FOLDER has one folder a repository, as of scripts/import_corpus.py; nothing is downloaded here:
  OpenRadioss+OpenRadioss       https://github.com/OpenRadioss/OpenRadioss, whose tests keep histories (T01)
  Firehawk4427+PILLARS-LSDyna   https://github.com/Firehawk4427/PILLARS-LSDyna, which keeps one of LS-DYNA (abstat)
`gasjet compare` gives the differences, as shares of the largest magnitude of the stored history. Nothing of a case is changed,
but for the variant `stored outflow`, which tells the causes of the differences apart: its vents pass what the stored history
let out, and its start is free of stress. --long takes the decks whose runs need more than a minute, too."""
import argparse
import csv
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

TESTS = "OpenRadioss+OpenRadioss/qa-tests/miniqa"
LEAKS = f"{TESTS}/LOIS/LEAK_MAT"
BAGS = "Firehawk4427+PILLARS-LSDyna/pillars_v2_airbag_open/keyfiles/100/20"
# Name, deck, history, options of the import, chambers (0: an abstat), ends of the windows [ms], variants. The Radioss decks are in kg, mm, ms.
DECKS = [
    ("jetting41b", f"{TESTS}/AIRBAG/jetting41b/data/JETV41B_0000.rad", f"{TESTS}/AIRBAG/jetting41b/reference/JETV41BT01", ["--merge-chambers"], 2, [5, 10],
     ["imported"]),
    *((f"LEAK_MAT {law}", f"{LEAKS}/run2_{law}_quads/data/RBPLI_0000.rad", f"{LEAKS}/run2_{law}_quads/reference/RBPLIT01", [], 1, [40],
       ["imported", "stored outflow"]) for law in ("LAW19", "LAW58")),
    ("open_airbag_v129", f"{BAGS}/open_airbag_v129.k", f"{BAGS}/abstat", ["--units", "kg-m-s"], 0, [500], ["imported"]),
]
LONG = ["open_airbag_v129"]
COLUMNS = ["pressure_Pa", "volume_m3", "temperature_K", "gas_mass_kg"]


def abstat_rows(path):
    """The first numbers of an abstat's rows of the only airbag, in SI units."""
    for line in path.read_text(errors="replace").splitlines():
        fields = line.split()
        if len(fields) >= 13 and fields[1] == "1" and re.match(r"[0-9.]+E", fields[0]):
            time, volume, pressure, mass, temperature = (float(fields[i]) for i in (0, 2, 3, 8, 9))
            yield {"time_s": time, "pressure_Pa": pressure, "volume_m3": volume, "temperature_K": temperature, "gas_mass_kg": mass}


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


def at_time(history, time):
    """The columns of a history at a time, linear between its rows."""
    rows = [{name: float(row[name]) for name in ("time_s", *COLUMNS)} for row in csv.DictReader(line for line in open(history) if line[0] != "#")]
    after = next(i for i, row in enumerate(rows) if row["time_s"] >= time)
    a, b = rows[after - 1], rows[after]
    share = (time - a["time_s"]) / (b["time_s"] - a["time_s"])
    return {name: a[name] + share * (b[name] - a[name]) for name in COLUMNS}


def differences(gasjet, history, stored, end, folder):
    """A row a column, as shares of the largest stored magnitude. A stored history of fewer rows than `compare` needs is judged at its last one."""
    stored = [row for row in stored if row["time_s"] <= end * 1e-3]
    mine, last = at_time(history, stored[-1]["time_s"]), stored[-1]
    found = {}
    if len(stored) > 2:
        write(folder / "stored.csv", stored, end * 1e-3)
        found = json.loads(ran(gasjet, "compare", history, folder / "stored.csv", "--columns", ",".join(COLUMNS), "--tolerance", "2%", "--format", "json"))["quantities"]
    for column in COLUMNS:
        size = max(abs(row[column]) for row in stored)
        row = {"column": column, "stored_peak": f"{size:.5g}", "at_the_end": f"{(mine[column] - last[column]) / size:.2g}", "rms": "", "largest": "", "largest_at_ms": ""}
        if column in found:
            error = found[column]["max_error"]
            row.update(rms=f"{found[column]['relative_error']:.2g}", largest=f"{error['value'] / size:.2g}", largest_at_ms=f"{error['time_s'] * 1e3:.3g}")
        yield row


def judged(gasjet, repositories, deck):
    name, deck, history, options, chambers, ends, variants = deck
    stored = list(stored_rows(repositories / history, chambers) if chambers else abstat_rows(repositories / history))
    with tempfile.TemporaryDirectory() as folder:
        folder = Path(folder)
        ran(gasjet, "import", repositories / deck, "--out", folder / "case", *options)
        case = next((folder / "case").glob("*.toml"))
        text = case.read_text()
        for variant in variants:
            case.write_text(with_stored_outflow(text, stored) if variant == "stored outflow" else text)
            results = folder / variant.replace(" ", "_")
            ran(gasjet, "run", case, "--out", results, "--quiet", "--set", f"output.history_every={max(ends) * 1e-7}", "--set", "output.frames=0",
                "--set", f"scene.end_time={max(ends) * 1e-3}")
            for end in ends:
                for row in differences(gasjet, results / "history.csv", stored, end, folder):
                    yield {"deck": name, "variant": variant, "until_ms": end, **row}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("gasjet", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--long", action="store_true", help="take the decks with long runs, too")
    options = parser.parse_args()
    gasjet = options.gasjet.resolve()
    rows = [row for deck in DECKS if options.long or deck[0] not in LONG for row in judged(gasjet, options.folder, deck)]
    with open(options.out, "w", newline="") as file:
        file.write(f"# {ran(gasjet, '--version')}")
        file.write("# stored histories: see scripts/import_judged.py; shares of their largest magnitude\n")
        table = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        table.writeheader()
        table.writerows(rows)


if __name__ == "__main__":
    main()
