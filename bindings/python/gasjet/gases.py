# SPDX-License-Identifier: Apache-2.0
"""Gas, outflow and tank. SI units; names of results end with their unit."""
from __future__ import annotations

from typing import Any, Dict, Optional, Tuple

from . import _gasjet
from .arrays import as_column, at_each, handle_of, is_single
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
    """A volume [m3] of gas at uniform pressure [Pa] and temperature [K], from time 0.

    Add parts before the first advance. Areas of vents and the loss of heat may change at any time.
    """

    __slots__ = ("_handle", "_volume", "_vents", "__weakref__")

    def __init__(self, gas: Gas, pressure: float, temperature: float, volume: float,
                 ambient_pressure: float = 101325.0, tolerance: float = 1e-10) -> None:
        self._handle = _gasjet.tank(handle_of(gas, Gas, "gas"), pressure, temperature, volume, ambient_pressure, tolerance)
        self._volume = volume
        self._vents = 0

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

    def add_vent(self, area: float, discharge_coefficient: float = 1.0, opens_at: float = 0.0) -> int:
        """A hole of area [m2]; it opens for ever at the overpressure opens_at [Pa]; 0: always open. Returns its number, from 0."""
        _gasjet.tank_add_vent(self._handle, discharge_coefficient, area, opens_at)
        self._vents += 1
        return self._vents - 1

    def set_vent(self, vent: int, area: float) -> None:
        """Area [m2] of a vent from now on; it stays closed until opens_at is reached."""
        _gasjet.tank_set_vent(self._handle, vent, area)

    def add_backflow(self, vent: int, gas: Gas, temperature: float) -> None:
        """This vent lets gas of temperature [K] in while the pressure is below ambient. All such vents let in the gas of the last call."""
        _gasjet.tank_add_backflow(self._handle, vent, handle_of(gas, Gas, "gas"), temperature)

    def set_heat_loss(self, conductance: float, outside_temperature: float) -> None:
        """Heat lost through the walls from now on, conductance (T - outside_temperature) [W]; conductance [W/K], temperatures [K]."""
        _gasjet.tank_set_heat_loss(self._handle, conductance, outside_temperature)

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
        gas_constant_J_kgK, inflow_kg_s, vent_outflow_kg_s, fabric_outflow_kg_s, backflow_kg_s, heat_loss_W."""
        return _gasjet.tank_state(self._handle)

    @property
    def masses(self) -> Dict[str, float]:
        """Mass [kg] of each species."""
        return {name: mass for name, mass, _ in _gasjet.tank_species(self._handle)}

    @property
    def composition(self) -> Dict[str, float]:
        """Fraction by mole of each species, as Gas takes them; 0 in an evacuated tank."""
        species = _gasjet.tank_species(self._handle)
        total = sum(amount for _, _, amount in species) or 1.0
        return {name: amount / total for name, _, amount in species}

    @property
    def balance(self) -> Dict[str, float]:
        """Amounts that crossed the boundary since the start: mass_in_kg, enthalpy_in_J, backflow_mass_kg, backflow_energy_J,
        vent_mass_out_kg, fabric_mass_out_kg, enthalpy_out_J, work_J, heat_J; residuals of the balances: mass_residual_kg,
        energy_residual_J; and the number of substeps."""
        return _gasjet.tank_balance(self._handle)
