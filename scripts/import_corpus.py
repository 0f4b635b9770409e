#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Imports public decks with airbags, runs what is written, and writes a table of how each ended.

usage: scripts/import_corpus.py GASJET FOLDER --out TABLE.csv [--steps 2000] [--seconds 300]

FOLDER has one folder a repository, as `git clone` leaves it; nothing is downloaded here. Decks were found in:
  https://github.com/OpenRadioss/OpenRadioss         qa-tests/miniqa: AIRBAG, LOIS/LEAK_MAT
  https://github.com/OpenRadioss/ModelExchange
  https://github.com/Firehawk4427/PILLARS-LSDyna
  https://github.com/ansys/pydyna                    tests/testfiles
  https://github.com/kamakiri1225/OpenRadiossExample
Volumes that exchange gas are imported as one chamber. Units are not stated in LS-DYNA decks; they follow from their numbers, below. A case runs for so many steps at
most, or to its end: these bags take up to a day. `balanced` is the program's own verdict on mass, energy and momentum."""
import argparse
import csv
import json
import re
import subprocess
import tempfile
from pathlib import Path

AIRBAG = re.compile(rb"^(\*AIRBAG_(?!REFERENCE|SHELL_REFERENCE)|/MONVOL/)", re.M)
# Ambient pressures in Pa, GPa and psi of decks that do not state their units.
UNITS = [(r"3\.0000E-10|101300\.|1\.01300E5|101325", "kg-m-s"), (r"1\.01300E-4", "kg-mm-ms"), (r"\b14\.7", "slinch-in-s")]


def units_of(deck, text):
    if deck.suffix == ".rad" or "*CONTROL_UNITS" in text:
        return []
    airbag = text[text.index("*AIRBAG_"):][:2000]
    for pattern, name in UNITS:
        if re.search(pattern, airbag):
            return ["--units", name]
    return ["--units", "kg-m-s"]


def chambers_of(text):
    """Volumes that exchange gas are imported as one chamber."""
    return ["--merge-chambers"] if text.count("/MONVOL/COMMU") > 1 else []


def run(words, seconds):
    try:
        done = subprocess.run([str(word) for word in words], capture_output=True, timeout=seconds, text=True, errors="replace")
        return done.returncode, (done.stderr + done.stdout).strip()
    except subprocess.TimeoutExpired as late:
        return None, (late.stderr or b"").decode(errors="replace") if isinstance(late.stderr, bytes) else ""


def end_of(gasjet, case, steps):
    """End of the run that so many steps reach [s], and its share of the deck's."""
    code, text = run([gasjet, "check", case], 120)
    wanted = float(re.search(r"scene\.end_time[^=]*= ([0-9.e+-]+)", text)[1])
    found = re.findall(r"step at the start[^:\n]*: ([0-9.e+-]+) s", text)
    return (min(wanted, steps * min(map(float, found))) if found else wanted), wanted


def judge(gasjet, deck, options):
    text = deck.read_text(errors="replace")
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "case"
        code, said = run([gasjet, "import", deck, "--out", out, *units_of(deck, text), *chambers_of(text)], options.seconds)
        row = {"deck": "", "nodes": "", "elements": "", "import": {0: "case", 2: "refused"}.get(code, f"failed ({code})"), "run": "", "share": "", "why": ""}
        if code != 0:
            row["why"] = said.split("\n")[0].split(": ", 1)[-1] if code == 2 else said[-200:]
            return row
        case = next(out.glob("*.toml"))
        mesh = (out / "bag.obj").read_text()
        row["nodes"], row["elements"] = mesh.count("\nv ") + mesh.startswith("v "), mesh.count("\nf ")
        end, wanted = end_of(gasjet, case, options.steps)
        results = Path(folder) / "run"
        code, said = run([gasjet, "run", case, "--out", results, "--quiet", "--set", f"scene.end_time={end}", "--set", "output.frames=0",
                          "--set", f"output.history_every={end / 100}"], options.seconds)
        row["share"] = f"{end / wanted:.3g}"
        row["run"] = {0: "balanced", 3: "left its domain", None: "too slow"}.get(code, f"failed ({code})")
        if code == 0:
            residual = json.loads((results / "summary.json").read_text())["residual"]
            row["why"] = "; ".join(f"{name} {value:.1e}" for name, value in residual.items() if isinstance(value, float))
        else:
            row["why"] = said.split("\n")[-1][-200:]
        return row


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("gasjet", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--steps", type=int, default=2000, help="most steps of a run")
    parser.add_argument("--seconds", type=float, default=300, help="most wall time of an import or a run")
    options = parser.parse_args()
    decks = sorted(path for path in options.folder.rglob("*") if path.suffix in (".k", ".key", ".dyn", ".rad") and AIRBAG.search(path.read_bytes()))
    with open(options.out, "w", newline="") as file:
        table = None
        for deck in decks:
            row = judge(options.gasjet.resolve(), deck, options)
            row["deck"] = str(deck.relative_to(options.folder))
            table = table or csv.DictWriter(file, row.keys(), lineterminator="\n")
            if file.tell() == 0:
                table.writeheader()
            table.writerow(row)
            file.flush()
            print(f"{row['import']:>8} {row['run']:>16} {row['deck'][-60:]} {row['why'][:100]}")


if __name__ == "__main__":
    main()
