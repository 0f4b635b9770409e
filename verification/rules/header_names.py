#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Where what a header declares is defined: what X.hpp declares, a source whose name begins with X defines.

usage: header_names.py ROOT FOLDER=PERCENT...
Prints each function of a folder that is defined under another name, if they are more than PERCENT of its functions; the
exit code is then 1.
header_names.py --all ROOT FOLDER... prints the share of each library and layer in the folders, and all such functions.
Functions of one source alone (static, in an unnamed namespace, in no header) do not count."""
import collections
import pathlib
import re
import sys

from class_sizes import closing, without_comments

NAME = re.compile(r"((?:\w+::)*)(~?\w+|operator\s*(?:\(\)|[^\s\w(]+|\w+))\s*\(")


def statements(text):
    """(position, text, has a body) of each declaration at namespace level, without what stands in braces."""
    part, start, i = "", 0, 0
    while i < len(text):
        c, scope = text[i], False
        if c == "{" and text[i - 1].isspace():
            scope = re.search(r"\bnamespace\s+[\w:]+\s*$|\bextern\s*$", part)
            if not scope:
                i = closing(text, i)
                if "(" in part and not re.search(r"=\s*$", part):
                    yield start, part, True
                    c, scope = "", True
                elif re.search(r"\bnamespace\s*$", part):  # an unnamed one: nobody else sees into it
                    scope = True
        elif c == "{":  # of an initialiser
            i = closing(text, i)
        elif c == ";":
            yield start, part, False
        if scope or c in ";}":
            part, start = "", i + 1
        else:
            part += c
        i += 1


def function(declaration):
    """(class or "", name) of a function's declaration; None if it is none."""
    text = re.sub(r"\[\[.*?\]\]|\b(decltype|noexcept|alignas|__attribute__)\s*\((\([^()]*\)|[^()])*\)", " ", declaration)
    while text != (plain := re.sub(r"(?<!operator)<[^<>]*>", " ", text)):
        text = plain
    found = NAME.search(text)
    if not found or re.search(r"=|\b(using|typedef|static|return|static_assert)\b", text[:found.start(2)]):
        return None
    return found[1].rstrip(":").split("::")[0], re.sub(r"\s", "", found[2])


def part(path):
    """The library or layer of a file: the folder above its src or include."""
    return str(path.parents[0]).split("/src")[0].split("/include")[0]


def declared(files):
    """Stems of the headers of each function and class, by library or layer."""
    stems = collections.defaultdict(set)
    for path, text in files:
        for _, statement, _ in statements(text):
            if found := function(statement):
                stems[found].add(path)
        for found in re.finditer(r"\b(?:class|struct)\s+(?:alignas\([^)]*\)\s*)?(\w+)[^;{}()]*\{", text):
            stems[found[1], None].add(path)
    return stems


def misnamed(files):
    """(part, place, name, headers) of each function of the sources that a header declares; headers only if none has the source's name."""
    headers = declared([f for f in files if f[0].suffix != ".cpp"])
    for path, text in files:
        if path.suffix != ".cpp":
            continue
        for start, statement, has_body in statements(text):
            found = function(statement) if has_body else None
            if not found:
                continue
            by = headers.get((found[0], None)) or headers.get(("", found[1]), set())
            if by:
                at = start + len(statement) - len(statement.lstrip())
                wrong = [] if any(path.stem.startswith(h.stem) for h in by) else sorted(map(str, by))
                yield part(path), f"{path}:{text.count(chr(10), 0, at) + 1}", "::".join(filter(None, found)), wrong


def sources(root, folder):
    """(path, text) of the C++ files of a folder, its tests left out."""
    paths = sorted(p for p in (root / folder).rglob("*.[ch]pp") if "tests" not in p.relative_to(root).parts)
    return [(p.relative_to(root), without_comments(p.read_text(encoding="utf-8"))) for p in paths]


def main(arguments):
    everything = arguments[0] == "--all"
    root = pathlib.Path(arguments[everything])
    broken = False
    for argument in arguments[everything + 1:]:
        folder, _, limit = argument.partition("=")
        parts = collections.defaultdict(list)
        for name, *entry in misnamed(sources(root, folder)):
            parts[name].append(entry)
        functions = [entry for entries in parts.values() for entry in entries]
        wrong = [entry for entry in functions if entry[2]]
        if everything:
            for name, entries in sorted(parts.items()):
                count = sum(bool(entry[2]) for entry in entries)
                print(f"{name}: {count} of {len(entries)} ({100 * count / len(entries):.1f} %)")
            print(f"{folder}: {len(wrong)} of {len(functions)} ({100 * len(wrong) / max(len(functions), 1):.1f} %)")
        if everything or len(wrong) > float(limit) / 100 * len(functions):
            broken = broken or not everything
            for place, name, headers in wrong:
                print(f"{place}: {name} is declared in {', '.join(headers)}")
    return broken


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
