# SPDX-License-Identifier: Apache-2.0
"""Runs the program `gasjet` and gives its messages as this package's exceptions and warnings."""
from __future__ import annotations

import contextlib
import fcntl
import functools
import hashlib
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import warnings
from typing import Any, Dict, Iterator, List, Mapping, Optional, TextIO, Tuple, Union

import numpy as np

from . import _gasjet
from .errors import DomainError, Error, GasjetWarning, InputError, StoppedError
from .runs import case_arguments, in_words
from .tables import Path

Case = Union[Path, Mapping[str, Any]]
UNDECIDED = 4  # exit code of a ladder, and of a study with missing runs: not a fault


def find_program() -> str:
    """The program beside the package, else that of the environment variable GASJET (the program, or a clone with build/gasjet), else of
    PATH. InputError if there is none, or if it is of another version than the package."""
    for path in _beside():
        if _runs(path):
            return _of_this_version(path)
    given = os.environ.get("GASJET")
    if given:
        path = os.path.join(given, "build", "gasjet") if os.path.isdir(given) else given
        if not _runs(path):
            raise InputError(f"GASJET: {path} is no program, allowed: the path of gasjet, or a clone in which build/gasjet is")
        return _of_this_version(path)
    found = shutil.which("gasjet")
    if not found:
        raise InputError("gasjet: the program is not found beside the package or on PATH; "
                         "install it (Debian's package gasjet), or set the environment variable GASJET to its path")
    return _of_this_version(found)


def _beside() -> Tuple[str, ...]:
    """Where the program is in a wheel, in a build's folder and below a prefix."""
    here = os.path.dirname(os.path.abspath(__file__))
    prefix = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(here))))  # of lib/python3/dist-packages/gasjet
    return os.path.join(here, "gasjet"), os.path.join(here, "..", "..", "gasjet"), os.path.join(prefix, "bin", "gasjet")


def main() -> None:
    """Becomes the program beside the package: the command `gasjet` that pip installs."""
    for path in _beside():
        if _runs(path):
            os.execv(path, ["gasjet", *sys.argv[1:]])
    sys.exit("gasjet: the program is not beside the package; install the package again")


def _runs(path: str) -> bool:
    return os.path.isfile(path) and os.access(path, os.X_OK)


@functools.lru_cache(maxsize=None)
def _of_this_version(path: str) -> str:
    try:
        said = subprocess.run([path, "--version"], stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace").stdout
    except OSError as error:
        raise InputError(f"gasjet: {path}: {error.strerror}, allowed: the program gasjet") from None
    version = said.split()[1:2] if said.startswith("gasjet ") else []
    if version != [_gasjet.version()]:
        raise InputError(f"gasjet: {path} is of version {' '.join(version) or 'none'}, allowed: {_gasjet.version()}, that of the package")
    return path


def options(**given: Any) -> List[str]:
    """Arguments as options of the command; None and False leave one out, a list repeats it."""
    words = []
    for name, value in given.items():
        flag = "--" + name.replace("_", "-")
        if isinstance(value, (bool, np.bool_)):
            words += [flag] if value else []
        elif value is not None:
            some = value if isinstance(value, (list, tuple)) else [value]
            words += [f"{flag}={_word(one, name)}" for one in some]
    return words


def _word(value: Any, name: str) -> str:
    if isinstance(value, (int, np.integer)) and not isinstance(value, bool):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    try:
        word = os.fsdecode(value)
    except TypeError:
        raise TypeError(f"{name}: is a {type(value).__name__}, allowed: a number, a text or a path") from None
    if not word or "\0" in word:
        raise InputError(f"{name}: is {word!r}, allowed: a text that is not empty")
    return word


def file_word(path: Any, name: str) -> str:
    """A path as an argument of the command, never an option."""
    if isinstance(path, (int, float)):
        raise TypeError(f"{name}: is a {type(path).__name__}, allowed: a path")
    word = _word(path, name)
    return os.path.join(".", word) if word.startswith("-") else word


@contextlib.contextmanager
def case_words(case: Case, set: Optional[Mapping[str, Any]], text: Optional[str] = None) -> Iterator[Tuple[List[str], Dict[str, str]]]:
    """The arguments for a case, and its names in messages. A dict or text is a file while the command runs, where its files are looked for."""
    path, content, overrides, _ = case_arguments(case, text, set, None)
    words = [f"--unset={line[6:]}" if line.startswith("unset ") else f"--set={line}" for line in overrides.split("\n") if line]
    name = file_word(path, "case")
    with contextlib.ExitStack() as after:
        names = {}
        if content is not None:
            name, names = _written(name, content, after)
        yield [name, *words], names


def _written(name: str, content: str, after: contextlib.ExitStack) -> Tuple[str, Dict[str, str]]:
    """A file beside `name`, called after the content too, so that a command which is called again finds its results."""
    stem, ending = os.path.splitext(name)
    file = f"{stem}_{hashlib.sha256(content.encode()).hexdigest()[:8]}{ending or '.toml'}"
    try:
        stream = _shared(file, content)
    except OSError as error:
        raise InputError(f"case: cannot be written to {file}: {error.strerror}; a dict needs a working folder that can be written to") from None
    after.callback(_leave, stream, file)
    return file, {file: name, os.path.basename(file)[:-len(ending or '.toml')]: os.path.basename(stem)}


def _shared(file: str, content: str) -> TextIO:
    """The file with this content, locked by all who use it: runs of the same dict may go on side by side in one folder."""
    while True:
        stream = open(file, "a", encoding="utf-8")
        with contextlib.suppress(BlockingIOError):  # somebody uses it, so it is whole
            fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
            stream.truncate(0)
            stream.write(content)
            stream.flush()
        fcntl.flock(stream, fcntl.LOCK_SH)
        with contextlib.suppress(FileNotFoundError):  # its last user removed it in between
            if os.path.samestat(os.fstat(stream.fileno()), os.stat(file)):
                return stream
        stream.close()


def _leave(stream: TextIO, file: str) -> None:
    """The last user removes the file."""
    with stream, contextlib.suppress(BlockingIOError):
        fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
        os.unlink(file)


@contextlib.contextmanager
def folder_for(out: Optional[Path]) -> Iterator[str]:
    """`out`, or a folder for as long as the command runs."""
    if out is not None:
        yield file_word(out, "out")
        return
    with tempfile.TemporaryDirectory() as scratch:
        yield os.path.join(scratch, "results")


def call(words: List[str], names: Optional[Mapping[str, str]] = None, accepted: Tuple[int, ...] = (0,)) -> str:
    """What the command prints. names: how paths are called in messages. Raises InputError (exit code 2), DomainError (3), StoppedError
    (130: somebody else ended it), Error. Ctrl-C ends the command as it ends `gasjet`, what it has computed is kept."""
    # A session of its own: Ctrl-C reaches it once, from here. A second one would kill it at once.
    with subprocess.Popen([find_program(), *words], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8",
                          errors="replace", start_new_session=True) as process:
        try:
            printed, told = process.communicate()
        except BaseException:
            process.send_signal(signal.SIGINT)
            process.communicate()
            raise
    for path, name in (names or {}).items():
        printed, told = printed.replace(path, name), told.replace(path, name)
    lines = told.splitlines()
    for line in lines:
        if line.startswith("warning: "):
            warnings.warn(line[9:], GasjetWarning, stacklevel=3)
    if process.returncode not in accepted:
        message = "\n".join(line.removeprefix("gasjet: ") for line in lines if not line.startswith("warning: "))
        raise _error(process.returncode, _in_python(message) or f"gasjet {words[0]} ended with exit code {process.returncode}")
    return printed


def _in_python(message: str) -> str:
    """A message of the command, with options renamed to arguments."""
    text = in_words(message).replace("; --help lists the options", "")
    return re.sub(r"--([a-z]+(?:-[a-z]+)*)\b", lambda found: found[1].replace("-", "_"), text)


def _error(code: int, message: str) -> Error:
    return {2: InputError, 3: DomainError, 130: StoppedError}.get(code, Error)(message)
