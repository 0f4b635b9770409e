#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the columns unit, allowed and default of docs/case_files.md, from the keys that `gasjet check` says a
case could set. Which keys it asks for depends on the case: those of all cases together are the reference. A key
without a row, and a row without a key, are errors: the meaning of a key is written by hand. A cell that is a link to
a table stands for the names in that table's first column.

usage: docs/make/pages/case_keys.py [--check] GASJET [PAGE]; --check changes nothing and fails if it would"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
CASES = ["cases/*.toml", "cases/reference/*.toml", "verification/rules/keys/*.toml"]
HEAD = "| key | meaning | unit | allowed | default |"
OF_A_CURVE = {"time", "overpressure", "strain", "mass_ratio", "value", "file", "time_column", "overpressure_column", "strain_column",
              "mass_ratio_column", "column", "scale", "offset", "time_scale", "shift", "cumulative", "units"}


def shown(allowed):
    """The words of a message, as short as a table needs them."""
    allowed = re.sub(r'"[^"]*"', lambda m: f"`{m[0]}`", allowed)
    return re.sub(r"\b(an array|a whole number|a number|a curve|a finite number|a string|a table|a composition|one)\b"
                  r"(?: of| from)? ?", lambda m: {"an array": "array of ", "a whole number": "whole, ", "a curve": "curve of ",
                  "a finite number": "any", "a string": "text", "a table": "table",
                  "a composition": "composition"}.get(m[1], ""), allowed)


def keys_of(gasjet):
    """{path: [(unit, allowed, default), ...]}, numbers of list entries left out."""
    curves, found = set(), []
    for case in sorted(path for pattern in CASES for path in ROOT.glob(pattern)):
        command = [gasjet, "check", case, "--format", "keys"]
        lines = subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE)
        for line in lines.stdout.splitlines():
            path, *facts = line.split("\t")
            path = re.sub(r"\.[0-9]+(?=\.|$)", "", path)
            found.append((path, facts))
            if "a curve of" in facts[1] or facts[1].startswith("a composition"):
                curves.add(path)
    keys = {}
    for path, facts in found:
        above, _, name = path.rpartition(".")
        if above in curves and above.endswith("composition"):
            continue
        if above.endswith(".units") and above[:-6] in curves:
            path = f"curve.units.{name}"
        if above in curves and name in OF_A_CURVE:
            path, facts[0] = f"curve.{name}", ""
        if facts not in keys.setdefault(path, []):
            keys[path].append(facts)
    return keys


def cells(facts_of_keys):
    """Unit, allowed and default of a row; one that all its keys share stands once."""
    columns = []
    for i in range(3):
        texts = []
        for facts in facts_of_keys:
            values = list(dict.fromkeys(fact[i] for fact in facts if fact[i] or i == 2))
            if i == 1:
                values = [shown(value) for value in values]
            if i == 2:
                values = [{"": "none", "[]": "none"}.get(value, value if value[:1] != '"' else f"`{value}`") for value in values]
            texts.append(" or ".join(values) if i == 2 else "; ".join(values))
        columns.append(texts[0] if len(set(texts)) == 1 else ", ".join(texts))
    return columns


def linked(cell):
    """The names in the first column of the table that the cell links to; none if it is no such link."""
    link = re.fullmatch(r"\[[^]]*\]\(([\w/.-]+)#([a-z-]+)\)", cell)
    if not link:
        return []
    section = re.split(r"^#+ ", (ROOT / "docs" / link[1]).read_text(encoding="utf-8"), flags=re.M)
    below = [part for part in section if part.split("\n")[0].lower().replace(" ", "-") == link[2]]
    return re.findall(r"^\| `([a-z_0-9]+)` \|", "".join(below), flags=re.M)


def rewritten(text, keys, page):
    """The page with its columns as the keys have them, and what is wrong with it."""
    lines, wrong, prefix, in_table, left = [], [], "curve", False, set(keys)
    for number, line in enumerate(text.split("\n"), 1):
        if heading := re.match(r"## `\[+([a-z.]+)\]+`", line):
            prefix = heading[1]
        in_table = line == HEAD or in_table and line.startswith("|")
        row = re.match(r"\| ((?:`[a-z_0-9.]+`(?:, )?)+) \|(.*?)\|", line) if in_table else None
        if row:
            names = re.findall(r"`([a-z_0-9.]+)`", row[1])
            paths = [prefix if prefix.split(".")[-1] == name else f"{prefix}.{name}" for name in names]
            wrong += [f"{page}:{number}: no case asks for {path}" for path in paths if path not in keys]
            left -= set(paths)
            if all(path in keys for path in paths):
                unit, allowed, default = cells([keys[path] for path in paths])
                before = line.split("|")[4].strip()
                if (names := linked(before)) and names == re.findall(r'`"([^"]+)"`', allowed):
                    allowed = before
                line = " | ".join([f"| {row[1]}", row[2].strip(), unit, allowed, default]) + " |"
                line = re.sub(r"\| +(?=\|)", "| ", line)
        lines.append(line)
    return "\n".join(lines), wrong + [f"{page}: no row for the key {path}" for path in sorted(left)]


def main(arguments):
    check = "--check" in arguments
    gasjet, *page = [argument for argument in arguments if argument != "--check"]
    page = pathlib.Path(page[0]) if page else ROOT / "docs/case_files.md"
    text = page.read_text(encoding="utf-8")
    new, wrong = rewritten(text, keys_of(gasjet), page.name)
    if check:
        wrong += [f"{page.name}:{i}: is '{a}', the program says '{b}'"
                  for i, (a, b) in enumerate(zip(text.split("\n"), new.split("\n")), 1) if a != b]
    else:
        page.write_text(new, encoding="utf-8")
    print("\n".join(wrong) if wrong else f"{page.name} says what the program reads")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
