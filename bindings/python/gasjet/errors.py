# SPDX-License-Identifier: Apache-2.0
"""Exceptions and the warning of Gasjet. Each text describes the fault and the allowed values."""


class Error(Exception):
    """A fault of the library, or lack of memory; base of the other exceptions."""


class InputError(Error, ValueError):
    """An argument, a file or a case is wrong; nothing was changed."""


class DomainError(Error, ArithmeticError):
    """The computation left its domain. For a run, `run` has the results so far."""

    run = None


class BusyError(Error, RuntimeError):
    """Another thread uses the object."""


class StoppedError(Error):
    """The run's callback stopped it; `run` has the results so far."""

    run = None


class GasjetWarning(UserWarning):
    """A likely mistake in a case, or an inaccuracy of its run. If turned into an error, its `run` has the results."""

    run = None
