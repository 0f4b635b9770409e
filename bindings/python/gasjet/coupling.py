# SPDX-License-Identifier: Apache-2.0
"""Pendulum and rigid body, contact of a body with a skin, and of a skin with itself. SI units; names of results end with their unit."""
from __future__ import annotations

from typing import Any, Dict, Optional, Tuple

import numpy as np

from . import _gasjet
from .arrays import Vector, as_column, as_numbers, as_points, mesh_arrays
from .errors import InputError

AT_REST = (0.0, 0.0, 0.0)
ALONG_SPACE = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
SHAPES = {("radius",): 0, ("half_axes",): 1, ("radius", "half_length"): 2, ("radius", "rim_radius"): 3}


def _shape(radius: Any, half_axes: Any, half_length: Any, rim_radius: Any) -> Tuple[Any, ...]:
    """Number of the shape that has these dimensions, and the dimensions."""
    given = {"radius": radius, "half_axes": half_axes, "half_length": half_length, "rim_radius": rim_radius}
    names = tuple(name for name, value in given.items() if value is not None)
    if names not in SHAPES:
        raise TypeError(f"radius: dimensions are {', '.join(names) or 'missing'}, allowed: radius (a sphere), half_axes (an ellipsoid), "
                        "radius and half_length (a cylinder), radius and rim_radius (a disc)")
    return (SHAPES[names], 0.0 if radius is None else radius, AT_REST if half_axes is None else half_axes,
            0.0 if half_length is None else half_length, 0.0 if rim_radius is None else rim_radius)


def _axes(given: Any) -> Tuple[Any, Any, Any]:
    """x, y and z axis, which are the columns of a rotation matrix."""
    axes = as_points(given, "axes")
    if len(axes) != 3:
        raise TypeError(f"axes: have the shape {axes.shape}, allowed: (3, 3)")
    return axes[:, 0], axes[:, 1], axes[:, 2]


class Pendulum:
    """A rigid pendulum with a sphere as impactor; centre of gravity and sphere lie on one line through the pivot.

    pivot [m]; axis: `angle` [rad] grows right-handed about it; rest_direction: from the pivot to the centre of gravity at angle 0,
    normal to the axis; mass [kg]; inertia_cg [kg m2]: about the centre of gravity; cg_distance, impactor_distance and
    impactor_radius [m]; gravity [m/s2]. `angle` and `angular_velocity` [rad/s] are first the initial and then the present values.
    """

    __slots__ = ("_model", "_step_before", "angle", "angular_velocity", "__weakref__")

    def __init__(self, pivot: Vector, axis: Vector, rest_direction: Vector, *, mass: float, inertia_cg: float, cg_distance: float,
                 impactor_distance: float, impactor_radius: float, gravity: Vector = AT_REST, angle: float = 0.0,
                 angular_velocity: float = 0.0) -> None:
        self._model = _gasjet.pendulum_model(pivot, axis, rest_direction, mass, inertia_cg, cg_distance, impactor_distance,
                                             impactor_radius, gravity)
        self._step_before = 0.0
        self.angle = angle
        self.angular_velocity = angular_velocity
        self.state  # checks the model

    def __repr__(self) -> str:
        return f"<gasjet.Pendulum at {self.angle:.6g} rad, {self.angular_velocity:.6g} rad/s>"

    @property
    def state(self) -> Dict[str, Any]:
        """impactor_centre_m, impactor_velocity_m_s, cg_position_m, gravity_moment_Nm, potential_energy_J, kinetic_energy_J,
        axis_inertia_kg_m2, and effective_mass_kg for a force along the impactor's path. Velocity and kinetic energy belong to
        `angular_velocity`."""
        return _gasjet.pendulum_evaluate(self._model, self.angle, self.angular_velocity)

    def moment(self, force: Vector, point: Vector) -> float:
        """Moment about the axis [N m] of a force [N] that acts at a point [m]."""
        return _gasjet.pendulum_moment(self._model, force, point)

    def advance(self, step: float, moment: float = 0.0) -> float:
        """Advances by a step [s] of the central difference; returns the angle. moment [N m]: present sum of all moments except gravity.

        After the first step `angular_velocity` belongs to half a step before `angle`.
        """
        all_moments = moment + self.state["gravity_moment_Nm"]
        try:
            self.angle, self.angular_velocity = _gasjet.pendulum_advance(self._model, all_moments, self._step_before, step,
                                                                         self.angle, self.angular_velocity)
        except InputError as error:
            raise InputError(str(error).replace("dt_after", "step", 1)) from None
        self._step_before = step
        return self.angle


class RigidBody:
    """A rigid body on a rail, which does not turn, or free.

    centre [m] of gravity; mass [kg]; rail: its direction; springs and stops of the rail, at most 4 in all: rows of stiffness [N/m],
    damping [N s/m] and the displacement [m] without force, of a stop that beyond which it acts, on the side away from the start; inertia
    (3, 3) [kg m2] of a free body, about the centre in its axes; axes (3, 3): columns are the body's axes in space; velocity [m/s], along
    the rail; angular_velocity [rad/s] of a free body; gravity [m/s2]. The attributes `centre`, `axes`, `velocity` and
    `angular_momentum` [kg m2/s] are first the initial and then the present values.
    """

    __slots__ = ("_model", "_step_before", "axes", "angular_momentum", "centre", "velocity", "__weakref__")

    def __init__(self, centre: Vector, *, mass: float, rail: Optional[Vector] = None, springs: Any = None, stops: Any = None,
                 inertia: Any = None, axes: Any = ALONG_SPACE, velocity: Vector = AT_REST, angular_velocity: Vector = AT_REST,
                 gravity: Vector = AT_REST) -> None:
        rows = {name: np.zeros((0, 3)) if given is None else as_points(given, name) for name, given in (("springs", springs), ("stops", stops))}
        for name, given in rows.items():
            if len(given) and rail is None:
                raise TypeError(f"{name}: are given, allowed: with a rail")
        self._model = _gasjet.rigid_body_model(rail is not None, mass, centre, *_axes(axes), velocity, angular_velocity,
                                               np.zeros((3, 3)) if inertia is None else as_points(inertia, "inertia"), gravity,
                                               AT_REST if rail is None else rail, rows["springs"], rows["stops"])
        self._step_before = 0.0
        self.centre, self.axes, self.velocity, self.angular_momentum = _gasjet.rigid_body_start(self._model)

    def __repr__(self) -> str:
        now = self.state
        return f"<gasjet.RigidBody {now['displacement_m']:.6g} m from its start, {now['speed_m_s']:.6g} m/s>"

    @property
    def _state(self) -> Tuple[Any, ...]:
        return (self.centre, *_axes(self.axes), self.velocity, self.angular_momentum)

    @property
    def state(self) -> Dict[str, Any]:
        """displacement_m and speed_m_s along the rail, or their lengths; angular_velocity_rad_s in space; own_force_N of gravity and
        springs; gravity_energy_J, spring_energy_J and kinetic_energy_J; turn_rad of the last step, for Contact.evaluate. Speeds,
        kinetic energy and turn belong to `velocity` and `angular_momentum`."""
        now = _gasjet.rigid_body_evaluate(self._model, *self._state)
        now["turn_rad"] = self._step_before * now["angular_velocity_rad_s"]
        return now

    def advance(self, step: float, force: Vector = AT_REST, couple: Vector = AT_REST) -> Dict[str, Any]:
        """Advances by a step [s] of the central difference under a force [N] and a couple [N m] about the centre beside gravity and
        springs. Returns velocity_m_s, acceleration_m_s2 and kinetic_energy_J before the step, at the time of force and place; kinetic_before_J
        and kinetic_after_J half a step earlier and later; and what the change of speeds did: load_work_J of force and couple,
        damping_loss_J, and work_J of all.

        After the first step `velocity` and `angular_momentum` belong to half a step before `centre`; a step of 0 brings them there.
        """
        try:
            new, kick = _gasjet.rigid_body_advance(self._model, force, couple, self._step_before, step, *self._state)
        except InputError as error:
            raise InputError(str(error).replace("dt_after", "step", 1)) from None
        self.centre, self.axes, self.velocity, self.angular_momentum = new
        self._step_before = step
        return kick

    def effective_mass(self, reach: float) -> float:
        """Mass [kg] that a contact up to reach [m] from the centre feels at least."""
        return _gasjet.rigid_body_limits(self._model, reach, 0.0)[0]

    def frequency(self, contact_force: float = 0.0, reach: float = 0.0) -> float:
        """Bound [1/s2] of omega^2 of the springs, and of a contact_force [N] that turns a free body up to reach [m] from the centre.
        Steps up to 2/sqrt(sum of all frequencies) are stable."""
        return _gasjet.rigid_body_limits(self._model, reach, contact_force)[1]


def head_injury_criterion(time: Any, acceleration: Any, window: float = 0.015) -> float:
    """Head injury criterion of an acceleration [m/s2], (n, 3) or (n,), at rising times [s], for intervals of up to window [s]: 0.015 or
    0.036. Its components are filtered by CFC 1000 first."""
    given = as_numbers(acceleration, "acceleration")
    if given.ndim == 1:
        given = np.column_stack([given, 0.0 * given, 0.0 * given])
    return _gasjet.head_injury_criterion(as_column(time, "time"), as_points(given, "acceleration"), window)


class Contact:
    """Contact of a rigid body with a skin: pressure = stiffness [N/m3] times penetration.

    The body is a sphere of radius [m], an ellipsoid with three half_axes [m], a cylinder with round ends along its z axis, radius and
    half_length [m] between the ends' centres, or a disc across its z axis, radius of the flat faces and rim_radius [m].
    reference: the skin's stress-free shape; masses [kg] of its nodes and effective_mass [kg] of the sphere, or the least of any point
    of another body, affect the frequency; friction [-]: Coulomb's coefficient.
    """

    __slots__ = ("_handle", "_words", "__weakref__")

    def __init__(self, reference: Any, triangles: Any = None, *, masses: Any, effective_mass: float, stiffness: float,
                 radius: Optional[float] = None, half_axes: Optional[Vector] = None, half_length: Optional[float] = None,
                 rim_radius: Optional[float] = None, friction: float = 0.0) -> None:
        shape = _shape(radius, half_axes, half_length, rim_radius)
        reference, triangles = mesh_arrays(reference, triangles, "reference")
        self._handle = _gasjet.contact(reference, triangles, as_column(masses, "masses"), effective_mass, *shape, stiffness, friction)
        dimensions = {"radius": radius, "half axes": half_axes, "half length": half_length, "rim radius": rim_radius}
        words = ", ".join(f"{name} {value} m" for name, value in dimensions.items() if value is not None)
        self._words = f"{words}, {stiffness:g} N/m3, friction {friction:g}, {len(triangles)} elements"

    @staticmethod
    def reach(*, radius: Optional[float] = None, half_axes: Optional[Vector] = None, half_length: Optional[float] = None,
              rim_radius: Optional[float] = None) -> float:
        """Largest distance [m] of a point of a body of these dimensions from its centre."""
        return _gasjet.impactor_reach(*_shape(radius, half_axes, half_length, rim_radius))

    def __repr__(self) -> str:
        return f"<gasjet.Contact {self._words}>"

    def evaluate(self, nodes: Any, centre: Vector, turn: Vector = AT_REST, axes: Any = ALONG_SPACE) -> Dict[str, Any]:
        """node_force_N (n, 3), force_N and couple_Nm (about the centre) on the body, energy_J, friction_loss_J (since the last call), area_m2,
        penetration_m, frequency_1_s2 (for the critical step) and deepest_element (-1: none touches) at positions nodes (n, 3) [m].

        Calls are successive times: between two of them the centre [m] must not cross the skin. turn [rad]: rotation of the body
        since the last call, used by friction only. axes (3, 3): columns are the body's axes in space; a sphere ignores them.
        DomainError if it sinks in by more than half its radius, its rim's, or c^2/a of an ellipsoid with half axes from c to a, or
        moves so far past the skin that it may have crossed it.
        """
        return _gasjet.contact_evaluate(self._handle, as_points(nodes, "nodes"), centre, *_axes(axes), turn)


class SkinContact:
    """Contact of a skin with itself: layers closer than thickness [m] push each other apart, pressure = stiffness [N/m3] times depth.

    reference: the skin's stress-free shape; masses [kg] of its nodes affect the frequency; thickness: at most the smallest altitude
    of a triangle; friction [-]: Coulomb's coefficient. Parts with a common node, or nodes that an edge joins, do not touch.
    """

    __slots__ = ("_handle", "_words", "__weakref__")

    def __init__(self, reference: Any, triangles: Any = None, *, masses: Any, thickness: float, stiffness: float,
                 friction: float = 0.0) -> None:
        reference, triangles = mesh_arrays(reference, triangles, "reference")
        self._handle = _gasjet.skin_contact(reference, triangles, as_column(masses, "masses"), thickness, stiffness, friction)
        self._words = f"thickness {thickness:g} m, {stiffness:g} N/m3, friction {friction:g}, {len(triangles)} elements"

    def __repr__(self) -> str:
        return f"<gasjet.SkinContact {self._words}>"

    def evaluate(self, nodes: Any) -> Dict[str, Any]:
        """node_force_N (n, 3), energy_J, friction_loss_J (since the last call), frequency_1_s2 (for the critical step), contacts
        (pairs that touch), gap_m (the smallest, infinite: none touches), first_nodes and second_nodes of that pair (a node and a
        triangle, or two edges), approach (largest decrease of a distance since the last call over its reach) and limited_nodes
        (started too close and have not moved away) at positions nodes (n, 3) [m].

        Calls are successive times. Layers that are too close at the first one start without force. DomainError if layers meet
        between two calls: call restart() then.
        """
        return _gasjet.skin_contact_evaluate(self._handle, as_points(nodes, "nodes"))

    def restart(self) -> None:
        """Forgets all calls: the next one is the first of a run."""
        _gasjet.skin_contact_restart(self._handle)

    @staticmethod
    def default_stiffness(share: float, other_frequency: float, surface_density: float) -> float:
        """Stiffness [N/m3] that adds at most that share of other_frequency [1/s2], the omega^2 of all other terms, to a skin of
        surface_density [kg/m2] without friction."""
        return _gasjet.default_skin_stiffness(share, other_frequency, surface_density)
