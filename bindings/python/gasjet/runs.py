# SPDX-License-Identifier: Apache-2.0
"""Whole runs, closed forms, comparison."""
from __future__ import annotations

import json
import os
import re
import tempfile
import warnings
from typing import Any, Callable, Dict, Mapping, Optional, Sequence, Tuple, Union

import numpy as np

from . import _gasjet
from .arrays import as_column, as_numbers
from .errors import DomainError, GasjetWarning, InputError, StoppedError
from .results import Run
from .tables import Path


def _toml(value: Any) -> str:
    """The text of an override's value."""
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{_toml(str(k))} = {_toml(v)}" for k, v in value.items()) + "}"
    if isinstance(value, np.ndarray):
        return _toml(value.tolist())
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_toml(v) for v in value) + "]"
    raise TypeError(f"set: has a {type(value).__name__}, allowed: numbers, texts, lists and dicts; None takes the key out")


def _override(key: Any, value: Any) -> str:
    """A line of the library's overrides."""
    if not isinstance(key, str) or not key or any(c in key for c in "=\r\n\0"):
        raise TypeError(f"set: has the key {key!r}, allowed: texts such as \"scene.end_time\"")
    return f"unset {key}" if value is None else f"{key}={_toml(value)}"


def _path(given: Any, name: str) -> bytes:
    """The bytes of a path."""
    try:
        path = os.fsencode(given)
        if not path:
            raise ValueError(f"{name}: is empty, allowed: a path")
        return path
    except (TypeError, UnicodeError):
        raise TypeError(f"{name}: is a {type(given).__name__}, allowed: a path") from None


def case_arguments(case: Union[Path, Mapping[str, Any]], text: Optional[str], set: Optional[Mapping[str, Any]],
                   out: Optional[Path]) -> Tuple[bytes, Optional[str], str, Optional[bytes]]:
    """File, text, overrides and folder for the library. A case may be a dict; its files are then looked for in the working folder."""
    if set is not None and not isinstance(set, Mapping):
        raise TypeError(f"set: is a {type(set).__name__}, allowed: a dict")
    if isinstance(case, Mapping):
        if text is not None:
            raise TypeError("text: is given beside a dict, allowed: one of the two")
        case, text = "case.toml", "".join(f"{json.dumps(str(key))} = {_toml(value)}\n" for key, value in case.items())
    overrides = "\n".join(_override(key, value) for key, value in (set or {}).items())
    return _path(case, "case"), text, overrides, None if out is None else _path(out, "out")


def run(case: Union[Path, Mapping[str, Any]], set: Optional[Mapping[str, Any]] = None, out: Optional[Path] = None, threads: int = 1,
        text: Optional[str] = None, progress: Optional[Callable[[float, float], Any]] = None) -> Run:
    """Runs a case like the command `gasjet run`, with the same bits.

    case: its file, or a dict of its tables; if `text` is given, that is the case, and the file only its name. set: {"key.path": value}, None removes a key. out:
    folder for the command's files. progress(time, end) is called some ten times a second; if it returns True, the run stops.
    Raises InputError, DomainError or StoppedError. The last two, KeyboardInterrupt and exceptions of `progress` have the
    results so far in `.run`. Each of the run's warnings is a GasjetWarning.
    """
    if progress is not None and not callable(progress):
        raise TypeError(f"progress: is a {type(progress).__name__}, allowed: a function of time and end")
    try:
        status, message, history, energy, summary, raised = _gasjet.run(*case_arguments(case, text, set, out), threads, progress)
    except InputError as error:
        raise InputError(in_words(str(error))) from None
    made = Run(history, energy, json.loads(summary), out)
    if raised is not None:
        raise _with_run(raised, made)
    for warning in made.warnings:
        try:
            warnings.warn(warning, GasjetWarning, stacklevel=2)
        except GasjetWarning as error:  # if the caller asked for errors
            raise _with_run(error, made)
    if status != 0:
        raise _with_run((DomainError if status == 3 else StoppedError)(message), made)
    return made


def _with_run(error: BaseException, made: Run) -> BaseException:
    try:
        error.run = made  # type: ignore[attr-defined]
    except (AttributeError, TypeError):  # a class of the caller's that takes no attribute
        pass
    return error


def in_words(text: str) -> str:
    """A message of the command, with options renamed to arguments."""
    text = re.sub(r"^--unset (.*?):", r"set: \1=None:", text)
    return re.sub(r"--(columns|tolerance|map)\b", r"\1", re.sub(r"^--(set|out|columns|tolerance) ", r"\1: ", text))


def _closed_forms() -> Any:
    """The module that links GSL; it may be left out of an installation."""
    try:
        from . import _exact
    except ImportError as error:
        raise ImportError(f"the closed forms are not installed, allowed with Debian's python3-gasjet-exact ({error})") from None
    return _exact


def _number(given: Any, name: str) -> float:
    array = as_numbers(given, name)
    if array.ndim != 0:
        raise TypeError(f"{name}: is an array, allowed: a number")
    return float(array)


def exact(name: str, times: Any = None, **parameters: float) -> Dict[str, np.ndarray]:
    """A closed form by name (see catalogue()), as arrays by column; times: its abscissae. Loads GSL, which is GPL."""
    _exact = _closed_forms()
    lines = "\n".join(f"{key}={_number(value, key)!r}" for key, value in parameters.items())
    abscissae = np.zeros(0) if times is None else as_column(times, "times")
    table = _exact.evaluate(name, lines, abscissae)
    none_asked = times is not None and abscissae.size == 0  # the library then takes the form's own
    return {column: values[:0] for column, values in table.items()} if none_asked else table


def catalogue() -> Dict[str, Dict[str, Any]]:
    """All closed forms: equation, parameters with units and defaults, columns, validity, source."""
    return {entry["name"]: entry for entry in json.loads(_closed_forms().catalogue())}


def compare(mine: Union[Path, Mapping[str, Any], Run], reference: Union[Path, Mapping[str, Any], Run],
            map: Optional[Path] = None, tolerance: float = 0.0, columns: Sequence[str] = ()) -> Dict[str, Any]:
    """Judges a history by the reference's band.

    Either is a CSV file, a Run, or a dict of columns with "time_s". map: file that names a foreign program's columns. columns: names
    of the quantities to compare; none: all. Returns
    - verdict (inside, outside or undecided) and reason; mine and reference, what was compared; rows, the number of times;
      runs and reference_runs, if the reference is a mean; format, version and commit of this program;
    - quantities, by name: verdict, reason, max_error and its time, l2_error, relative_error, share_of_band, phase_lag_s, peak,
      reference_peak; seen_share, if the reference is a mean.
    """
    if not isinstance(columns, (list, tuple)) or not all(isinstance(name, str) and name and "," not in name for name in columns):
        raise TypeError(f"columns: is {columns!r}, allowed: a list of names")
    with tempfile.TemporaryDirectory() as folder:
        files = [file_of(mine, "mine", folder, map is None), file_of(reference, "reference", folder, True)]
        try:
            text = _gasjet.compare(*files, None if map is None else _path(map, "map"), ",".join(columns), tolerance)
        except InputError as error:
            raise InputError(in_words(_without_file(str(error), folder))) from None
    difference: Dict[str, Any] = json.loads(text)
    for name, given in (("mine", mine), ("reference", reference)):
        if isinstance(given, (Run, Mapping)):
            difference[name] = "a Run" if isinstance(given, Run) else "a dict"
    for part in (difference, *difference["quantities"].values()):
        if part.get("reason"):
            part["reason"] = in_words(part["reason"])
    return difference


def _without_file(text: str, folder: str) -> str:
    """A message of a temporary file, in terms of the columns that it was written from."""

    def place(found: Any) -> str:
        name, line, column = found.group(1), int(found.group(2) or 0), found.group(3)
        return f"{name}: {column}[{line - 2}]: " if column and line > 1 else f"{name}: {column}: " if column else f"{name}: "

    return re.sub(re.escape(os.path.join(folder, "")) + r"(mine|reference)\.csv(?::(\d+):\d+)?: (?:(\w+): )?", place, text)


def file_of(history: Any, argument: str, folder: str, own_names: bool) -> bytes:
    """The file of a history; a dict is written into the folder, with all digits."""
    if isinstance(history, Run):
        history = history.history
    if not isinstance(history, Mapping):
        return _path(history, argument)
    if not history:
        raise ValueError(f"{argument}: has no columns, allowed: time_s and others")
    for name in history:
        if not isinstance(name, str) or not name or any(c in name for c in ',"#\r\n\0'):
            raise TypeError(f"{argument}: has the column {name!r}, allowed: names without commas, quotes, # and new lines")
    columns = {name: as_numbers(values, f"{argument}: {name}") for name, values in history.items()}
    if len({values.shape for values in columns.values()}) > 1 or any(values.ndim != 1 for values in columns.values()):
        raise ValueError(f"{argument}: has columns that differ in length, allowed: one dimension and the same length")
    if own_names and "time_s" not in columns:
        raise InputError(f"{argument}: has no column time_s, only {', '.join(columns)}")
    if (count := len(next(iter(columns.values())))) < 3:
        raise InputError(f"{argument}: has {count} numbers in each column, allowed: 3 or more")
    for name, values in columns.items():
        if not np.isfinite(values).all():
            at = int(np.argmin(np.isfinite(values)))
            raise InputError(f"{argument}: {name}[{at}]: is {values[at]}, allowed: finite numbers")
    path = os.path.join(folder, argument + ".csv")
    with open(path, "w", encoding="utf-8") as file:
        file.write(",".join(columns) + "\n")
        for row in zip(*columns.values()):
            file.write(",".join(repr(float(value)) for value in row) + "\n")
    return os.fsencode(path)
