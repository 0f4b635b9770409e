#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes random changes of one operator or number each, in functions of the libraries and of the steps, as lines that
scripts/tests/mutate.py --list tries: which tests must notice it, file, sed expression.
usage: scripts/tests/random_mutations.py [--number N] [--seed S] [--functions REGEX] [FILE...]
  --number N         how many (300); fewer where there are not so many
  --seed S           of the choice (1): the same seed and source give the same list
  --functions REGEX  only in functions whose `file:name` matches
  FILE               only in these (default: every .cpp and .hpp of the libraries' and the steps' sources)
Arithmetic turns into its inverse, a comparison into its negation (numbers are real: < for <= is the same program), a number
other than 0 grows by a tenth. Strings, comments and assertions of input (require, check::) are left alone."""

import argparse
import pathlib
import random
import re
import sys

CHANGES = [
    (r" \+ ", " - "), (r" - ", " + "), (r" \* ", " / "), (r" / ", " * "), (r" \+= ", " -= "), (r" -= ", " += "),
    (r" \*= ", " /= "), (r" < ", " >= "), (r" > ", " <= "), (r" <= ", " > "), (r" >= ", " < "), (r" == ", " != "),
    (r" != ", " == "), (r" && ", " || "), (r" \|\| ", " && "), (r"std::min\(", "std::max("), (r"std::max\(", "std::min("),
    (r"std::sin\(", "std::cos("), (r"std::cos\(", "std::sin("), (r"\b(?!0\.0\b)[0-9]+\.[0-9]+(e-?[0-9]+)?\b", None),
]
HIDDEN = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|^[ \t]*#[^\n]*', re.S | re.M)
SPARED = re.compile(r"\brequire|\bcheck::|static_assert|\bassert\b")
SCOPE = re.compile(r"\b(namespace|class|struct|enum|union|extern)\b")
# Where a file's tests stand, nearest first; the coupled ones run the whole program.
TESTS = {"libgas": "@gas coupled", "libmembrane": "@membrane coupled", "libmembrane/mesh": "@mesh coupled",
         "libjet": "@jet coupled", "libcoupling": "@coupling coupled", "driver": "@coupled", "verification": "@closed_form/tests"}
ROOT = pathlib.Path(__file__).resolve().parents[2]


def blank(match):
    return re.sub(r"[^\n]", "\0", match.group())


def functions(text):
    """(name, begin, end) of each function body; what is not code is blanked in `text`."""
    depth, start, scopes, found = 0, 0, 0, None
    for token in re.finditer(r"[{};]", text):
        at = token.start()
        if token.group() == "{":
            head = text[start:at]
            if found is None and depth == scopes:
                if SCOPE.search(head) and "(" not in head:
                    scopes += 1
                elif name := re.search(r"([\w:~]+|operator\W+)\s*\(", re.sub(r"__attribute__\(\(.*?\)\)", "", head)):
                    found = (name.group(1), at, depth)
            depth += 1
        elif token.group() == "}":
            depth -= 1
            if found and depth == found[2]:
                yield found[0], found[1], at
                found = None
            scopes = min(scopes, depth)
        if found is None:
            start = at + 1


def mutations(file, wanted):
    text = HIDDEN.sub(blank, (ROOT / file).read_text())
    raw = (ROOT / file).read_text().split("\n")
    for name, begin, end in functions(text):
        if not wanted.search(f"{file}:{name}"):
            continue
        first = text.count("\n", 0, begin)
        for number, line in enumerate(text[begin:end].split("\n")):
            number += first
            if SPARED.search(line):
                continue
            offset = begin - text.rfind("\n", 0, begin) - 1 if number == first else 0
            for pattern, replacement in CHANGES:
                for match in re.finditer(pattern, line):
                    old = match.group()
                    new = replacement or f"1.1 * {old}"
                    yield sed(raw[number], number + 1, offset + match.start(), old, new)


def sed(line, number, column, old, new):
    nth = len(re.findall(re.escape(old), line[:column])) + 1
    basic = re.sub(r"([][.*/\\^$])", r"\\\1", old)
    return f"{number}s/{basic}/{new.replace('/', chr(92) + '/').replace('&', chr(92) + '&')}/{nth}"


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1])
    parser.add_argument("--number", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--functions", type=re.compile, default=re.compile(""))
    parser.add_argument("files", nargs="*")
    wanted = parser.parse_args()
    files = wanted.files or sorted(
        str(p.relative_to(ROOT)) for folder in ("libgas", "libmembrane", "libjet", "libcoupling", "driver/engine/src/step")
        for p in (ROOT / folder).rglob("*") if p.suffix in (".cpp", ".hpp"))
    lines = []
    for file in files:
        suite = TESTS.get("libmembrane/mesh" if file.startswith("libmembrane/mesh/") else file.split("/")[0])
        if suite is None or not (ROOT / file).is_file():
            sys.exit(f"random_mutations.py: {file}: no source of a library, a step or a closed form")
        lines += [f"{suite}\t{file}\t{m}" for m in mutations(file, wanted.functions)]
    random.Random(wanted.seed).shuffle(lines)
    if not lines:
        sys.exit("random_mutations.py: no function there that could be changed")
    print("\n".join(sorted(lines[:wanted.number])))


main()
