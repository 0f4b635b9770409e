# SPDX-License-Identifier: Apache-2.0
"""The commands of `gasjet` as functions. They run the program, so that what they give has its bits."""
from __future__ import annotations

import json
import os
import tempfile
from typing import Any, Dict, List, Mapping, Optional, Sequence, Tuple, Union

from .errors import DomainError, InputError
from .program import UNDECIDED, Case, call, case_words, file_word, folder_for, options
from .results import Results, Run, forget_folder, load
from .runs import file_of
from .tables import Path, Table, read_table


def _results(words: List[str], out: Optional[Path], names: Optional[Mapping[str, str]] = None, accepted: Tuple[int, ...] = (0,)) -> Results:
    """Runs a command that writes a folder."""
    with folder_for(out) as folder:
        try:
            printed = call([*words, f"--out={folder}"], {**(names or {}), **({folder: "out"} if out is None else {})}, accepted)
        except DomainError as error:
            error.run = _kept(folder, out)
            raise
        made = load(folder)
    made.printed = printed
    return made if out is not None else forget_folder(made)


def _kept(folder: str, out: Optional[Path]) -> Optional[Results]:
    """What a command has left that could not end well."""
    try:
        made = load(folder)
    except InputError:
        return None
    return made if out is not None else forget_folder(made)


def check(case: Case, set: Optional[Mapping[str, Any]] = None, text: Optional[str] = None) -> Dict[str, Any]:
    """Validates a case without running it: `settings` (all, by table), `defaults` (the keys that the case leaves out), `derived`, `forecast`
    (which effects will matter) and `warnings`. Arguments as in run(). Raises InputError."""
    with case_words(case, set, text) as (words, names):
        return json.loads(call(["check", *words, "--format=json"], names))


def cost(case: Case, set: Optional[Mapping[str, Any]] = None, out: Optional[Path] = None, text: Optional[str] = None, threads: int = 1,
         runs: Optional[int] = None) -> Results:
    """What jet, hidden-element test, contact, gas and files cost: table `cost`, and `data["variants"]`. runs: of each, the fastest counts."""
    with case_words(case, set, text) as (words, names):
        return _results(["cost", *words, *options(threads=threads, runs=runs)], out, names)


def ensemble(case: Case, set: Optional[Mapping[str, Any]] = None, out: Optional[Path] = None, text: Optional[str] = None, threads: int = 1,
             runs: Optional[int] = None, amplitude: Optional[float] = None, first_seed: Optional[int] = None, against: Optional[Path] = None) -> Results:
    """Repeats a run with displaced nodes: tables `ensemble` (means and standard errors over time), `quantities` and `runs`, and
    `data["quantities"]`.

    amplitude [m]: largest displacement. against: file of a second case; the result then has the table `effects`, and the two in `parts`.
    """
    with case_words(case, set, text) as (words, names):
        more = options(threads=threads, runs=runs, amplitude=amplitude, first_seed=first_seed, against=against)
        made = _results(["ensemble", *words, *more], out, names)
    if against is not None or len(made.parts) != 1:
        return made
    (part,) = made.parts.values()
    part.printed = made.printed
    return part


def ladder(case: Case, quantity: str, tolerance: Union[float, str, None] = None, set: Optional[Mapping[str, Any]] = None,
           out: Optional[Path] = None, text: Optional[str] = None, threads: int = 1, hold: Sequence[str] = (), runs: Optional[int] = None,
           most_runs: Optional[int] = None, error_rate: Optional[float] = None, finer: Optional[int] = None) -> Results:
    """The cheapest form of a case within a tolerance (0.1 or "10%") of a quantity: table `ladder`, `data["cheapest"]`, and
    `texts["cheapest.toml"]`, its case. `data["verdict"]` may be "undecided"."""
    if isinstance(hold, str):
        raise TypeError(f"hold: is {hold!r}, allowed: a list of axes")
    if isinstance(tolerance, (int, float)):
        tolerance = f"{100 * tolerance!r}%"
    with case_words(case, set, text) as (words, names):
        more = options(quantity=quantity, tolerance=tolerance, hold=",".join(hold) or None, runs=runs, most_runs=most_runs,
                       error_rate=error_rate, finer=finer, threads=threads)
        return _results(["ladder", *words, *more], out, names, (0, UNDECIDED))


def study(plan: Case, out: Optional[Path] = None, threads: int = 1) -> Results:
    """Computes the missing runs of a plan (its file, or a dict of its tables): table `results`, and what its analysis asks for.

    With `out` a study that was ended goes on where it was. A dict's files are looked for in the working folder.
    """
    if not isinstance(plan, Mapping):
        plan = file_word(plan, "plan")
    with case_words(plan, None) as (words, names):
        return _results(["study", "run", *words, *options(threads=threads)], out, names, (0, UNDECIDED))


def merge_study(folder: Path) -> Results:
    """The tables of the shares in a study's folder, which `gasjet study run --share` has computed on any machines; `status` may be
    "incomplete"."""
    place = file_word(folder, "folder")
    printed = call(["study", "merge", place], accepted=(0, UNDECIDED))
    made = load(place)
    made.printed = printed
    return made


def identify(readings: Union[Path, Mapping[str, Any]], method: str, volume: float, mass: float, gas: str, out: Optional[Path] = None,
             **more: Any) -> Table:
    """Mass flow and temperature of an inflator from a tank test's readings: a CSV file, or a dict of columns.

    method: "average" or "dual"; volume [m3] of the tank; mass [kg] of the gas; gas: "N2=0.7,CO2=0.3", fractions by mass unless
    by="mole". out: file of the curves for a case, else none. more: the command's other options, with _ for -: points=501,
    heat_loss="fit", tank_unit="kPa gauge". Returns the curves with their 95 % bands; `about` says what the command found.
    """
    with tempfile.TemporaryDirectory() as scratch:
        place = file_word(os.fsdecode(file_of(readings, "readings", scratch, False)), "readings")
        curves = os.path.join(scratch, "curves.csv") if out is None else file_word(out, "out")
        names = {place: "readings"} if isinstance(readings, Mapping) else {}
        call(["identify", place, *options(out=curves, method=method, volume=volume, mass=mass, gas=gas, **more)], names)
        return read_table(curves)


def export(case: Case, format: str, units: str, out: Path, set: Optional[Mapping[str, Any]] = None, text: Optional[str] = None,
           any_size: bool = False) -> Results:
    """Writes a case as a deck: format "radioss" or "lsdyna"; units "kg-m-s", "t-mm-s" or "kg-mm-ms"; out: its folder. `data["keys"]` says
    what became of each key of the case."""
    with case_words(case, set, text) as (words, names):
        return _results(["export", *words, *options(format=format, units=units, any_size=any_size)], out, names)


def import_deck(deck: Path, out: Path, bag: Optional[int] = None, merge_chambers: bool = False, units: Optional[str] = None) -> Results:
    """Writes the bag in another program's deck as a case into the folder `out`: `data["cards"]` says what became of each card, and
    `texts["bag.toml"]` is the case."""
    return _results(["import", file_word(deck, "deck"), *options(bag=bag, merge_chambers=merge_chambers, units=units)], out)


def report(results: Union[Path, Run, Results, Sequence[Union[Path, Run, Results]]], out: Path, against: Optional[Path] = None) -> str:
    """Writes one HTML page that shows results: folders, runs or results that have one, CSV files, or a list of these. Returns its path.

    against: reference (CSV) to judge the runs by.
    """
    some = results if isinstance(results, (list, tuple)) else [results]
    page = file_word(out, "out")
    call(["report", *(file_word(_place(one), "results") for one in some), *options(out=page, against=against)])
    return page


def _place(one: Union[Path, Run, Results]) -> Path:
    if not isinstance(one, (Run, Results)):
        return one
    if one.folder is None:
        raise InputError("results: have no folder, allowed: those with out=, or of gasjet.load(folder)")
    return one.folder
