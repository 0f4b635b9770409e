# SPDX-License-Identifier: Apache-2.0
"""The cases and reference histories that come with the package."""
from __future__ import annotations

import glob
import os
from typing import Dict

from .errors import InputError


def cases() -> Dict[str, str]:
    """Files of the shipped cases by name, also of those made for a reference: gasjet.run(gasjet.cases()["jet_bag"]). InputError if there are none."""
    folder = _folder()
    return {**_by_name(os.path.join(folder, "reference", "*.toml")), **_by_name(os.path.join(folder, "*.toml"))}


def references() -> Dict[str, str]:
    """Files of the reference histories by name of the scene: gasjet.compare(run, gasjet.references()["tank_blowdown"]). Their README.md says
    which case each is of. InputError if there are none."""
    return _by_name(os.path.join(_folder(), "reference", "*.csv"))


def _folder() -> str:
    """In a wheel, in the clone of a build, below a prefix, else in the clone that GASJET names."""
    here = os.path.dirname(os.path.abspath(__file__))
    prefix = os.path.join(here, "..", "..", "..", "..")  # of lib/python3/dist-packages/gasjet
    places = [os.path.join(place, "cases") for place in (here, os.path.join(here, "..", "..", ".."), os.path.join(prefix, "share", "gasjet"),
                                                         os.environ.get("GASJET") or here)]
    for place in places:
        if os.path.isfile(os.path.join(place, "reference", "VERSION")):
            return os.path.normpath(place)
    raise InputError("cases: are not found beside the package; install them (Debian's package gasjet), or set the environment variable GASJET "
                     "to a clone")


def _by_name(pattern: str) -> Dict[str, str]:
    return {os.path.splitext(os.path.basename(file))[0]: file for file in sorted(glob.glob(pattern))}
