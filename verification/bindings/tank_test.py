# SPDX-License-Identifier: Apache-2.0
"""Tanks of gasjet.Tank that mix gases, breathe and cool, against closed forms and SciPy."""
import unittest

import numpy as np

import gasjet

try:
    from scipy.integrate import solve_ivp
except ImportError:
    solve_ivp = None

AMBIENT, VOLUME = 101325.0, 0.06
HEAVY, LIGHT = (296.8, 1038.8), (2077.1, 5193.0)  # R and cp [J/(kg K)]


def hole(area, pressure, temperature, gas_constant, cp, outside):
    """Mass flow [kg/s] of (G.6), written anew."""
    if pressure <= outside:
        return 0.0
    gamma = cp / (cp - gas_constant)
    r = max(outside / pressure, (2.0 / (gamma + 1.0)) ** (gamma / (gamma - 1.0)))
    return area * pressure / (gas_constant * temperature) * np.sqrt(2.0 * cp * temperature * (r ** (2.0 / gamma) - r ** (1.0 + 1.0 / gamma)))


def breathing_tank():
    """Below ambient at first; a light gas flows in from 20 ms on; vent 0 lets heavy gas in at 320 K; the walls are cold."""
    heavy, light = gasjet.Gas.ideal(*HEAVY), gasjet.Gas.ideal(*LIGHT)
    tank = gasjet.Tank(heavy, 5e4, 400.0, VOLUME, AMBIENT, tolerance=1e-12)
    tank.add_inflow(light, [0.0, 1.0], [0.2, 0.2], [600.0, 600.0], start_time=0.02)
    tank.add_backflow(tank.add_vent(4e-4, 0.7), heavy, 320.0)
    tank.add_vent(3e-4)
    tank.set_heat_loss(60.0, 280.0)
    return tank


class Tanks(unittest.TestCase):
    def test_breathing_tank_eq_scipy(self):
        """Two gases, two vents of changing areas, backflow and heat, by other equations and another integrator."""
        self.assertIsNotNone(solve_ivp, "python3-scipy is missing")
        areas, light = [0.7 * 4e-4, 3e-4], 0.0

        def rates(_, state):
            masses, energy = state[:2], state[2]
            gas_constant, cp = (sum(masses * np.array(each)) / sum(masses) for each in zip(HEAVY, LIGHT))
            temperature = energy / (sum(masses) * (cp - gas_constant))
            pressure = sum(masses) * gas_constant * temperature / VOLUME
            out = sum(hole(area, pressure, temperature, gas_constant, cp, AMBIENT) for area in areas)
            back = hole(areas[0], AMBIENT, 320.0, *HEAVY, pressure)
            parts = masses / sum(masses)
            heat = 60.0 * (temperature - 280.0)
            return [back - out * parts[0], light - out * parts[1],
                    back * HEAVY[1] * 320.0 + light * LIGHT[1] * 600.0 - out * cp * temperature - heat]

        tank = breathing_tank()
        mass = 5e4 * VOLUME / (HEAVY[0] * 400.0)
        state, now = np.array([mass, 0.0, mass * (HEAVY[1] - HEAVY[0]) * 400.0]), 0.0
        for end, vent, area in ((0.02, 1, 1e-3), (0.06, 0, 1e-3), (0.1, 1, 0.0), (0.12, 1, 0.0)):
            state = solve_ivp(rates, (now, end), state, method="DOP853", rtol=1e-12, atol=1e-13).y[:, -1]
            own = tank.advance(end)
            np.testing.assert_allclose([*tank.masses.values(), own["internal_energy_J"]], state, rtol=1e-8, atol=0.0)
            tank.set_vent(vent, area)
            areas[vent], now, light = (0.7 if vent == 0 else 1.0) * area, end, 0.2
        balance = tank.balance
        for term, least in (("mass_in_kg", 0.01), ("backflow_mass_kg", 1e-3), ("backflow_energy_J", 100.0), ("vent_mass_out_kg", 1e-3),
                            ("heat_J", 500.0)):
            self.assertGreater(balance[term], least, term)
        self.assertLess(abs(balance["mass_residual_kg"]), 1e-15)
        self.assertLess(abs(balance["energy_residual_J"]), 1e-9)

    def test_inrush_eq_closed_form(self):
        gas, times = gasjet.Gas.ideal(296.8, 1038.8), np.linspace(0.02, 0.3, 8)
        tank = gasjet.Tank(gas, 2e4, 293.15, VOLUME, AMBIENT)
        tank.add_backflow(tank.add_vent(1e-3), gas, 293.15)
        exact = gasjet.exact("ambient_inrush", times=times)
        pressures = [tank.advance(time)["pressure_Pa"] for time in times]
        np.testing.assert_allclose(pressures, exact["pressure_Pa"], rtol=1e-8)

    def test_sealed_tank_cools_as_an_exponential(self):
        tank = gasjet.Tank(gasjet.Gas.ideal(296.8, 1038.8), 2e5, 500.0, VOLUME)
        rate = 5.0 / (tank.state["gas_mass_kg"] * (1038.8 - 296.8))  # [1/s]
        tank.advance(1.0)
        tank.set_heat_loss(5.0, 300.0)
        self.assertAlmostEqual(tank.state["heat_loss_W"], 1000.0, 6)
        self.assertAlmostEqual(tank.advance(9.0)["temperature_K"], 300.0 + 200.0 * np.exp(-8.0 * rate), 6)

    def test_composition_is_by_mole(self):
        tank = gasjet.Tank(gasjet.Gas("N2:0.6, O2:0.4"), 1e5, 300.0, 1.0)
        self.assertEqual([*tank.masses], ["N2", "O2"])
        self.assertAlmostEqual(tank.composition["O2"], 0.4, 12)
        self.assertAlmostEqual(tank.masses["O2"] / tank.masses["N2"], 0.4 * 31.998 / (0.6 * 28.014), 4)
        self.assertAlmostEqual(sum(tank.masses.values()), tank.state["gas_mass_kg"], 12)

    def test_a_vent_that_is_set_waits_for_its_pressure(self):
        tank = gasjet.Tank(gasjet.Gas("N2=1"), 1.2e5, 300.0, 0.1, 1e5)
        vent = tank.add_vent(0.0, opens_at=4e4)
        tank.set_vent(vent, 1e-3)
        self.assertEqual(tank.advance(0.01)["vent_outflow_kg_s"], 0.0)
        self.assertGreater(tank.advance(0.02, 0.08)["vent_outflow_kg_s"], 0.0)


if __name__ == "__main__":
    unittest.main()
