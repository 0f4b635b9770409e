#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs damaged copies of the shipped cases and judges how each ends.

usage: damaged_cases.py GASJET SOURCE_DIR NUMBER [--seed N] [--keep DIR] [--jobs N]

Each input is one shipped case, made short, with one or two faults of a named class. A run must end in one of four
ways: done with finite values; refused (exit 2) with a message that names file and place; stopped (exit 3) with a
reason in summary.json; or, where the case asks for a long run, ended within seconds of SIGTERM with its results kept.
Prints a table by class as tab-separated values. Exit 1 if an input ends otherwise; --keep stores such inputs.
"""

import argparse
import csv
import json
import math
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

from damaged_inputs import tally

PATIENCE = 20.0  # [s] until a run is asked to end, and then again until it must have ended
NUMBER = re.compile(r"(?<![\w.\"])[-+]?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?(?![\w.])")
STRING = re.compile(r'"[^"\n]*"')
KEY = re.compile(r"^\s*([A-Za-z_][\w.]*)\s*=")
HEADER = re.compile(r"^\s*\[")
LIST = re.compile(r"\[[^\[\]\n=]*,[^\[\]\n]*\]")
BAD_NUMBERS = ["0", "-0.0", "nan", "inf", "-inf", "1e308", "-1e308", "1e-308", "5e-324", "9223372036854775807",
               "99999999999999999999", '"text"', "true", "[]", "{}", "1979-05-27", "[1.0, 2.0]"]
BAD_STRINGS = ['""', '"' + "x" * 70000 + '"', '"\\u00e9\\U0001F4A5"', '"missing.csv"', '"/dev/null"', '"/dev/zero"',
               '"/tmp"', '"../../etc/passwd"', '"%s%n"', "1.5", "false", '["a", "b"]', '"line\\nbreak"']


def code_lines(lines):
    """Numbers of the lines that hold a key."""
    return [i for i, line in enumerate(lines) if KEY.match(line)]


def replace_match(rng, text, pattern, replacement):
    """`text` with one match of `pattern` outside comments replaced by replacement(match)."""
    matches = [m for m in pattern.finditer(text) if "#" not in text[text.rfind("\n", 0, m.start()) + 1 : m.start()]]
    if not matches:
        return text
    m = rng.choice(matches)
    return text[: m.start()] + replacement(m.group()) + text[m.end() :]


def scaled_number(rng, text):
    factor = rng.choice([-1.0, 0.1, 10.0, 1e3, 1e-3, 1e6, 1e-6, 1e12, 1e-12, 1e30, 1e-30])
    return replace_match(rng, text, NUMBER, lambda old: repr(float(old) * factor))


def bad_number(rng, text):
    return replace_match(rng, text, NUMBER, lambda _: rng.choice(BAD_NUMBERS))


def bad_string(rng, text):
    other = rng.choice(STRING.findall(text) or ['""'])
    return replace_match(rng, text, STRING, lambda _: rng.choice([*BAD_STRINGS, other]))


def bad_list(rng, text):
    def change(old):
        items = old[1:-1].split(",")
        kind = rng.randrange(4)
        if kind == 0:
            items.pop(rng.randrange(len(items)))
        elif kind == 1:
            items.insert(rng.randrange(len(items) + 1), rng.choice(items))
        elif kind == 2:
            items.reverse()
        else:
            items = items * rng.choice([0, 2, 1000])
        return "[" + ",".join(items) + "]"

    return replace_match(rng, text, LIST, change)


def changed_key(rng, text):
    lines = text.split("\n")
    at = rng.choice(code_lines(lines))
    key = KEY.match(lines[at]).group(1)
    kind = rng.randrange(4)
    if kind == 0:
        lines.pop(at)
    elif kind == 1:
        lines.insert(at, lines[at])
    elif kind == 2:
        cut = rng.randrange(len(key))
        lines[at] = lines[at].replace(key, key[:cut] + rng.choice("aeiou_") + key[cut + 1 :], 1)
    else:
        lines.insert(rng.choice(code_lines(lines)), lines.pop(at))
    return "\n".join(lines)


def changed_table(rng, text):
    lines = text.split("\n")
    headers = [i for i, line in enumerate(lines) if HEADER.match(line)]
    at = rng.choice(headers)
    end = next((i for i in headers if i > at), len(lines))
    kind = rng.randrange(4)
    if kind == 0:
        lines.pop(at)
    elif kind == 1:
        del lines[at:end]
    elif kind == 2:
        lines[end:end] = lines[at:end]
    else:
        lines[at] = lines[rng.choice(headers)]
    return "\n".join(lines)


def changed_bytes(rng, text):
    data = bytearray(text.encode())
    for _ in range(rng.choice([1, 1, 4])):
        at = rng.randrange(len(data) or 1)
        kind = rng.randrange(4)
        if kind == 0:
            data[at : at + 1] = bytes([rng.randrange(256)])
        elif kind == 1:
            del data[at : at + rng.randrange(1, 20)]
        elif kind == 2:
            data[at:at] = bytes(rng.randrange(256) for _ in range(rng.randrange(1, 8)))
        else:
            del data[at:]
            data += b"\n"
    return bytes(data)


CLASSES = {
    "number scaled": scaled_number,
    "number replaced": bad_number,
    "text replaced": bad_string,
    "list changed": bad_list,
    "key changed": changed_key,
    "table changed": changed_table,
    "two faults": None,  # of the six above
    "bytes changed": changed_bytes,
}


def short_case(text):
    """The case with a fiftieth of its time."""
    return re.sub(r"^(end_time\s*=\s*)([\d.eE+-]+)", lambda m: m[1] + repr(float(m[2]) / 50.0), text, flags=re.M)


def make_input(cases, seed, index):
    """Name of the class and bytes of input number `index`."""
    rng = random.Random(f"{seed} {index}")
    name = list(CLASSES)[index % len(CLASSES)]
    text = short_case(rng.choice(cases))
    faults = [CLASSES[name]] if CLASSES[name] else rng.choices(list(CLASSES.values())[:6], k=2)
    for fault in faults:
        text = fault(rng, text)
    return name, text if isinstance(text, bytes) else text.encode()


def judge_values(out, summary):
    """What is wrong with the files of a finished run; None if nothing is."""
    if summary.get("status") != "done":
        return f"exit 0 with status {summary.get('status')}"
    with open(out / "history.csv", newline="") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    for row in rows[1:]:
        if not all(math.isfinite(float(value)) for value in row):
            return "value that is not finite in history.csv"
    return None if len(rows) > 1 else "no row in history.csv"


def run_input(gasjet, case, out):
    """(outcome, what is wrong or None)"""
    process = subprocess.Popen([gasjet, "run", case, "--out", out, "--quiet"], cwd=case.parent, stdin=subprocess.DEVNULL,
                               stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    try:
        message = process.communicate(timeout=PATIENCE)[1]
    except subprocess.TimeoutExpired:
        process.terminate()
        try:
            message = process.communicate(timeout=PATIENCE)[1]
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            return "hang", "does not end on SIGTERM"
    message = message.decode(errors="replace")
    code = process.returncode
    summary = json.loads((out / "summary.json").read_text()) if (out / "summary.json").exists() else {}
    if summary.get("status") == "interrupted":
        return "ended on request", None
    if code == 0:
        return "done", judge_values(out, summary)
    if code == 2:
        if re.search(rf"{re.escape(case.name)}:\d+:\d+: ", message):
            return "refused with place", None
        named = re.search(r"^(gasjet: )?(error: )?\S.*: .+", message)
        return "refused by file", None if named else f"unclear message: {message[:200]!r}"
    if code == 3:
        return "stopped", None if summary.get("message") and message else f"exit 3 without summary: {message[-300:]!r}"
    return "broken", f"exit {code}: {message[-300:]!r}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("gasjet", type=pathlib.Path)
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("number", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    options = parser.parse_args()
    gasjet = options.gasjet.resolve()
    cases = [path.read_text() for path in sorted((options.source / "cases").glob("*.toml"))]

    def work(index):
        name, data = make_input(cases, options.seed, index)
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            for extra in (options.source / "cases").iterdir():  # what the cases read, by their relative names
                if extra.suffix != ".toml":
                    (folder / extra.name).symlink_to(extra.resolve())
            case = folder / "damaged.toml"
            case.write_bytes(data)
            outcome, wrong = run_input(gasjet, case, folder / "out")
            if wrong and options.keep:
                options.keep.mkdir(parents=True, exist_ok=True)
                shutil.copy(case, options.keep / f"{options.seed}_{index}.toml")
        return name, outcome, wrong, f"{options.seed}_{index}"

    return tally(work, options.number, options.jobs, CLASSES,
                 ["done", "refused with place", "refused by file", "stopped", "ended on request", "wrong"])


if __name__ == "__main__":
    sys.exit(main())
