#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Decks of `gasjet export` in the real program: OpenRadioss' starter reads each case with a bag or a sheet, in its own format and as an LS-DYNA
deck by its reader of that. OpenRadioss is built outside this repository, and nothing of it enters here.
usage: read_decks.py STARTER [CASE...]   by default all of them; prints a row for each deck: errors and warnings
environment: GASJET, the program `gasjet` (by default build/gasjet of this tree); what the starter itself needs, such as
  LD_LIBRARY_PATH and RAD_CFG_PATH; UNITS, a unit system (by default t-mm-s)
Exit code: 0 no errors; 1 the starter finds errors in a deck, or does not say that there are none; 2 bad arguments; 77 no starter.
"""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from run import ROOT, call, end, find_programs, prepare


def read_deck(case, form, out, starter, gasjet):
    """Errors and warnings, as the listing's last lines have them, or None."""
    units = os.environ.get("UNITS", "t-mm-s")
    if subprocess.run([gasjet, "export", case, "--format", form, "--units", units, "--out", out], stdout=subprocess.DEVNULL).returncode != 0:
        end(2, f"read_decks.py: {case}: no deck")
    said = call(out, "starter.txt", starter, "-i", {"radioss": "bag_0000.rad", "lsdyna": "bag.k"}[form], "-np", "1")
    listing = out / "bag_0000.out"
    if listing.exists():
        for text in re.findall(r"(?m)^(?:ERROR|WARNING) ID.*\n(?:.*\n){0,4}", listing.read_text(errors="replace")):
            print("  " + text.rstrip("\n").replace("\n", "\n  "), file=sys.stderr)
    counts = [re.findall(rf"(?m)([0-9]+) +{kind}\(S\) *$", said) for kind in ("ERROR", "WARNING")]
    return [int(found[-1]) for found in counts] if all(counts) else None


def main():
    starter, gasjet = (find_programs([*sys.argv[1:2], ""][:1])[i] for i in (0, -1))
    cases = sys.argv[2:] or [case for folder in ("cases", "cases/reference") for case in sorted((ROOT / folder).glob("*.toml"))
                             if re.search(r"(?m)^\[membrane\]", case.read_text())]
    prepare()
    bad = False
    print("| case | deck | errors | warnings |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory() as work:
        for case in map(Path, cases):
            for form in ("radioss", "lsdyna"):
                counts = read_deck(case, form, Path(work, f"{case.stem}.{form}"), starter, gasjet)
                bad |= counts is None or counts[0] > 0
                errors, warnings = counts or ("no end", "")
                print(f"| {case.stem} | {form} | {errors} | {warnings} |", flush=True)
    sys.exit(bad)


if __name__ == "__main__":
    main()
