# SPDX-License-Identifier: Apache-2.0
"""What the programs that make and draw tables share: the repository, the program, what a table was made on and by,
rows of tables, and names as data for gnuplot."""
import csv
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
os.environ["LC_ALL"] = "C.UTF-8"  # numbers with a decimal point, wherever the user is


def gasjet():
    """The program: build/gasjet, or what GASJET names; a clone, as the tutorials set it, has it in build."""
    named = pathlib.Path(os.environ.get("GASJET") or ROOT / "build/gasjet")
    return str(named / "build/gasjet" if named.is_dir() else named)


def output(*command, allowed=(0,), **options):
    """What a command prints; ends this program if its exit code is not one of those allowed."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, encoding="utf-8", **options)
    if done.returncode not in allowed:
        sys.exit(f"{pathlib.Path(sys.argv[0]).name}: exit code {done.returncode} of {' '.join(map(str, command))}")
    return done.stdout


def machine(note=""):
    """The first line of a CSV of docs/charts or docs/figures; the note says how much of the machine was used."""
    model = re.search(r"^model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8"), flags=re.M)
    return f"# machine: {model[1] if model else ''}, {len(os.sched_getaffinity(0))} cores{note and ', ' + note}\n"


def build_version():
    """Version, commit, compiler and flags of the program."""
    return "".join(f"# {line}\n" for line in output(gasjet(), "--version").splitlines())


def provenance(note=""):
    return machine(note) + build_version()


def rows_of(path):
    """The rows of a CSV file, as dictionaries of texts."""
    with open(path, encoding="utf-8", newline="") as lines:
        return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def head_of(path):
    """The lines `# key: value` above the columns."""
    with open(path, encoding="utf-8", errors="replace") as lines:
        return dict(re.findall(r"^# ([^:\n]+): (.*)$", "".join(line for line in lines if line.startswith("#")), flags=re.M))


def gnuplot_text(text):
    """A string of gnuplot's that stands for the text. Within single quotes nothing is a command, an escape or a variable."""
    text = re.sub(r"[\x01-\x1f\x7f]", " ", text).encode("utf-8", "ignore").decode("utf-8")
    text = text.replace("]]>", "]] >", 1)  # which ends a part of an SVG file
    return "'" + text.replace("'", "''") + "'"


def gnuplot_file(name):
    """The same of a file; a name that begins with < or | would be a command."""
    name = str(name)
    if re.search(r"[\x00-\x1f\x7f]", name):
        print(f"{pathlib.Path(sys.argv[0]).name}: the name {name!r} has a line break or another control character, which gnuplot cannot read",
              file=sys.stderr)
        sys.exit(2)
    return "'" + (name if name.startswith("/") else f"./{name}").replace("'", "''") + "'"


def draw(script, **variables):
    """Runs a script of docs/charts/gnuplot with these variables, texts in gnuplot's quotes."""
    settings = "; ".join(f"{name}={value}" for name, value in variables.items())
    subprocess.run(["gnuplot", "-e", settings, f"docs/charts/gnuplot/{script}.gp"], cwd=ROOT, check=True)
