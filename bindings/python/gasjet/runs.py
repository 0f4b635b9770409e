# SPDX-License-Identifier: Apache-2.0
"""Whole runs, closed forms, comparison."""
from __future__ import annotations

import json
import os
import tempfile
from typing import Any, Callable, Dict, Mapping, Optional, Union

import numpy as np

from . import _gasjet
from .errors import DomainError, StoppedError

Path = Union[str, "os.PathLike[str]"]
Table = Dict[str, np.ndarray]


class Run:
    """What a run gave: `history` and `energy`, arrays by column, views that keep the run; `summary` as summary.json."""

    def __init__(self, history: Table, energy: Table, summary: Dict[str, Any]) -> None:
        self.history = history
        self.energy = energy
        self.summary = summary

    def __repr__(self) -> str:
        return f"<gasjet.Run {self.summary['scene']}: {self.summary['status']}, {len(self.history['time_s'])} rows>"


def _toml(value: Any) -> str:
    """A value of an override."""
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    if isinstance(value, str):
        return json.dumps(value)
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{json.dumps(str(k))} = {_toml(v)}" for k, v in value.items()) + "}"
    if isinstance(value, (list, tuple, np.ndarray)):
        return "[" + ", ".join(_toml(v) for v in value) + "]"
    raise TypeError(f"set: a {type(value).__name__}, allowed: numbers, texts, lists and dicts; None takes the key out")


def run(case: Path, set: Optional[Mapping[str, Any]] = None, out: Optional[Path] = None, threads: int = 1,
        text: Optional[str] = None, progress: Optional[Callable[[float, float], Any]] = None) -> Run:
    """Runs a case, as the command `gasjet run` does, to the same bits.

    case: its file; with `text`, the case itself, the file only names it. set: {"key.path": value}, None takes a key out. out:
    folder for the command's files. progress(time, end) is called some ten times a second; if it returns True, the run stops.
    Raises InputError, DomainError or StoppedError; of the last two `.run` is what was computed.
    """
    overrides = [f"unset {key}" if value is None else f"{key}={_toml(value)}" for key, value in (set or {}).items()]
    status, message, history, energy, summary = _gasjet.run(
        os.fspath(case), text, "\n".join(overrides), None if out is None else os.fspath(out), threads, progress)
    made = Run(history, energy, json.loads(summary))
    if status != 0:
        error = (DomainError if status == 3 else StoppedError)(message)
        error.run = made
        raise error
    return made


def _closed_forms() -> Any:
    """The module that links GSL; it may be left out of an installation."""
    try:
        from . import _exact
    except ImportError as error:
        raise ImportError(f"the closed forms are not installed, allowed with Debian's python3-gasjet-exact ({error})") from None
    return _exact


def exact(name: str, times: Any = None, **parameters: float) -> Table:
    """A closed form by name (see catalogue()), as arrays by column; times: its abscissae. Loads GSL, which is GPL."""
    _exact = _closed_forms()
    lines = "\n".join(f"{key}={float(value)!r}" for key, value in parameters.items())
    return _exact.evaluate(name, lines, np.zeros(0) if times is None else np.atleast_1d(np.asarray(times, float)))


def catalogue() -> Dict[str, Dict[str, Any]]:
    """All closed forms: equation, parameters with units and defaults, columns, validity, source."""
    return {entry["name"]: entry for entry in json.loads(_closed_forms().catalogue())}


def compare(mine: Union[Path, Mapping[str, Any], Run], reference: Union[Path, Mapping[str, Any], Run],
            map: Optional[Path] = None, tolerance: float = 0.0) -> Dict[str, Any]:
    """Judges a history by the reference's band, as `gasjet compare` does: "verdict" and each quantity's difference.

    Either is a CSV file, a Run, or a dict of columns with "time_s". map: file that names a foreign program's columns.
    """
    with tempfile.TemporaryDirectory() as folder:
        files = [_file_of(given, os.path.join(folder, name)) for given, name in ((mine, "mine.csv"), (reference, "reference.csv"))]
        return json.loads(_gasjet.compare(*files, None if map is None else os.fspath(map), tolerance))


def _file_of(history: Any, path: str) -> str:
    """The file of a history; one of a dict is written to `path`, its numbers as they are."""
    if isinstance(history, Run):
        history = history.history
    if not isinstance(history, Mapping):
        return os.fspath(history)
    columns = {name: np.asarray(values, float) for name, values in history.items()}
    if len({values.shape for values in columns.values()}) > 1 or any(values.ndim != 1 for values in columns.values()):
        raise ValueError("history: columns differ in length, allowed: one dimension and the same length")
    with open(path, "w", encoding="utf-8") as file:
        file.write(",".join(columns) + "\n")
        for row in zip(*columns.values()):
            file.write(",".join(repr(float(value)) for value in row) + "\n")
    return path
