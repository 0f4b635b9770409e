# SPDX-License-Identifier: Apache-2.0
"""Gasjet: airbags inflated with an analytical gas jet. SI units throughout.

run() runs a case, Simulation steps it, exact() and catalogue() give the closed forms, compare() judges histories, visible() finds
hidden elements, check_surface() finds faults of a mesh. Gas, Tank, Jet, Surface, Membrane, Contact, SkinContact, Pendulum and RigidBody
are parts for your own program, head_injury_criterion() judges its acceleration.
"""
from . import _gasjet
from .bodies import Gas, Jet, Membrane, Surface, Tank, check_surface, fabric_leak, orifice, outlet, visible
from .coupling import Contact, Pendulum, RigidBody, SkinContact, head_injury_criterion
from .errors import BusyError, DomainError, Error, GasjetWarning, InputError, StoppedError
from .runs import Run, catalogue, compare, exact, run
from .simulation import Simulation

__version__ = _gasjet.version()
__all__ = [
    "BusyError", "Contact", "DomainError", "Error", "Gas", "GasjetWarning", "InputError", "Jet", "Membrane", "Pendulum", "RigidBody",
    "Run", "Simulation", "SkinContact", "StoppedError", "Surface", "Tank", "catalogue", "check_surface", "compare", "exact", "fabric_leak",
    "head_injury_criterion", "orifice", "outlet", "run", "visible",
]
