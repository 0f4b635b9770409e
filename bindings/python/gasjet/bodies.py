# SPDX-License-Identifier: Apache-2.0
"""Gas, tank, jet, surface and membrane. SI units; names of results end with their unit."""
from __future__ import annotations

from typing import Any, Dict, Optional, Tuple

import numpy as np

from . import _gasjet
from .arrays import NAN, NO_VECTOR, Vector, as_column, as_indices, as_points, as_triangles, at_each, handle_of, is_single, mesh_arrays
from .errors import Error


class Gas:
    """A mixture by mole, "N2=0.78, O2=0.22" or "N2:0.78, O2:0.22", with NASA-7 heat capacities.

    Species: N2 O2 Ar He H2 CO CO2 H2O NO N2O NH3 CH4. constant_cp_at [K]: makes cp constant, with its value at this temperature.
    Temperatures and the like may be arrays; so are the results then.
    """

    __slots__ = ("_handle", "_made_by", "__weakref__")

    def __init__(self, composition: str, constant_cp_at: float = 0.0) -> None:
        if isinstance(composition, str):
            composition = composition.replace(":", "=")
        self._handle = _gasjet.gas(composition, constant_cp_at)
        self._made_by: Tuple[Any, ...] = (Gas, composition, constant_cp_at)

    @classmethod
    def ideal(cls, gas_constant: float, cp: float) -> Gas:
        """A gas of constant cp [J/(kg K)] > gas_constant [J/(kg K)] > 0."""
        made = cls.__new__(cls)
        made._handle = _gasjet.ideal_gas(gas_constant, cp)
        made._made_by = (Gas.ideal, gas_constant, cp)
        return made

    def __repr__(self) -> str:
        how, first, second = self._made_by
        if how is not Gas:
            return f"<gasjet.Gas ideal, gas constant {first:g} J/(kg K), cp {second:g} J/(kg K)>"
        return f"<gasjet.Gas {first}{f', constant cp at {second:g} K' if second else ''}>"

    def __reduce__(self) -> Tuple[Any, ...]:
        return self._made_by[0], self._made_by[1:]

    def properties(self, temperature: Any) -> Dict[str, Any]:
        """Properties of 1 kg at temperature [K]: gas_constant_J_kgK, cp_J_kgK, cv_J_kgK, gamma, enthalpy_J_kg, internal_energy_J_kg,
        speed_of_sound_m_s."""
        if is_single(temperature):
            return _gasjet.gas_values(self._handle, temperature)
        names = _gasjet.gas_values(self._handle, 300.0)
        rows = at_each(lambda one: tuple(_gasjet.gas_values(self._handle, one).values()), (len(names),), temperature=temperature)
        return {name: rows[..., i] for i, name in enumerate(names)}

    def temperature(self, internal_energy: Any) -> Any:
        """Temperature [K] from the internal energy [J/kg]."""
        return at_each(lambda one: _gasjet.gas_temperature(self._handle, one), internal_energy=internal_energy)

    def entropy(self, temperature: Any, pressure: Any) -> Any:
        """Entropy [J/(kg K)] at temperature [K] and pressure [Pa]; arrays are broadcast."""
        return at_each(lambda t, p: _gasjet.gas_entropy(self._handle, t, p), temperature=temperature, pressure=pressure)


def orifice(effective_area: float, pressure: float, temperature: float, gas_constant: float, cp: float,
            ambient_pressure: float) -> float:
    """Mass flow [kg/s] of a hole of effective_area = Cd A [m2], sonic or subsonic."""
    return _gasjet.orifice(effective_area, pressure, temperature, gas_constant, cp, ambient_pressure)


def fabric_leak(leak_area: float, density: float, overpressure: float) -> float:
    """Mass flow [kg/s] of porous fabric of leak_area = sum eta^2 A [m2] at overpressure [Pa]."""
    return _gasjet.fabric(leak_area, density, overpressure)


class Tank:
    """A volume [m3] of gas at uniform pressure [Pa] and temperature [K], from time 0. Add parts before the first advance."""

    __slots__ = ("_handle", "_volume", "__weakref__")

    def __init__(self, gas: Gas, pressure: float, temperature: float, volume: float,
                 ambient_pressure: float = 101325.0, tolerance: float = 1e-10) -> None:
        self._handle = _gasjet.tank(handle_of(gas, Gas, "gas"), pressure, temperature, volume, ambient_pressure, tolerance)
        self._volume = volume

    def __repr__(self) -> str:
        try:
            now = self.state
        except Error:  # another thread uses it
            return "<gasjet.Tank>"
        return (f"<gasjet.Tank at {now['time_s']:g} s: {now['volume_m3']:.6g} m3, {now['pressure_Pa']:.6g} Pa, "
                f"{now['temperature_K']:.6g} K>")

    def add_inflow(self, gas: Gas, time: Any, mass_flow: Any, temperature: Any, start_time: float = 0.0) -> None:
        """mass_flow [kg/s] and temperature [K] at knots time [s] since start_time; linear between, no flow outside."""
        knots = as_column(time, "time"), as_column(mass_flow, "mass_flow"), as_column(temperature, "temperature")
        _gasjet.tank_add_inflow(self._handle, handle_of(gas, Gas, "gas"), *knots, start_time)

    def add_vent(self, area: float, discharge_coefficient: float = 1.0, opens_at: float = 0.0) -> None:
        """A hole of area [m2]; it opens for ever at the overpressure opens_at [Pa]; 0: always open."""
        _gasjet.tank_add_vent(self._handle, discharge_coefficient, area, opens_at)

    def add_fabric(self, leak_area: float) -> None:
        """Porous fabric of leak_area = sum eta^2 A [m2]."""
        _gasjet.tank_add_fabric(self._handle, leak_area)

    def advance(self, time: float, volume: Optional[float] = None) -> Dict[str, float]:
        """Advances to time [s]; the volume changes linearly to `volume` [m3] (None: constant). Returns `state`."""
        new = self._volume if volume is None else volume
        _gasjet.tank_advance(self._handle, time, new)
        self._volume = new
        return self.state

    @property
    def state(self) -> Dict[str, float]:
        """Present state: time_s, pressure_Pa, temperature_K, volume_m3, gas_mass_kg, internal_energy_J, density_kg_m3, gamma, cp_J_kgK,
        gas_constant_J_kgK, inflow_kg_s, vent_outflow_kg_s, fabric_outflow_kg_s."""
        return _gasjet.tank_state(self._handle)

    @property
    def balance(self) -> Dict[str, float]:
        """Amounts that crossed the boundary since the start: mass_in_kg, enthalpy_in_J, vent_mass_out_kg, fabric_mass_out_kg,
        enthalpy_out_J, work_J; residuals of the balances: mass_residual_kg, energy_residual_J; and the number of substeps."""
        return _gasjet.tank_balance(self._handle)


OUTLET_LAWS = ("sonic_static", "sonic_stagnation", "pressure_matched", "expanded")


def outlet(area: float, mass_flow: float, temperature: float, cp: float, gas_constant: float,
           law: str = "sonic_static", bag_pressure: float = 101325.0) -> Dict[str, float]:
    """velocity_m_s, density_kg_m3, pressure_Pa and temperature_K (static) in an outlet of area [m2]; law: one of OUTLET_LAWS.

    "expanded": those of the notional nozzle, if the outlet's pressure would be above bag_pressure.
    """
    if law not in OUTLET_LAWS:
        raise ValueError(f"law: is {law!r}, allowed: {', '.join(OUTLET_LAWS)}")
    return _gasjet.outlet(OUTLET_LAWS.index(law), area, mass_flow, temperature, cp, gas_constant, bag_pressure)


class Surface:
    """Triangles for repeated queries of what a source sees. Stored data makes the next query faster."""

    __slots__ = ("_elements", "_nodes", "_handle", "__weakref__")

    def __init__(self, triangles: Any, node_count: int, null_elements: Any = None, attachment_elements: Any = None) -> None:
        elements = as_triangles(triangles)
        self._elements = len(elements)
        self._handle = _gasjet.surface(elements, node_count, as_indices(null_elements, "null_elements"),
                                       as_indices(attachment_elements, "attachment_elements"))
        self._nodes = node_count

    def __repr__(self) -> str:
        return f"<gasjet.Surface {self._elements} elements, {self._nodes} nodes>"

    def visible(self, nodes: Any, centre: Vector, axis: Vector, long_direction: Vector = NO_VECTOR, half_long: float = 0.0,
                candidates: Any = None, displacement_bound: float = NAN) -> np.ndarray:
        """Mask (bool) of the candidates (None: every element) that are seen from `centre` [m], exactly.

        half_long [m] > 0: the source is a line along long_direction. displacement_bound [m]: no node has moved farther since
        the first call; it affects the speed only.
        """
        some = None if candidates is None else as_indices(candidates, "candidates")
        return _gasjet.surface_visible(self._handle, self._elements, as_points(nodes, "nodes"), centre, axis, long_direction, half_long, some,
                                       displacement_bound)


def visible(nodes: Any, triangles: Any = None, centre: Vector = (0.0, 0.0, 0.0), axis: Vector = (1.0, 0.0, 0.0),
            long_direction: Vector = NO_VECTOR, half_long: float = 0.0, null_elements: Any = None,
            attachment_elements: Any = None) -> np.ndarray:
    """Mask (bool) of the triangles that are seen from `centre` [m], exactly.

    nodes: (n, 3) doubles in any layout, [m]; triangles: (m, 3) integers, counter-clockwise seen from outside; or a meshio mesh
    instead of both. An element is seen if its inner side faces the source and nothing lies in between.
    """
    nodes, triangles = mesh_arrays(nodes, triangles)
    return Surface(triangles, len(nodes), null_elements, attachment_elements).visible(
        nodes, centre, axis, long_direction, half_long)


def check_surface(nodes: Any, triangles: Any = None) -> Dict[str, Any]:
    """Faults that keep a surface from enclosing a volume: `findings`, a list of texts, and the counts. `ok`: there are none.

    Counts: boundary_edges, non_manifold_edges, inconsistent_edges, repeated_node_elements, pinched_nodes, unused_nodes,
    more_components (beyond the first). True or False: inward, flat. Membrane and Jet accept any surface, but with faults its
    volume and load are meaningless. A meshio mesh can replace nodes and triangles.
    """
    return _gasjet.check_surface(*mesh_arrays(nodes, triangles))


class Jet:
    """A gas jet out of a round outlet (radius [m]) or a rectangular one (short_side, at most long_side [m], long_direction).

    decay_coefficient [-]: of the centreline. cone_initial_width [m], cone_half_angle [rad]: the width grows along a cone
    instead of by conservation of momentum. `counters` of the last `pressure`: candidates, lit, hidden, facing_away.
    """

    __slots__ = ("_model", "_restitution", "_skin", "_words", "counters", "__weakref__")

    def __init__(self, centre: Vector, axis: Vector, *, decay_coefficient: float, radius: float = NAN, short_side: float = NAN,
                 long_side: float = NAN, long_direction: Vector = NO_VECTOR, cone_initial_width: float = NAN,
                 cone_half_angle: float = NAN, restitution: float = 1.0, cut_off: float = 1e-3, radial: bool = False) -> None:
        self._model = _gasjet.jet_model(centre, axis, radius, short_side, long_side, long_direction, decay_coefficient,
                                        cone_initial_width, cone_half_angle, restitution, cut_off, radial)
        self._skin: Tuple[Any, Any] = (None, None)
        self._restitution = restitution
        self.counters: Dict[str, int] = {}
        self.velocity(np.zeros((1, 3)))  # checks the model
        size = f"round, radius {radius:g} m" if radius == radius else f"{short_side:g} m by {long_side:g} m"
        self._words = f"{size}, at ({', '.join(f'{x:g}' for x in centre)}) m along ({', '.join(f'{x:g}' for x in axis)})"

    def __repr__(self) -> str:
        return f"<gasjet.Jet {self._words}>"

    def velocity(self, points: Any) -> np.ndarray:
        """Velocity relative to the outlet's at points (n, 3) [m]."""
        return _gasjet.jet_velocity(self._model, as_points(points, "points"))

    def pressure(self, nodes: Any, triangles: Any = None, *, velocity: float, density: float, occlusion: bool = True,
                 null_elements: Any = None, attachment_elements: Any = None, displacement_bound: float = NAN,
                 area_ratio: float = 1.0, reflected: float = 1.0,
                 restitution: Optional[float] = None) -> Tuple[np.ndarray, np.ndarray]:
        """Overpressure [Pa] of each triangle and the force [N] of all; `counters` has the numbers of lit and hidden elements.

        velocity [m/s] and density [kg/m3] belong to the outlet, or to its notional nozzle. area_ratio [-] is that nozzle's area
        over the outlet's, mass_flow / (density velocity area); reflected [-] the outlet's velocity over the nozzle's.
        restitution [-] in this call, -0.5 to 4; None: the jet's. Data of a surface is kept for the next call with equal
        triangles; for displacement_bound see Surface.
        """
        if restitution != restitution:  # in C it would mean: as before
            raise ValueError("restitution: is nan, allowed: -0.5 to 4")
        nodes, triangles = mesh_arrays(nodes, triangles)
        roles = (as_indices(null_elements, "null_elements"), as_indices(attachment_elements, "attachment_elements"))
        key = (len(nodes), *(part.tobytes() for part in (triangles, *roles)))  # quicker to compare than arrays
        handle, known = self._skin
        if known != key:
            handle = _gasjet.jet(self._model, triangles, len(nodes), *roles)
            self._skin = (handle, key)
        pressure, force, self.counters = _gasjet.jet_pressure(handle, len(triangles), nodes, velocity, density, occlusion,
                                                              displacement_bound, area_ratio, reflected,
                                                              self._restitution if restitution is None else restitution)
        return pressure, force


FABRIC_LAWS = ("saint_venant_kirchhoff", "hencky")


class Membrane:
    """Isotropic fabric of triangles: thickness [m], density [kg/m3], young_modulus [Pa], poisson [-].

    reference: the stress-free shape. wrinkles: goes slack instead of carrying compression. law: one of FABRIC_LAWS; stress is
    linear in Green-Lagrange strain, or Cauchy's in logarithmic strain (with wrinkles, to stretches of 1.65).
    """

    __slots__ = ("_handle", "_nodes", "_words", "__weakref__")

    def __init__(self, reference: Any, triangles: Any = None, *, thickness: float, density: float, young_modulus: float,
                 poisson: float, wrinkles: bool = True, law: str = "saint_venant_kirchhoff", null_elements: Any = None,
                 fixed_nodes: Any = None) -> None:
        if law not in FABRIC_LAWS:
            raise ValueError(f"law: is {law!r}, allowed: {', '.join(FABRIC_LAWS)}")
        reference, triangles = mesh_arrays(reference, triangles, "reference")
        self._handle = _gasjet.membrane(reference, triangles, thickness, density, young_modulus, poisson, wrinkles,
                                        FABRIC_LAWS.index(law), as_indices(null_elements, "null_elements"),
                                        as_indices(fixed_nodes, "fixed_nodes"))
        self._nodes = len(reference)
        self._words = f"{len(triangles)} elements, {len(reference)} nodes, {law}, {'with' if wrinkles else 'without'} wrinkles"

    def __repr__(self) -> str:
        return f"<gasjet.Membrane {self._words}>"

    @property
    def masses(self) -> np.ndarray:
        """Mass of each node [kg]."""
        return _gasjet.membrane_masses(self._handle, self._nodes)

    def evaluate(self, nodes: Any, gamma: float = 0.0, pressure: float = 0.0) -> Dict[str, Any]:
        """force_N and gradient_m2 (of the volume) of each node, volume_m3, area_m2, mass_kg, strain_energy_J and critical_step_s at
        positions nodes (n, 3) [m].

        gamma [-] and absolute pressure [Pa] of the gas affect the critical step; gamma = 0: the pressure is prescribed.
        """
        return _gasjet.membrane_evaluate(self._handle, as_points(nodes, "nodes"), gamma, pressure)
