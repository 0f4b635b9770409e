#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Judges a foreign program by the reference set: hands it each scene as JSON, reads its history back as CSV and compares all columns,
row by row, with the reference (docs/compare.md).
usage: run_external.py [--tolerance SHARE] [--tolerances FILE] [--timeout SECONDS] [--scenes NAME,...] [--out FOLDER] COMMAND [ARGUMENT...]
  called as COMMAND ARGUMENT... SCENE.json HISTORY.csv; exit code 77: it does not do this scene. SCENE.json follows
  schemas/scene.schema.json: `settings` (those of the case file, defaults too, SI units), `times` of the reference and its `columns` that
  have a band, and files of the mesh if there is one: `mesh` (OBJ) and `mesh_keyword`, the design shape, and `mesh_initial`, the shape at the start.
  HISTORY.csv: a header row with `time_s` and the columns, then rows.
  --tolerance SHARE  what the program may be off by itself, of each column's largest magnitude (0 by default)
  --tolerances FILE  the same of single columns: CSV with the header scene,column,tolerance; * stands for all; the last row that fits counts
  --timeout SECONDS  what it may take for a scene (3600 by default)
  --out FOLDER       keeps what was handed over and read back, both histories in one table (SCENE.rows.csv), the verdicts (SCENE.txt), and
                     writes report.json (schemas/report.schema.json) and junit.xml
environment: GASJET, the program `gasjet` that compares, or a tree with build/gasjet (by default that of this tree or installation,
  else the one in PATH)
Exit code: 0 inside the bands in all scenes that it does; 1 outside in one; 2 bad arguments, or the program or its file failed; 4 undecided.
"""
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as xml
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE if (HERE / "cases/reference").is_dir() else HERE.parent  # installed, beside the cases; in the source tree one folder below
REFERENCE = ROOT / "cases/reference"
TUBES = HERE / "enclosure/tubes"
OPTIONS = {"--tolerance": "0", "--tolerances": "", "--timeout": "3600", "--scenes": "", "--out": ""}
VERDICTS = {0: "inside", 4: "undecided", 1: "outside", 2: "failed"}  # by exit code, from good to bad


def fail(what):
    sys.exit(print(f"run_external.py: {what}", file=sys.stderr) or 2)


def is_share(text):
    """A number from 0 to 1, or of per cent."""
    return bool(re.fullmatch(r"\d*\.?\d+([eE][-+]?\d+)?%?", text)) and float(text.rstrip("%")) <= (100 if text.endswith("%") else 1)


def arguments(words):
    """Options by name, and the command."""
    options = dict(OPTIONS)
    while words and words[0].startswith("-"):
        if words[0] == "--help":
            sys.exit(print(__doc__.strip()))
        if words[0] not in options:
            fail(f"unknown option {words[0]}; allowed before the command: {', '.join(options)}")
        if len(words) < 2:
            fail(f"{words[0]} needs a value")
        options[words[0]], words = words[1], words[2:]
    if not is_share(options["--tolerance"]):
        fail(f"--tolerance {options['--tolerance']}: is not a share from 0 to 1, such as 0.02 or 2%")
    if not re.fullmatch("[1-9][0-9]*", options["--timeout"]):
        fail(f"--timeout {options['--timeout']}: is not a whole number of seconds above 0")
    if not words:
        fail("needs the command of a program")
    if not shutil.which(words[0]):
        fail(f"no program '{words[0]}'")
    return options, words


def find_gasjet():
    named = os.environ.get("GASJET", "")
    places = [named]
    if not named or os.path.isdir(named):
        places = [f"{named}/build/gasjet", ROOT / "build/gasjet", ROOT / "../../bin/gasjet", shutil.which("gasjet") or ""]
    found = [os.path.abspath(place) for place in places if os.path.isfile(place) and os.access(place, os.X_OK)]
    return found[0] if found else fail(f"no program {named or 'gasjet'}: build it first, or name it by the variable GASJET")


class Scene:
    """A reference history: its comments, times as texts, and columns that have a band."""

    def __init__(self, name):
        self.name, self.table = name, REFERENCE / f"{name}.csv"
        lines = self.table.read_text().splitlines()
        self.comments = dict(line[2:].split(": ", 1) for line in lines if line.startswith("# ") and ": " in line)
        head, *rows = (line.split(",") for line in lines if not line.startswith("#"))
        self.times = [row[0] for row in rows]
        self.columns = [column[:-len("_band")] for column in head if column.endswith("_band")]


def chosen_scenes(names):
    if not re.fullmatch("[a-z_,]*", names):
        fail("--scenes: allowed: names of scenes, such as tank_fill,plate_jet")
    known = sorted(file.stem for file in REFERENCE.glob("*.csv"))
    chosen = names.split(",") if names else known
    if unknown := set(chosen) - set(known):
        fail(f"no scene '{min(unknown)}' in {REFERENCE}")
    return [Scene(name) for name in chosen]


def read_tolerances(path):
    """Rows of --tolerances: scene, column, share."""
    if not os.path.isfile(path) or not os.access(path, os.R_OK):
        fail(f"--tolerances {path}: no such file")
    known = {file.stem: Scene(file.stem).columns for file in REFERENCE.glob("*.csv")}
    known["*"] = [column for columns in known.values() for column in columns]
    rows, header = [], False
    for number, line in enumerate(Path(path).read_text().splitlines(), 1):
        fields = [field.strip() for field in line.split(",")]
        place = f"{path}:{number}:"
        if not line.strip() or line.startswith("#"):
            continue
        if not header:
            header = fields == ["scene", "column", "tolerance"] or fail(f"{place}1: needed: the header scene,column,tolerance")
            continue
        if len(fields) != 3:
            fail(f"{place}1: has {len(fields)} fields, needed: three")
        scene, column, share = fields
        if scene not in known:
            fail(f"{place}1: scene: no scene '{scene}', allowed: those of the reference set and *")
        if column != "*" and column not in known[scene]:
            whose = "any scene" if scene == "*" else scene
            fail(f"{place}{len(scene) + 2}: column: no column '{column}' of {whose}, allowed: those with a band and *")
        if not is_share(share):
            fail(f"{place}{len(scene) + len(column) + 3}: tolerance: '{share}' is not a share from 0 to 1, such as 0.02 or 2%")
        rows.append(fields)
    return rows if header else fail(f"{path}:1:1: is empty, needed: the header scene,column,tolerance")


class Judge:
    def __init__(self, options, command):
        self.command, self.limit, self.gasjet = command, options["--timeout"], find_gasjet()
        self.scenes = chosen_scenes(options["--scenes"])
        self.keep, self.tolerance = options["--out"], options["--tolerance"]
        self.tolerances = read_tolerances(options["--tolerances"]) if options["--tolerances"] else []
        try:
            self.work = Path(self.keep or tempfile.mkdtemp()).resolve()
            self.work.mkdir(parents=True, exist_ok=True)
        except OSError:
            pass
        if not os.access(self.work, os.W_OK):
            fail(f"--out {self.keep}: the folder is not writable")
        self.entries, self.suites = [], xml.Element("testsuites", name=f"gasjet reference set {self.version_of_data()}")
        self.worst = 0

    @staticmethod
    def version_of_data():
        return json.loads((REFERENCE / "VERSION").read_text())

    def run(self, *words):
        return subprocess.run([self.gasjet, *map(str, words)], cwd=ROOT, stdin=subprocess.DEVNULL, capture_output=True, encoding="utf-8",
                              errors="replace")

    def file(self, scene, ending):
        return self.work / (scene.name + ending)

    def write_scene(self, scene):
        """The case's settings, and what the reference asks for, in one object."""
        case = scene.comments["case"]
        displaced = [word for setting in scene.comments.get("initial shape", "").split() for word in ("--set", setting)]
        head = {"scene": json.dumps(scene.name), "columns": json.dumps(scene.columns), "times": f"[{', '.join(scene.times)}]"}
        meshes = {"mesh": ".obj", "mesh_keyword": ".k", "mesh_initial": ".initial.obj"}
        if self.run("mesh", "case", case, "--out", self.file(scene, ".obj"), "--initial", self.file(scene, ".initial.obj"), *displaced).returncode == 0:
            self.run("mesh", "case", case, "--out", self.file(scene, ".k"))
            head |= {key: json.dumps(str(self.file(scene, ending))) for key, ending in meshes.items()}
        checked = self.run("check", case, "--format", "json")
        if checked.returncode != 0:
            fail(f"{scene.name}: no JSON")
        self.file(scene, ".json").write_text("\n".join(["{", *(f'  "{key}": {value},' for key, value in head.items()), checked.stdout.partition("\n")[2]]))

    def call(self, scene):
        """Runs the program; what went wrong, if something did, or None if it does not do the scene."""
        self.file(scene, ".csv").unlink(missing_ok=True)  # of an earlier run
        log = self.file(scene, ".log")
        with open(log, "wb") as output:
            child = subprocess.Popen([*self.command, self.file(scene, ".json"), self.file(scene, ".csv")], stdin=subprocess.DEVNULL, stdout=output,
                                     stderr=subprocess.STDOUT, start_new_session=True)
            try:
                code = child.wait(int(self.limit))
            except (subprocess.TimeoutExpired, KeyboardInterrupt) as why:
                os.killpg(child.pid, signal.SIGKILL)
                child.wait()
                if isinstance(why, KeyboardInterrupt):
                    sys.exit(130)
                return f"the program took longer than {self.limit} s"
        last = (log.read_text(errors="replace").splitlines() or [""])[-1]
        if code == 77:
            return None
        if code != 0:
            return f"the program failed with exit code {code if code > 0 else 128 - code}: {last}"
        return "" if self.file(scene, ".csv").exists() else f"the program wrote no history: {last}"

    def compare(self, scene):
        """The verdict's exit code, its line, and what `gasjet compare` says as JSON, or None."""
        options = ["--tolerance", self.tolerance]
        for column in scene.columns:
            shares = [share for s, c, share in self.tolerances if s in (scene.name, "*") and c in (column, "*")]
            options += ["--tolerance", f"{column}={shares[-1]}"] if shares else []
        words = ["compare", self.file(scene, ".csv"), scene.table, *options]
        self.file(scene, ".rows.csv").unlink(missing_ok=True)
        judged = self.run(*words, "--format", "json", "--rows", self.file(scene, ".rows.csv"))
        self.file(scene, ".verdict.json").write_text(judged.stdout)
        said = self.run(*words)
        self.file(scene, ".txt").write_text(said.stderr + said.stdout)
        last = (said.stderr + said.stdout).splitlines()[-1:]
        return said.returncode, "".join(last), json.loads(judged.stdout) if judged.stdout else None

    def say_proved(self, scene):
        """Prints which digits are right at the times of proved bounds (gasjet enclose), if the scene has any."""
        tube = TUBES / Path(scene.comments["case"]).with_suffix(".csv").name
        judged = self.run("compare", self.file(scene, ".csv"), tube, "--enclosure", "--format", "json").stdout if tube.exists() else ""
        for q in json.loads(judged)["quantities"] if judged else []:
            digit = max(1, -int(f"{q['share']:e}".split("e")[1])) if q["share"] else 0
            print(f"  proved: {q['name']}: " + (f"wrong from digit {digit} on, by {q['outside_by']:.3g} or more at {q['time_s']:.6g} s" if digit
                                                else f"right within {q['width']:.1e}" if q["rows"] else "no row at their times"))

    def note(self, code):
        ranks = list(VERDICTS)
        self.worst = max(self.worst, code if code in ranks else 2, key=ranks.index)  # a comparison that died judged nothing

    def judge(self, scene):
        self.write_scene(scene)
        start = time.monotonic()
        reason = self.call(scene)
        seconds = round(time.monotonic() - start, 3)
        if reason is None:
            print(f"{scene.name}: not done by the program")
            return self.report(scene, seconds, "not done", "", None)
        if reason:
            reason += "" if self.keep else " (--out keeps what it was given and what it said)"
            print(f"{scene.name}: {reason}")
            self.note(2)
            return self.report(scene, seconds, "failed", reason, None)
        code, reason, comparison = self.compare(scene)
        self.note(code)
        print(f"{scene.name}: {reason}")
        self.say_proved(scene)
        wrong = [(column, c) for column, c in judged_columns(comparison) if c["verdict"] != "inside"]
        for column, c in wrong if len(wrong) > 1 else []:  # the line names one
            print(f"  {c['verdict']}: {column}: {c['reason']}")
        return self.report(scene, seconds, "judged" if comparison else "failed", reason, comparison)

    def report(self, scene, seconds, status, message, comparison):
        """Adds the scene to both reports; the JUnit one has a test for each judged column, or one named `run`."""
        self.entries.append({"scene": scene.name, "status": status, "seconds": seconds, "message": message, "comparison": comparison})
        columns, counts = judged_columns(comparison) or [("run", None)], dict.fromkeys(("failures", "errors", "skipped"), 0)
        suite = xml.SubElement(self.suites, "testsuite", name=scene.name, tests=str(len(columns)))
        for column, found in columns:
            test = xml.SubElement(suite, "testcase", classname=scene.name, name=column)
            if status == "judged" and found["verdict"] != "inside":
                counts["failures"] += 1
                xml.SubElement(test, "failure", type=found["verdict"], message=printable(found["reason"]))
            elif status == "failed":
                counts["errors"] += 1
                xml.SubElement(test, "error", message=printable(message))
            elif status == "not done":
                counts["skipped"] += 1
                xml.SubElement(test, "skipped", message="not done by the program")
        suite.attrib |= {**{name: str(count) for name, count in counts.items()}, "time": f"{seconds:.3f}"}

    def write_reports(self, judged):
        version, commit = re.match(r"gasjet (\S+) \(([^,]+),", self.run("--version").stdout).groups()
        verdict = VERDICTS[self.worst] if judged else "not judged"
        report = {"format": 1, "version": version, "commit": commit, "reference_data": self.version_of_data(), "command": " ".join(self.command),
                  "verdict": verdict, "scenes": self.entries}
        (self.work / "report.json").write_text(json.dumps(report, indent=2, ensure_ascii=False) + "\n")
        xml.indent(self.suites)
        xml.ElementTree(self.suites).write(self.work / "junit.xml", encoding="UTF-8", xml_declaration=True)

    def judge_all(self):
        for scene in self.scenes:
            self.judge(scene)
        judged = any(entry["status"] != "not done" for entry in self.entries)
        if self.keep:
            self.write_reports(judged)
        return self.worst if judged else fail("the program does none of the scenes")


def judged_columns(comparison):
    return [(name, c) for name, c in comparison["quantities"].items() if c["verdict"] != "not judged"] if comparison else []


def printable(text):
    """Without what XML cannot hold."""
    return re.sub(r"[\x00-\x1f\x7f]", "", text.replace("\t", " ").replace("\n", " "))


def main():
    os.environ["LC_ALL"] = "C.UTF-8"  # numbers with a decimal point, wherever the user is
    sys.stdout.reconfigure(line_buffering=True)
    judge = Judge(*arguments(sys.argv[1:]))
    try:
        sys.exit(judge.judge_all())
    finally:
        if not judge.keep:
            shutil.rmtree(judge.work, ignore_errors=True)


if __name__ == "__main__":
    main()
