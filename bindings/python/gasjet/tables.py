# SPDX-License-Identifier: Apache-2.0
"""Tables: arrays by column, as the result files have them."""
from __future__ import annotations

import csv
import itertools
import os
from typing import Any, Dict, Iterable, List, Mapping, Optional, Union

import numpy as np

from .errors import InputError

Path = Union[str, "os.PathLike[str]"]


class Table(Dict[str, np.ndarray]):
    """Arrays by column; numbers as float64 (an empty cell is nan), other columns as texts. `about`: what its first lines say."""

    def __init__(self, columns: Mapping[str, np.ndarray], about: Optional[Mapping[str, str]] = None) -> None:
        super().__init__(columns)
        self.about: Dict[str, str] = dict(about or {})

    def __repr__(self) -> str:
        return f"<gasjet.Table {_rows(self)} rows: {', '.join(self)}>"

    def to_pandas(self) -> Any:
        """The same as a pandas.DataFrame."""
        return as_frame(self)


def _rows(table: Mapping[str, np.ndarray]) -> int:
    return len(next(iter(table.values()))) if table else 0


def as_frame(table: Mapping[str, np.ndarray]) -> Any:
    """A pandas.DataFrame, by time_s if there is such a column."""
    try:
        import pandas
    except ImportError as error:
        raise ImportError(f"pandas is not installed, allowed with Debian's python3-pandas ({error})") from None
    frame = pandas.DataFrame(dict(table))
    return frame.set_index("time_s") if "time_s" in frame.columns else frame


def _array(cells: List[str]) -> np.ndarray:
    """Numbers if all cells are some, else texts."""
    try:
        return np.array([float(cell) if cell else np.nan for cell in cells], float)
    except ValueError:
        return np.array(cells, str)


def read_table(file: Path) -> Table:
    """A CSV file of Gasjet's, or one like it: lines `# key: value`, a row of names, rows of cells. Raises InputError."""
    try:
        with open(file, encoding="utf-8", newline="") as stream:
            lines = stream.read().splitlines()
    except (OSError, UnicodeError) as error:
        raise InputError(f"{os.fspath(file)}: {getattr(error, 'strerror', None) or error}, allowed: a CSV file in UTF-8") from None
    head = list(itertools.takewhile(lambda line: line.startswith("#"), lines))
    about = dict(line[1:].strip().split(": ", 1) for line in head if ": " in line)
    return Table(_columns(os.fspath(file), csv.reader(lines[len(head):]), len(head)), about)


def _columns(file: str, reader: Iterable[List[str]], above: int) -> Dict[str, np.ndarray]:
    rows = list(reader)
    if not rows or not rows[0]:
        raise InputError(f"{file}: has no names of columns, allowed: a row of them above the numbers")
    for number, row in enumerate(rows[1:], above + 2):
        if len(row) != len(rows[0]):
            raise InputError(f"{file}:{number}: has {len(row)} cells, allowed: {len(rows[0])}, one for each column")
    return {name: _array([row[i] for row in rows[1:]]) for i, name in enumerate(rows[0])}
