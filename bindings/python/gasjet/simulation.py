# SPDX-License-Identifier: Apache-2.0
"""Cases that a program steps."""
from __future__ import annotations

import json
import warnings
from typing import Any, Callable, Dict, Mapping, Optional, Tuple, Union

import numpy as np

from . import _gasjet
from .arrays import Vector, as_numbers
from .errors import Error, GasjetWarning, InputError
from .runs import Path, Run, case_arguments, in_words


class Simulation:
    """A case that you step, read and change between steps; without changes it has the bits of run().

    Arguments and the case's warnings are as in run(). With `out`, the command's files are written while it goes on, with the energies'
    term driving_work_J, and looks whether the skin passes through itself; finish() completes them.

    A step has two halves. The first finds gas, forces and the length of the step at the level where the simulation is; the second moves
    it. What you read of forces does the first half. Arrays are views of shape (n, 3) that change as the simulation steps; forces in them
    are those of the last evaluate(). What you set stays until you set it again; gas outside, inflow and outlets
    act from this level on, or from the next one if this is evaluated. Computations that leave their domain raise DomainError.
    """

    __slots__ = ("_handle", "_case", "_own_force", "__weakref__")

    def __init__(self, case: Union[Path, Mapping[str, Any]], set: Optional[Mapping[str, Any]] = None, out: Optional[Path] = None,
                 threads: int = 1, text: Optional[str] = None) -> None:
        self._case = (*case_arguments(case, text, set, out), threads)
        try:
            self._handle = _gasjet.sim_create(*self._case)
        except InputError as error:
            raise InputError(in_words(str(error))) from None
        self._own_force: Optional[np.ndarray] = None
        for warning in self.results.warnings:
            warnings.warn(warning, GasjetWarning, stacklevel=2)

    def __repr__(self) -> str:
        try:
            time, steps, ended = _gasjet.sim_time(self._handle)
        except Error:  # another thread uses it
            return "<gasjet.Simulation>"
        return f"<gasjet.Simulation at {time:g} s, step {steps}{', ended' if ended else ''}>"

    def clone(self) -> Simulation:
        """A simulation in the same state, which goes on by itself; without a folder. copy.copy() does the same."""
        return self._of(_gasjet.sim_clone(self._handle), self._case)

    @classmethod
    def _of(cls, handle: Any, case: Tuple[Any, ...]) -> Simulation:
        made = cls.__new__(cls)
        made._handle, made._case, made._own_force = handle, case, None
        return made

    @classmethod
    def _restored(cls, case: Tuple[Any, ...], state: bytes) -> Simulation:
        made = cls._of(_gasjet.sim_create(*case), case)
        made.restore(state)
        return made

    def __reduce__(self) -> Tuple[Any, ...]:
        file, text, overrides, _, threads = self._case  # the folder stays with this one
        return Simulation._restored, ((file, text, overrides, None, threads), self.save())

    def __copy__(self) -> Simulation:
        return self.clone()

    def __deepcopy__(self, memo: Any) -> Simulation:
        return self.clone()

    def assign(self, other: Simulation) -> None:
        """Takes over the state of a clone, or of what this was cloned from: `saved = s.clone()` and later `s.assign(saved)`."""
        _gasjet.sim_assign(self._handle, _handle_of(other))

    def save(self) -> bytes:
        """The state and all that was set, without the rows so far; only the same build reads it. Pickling uses it."""
        return _gasjet.sim_save(self._handle)

    def restore(self, state: bytes) -> None:
        """Goes on from a saved state of the same case, with the same bits; the rows so far stay."""
        _gasjet.sim_restore(self._handle, state)

    def reset(self) -> None:
        """Back to time 0 of the case, without any change."""
        _gasjet.sim_reset(self._handle)

    def evaluate(self) -> float:
        """The first half of the step; returns its length [s], 0 at the end."""
        return _gasjet.sim_evaluate(self._handle)[0]

    def step(self, count: int = 1) -> None:
        """Steps; fewer at the end of the scene. Ctrl-C ends it after some."""
        _gasjet.sim_step(self._handle, count)

    def advance(self, time: float, progress: Optional[Callable[[float, float], Any]] = None) -> None:
        """Steps until `time` [s] is reached or passed. progress as in run(): StoppedError if it returns True."""
        _gasjet.sim_advance(self._handle, time, False, progress)

    def advance_exactly(self, time: float, progress: Optional[Callable[[float, float], Any]] = None) -> None:
        """The same with steps that meet `time`."""
        _gasjet.sim_advance(self._handle, time, True, progress)

    def meet_every(self, interval: float) -> None:
        """Steps meet the multiples of `interval` [s] from now on, at which you exchange values with another program; 0: of none."""
        _gasjet.sim_meet_every(self._handle, interval)

    def finish(self) -> None:
        """Evaluates the last level if it is reached, and completes the files of `out`."""
        _gasjet.sim_finish(self._handle)

    @property
    def time(self) -> float:
        """[s] Where it is."""
        return _gasjet.sim_time(self._handle)[0]

    @property
    def steps(self) -> int:
        """Number of the level."""
        return _gasjet.sim_time(self._handle)[1]

    @property
    def ended(self) -> bool:
        """True at the end of the scene."""
        return _gasjet.sim_time(self._handle)[2]

    @property
    def step_limits(self) -> Tuple[float, float]:
        """[s] Length of the step that leaves the level, and its bound by stability."""
        return _gasjet.sim_evaluate(self._handle)

    @property
    def position(self) -> np.ndarray:
        """[m] (nodes, 3) of the level."""
        return _gasjet.sim_array(self._handle, 0)

    @property
    def velocity(self) -> np.ndarray:
        """[m/s] (nodes, 3) half a step before the level."""
        return _gasjet.sim_array(self._handle, 1)

    @property
    def fabric_force(self) -> np.ndarray:
        """[N] (nodes, 3) of the fabric's stress, of the level."""
        return _gasjet.sim_array(self._handle, 2)

    @property
    def volume_gradient(self) -> np.ndarray:
        """[m2] (nodes, 3) dV/dx of the level; times the overpressure it is the gas's force."""
        return _gasjet.sim_array(self._handle, 3)

    def _evaluated(self, array: int) -> np.ndarray:
        _gasjet.sim_evaluate(self._handle)
        return _gasjet.sim_array(self._handle, array)

    @property
    def contact_force(self) -> np.ndarray:
        """[N] (nodes, 3); no rows without contact."""
        return self._evaluated(4)

    @property
    def jet_force(self) -> np.ndarray:
        """[N] (nodes, 3); no rows without jets."""
        return self._evaluated(5)

    @property
    def support_force(self) -> np.ndarray:
        """[N] (nodes, 3) of straps and plates; no rows without them."""
        return self._evaluated(6)

    @property
    def own_force(self) -> np.ndarray:
        """[N] (nodes, 3) of yours, zero at first: write into it at any time. The bound of the step does not know their stiffness."""
        if self._own_force is None:
            self._own_force = _gasjet.sim_own_force(self._handle)
        return self._own_force

    @property
    def triangles(self) -> np.ndarray:
        """(elements, 3) node numbers of the skin."""
        return _gasjet.sim_triangles(self._handle)

    def overpressure(self, jet: int = 0) -> np.ndarray:
        """[Pa] (elements) of a jet, 0 where it is hidden; a view until the next step."""
        return _gasjet.sim_jet(self._handle, jet)[0]

    def lit(self, jet: int = 0) -> np.ndarray:
        """(elements) True where a jet that can reach the element is not blocked."""
        return _gasjet.sim_jet(self._handle, jet)[1]

    @property
    def gas(self) -> Dict[str, float]:
        """Gas of the level; the names of Tank.state."""
        return _gasjet.sim_gas(self._handle)

    @property
    def pressure(self) -> float:
        """[Pa] of the level."""
        return _gasjet.sim_gas(self._handle)["pressure_Pa"]

    @property
    def gas_masses(self) -> np.ndarray:
        """[kg] (species) of the level."""
        return _gasjet.sim_array(self._handle, 7)[:, 0]

    @property
    def streams(self) -> Dict[str, np.ndarray]:
        """[kg], [J] (n, 2) mass and enthalpy since the start: inflows by inflator; outflows by vent, then fabric; backflows by vent."""
        return {name: _gasjet.sim_array(self._handle, 8 + i) for i, name in enumerate(("inflows", "outflows", "backflows"))}

    @property
    def impact(self) -> Dict[str, Any]:
        """The impactor: centre [m], axes (3, 3) in columns; velocity [m/s] and angular_velocity [rad/s] half a step before; force [N] and
        couple [N m] of the skin on it, energy_J of the contact, penetration_m."""
        return _gasjet.sim_impact(self._handle)

    def value(self, column: str, energy: bool = False) -> float:
        """A column of the history, or of the energies, at the last level with a row."""
        return _gasjet.sim_value(self._handle, energy, column)

    @property
    def drift(self) -> float:
        """Largest drift of the energy so far, as a share; without what you supply."""
        return _gasjet.sim_drift(self._handle)

    def record(self, every_level: bool = True) -> None:
        """Adds each level to the tables, not only those that the case asks for."""
        _gasjet.sim_record(self._handle, every_level)

    @property
    def results(self) -> Run:
        """The rows so far, and the summary; frames with `out`, after finish()."""
        history, energy, summary = _gasjet.sim_results(self._handle)
        return Run(history, energy, json.loads(summary), self._case[3])

    def set_vent(self, vent: int, area: float) -> None:
        """Area [m2] of a vent, in place of the case's; its trigger stays."""
        _gasjet.sim_set_vent(self._handle, vent, area)

    def set_sensor(self, name: str, on: bool) -> None:
        """Switches a sensor of the case with `external = true`."""
        _gasjet.sim_set_sensor(self._handle, name, on)

    def set_ambient(self, pressure: float, temperature: float) -> None:
        """Gas outside [Pa], [K]."""
        _gasjet.sim_set_ambient(self._handle, pressure, temperature)

    def set_inflow(self, inflator: int, mass_flow: float, temperature: float) -> None:
        """Mass flow [kg/s] and temperature [K] of an inflator, whatever its trigger does."""
        _gasjet.sim_set_inflow(self._handle, inflator, mass_flow, temperature)

    def set_outlet(self, jet: int, centre: Vector, axis: Vector) -> None:
        """Centre [m] and axis [-] of a jet's outlet. InputError if the centre is outside the bag."""
        _gasjet.sim_set_outlet(self._handle, jet, centre, axis)

    def set_gravity(self, gravity: Vector) -> None:
        """Gravity [m/s2], or what stands for it in a frame that moves. Not in a case with a constant one."""
        _gasjet.sim_set_gravity(self._handle, gravity)

    def set_impactor(self, centre: Vector, velocity: Vector, axes: Any = None, angular_velocity: Vector = (0.0, 0.0, 0.0)) -> None:
        """Moves an impactor on a rail or free, from now on in place of its own dynamics.

        centre [m]; velocity [m/s] and angular_velocity [rad/s] with which it goes on; axes: (3, 3), its x, y and z axis in columns
        (None: as now). Call it after a step, before you read forces.
        """
        numbers = None
        if axes is not None:
            given = as_numbers(axes, "axes")
            if given.shape != (3, 3):
                raise TypeError(f"axes: have the shape {given.shape}, allowed: (3, 3)")
            numbers = [float(x) for x in given.T.ravel()]
        _gasjet.sim_set_impactor(self._handle, centre, velocity, numbers, angular_velocity)

    def set_impactor_speed(self, velocity: Vector, angular_velocity: Vector = (0.0, 0.0, 0.0)) -> None:
        """Speeds [m/s], [rad/s] with which that impactor goes on from here; also after you have read its forces."""
        _gasjet.sim_set_impactor_speed(self._handle, velocity, angular_velocity)


def _handle_of(given: Any) -> Any:
    if not isinstance(given, Simulation):
        raise TypeError(f"other: is a {type(given).__name__}, allowed: a gasjet.Simulation")
    return given._handle
