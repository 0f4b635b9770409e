# SPDX-License-Identifier: Apache-2.0
"""Jet, surface and membrane. SI units; names of results end with their unit."""
from __future__ import annotations

from typing import Any, Dict, Optional, Tuple

import numpy as np

from . import _gasjet
from .arrays import NAN, NO_VECTOR, Vector, as_indices, as_points, as_triangles, mesh_arrays


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
