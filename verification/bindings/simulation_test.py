# SPDX-License-Identifier: Apache-2.0
"""Simulations from Python: the bits of a run, a controller, an impactor of one's own, copies."""
import copy
import os
import pickle
import tempfile
import time
import unittest

import numpy as np

import gasjet

CASES = os.path.join(os.environ["GASJET_SOURCE_DIR"], "cases")
JET = {"scene.end_time": 0.004}  # of the sharp pair


def case(name):
    return os.path.join(CASES, name + ".toml")


def same(a, b):
    return all(np.array_equal(a[name], b[name], equal_nan=True) for name in b)


class Bits(unittest.TestCase):
    def test_steps_have_the_bits_of_a_run(self):
        with tempfile.TemporaryDirectory() as folder:
            mine, theirs = os.path.join(folder, "mine"), os.path.join(folder, "theirs")
            reference = gasjet.run(case("passenger_sharp"), set=JET, out=theirs)
            simulation = gasjet.Simulation(case("passenger_sharp"), set=JET, out=mine)
            while not simulation.ended:
                simulation.step()
            simulation.finish()
            self.assertTrue(same(simulation.results.history, reference.history))
            self.assertEqual(simulation.results.summary["status"], "done")
            with open(os.path.join(mine, "history.csv")) as a, open(os.path.join(theirs, "history.csv")) as b:
                rows = [[line for line in file if not line.startswith("#")] for file in (a, b)]
            self.assertEqual(*rows)
            self.assertEqual(sorted(os.listdir(mine)), sorted(os.listdir(theirs)))

    def test_summary_has_looks_at_the_skin_and_cpu_time(self):
        reference = gasjet.run(case("passenger_sharp"), set=JET)
        before = time.thread_time()
        simulation = gasjet.Simulation(case("passenger_sharp"), set=JET)
        created = time.thread_time()
        simulation.step(10)
        simulation = simulation.clone()
        simulation.advance(1.0, progress=lambda now, end: time.sleep(0.2))
        simulation.evaluate()
        after = time.thread_time()
        summary = simulation.results.summary
        self.assertEqual(summary["self_intersection"], reference.summary["self_intersection"])
        self.assertEqual(len(summary["self_intersection"]["looks"]), 2)
        self.assertLess(summary["cpu_s"], after - before)
        self.assertGreater(summary["cpu_s"], 0.5 * (after - created))  # the rest is the clone's
        self.assertGreater(summary["wall_s"], 0.2)

    def test_a_dict_is_a_case(self):
        tank = {"scene": {"format": 1, "name": "dict", "end_time": 0.05},
                "gas": {"thermodynamics": "constant", "initial": {"composition": {"air": 1.0}, "pressure": 2e5}},
                "tank": {"volume": 0.06}, "vent": [{"area": 1e-3, "discharge_coefficient": 0.6}]}
        reference = gasjet.run(tank)
        simulation = gasjet.Simulation(tank)
        simulation.advance(1.0)
        self.assertTrue(same(simulation.results.history, reference.history))
        self.assertLess(reference.history["pressure_Pa"][-1], 1.9e5)
        self.assertIn("at 0.05 s", repr(simulation))

    def test_copies_go_on_with_the_same_bits(self):
        simulation = gasjet.Simulation(case("passenger_sharp"), set=JET)
        simulation.step(20)
        copies = [simulation.clone(), copy.copy(simulation), copy.deepcopy(simulation), pickle.loads(pickle.dumps(simulation))]
        view = simulation.position
        before = view.copy()
        saved = simulation.clone()
        for one in copies + [simulation]:
            one.step(15)
        for one in copies:
            np.testing.assert_array_equal(one.position, view)
        simulation.assign(saved)
        np.testing.assert_array_equal(view, before)  # the view follows
        simulation.reset()
        self.assertEqual((simulation.time, simulation.steps), (0.0, 0))

    def test_a_sweep_of_a_thousand_clones(self):
        start = gasjet.Simulation(case("tank_triggers"))
        start.advance_exactly(0.01)
        ends = []
        for i in range(1000):
            one = start.clone()
            one.set_inflow(0, 0.001 * i, 600.0)
            one.advance(0.02)
            ends.append(one.pressure)
        self.assertEqual(start.time, 0.01)
        self.assertGreater(min(np.diff(ends)), 0.0)


class Controls(unittest.TestCase):
    def test_a_controller_holds_the_pressure_by_a_vent(self):
        simulation = gasjet.Simulation(case("jet_bag"), set={"vent": [{"area": 1e-9, "discharge_coefficient": 0.6}]})
        free = gasjet.run(case("jet_bag")).history["pressure_Pa"].max()
        limit = 0.5 * (free + 101325.0)
        highest = 0.0
        while not simulation.ended:
            excess = simulation.pressure - limit
            simulation.set_vent(0, min(0.02, max(0.0, 1e-4 * excess)))
            simulation.step()
            highest = max(highest, simulation.pressure)
        self.assertLess(highest, limit + 0.3 * (free - limit))
        self.assertGreater(highest, limit)
        self.assertLess(simulation.drift, 2e-3)
        self.assertGreater(simulation.streams["outflows"][0, 0], 1e-4)

    def test_an_own_impactor_follows_the_scenes(self):
        settings = {"scene.end_time": 0.03, "contact.stiffness_share": 0.02}
        reference = gasjet.run(case("guided_headform"), set=settings).history
        simulation = gasjet.Simulation(case("guided_headform"), set=settings)
        mass, along = 6.8, np.array([-1.0, 0.0, 0.0])
        centre, velocity, before = np.array([0.52, 0.0, 0.02]), 6.7 * along, 0.0
        while True:
            simulation.set_impactor(centre, velocity)
            after = simulation.evaluate()
            if simulation.ended:
                break
            force = simulation.impact["force"] @ along
            velocity = velocity + 0.5 * (before + after) * force / mass * along
            centre = centre + after * velocity
            simulation.step()
            before = after
        self.assertGreater(reference["contact_force_N"][-1], 100.0)
        self.assertLess(abs(simulation.value("impactor_displacement_m") / reference["impactor_displacement_m"][-1] - 1.0), 1e-9)
        self.assertLess(simulation.drift, 1e-3)

    def test_own_forces_lift_a_ball(self):
        simulation = gasjet.Simulation(case("ball_impact"), set={"pendulum": None, "contact": None, "scene.end_time": 2e-3})
        force = simulation.own_force
        self.assertEqual(force.strides, (32, 8))
        force[:, 2] = 10.0 / len(force)
        simulation.advance(1.0)
        mass = 0.280108  # [kg] of the ball
        self.assertAlmostEqual(simulation.velocity[:, 2].mean(), 10.0 / mass * simulation.time, delta=0.1 * 10.0 / mass * simulation.time)
        self.assertGreater(simulation.results.energy["driving_work_J"][-1], 0.0)

    def test_views_are_of_the_level(self):
        simulation = gasjet.Simulation(case("passenger_sharp"), set={"scene.end_time": 0.02})
        simulation.advance(0.01)
        x, t = simulation.position, simulation.triangles
        corners = x[t]
        volume = np.einsum("ni,ni->n", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])).sum() / 6.0
        self.assertAlmostEqual(volume, simulation.gas["volume_m3"], delta=1e-12)
        self.assertAlmostEqual(simulation.gas_masses.sum(), simulation.gas["gas_mass_kg"], delta=1e-15)
        lit, pressure = simulation.lit(), simulation.overpressure()
        self.assertTrue(lit.any() and not lit.all())
        self.assertTrue((lit[pressure > 0.0]).all())
        area = 0.5 * np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        np.testing.assert_allclose(simulation.jet_force.sum(axis=0), pressure @ area, rtol=1e-9, atol=1e-9)
        self.assertFalse(x.flags.writeable)
        step, limit = simulation.step_limits
        self.assertTrue(0.0 < step <= limit)


if __name__ == "__main__":
    unittest.main()
