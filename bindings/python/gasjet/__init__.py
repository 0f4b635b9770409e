# SPDX-License-Identifier: Apache-2.0
"""Gasjet: airbags inflated with an analytical gas jet. SI units throughout.

run() runs a case, Simulation steps it, load() reads a folder of results. check(), cost(), ensemble(), ladder(), study(), identify(),
mesh(), export(), import_deck() and report() are the program's commands. exact() and catalogue() give the closed forms, compare() judges
histories, cases() and references() are the files that come with it, visible() finds hidden elements, check_surface() finds faults of a
mesh. Gas, Tank, Jet, Surface, Membrane, Contact, SkinContact, Pendulum and RigidBody are parts for your own program,
head_injury_criterion() judges its acceleration.
"""
from . import _gasjet
from .bodies import Jet, Membrane, Surface, check_surface, outlet, visible
from .commands import check, cost, ensemble, export, identify, import_deck, ladder, merge_study, report, study
from .coupling import Contact, Pendulum, RigidBody, SkinContact, head_injury_criterion
from .errors import BusyError, DomainError, Error, GasjetWarning, InputError, StoppedError
from .frames import Frame, Frames
from .gases import Gas, Tank, fabric_leak, orifice
from .meshes import Mesh, mesh
from .results import Results, Run, load
from .runs import catalogue, compare, exact, run
from .shipped import cases, references
from .simulation import Simulation
from .tables import Table

__version__ = _gasjet.version()
__all__ = [
    "BusyError", "Contact", "DomainError", "Error", "Frame", "Frames", "Gas", "GasjetWarning", "InputError", "Jet", "Membrane",
    "Mesh", "Pendulum", "Results", "RigidBody", "Run", "Simulation", "SkinContact", "StoppedError", "Surface", "Table", "Tank",
    "cases", "catalogue", "check", "check_surface", "compare", "cost", "ensemble", "exact", "export", "fabric_leak",
    "head_injury_criterion", "identify", "import_deck", "ladder", "load", "merge_study", "mesh", "orifice", "outlet", "references",
    "report", "run", "study", "visible",
]
