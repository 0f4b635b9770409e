#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Decks of `gasjet export` in the real program: OpenRadioss runs scenes, in its own format and as LS-DYNA decks by its reader of those,
and `gasjet compare` judges its time histories. OpenRadioss is built outside this repository, and nothing of it enters here.
usage: run.py [--scenes NAME,...] [--formats radioss,lsdyna] [--out FOLDER] STARTER ENGINE
  The scenes are those of scenes.csv beside this script: each has a limit for the columns that are wanted at its end.
  Prints a table as Markdown. --out keeps decks, listings and histories, and writes table.md and table.csv with what made them.
environment: GASJET, the program `gasjet` (by default build/gasjet of this tree); what OpenRadioss itself needs, such as
  LD_LIBRARY_PATH and RAD_CFG_PATH; OPENRADIOSS, what the table calls the program (a commit, say); TIMEOUT [s] of a run (3600)
Exit code: 0 all within their limits; 1 one is not, or a run has no normal end; 2 bad arguments; 77 no OpenRadioss.
"""
import argparse
import csv
import datetime
import json
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
HEAD = ["scene", "deck", "column", "end_s", "at_the_end", "rms", "largest", "limit", "verdict"]
# The reader of LS-DYNA decks asks for no history of *AIRBAG_HYBRID, so that the file that includes the deck does.
INCLUDE = "\n".join(["#RADIOSS STARTER", "/BEGIN", "run", "      2022         0", *["".join(f"{unit:>20}" for unit in ("Mg", "mm", "s"))] * 2,
                     "/INCLUDE_LS-DYNA/", "bag.k", "/TH/MONV/1", "history", "DEF       ", "         1", "/END", ""])


def end(code, text):
    print(text, file=sys.stderr)
    sys.exit(code)


def find_programs(names):
    """Paths of OpenRadioss' starter and engine, and of gasjet."""
    found = []
    for name, what in zip(names, ("starter", "engine")):
        found.append(shutil.which(name) or end(77, f"{Path(sys.argv[0]).name}: no OpenRadioss {what} '{name}': name it as an argument"))
    gasjet = os.environ.get("GASJET") or ROOT / "build/gasjet"
    if not os.access(gasjet, os.X_OK):
        end(2, f"{Path(sys.argv[0]).name}: no program {gasjet}: build it first, or name it by the variable GASJET")
    return [os.path.realpath(program) for program in (*found, gasjet)]


def prepare():
    """Both programs of OpenRadioss have arrays on the stack."""
    resource.setrlimit(resource.RLIMIT_STACK, (resource.getrlimit(resource.RLIMIT_STACK)[1],) * 2)
    os.environ |= {"OMP_NUM_THREADS": "1", "OMP_STACKSIZE": os.environ.get("OMP_STACKSIZE", "400m")}


def call(folder, listing, *words):
    """Runs a program in a folder, its words in a listing there; they are given back."""
    with open(folder / listing, "wb") as said:
        try:
            subprocess.run(words, cwd=folder, stdin=subprocess.DEVNULL, stdout=said, stderr=said, timeout=float(os.environ.get("TIMEOUT", 3600)))
        except subprocess.TimeoutExpired:
            pass
    return (folder / listing).read_text(errors="replace")


def run_radioss(folder, starter, engine):
    """From a Radioss deck, or an LS-DYNA deck that a starter file includes, to histories.csv; whether the run has a normal end."""
    control = (folder / "run_0001.rad").read_text()
    control = re.sub(r"(?m)^/ANIM.*\n.*\n", "", control).replace("/RUN/bag/1", "/RUN/run/1")  # no pictures
    (folder / "run_0001.rad").write_text(control)
    if (folder / "bag.k").exists():
        (folder / "run_0000.rad").write_text(INCLUDE)
    else:
        (folder / "bag_0000.rad").rename(folder / "run_0000.rad")
    call(folder, "starter.txt", starter, "-i", "run_0000.rad", "-np", "1")
    listing = folder / "run_0000.out"
    if not listing.exists() or not re.search(r"(?m)^ *0 +ERROR\(S\)", listing.read_text(errors="replace")):
        return False
    if "NORMAL TERMINATION" not in call(folder, "engine.txt", engine, "-i", "run_0001.rad", "-nt", "1"):
        return False
    with open(folder / "histories.csv", "w") as histories:
        return subprocess.run([sys.executable, "-B", HERE / "time_history.py", "runT01"], cwd=folder, stdout=histories).returncode == 0


def judge(folder, scene, deck, limits):
    """Rows of the table for a run that was compared: differences as shares of the largest magnitude of Gasjet's column."""
    quantities = json.loads((folder / "compare.json").read_text())["quantities"]
    with open(folder / "rows.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if line[0] != "#"))
    for column in limits.keys() - quantities:
        print(f"{scene}: no column {column}", file=sys.stderr)
        yield [scene, deck, column, "", "", "", "", limits[column], "outside"]
    for column, found in quantities.items():
        if "relative_error" not in found:
            continue
        mine, reference = ([float(row[name]) for row in rows] for name in (column, column + "_reference"))
        scale = max(map(abs, reference)) or 1.0
        last = (mine[-1] - reference[-1]) / scale
        verdict = "" if column not in limits else "inside" if abs(last) <= limits[column] else "outside"
        yield [scene, deck, column, rows[-1]["time_s"], f"{last:.2g}", f"{found['relative_error'] or 0.0:.2g}",
               f"{max(abs(a - b) for a, b in zip(mine, reference)) / scale:.2g}", limits.get(column, ""), verdict]


def write_tables(out, rows, made):
    with open(out / "table.csv", "w", encoding="utf-8") as file:
        file.write(f"# differences of OpenRadioss to Gasjet, by {made}: verification/openradioss/run.py\n")
        file.write("# shares of the largest magnitude of Gasjet's column: at the end of the run, root mean square (of the column's), largest\n")
        csv.writer(file, lineterminator="\n").writerows([HEAD, *rows])
    lines = [f"By {made}.", "", "| scene | deck | column | at the end | rms | largest | limit |", "|---|---|---|---|---|---|---|"]
    for scene, deck, column, _, last, rms, largest, limit, verdict in rows:
        lines.append(f"| {scene} | {deck} | no end | | | | |" if verdict == "no end" else
                     f"| {scene} | {deck} | {column} | {last} | {rms} | {largest} | {limit}{' **outside**' * (verdict == 'outside')} |")
    (out / "table.md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


def run_scene(row, forms, out, starter, engine, gasjet):
    """Rows of the table for a scene, from decks of each format."""
    name, case, settings, limits = row
    case = ROOT / case
    options = [word for setting in settings.split() for word in (("--unset", setting[1:]) if setting[0] == "-" else ("--set", setting))]
    limits = {column: float(share) for column, share in (item.split("=") for item in limits.split())}
    if subprocess.run([gasjet, "run", case, *options, "--quiet", "--out", out / name]).returncode != 0:
        end(2, f"run.py: {name}: the run of gasjet failed")
    for form in forms:
        folder = out / f"{name}.{form}"
        shutil.rmtree(folder, ignore_errors=True)
        # The engine file of a Radioss deck serves both. The next export takes away what it did not write.
        for kind in ("radioss", form) if form == "lsdyna" else ("radioss",):
            done = subprocess.run([gasjet, "export", case, *options, "--format", kind, "--units", "t-mm-s", "--out", folder], stdout=subprocess.DEVNULL)
            if done.returncode != 0:
                end(2, f"run.py: {name}: no deck")
            if kind == "radioss":
                (folder / "bag_0001.rad").rename(folder / "run_0001.rad")
        if run_radioss(folder, starter, engine):
            with open(folder / "compare.json", "w") as verdict:
                subprocess.run([gasjet, "compare", folder / "histories.csv", out / name / "history.csv", "--map",
                                ROOT / "cases/maps/openradioss_t_mm_s.toml", "--rows", folder / "rows.csv", "--format", "json"], stdout=verdict)
            yield from judge(folder, name, form, limits)
        else:
            yield [name, form, "", "", "", "", "", "", "no end"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenes", default="")
    parser.add_argument("--formats", default="radioss,lsdyna")
    parser.add_argument("--out")
    parser.add_argument("programs", nargs="*")
    arguments = parser.parse_args()
    starter, engine, gasjet = find_programs([*arguments.programs, "", ""][:2])
    with open(HERE / "scenes.csv", encoding="utf-8") as file:
        scenes = [line.rstrip("\n").split(";") for line in file if not line.startswith("#")]
    names = arguments.scenes.split(",") if arguments.scenes else [scene[0] for scene in scenes]
    chosen = [scene for scene in scenes if scene[0] in names] or end(2, f"run.py: no scene of this name; scenes.csv has {' '.join(s[0] for s in scenes)}")
    prepare()
    with tempfile.TemporaryDirectory() as scratch:
        out = Path(arguments.out or scratch).resolve()
        out.mkdir(parents=True, exist_ok=True)
        rows = [row for scene in chosen for row in run_scene(scene, arguments.formats.split(","), out, starter, engine, gasjet)]
        version = subprocess.run([gasjet, "--version"], capture_output=True, text=True).stdout.splitlines()[-1]
        write_tables(out, rows, f"{version} and {os.environ.get('OPENRADIOSS', 'OpenRadioss')}, {datetime.date.today().isoformat()}")
    sys.exit(1 if {"no end", "outside"} & {row[-1] for row in rows} else 0)


if __name__ == "__main__":
    main()
