#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes what the pages say from CSV files: each table between <!-- table NAME --> and <!-- end of table NAME -->,
and each paragraph with numbers between the same marks with `text`. The template is docs/make/pages/tables/NAME.j2,
in jinja2's language: it reads a file by csv(), a row by row(), and prints its numbers by f(), with so
many digits behind the point, or by Python's %. Below a table
stand the commits that made its files.

usage: docs/make/pages/write.py [--check | --ages]
  --check  change nothing; exit code 1 if a page says something else, or a CSV does not say what it was made on
           and by
  --ages   list the CSV files with the number of commits to the sources since the commit that made each"""
import csv
import difflib
import itertools
import math
import os
import pathlib
import re
import subprocess
import sys

import jinja2

ROOT = pathlib.Path(__file__).resolve().parents[3]
SOURCES = ["elementary", "libgas", "libmembrane", "libjet", "libcoupling", "driver", ":(exclude)*.md"]


class Number(float):
    """A number of a table; as text it reads as in the file."""

    def __new__(cls, text):
        self = super().__new__(cls, text.split()[0])  # a page may give its unit too
        self.text = text
        return self

    def __str__(self):
        return self.text


def cell(text):
    return Number(text) if re.match(r"[-+]?[0-9.]+(e[-+]?[0-9]+)?( |$)", text) else text


class Table:
    """The rows of a CSV file, or of all tables of a page. `head` has its lines `# key: value`."""

    def __init__(self, path, used):
        self.path, self.used, self.rows, self.head = path, used, [], {}
        lines = (ROOT / path).read_text(encoding="utf-8").splitlines()
        for line in lines:
            if match := re.match(r"# gasjet \S+ \(([^,]+), ([^,]+), ([^)]+)\)$", line):
                self.head.update(commit=match[1], compiler=match[2], flags=match[3])
            elif match := re.match(r"# ([\w ]+): (.*)", line):
                self.head.setdefault(match[1], match[2])
            elif not line.startswith("#") and path.endswith(".csv"):
                break
        if path.endswith(".md"):
            tables = itertools.groupby(lines, lambda line: line.startswith("|"))
            tables = [[re.split(r" *(?<!\\)\| *", line)[1:-1] for line in table] for is_table, table in tables if is_table]
            self.rows = [dict(zip(table[0], map(cell, row))) for table in tables for row in table[2:]]
        else:
            rows = csv.reader(line for line in lines if not line.startswith("#"))
            names = next(rows)
            self.rows = [dict(zip(names, map(cell, row))) for row in rows]

    def where(self, **wanted):
        if self.path not in self.used:
            self.used.append(self.path)
        return [Row(self, row) for row in self.rows if all(str(row.get(name)) == value for name, value in wanted.items())]

    def row(self, **wanted):
        rows = self.where(**wanted)
        if len(rows) != 1:
            raise ValueError(f"{self.path}: {len(rows)} rows have {wanted}")
        return rows[0]

    @property
    def percent(self):
        """What makes a difference of a ladder's quantity a share of the reference, from where the quantity counts [%]."""
        return 100 / abs(float(self.head["reference"]) - float(self.head.get("counted from", 0)))


class Row:
    def __init__(self, table, cells):
        self.table, self.cells = table, cells

    def __getitem__(self, column):
        if column not in self.cells or self.cells[column] == "":
            raise ValueError(f"{self.table.path}: nothing in the column {column} of {self.cells}")
        return self.cells[column]


ENVIRONMENT = jinja2.Environment(loader=jinja2.FileSystemLoader(ROOT / "docs/make/pages/tables"), line_statement_prefix="%",
                                 undefined=jinja2.StrictUndefined, keep_trailing_newline=True)
ENVIRONMENT.globals.update(degrees=180 / math.pi, f=lambda value, digits: f"{value:.{digits}f}")


def made_at(used, page):
    """The commits of the files, each with its files; a page says nothing of a commit: CI compares it with its tests."""
    files_of = {}
    for path in used:
        link = f"[{path.split('/')[-1]}]({os.path.relpath(path, os.path.dirname(page) or '.')})"
        files_of.setdefault(Table(path, []).head.get("commit"), []).append(link)
    taken = files_of.pop(None, [])
    made = ", ".join(f"`{commit}` ({', '.join(files)})" for commit, files in files_of.items())
    return ". ".join(filter(None, [made and f"Made at commit {made}", taken and f"Taken from {', '.join(taken)}"])) + "."


def rendered(kind, name, page):
    used = []
    text = ENVIRONMENT.get_template(f"{name}.j2").render(csv=lambda path: Table(path, used))
    return f"\n{text}\n" + (f"{made_at(used, page)}\n\n" if kind == "table" else "")


def written(text, page, wrong):
    """The page with its tables and texts made anew."""
    def block(match):
        mark, kind, name = match[1], match[2], match[3]
        try:
            return f"{mark}\n{rendered(kind, name, page)}<!-- end of {kind} {name} -->\n"
        except (OSError, TypeError, ValueError, KeyError, jinja2.TemplateError) as fault:
            wrong.append(f"{page}: {kind} {name}: {type(fault).__name__}: {fault}")
            return match[0]
    begun = re.findall(r"^<!-- (?:table|text) ([a-z0-9_]+) -->$", text, flags=re.M)
    pattern = r"^(<!-- (table|text) ([a-z0-9_]+) -->)\n(?:(?!<!-- (?:table|text) ).*\n)*?<!-- end of \2 \3 -->\n"
    new, count = re.subn(pattern, block, text, flags=re.M)
    if not count == len(begun) == len(re.findall("^<!-- end of (?:table|text) ", text, flags=re.M)):
        wrong.append(f"{page}: a table or text begins or ends without the other mark")
    return new, begun


def pages():
    return [ROOT / "README.md", *sorted(ROOT.glob("docs/**/*.md"))]


def tables():
    return [str(path.relative_to(ROOT)) for folder in ("charts", "figures") for path in sorted(ROOT.glob(f"docs/{folder}/*.csv"))]


def faults_of_heads():
    """What CSV files do not say of the machine and the program that made them."""
    for path in tables():
        head = Table(path, []).head
        for part in ("machine", "commit", "compiler", "flags"):
            if not head.get(part, "").strip():
                yield f"{path}:1: the lines above the columns do not name its {part} (docs/make/charts/common.py)"
        if not re.fullmatch("[0-9a-f]{7,}", head.get("commit", "")):
            yield f"{path}:1: made by a build of changed sources, of which no commit tells"


def ages():
    for path in tables():
        commit = Table(path, []).head["commit"]
        count = subprocess.run(["git", "rev-list", "--count", "--no-merges", f"{commit}..HEAD", "--", *SOURCES], cwd=ROOT,
                               text=True, capture_output=True)
        print(f"{path}: {count.stdout.strip() or f'{commit} is not in this clone:'} commits to the sources since {commit}")


def main(arguments):
    if arguments not in ([], ["--check"], ["--ages"]):
        print(f"write.py: cannot take '{' '.join(arguments)}'; allowed: nothing, --check, --ages", file=sys.stderr)
        return 2
    if arguments == ["--ages"]:
        return ages()
    wrong, used = [], set()
    for path in pages():
        page, before = str(path.relative_to(ROOT)), path.read_text(encoding="utf-8")
        after, names = written(before, page, wrong)
        used.update(names)
        if after != before and arguments:
            wrong.append(f"{page} says something else than its CSV files: docs/make/pages/write.py writes it anew")
            wrong += difflib.unified_diff(before.split("\n"), after.split("\n"), page, "written", lineterm="", n=0)
        elif after != before:
            path.write_text(after, encoding="utf-8")
            print(f"{page}: written")
    templates = {path.stem for path in ROOT.glob("docs/make/pages/tables/*.j2")}
    wrong += [f"docs/make/pages/tables/{name}.j2: no page has this table" for name in sorted(templates - used)]
    wrong += faults_of_heads()
    print("\n".join(wrong), end="\n" if wrong else "")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
