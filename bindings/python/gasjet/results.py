# SPDX-License-Identifier: Apache-2.0
"""Results of runs and commands, of this program or in a folder."""
from __future__ import annotations

import json
import os
from typing import Any, Dict, List, Mapping, Optional, Tuple, Union

import numpy as np

from .display import page
from .errors import InputError
from .frames import Frames, read_frames
from .tables import Path, Table, as_frame, read_table

STATUS_HEAD = "# Written by gasjet:"
TEXTS = (".toml", ".md", ".svg", ".txt")


class Run:
    """Results of a run: `history` and `energy`, arrays by column (views that keep the run alive); `summary` as in summary.json.

    `warnings`: likely mistakes in the case, and a drift of the energy, as the command prints them. `folder`: where its files are, or None.
    """

    __slots__ = ("history", "energy", "summary", "warnings", "folder", "_frames", "__weakref__")

    def __init__(self, history: Mapping[str, np.ndarray], energy: Mapping[str, np.ndarray], summary: Dict[str, Any],
                 folder: Optional[Union[Path, bytes]] = None) -> None:
        self.history = history
        self.energy = energy
        self.summary = summary
        self.warnings: List[str] = summary["warnings"]
        self.folder = None if folder is None else os.path.abspath(os.fsdecode(folder))
        self._frames: Optional[Frames] = None

    def __repr__(self) -> str:
        told = {0: "", 1: ", 1 warning"}.get(len(self.warnings), f", {len(self.warnings)} warnings")
        return f"<gasjet.Run {self.summary['scene']}: {self.summary['status']}, {len(self.history['time_s'])} rows{told}>"

    def _repr_html_(self) -> str:
        try:
            frame = self.frames[-1]
        except InputError:
            frame = None
        return page(f"gasjet: {self.summary['scene']}", self.summary, self.history, frame)

    @property
    def frames(self) -> Frames:
        """The bag or target at the times of frames.bin, read when you first ask. InputError without a folder or such a file."""
        if self._frames is None:
            if self.folder is None:
                raise InputError("frames: the run has no folder, allowed: a run with out=, or gasjet.load(folder)")
            self._frames = read_frames(os.path.join(self.folder, "frames.bin"), self.summary.get("run"))
        return self._frames

    def to_meshio(self, index: int = -1) -> Any:
        """Frame `index` as a meshio.Mesh, see Frame.to_meshio."""
        return self.frames[index].to_meshio()

    def to_pandas(self, energy: bool = False) -> Any:
        """The history, or the energies, as a pandas.DataFrame by time_s."""
        return as_frame(self.energy if energy else self.history)


class Results:
    """What a command other than `run` has written to its folder.

    `data`: its JSON file; `tables`: its CSV files by name, as arrays by column; `texts`: its other readable files by name; `parts`: the
    results in its folders by name; `printed`: what the command printed. `folder`: where the files are; None if that was temporary.
    """

    __slots__ = ("command", "status", "data", "tables", "texts", "parts", "printed", "folder", "__weakref__")

    def __init__(self, folder: str) -> None:
        self.command, self.status, names = _finished(folder)
        self.folder: Optional[str] = folder
        self.data: Dict[str, Any] = {}
        self.tables: Dict[str, Table] = {}
        self.texts: Dict[str, str] = {}
        self.printed = ""
        for name in names:
            stem, ending = os.path.splitext(name)
            path = os.path.join(folder, name)
            if not os.path.exists(path):  # a journal of runs that have ended
                continue
            if ending == ".json":
                self.data = _json(path)
            elif ending == ".csv":
                self.tables[stem] = read_table(path)
            elif ending in TEXTS:
                with open(path, encoding="utf-8") as file:
                    self.texts[name] = file.read()
        inner = [name for name in sorted(os.listdir(folder)) if os.path.isfile(os.path.join(folder, name, "gasjet.status"))]
        self.parts: Dict[str, Results] = {name: Results(os.path.join(folder, name)) for name in inner}

    def __repr__(self) -> str:
        inside = [*self.tables, *self.texts, *self.parts]
        return f"<gasjet.Results of {self.command}: {self.status}{', ' if inside else ''}{', '.join(inside)}>"


def forget_folder(results: Results) -> Results:
    """The same without a folder, for one that will be removed."""
    results.folder = None
    for part in results.parts.values():
        forget_folder(part)
    return results


def load(folder: Path) -> Union[Run, Results]:
    """The results in a folder that `gasjet` or this package has written: a Run, or the Results of another command.

    A folder whose run goes on or was killed is refused by InputError, and so is a file of another run.
    """
    try:
        place = os.fsdecode(folder)
    except TypeError:
        raise TypeError(f"folder: is a {type(folder).__name__}, allowed: a path") from None
    command, _, _ = _finished(place)
    if command != "run":
        return Results(place)
    summary = _json(os.path.join(place, "summary.json"))
    history, energy = (read_table(os.path.join(place, name)) for name in ("history.csv", "energy.csv"))
    for name, table in (("history.csv", history), ("energy.csv", energy)):
        if table.about.get("run") != summary["run"]:
            raise InputError(f"{os.path.join(place, name)}: is of run {table.about.get('run')}, allowed: {summary['run']}, that of summary.json")
    return Run(history, energy, summary, place)


def _json(path: str) -> Dict[str, Any]:
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except OSError as error:
        raise InputError(f"{path}: {error.strerror}, allowed: a file of the folder's run") from None
    except ValueError as error:
        raise InputError(f"{path}: is no whole JSON file: {error}") from None


def _finished(folder: str) -> Tuple[str, str, List[str]]:
    """Command, status and files of a folder whose command has ended."""
    path = os.path.join(folder, "gasjet.status")
    try:
        with open(path, encoding="utf-8") as file:
            head, *lines = file.read().split("\n")
    except (OSError, UnicodeError):
        raise InputError(f"{folder}: has no readable gasjet.status, allowed: a folder of results") from None
    if not head.startswith(STATUS_HEAD):
        raise InputError(f"{path}: is not a status file of gasjet, allowed: a folder of results")
    pairs = [line.split(": ", 1) for line in lines[:-1] if ": " in line]  # a line without its end is torn
    last = dict(pairs)
    if last.get("status", "running") == "running":
        raise InputError(f"{folder}: its {last.get('command', 'run')} has not ended; wait for it, or start it again if it was killed")
    return last.get("command", ""), last["status"], [value for key, value in pairs if key == "file" and os.path.basename(value) == value]
