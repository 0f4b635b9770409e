# SPDX-License-Identifier: Apache-2.0
"""What tests of the command share: running it, judging what it says, reading and editing files.

A command is written as in a shell, without `gasjet`; words that follow it are taken as they are.
"""
import csv
import json
import os
import re
import resource
import shlex
import signal
import subprocess
import time
import xml.etree.ElementTree as xml
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
GASJET = os.path.abspath(os.environ.get("GASJET", ROOT / "build/gasjet"))


class Done:
    """How a program ended."""

    def __init__(self, done):
        self.code, self.out, self.err = done.returncode, *(text.decode(errors="replace") for text in (done.stdout or b"", done.stderr or b""))
        self.said = self.err + self.out
        self.what = f"exit {self.code} of {' '.join(map(str, done.args))}: {self.said[-3000:]}"


def line(command, *words):
    return [GASJET, *shlex.split(command), *map(str, words)]


def limited(memory=None, file=None, ignore=True):
    """For a child: bounds of its memory and of the size of its files [KiB]; a write beyond fails, or kills unless ignored."""

    def set_limits():
        if memory:
            resource.setrlimit(resource.RLIMIT_AS, (memory << 10, memory << 10))
        if file:
            resource.setrlimit(resource.RLIMIT_FSIZE, (file << 10, file << 10))
            if ignore:
                signal.signal(signal.SIGXFSZ, signal.SIG_IGN)

    return set_limits


def fits(memory):
    """Whether the command starts with so much memory [KiB]; one with sanitizers needs more."""
    return subprocess.run(line("--version"), capture_output=True, preexec_fn=limited(memory)).returncode == 0


def program(*words, env=None, **how):
    """Runs any program."""
    how = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **how}
    return Done(subprocess.run([*map(str, words)], env={**os.environ, **(env or {})}, **how))


def gasjet(command, *words, **how):
    return program(*line(command, *words), **how)


def says(pattern, done):
    assert re.search(pattern, done.said, re.MULTILINE), f"no '{pattern}' in {done.what}"


def ended(code, pattern, done):
    assert done.code == code, f"{code} expected: {done.what}"
    says(pattern, done)
    return done


def expect(code, pattern, command, *words, **how):
    """Runs the command: its exit code, and a pattern in what it says."""
    return ended(code, pattern, gasjet(command, *words, **how))


def ok(command, *words, **how):
    return expect(0, "", command, *words, **how)


def files(folder="."):
    return sorted(os.path.join(at, name) for at, folders, names in os.walk(folder) for name in folders + names)


def refused(pattern, command, *words, **how):
    """The command says what is wrong with its input, and writes nothing."""
    before = files()
    expect(2, pattern, command, *words, **how)
    assert files() == before, f"bad input wrote {set(files()) - set(before)}"


def as_json(command, *words, code=0):
    return json.loads(expect(code, "", command, *words).out)


def started(command, *words, **how):
    """The command in the background, its words in no file unless `stdout` and `stderr` say so."""
    return subprocess.Popen(line(command, *words), stdin=subprocess.DEVNULL, **{"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, **how})


def until(condition, process=None, seconds=60):
    """Waits until the condition holds; True if it does, False if the process ended before."""
    end = time.monotonic() + seconds
    while not condition():
        if process and process.poll() is not None:
            return bool(condition())
        assert time.monotonic() < end, f"waited {seconds} s"
        time.sleep(0.01)
    return True


def has(path, pattern="."):
    """Whether the file is there, and holds the pattern."""
    return os.path.exists(path) and re.search(pattern, read(path), re.MULTILINE) is not None


def stop(process, how=signal.SIGINT):
    """Sends the signal and gives back the exit code."""
    process.send_signal(how)
    return process.wait(60)


def read(path):
    return Path(path).read_bytes().decode(errors="replace")


def write(path, *lines):
    Path(path).write_text("\n".join(lines) + "\n")


def load(path):
    return json.loads(Path(path).read_text(encoding="utf-8"))


def change(path, *edits, to=None):
    """Edits a text by pairs of a regular expression and what takes its place; each changes something."""
    text = read(path)
    for pattern, new in edits:
        text, count = re.subn(pattern, new, text, flags=re.MULTILINE)
        assert count, f"'{pattern}' is not in {path}"
    Path(to or path).write_text(text)


def table(path):
    """Rows of a CSV file by column, as texts."""
    with open(path, newline="", encoding="utf-8-sig") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def numbers(path):
    """Columns of numbers of a CSV file."""
    rows = table(path)
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


def write_table(path, columns, comments=()):
    """Columns by name as a CSV file."""
    with open(path, "w", newline="") as file:
        file.writelines(f"# {comment}\n" for comment in comments)
        out = csv.writer(file, lineterminator="\n")
        out.writerow(columns)
        out.writerows(zip(*columns.values()))


def whole_rows(path):
    """The number of rows; each is whole and ends with its line."""
    lines = [line for line in read(path).splitlines() if not line.startswith("#")]
    assert read(path).endswith("\n") and len({line.count(",") for line in lines}) == 1, f"torn rows in {path}: {read(path)[-300:]!r}"
    return len(lines) - 1


def bare(path, but="date|options"):
    """The file's bytes without some comments."""
    return re.sub(rb"(?m)^# (%s).*\n" % but.encode(), b"", Path(path).read_bytes())


def same(a, b, *names, but="date|options"):
    """Two folders have the same files, but for such comments."""
    for name in names:
        assert bare(f"{a}/{name}", but) == bare(f"{b}/{name}", but), f"{name} of {a} and {b}"


def status(folder):
    return ["", *re.findall("(?m)^status: (.*)", read(f"{folder}/gasjet.status"))][-1]


def write_script(name, text):
    Path(name).write_text(text)
    os.chmod(name, 0o755)
    return os.path.abspath(name)


def arrays(path):
    """Numbers of a .vtp file by the name of their array."""
    return {array.get("Name"): list(map(float, array.text.split())) for array in xml.parse(path).iter("DataArray")}
