#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Imports damaged copies of decks and judges how each ends.

usage: damaged_decks.py GASJET SOURCE_DIR NUMBER [--decks FILE...] [--seed N] [--keep DIR] [--jobs N]

Decks are what `gasjet export` writes of some shipped cases, and files that are given. Each gets a fault of a named class.
An import must end within 5 s with exit code 0 (a case that runs) or 2 (a message, and no case), and nothing may be lost
unsaid: each card of the deck, which this script finds by itself, stands in import.json with what became of it, and the
counts there add up. Prints a table by class as tab-separated values. Exit 1 if an input ends otherwise; --keep stores it.
"""

import argparse
import bisect
import json
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

from damaged_inputs import tally

PATIENCE = 5.0  # [s]
CASES = ["flattened_sphere", "strapped_sphere", "bag_leak_table", "measured_fabric", "bag_from_files", "contact_vent", "clamped_disc"]
BAD = ["x", "NaN", "inf", "1e999", "-1e308", "0", "-1", "99999999", "1.5", "1+5", "&lost", "é", "1,2", "\t", "*", "/", "$", "#"]
FIELD = re.compile(r"[^\s,]+")


def mark_of(lines):
    return "*" if any(line.startswith("*KEYWORD") for line in lines[:50]) else "/"


def starts_of(lines):
    """Numbers of the lines with keywords."""
    mark = mark_of(lines)
    return [i for i, line in enumerate(lines) if line.startswith(mark)]


def data_lines(lines):
    return [i for i, line in enumerate(lines) if line.strip() and line[0] not in "*/#$"] or [0]


def block(rng, lines):
    """First line of a card and of the next one."""
    starts = starts_of(lines) or [0]
    at = rng.randrange(len(starts))
    return starts[at], (starts + [len(lines)])[at + 1]


def card_dropped(rng, lines):
    begin, end = block(rng, lines)
    del lines[begin:end]


def card_repeated(rng, lines):
    begin, end = block(rng, lines)
    where = block(rng, lines)[1]
    lines[where:where] = lines[begin:end]


def cards_reordered(rng, lines):
    begin, end = block(rng, lines)
    card = lines[begin:end]
    del lines[begin:end]
    where = block(rng, lines)[1] if starts_of(lines) else 0
    lines[where:where] = card


def keyword_changed(rng, lines):
    at = block(rng, lines)[0]
    word = lines[at]
    cut = rng.randrange(1, max(2, len(word)))
    lines[at] = rng.choice([word[:cut], word + "_TITLE", word + "_ID", word[:cut] + "X" + word[cut + 1:], word.lower(), word + "/1",
                            word + "+", lines[block(rng, lines)[0]], word[0]])


def a_field(rng, line):
    """Bounds of a field; columns where there are no commas."""
    found = [match.span() for match in FIELD.finditer(line)]
    return rng.choice(found) if found else (0, len(line))


def number_replaced(rng, lines):
    at = rng.choice(data_lines(lines))
    begin, end = a_field(rng, lines[at])
    new = rng.choice(BAD)
    lines[at] = lines[at][:begin] + new.rjust(end - begin)[-max(end - begin, len(new)):] + lines[at][end:]


def number_changed(rng, lines):
    """Another number of the deck, or one digit more or less: of another node, part, set or curve."""
    at, other = rng.choice(data_lines(lines)), rng.choice(data_lines(lines))
    begin, end = a_field(rng, lines[at])
    first, last = a_field(rng, lines[other])
    new = rng.choice([lines[other][first:last], lines[at][begin:end][:-1], "7", "0", "-" + lines[at][begin:end]])
    lines[at] = lines[at][:begin] + new.rjust(end - begin) + lines[at][end:]


def fields_swapped(rng, lines):
    at = rng.choice(data_lines(lines))
    (a, b), (c, d) = sorted([a_field(rng, lines[at]), a_field(rng, lines[at])])
    if b <= c:
        lines[at] = lines[at][:a] + lines[at][c:d].rjust(b - a) + lines[at][b:c] + lines[at][a:b].rjust(d - c) + lines[at][d:]


def line_cut(rng, lines):
    at = rng.choice(data_lines(lines))
    lines[at] = lines[at][: rng.randrange(len(lines[at]) + 1)]


def line_lost(rng, lines):
    at = rng.choice(data_lines(lines))
    kind = rng.randrange(3)
    if kind == 0:
        del lines[at]
    elif kind == 1:
        lines.insert(at, lines[at])
    else:
        lines.insert(rng.choice(data_lines(lines)), lines.pop(at))


def file_cut(rng, lines):
    del lines[rng.randrange(len(lines)):]
    if lines and rng.random() < 0.5:
        lines[-1] = lines[-1][: rng.randrange(len(lines[-1]) + 1)]


CLASSES = {
    "card dropped": card_dropped,
    "card repeated": card_repeated,
    "cards reordered": cards_reordered,
    "keyword changed": keyword_changed,
    "number replaced": number_replaced,
    "number changed": number_changed,
    "fields swapped": fields_swapped,
    "line cut": line_cut,
    "line lost": line_lost,
    "file cut": file_cut,
    "three faults": None,  # of those above
}


def make_input(decks, seed, index):
    """Name of the class, name of the file and its text, of input number `index`."""
    rng = random.Random(f"{seed} {index}")
    name = list(CLASSES)[index % len(CLASSES)]
    path, text = rng.choice(decks)
    lines = text.split("\n")
    for fault in [CLASSES[name]] if CLASSES[name] else rng.choices(list(CLASSES.values())[:-1], k=3):
        if lines:
            fault(rng, lines)
    return name, path, "\n".join(lines)


def cards_of(text, mark):
    """(line from 1, keyword) of each card."""
    for number, line in enumerate(text.split("\n"), 1):
        if mark == "*" and line.startswith("*"):
            word = re.split(r"[ \t,]", line.strip())[0].upper()
            yield number, word[:-1] if word[-1] in "+-" and len(word) > 1 else word
        elif mark == "/" and (line.startswith("/") or line.startswith(("#include", "#INCLUDE"))):
            yield number, "#INCLUDE" if line[0] == "#" else line.strip().upper()


def judge_report(out, path, text):
    """What is lost unsaid; None if nothing is."""
    report = json.loads((out / "import.json").read_text(errors="replace"))
    mark = "*" if path.suffix in (".k", ".key", ".dyn") else "/"
    cards = list(cards_of(text, mark))
    end = next((i for i, (_, word) in enumerate(cards) if word == mark + "END"), None)
    after = [card for card in cards[end + 1:] if card[1][0] == mark] if end is not None else []
    cards = cards[:end]
    lines = [line for line, _ in cards]
    told = set()
    for row in report["cards"]:
        for place in row["places"]:
            file, _, line = place.rpartition(":")
            if file == path.name and (at := bisect.bisect_right(lines, int(line)) - 1) >= 0:
                told.add((lines[at], row["card"].upper()))
    lost = [card for card in cards if card not in told]
    if lost:
        return f"line {lost[0][0]}: {lost[0][1]} is not in the report"
    if after and not any(str(len(after)) in note and "END" in note for note in report["notes"]):
        return f"{len(after)} cards after the end are not named"
    counts, number = report["counts"], len(cards) + sum(row["card"] == "/REFSTA_FILE" for row in report["cards"])
    if counts["cards"] != number or sum(counts.values()) != 2 * number:
        return f"{number} cards, but the counts are {counts}"
    return None


def run_input(gasjet, deck, text, out):
    """(outcome, what is wrong or None)"""
    try:
        done = subprocess.run([gasjet, "import", deck, "--out", out, "--units", "kg-m-s"][: 5 if "CONTROL_UNITS" in text or deck.suffix == ".rad" else 7],
                              capture_output=True, timeout=PATIENCE, stdin=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        return "hang", "takes more than 5 s"
    message = (done.stderr + done.stdout).decode(errors="replace")
    if done.returncode not in (0, 2) or "runtime error" in message or "Sanitizer" in message:
        return "broken", f"exit {done.returncode}: {message[-600:]!r}"
    if not (out / "import.json").exists():
        return "refused", None if re.search(r"\S+: .+", message) else f"unclear message: {message[:200]!r}"
    if bool(list(out.glob("*.toml"))) != (done.returncode == 0):
        return "broken", f"exit {done.returncode} with or without a case"
    return "case" if done.returncode == 0 else "refused", judge_report(out, deck, text)


def own_decks(gasjet, source, folder):
    for name in CASES:
        for form in ("radioss", "lsdyna"):
            out = folder / name / form
            out.parent.mkdir(parents=True, exist_ok=True)
            subprocess.run([gasjet, "export", source / f"cases/{name}.toml", "--format", form, "--units", "kg-mm-ms", "--out", out], check=True, capture_output=True)
            yield next(path for path in out.iterdir() if path.name in ("bag.k", "bag_0000.rad"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("gasjet", type=pathlib.Path)
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("number", type=int)
    parser.add_argument("--decks", type=pathlib.Path, nargs="*", default=[])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    gasjet = options.gasjet.resolve()
    with tempfile.TemporaryDirectory() as folder:
        paths = [*own_decks(gasjet, options.source, pathlib.Path(folder)), *options.decks]
        decks = [(path, path.read_text(errors="replace")) for path in paths]

        def work(index):
            name, path, text = make_input(decks, options.seed, index)
            with tempfile.TemporaryDirectory() as own:
                deck = pathlib.Path(own) / path.name
                deck.write_text(text)
                for extra in path.parent.iterdir():  # what the deck includes, and Radioss' engine file
                    if extra != path:
                        (deck.parent / extra.name).symlink_to(extra.resolve())
                outcome, wrong = run_input(gasjet, deck, text, pathlib.Path(own) / "out")
                if wrong and options.keep:
                    options.keep.mkdir(parents=True, exist_ok=True)
                    shutil.copy(deck, options.keep / f"{options.seed}_{index}_{path.name}")
            return name, outcome, wrong, f"{options.seed}_{index}"

        return tally(work, options.number, options.jobs, CLASSES, ["case", "refused", "wrong"])


if __name__ == "__main__":
    sys.exit(main())
