# SPDX-License-Identifier: Apache-2.0
"""Exceptions and the warning of Gasjet. Each text says what is wrong and what is allowed."""


class Error(Exception):
    """A fault of the library, or no memory; and the base of the others."""


class InputError(Error, ValueError):
    """An argument, a file or a case is wrong; nothing was done."""


class DomainError(Error, ArithmeticError):
    """The computation left its domain. Of a run: `run` is what was computed so far."""

    run = None


class BusyError(Error, RuntimeError):
    """Another thread uses the object."""


class StoppedError(Error):
    """The run's callback asked for it; `run` is what was computed so far."""

    run = None


class GasjetWarning(UserWarning):
    """A likely mistake in a case, or an inaccuracy of its run. Turned into an error it has `run`, what was computed."""

    run = None
