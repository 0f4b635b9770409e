# SPDX-License-Identifier: Apache-2.0
"""Simulations from Python that are misused: each fault is named, and nothing is lost."""
import itertools
import os
import tempfile
import threading
import unittest
import warnings

import numpy as np

import gasjet

CASES = os.path.join(os.environ["GASJET_SOURCE_DIR"], "cases")


def case(name):
    return os.path.join(CASES, name + ".toml")


class Misuse(unittest.TestCase):
    def setUp(self):
        self.simulation = gasjet.Simulation(case("guided_headform"), set={"scene.end_time": 5e-4})

    def test_wrong_arguments_are_named(self):
        bad_numbers = ["x", None, [1.0], float("nan"), float("inf"), -1.0, object(), 1e400]
        bad_vectors = [None, 1.0, (1, 2), (1, 2, 3, 4), (1.0, float("nan"), 0.0), "abc", (1, 2, "x")]
        bad_indices = [-1, 99, "x", None, 1.5, 2**70]
        s = self.simulation
        calls = [(s.set_vent, "area", [(0, v) for v in bad_numbers]), (s.set_vent, "vent", [(v, 1e-3) for v in bad_indices]),
                 (s.set_inflow, "mass_flow", [(0, v, 400.0) for v in bad_numbers]),
                 (s.set_inflow, "temperature", [(0, 1.0, v) for v in bad_numbers + [0.0]]),
                 (s.set_inflow, "inflator", [(v, 1.0, 400.0) for v in bad_indices]),
                 (s.set_ambient, "pressure", [(v, 300.0) for v in bad_numbers]),
                 (s.set_ambient, "temperature", [(1e5, v) for v in bad_numbers + [0.0]]),
                 (s.set_gravity, "gravity", [(v,) for v in bad_vectors]),
                 (s.set_outlet, "jet", [(v, (0, 0, 0), (1, 0, 0)) for v in bad_indices + [0]]),
                 (s.set_outlet, "centre", [(0, v, (1, 0, 0)) for v in bad_vectors]),
                 (s.set_outlet, "axis", [(0, (0, 0, 0), v) for v in bad_vectors]),
                 (s.set_sensor, "name", [(v, True) for v in ["", "x", 3, None, "a\0b"]]),
                 (s.set_impactor, "centre", [(v, (0, 0, 0)) for v in bad_vectors + [(9.0, 9.0, 9.0)]]),
                 (s.set_impactor, "velocity", [((0.52, 0, 0.02), v) for v in bad_vectors]),
                 (s.set_impactor, "axes", [((0.52, 0, 0.02), (0, 0, 0), v) for v in [1.0, np.zeros((3, 3)), np.eye(2), -np.eye(3), "x"]]),
                 (s.set_impactor, "angular_velocity", [((0.52, 0, 0.02), (0, 0, 0), None, v) for v in bad_vectors]),
                 (s.step, "count", [(v,) for v in [-1, "x", None, 1.5, 2**70]]),
                 (s.advance, "time", [(v,) for v in ["x", None, float("nan"), -1.0]]),
                 (s.advance_exactly, "time", [(v,) for v in ["x", None, float("nan"), -1.0]]),
                 (s.overpressure, "jet", [(v,) for v in bad_indices]), (s.lit, "jet", [(v,) for v in bad_indices]),
                 (s.value, "name", [(v,) for v in ["", "x", 3, None, "a\0b"]]),
                 (s.restore, "state", [(v,) for v in [b"", b"x", b"x" * 1000, "text", None, 3]]),
                 (s.assign, "other", [(v,) for v in [None, 3, "x", gasjet.Tank]])]
        count = 0
        for call, name, arguments in calls:
            for given in arguments:
                with self.subTest(call=call.__name__, given=repr(given)[:80]):
                    with self.assertRaises((gasjet.InputError, TypeError)) as caught:
                        call(*given)
                    self.assertRegex(str(caught.exception), f"^({name}|sim|size|from|jet|column)\\b")
                    count += 1
        self.assertGreater(count, 130)
        s.step(3)  # nothing was changed
        fresh = gasjet.Simulation(case("guided_headform"), set={"scene.end_time": 5e-4})
        fresh.step(3)
        np.testing.assert_array_equal(s.position, fresh.position)

    def test_wrong_cases_are_named(self):
        for given, text in ((3, None), ("", None), ("no_such_file", None), ({"scene": 1}, None), ({"a": object()}, None),
                            ({}, None), ({"scene": {}}, "x = 1"), ("x", "not toml")):
            with self.subTest(given=given), self.assertRaises((gasjet.InputError, TypeError, ValueError)):
                gasjet.Simulation(given, text=text)
        with self.assertRaisesRegex(gasjet.InputError, "threads"):
            gasjet.Simulation(case("rigid_tank"), threads=0)

    def test_what_a_case_does_not_have_is_named(self):
        tank, pendulum = gasjet.Simulation(case("rigid_tank")), gasjet.Simulation(case("pendulum_pulse"))
        for call in (lambda: tank.triangles, lambda: tank.own_force, lambda: tank.impact, lambda: tank.set_gravity((0, 0, 1)),
                     lambda: tank.set_impactor((0, 0, 0), (0, 0, 0)), lambda: pendulum.gas, lambda: pendulum.set_vent(0, 1.0),
                     lambda: pendulum.set_impactor((0, 0, 0), (0, 0, 0)), lambda: tank.set_outlet(0, (0, 0, 0), (1, 0, 0))):
            with self.assertRaises(gasjet.InputError) as caught:
                call()
            self.assertTrue(str(caught.exception))
        self.assertEqual(len(tank.position), 0)

    def test_other_cases_states_are_refused(self):
        other = gasjet.Simulation(case("rigid_tank"))
        with self.assertRaisesRegex(gasjet.InputError, "from: is of another case"):
            self.simulation.assign(other)
        with self.assertRaisesRegex(gasjet.InputError, "from: is the simulation itself"):
            other.assign(other)
        with self.assertRaisesRegex(gasjet.InputError, "state: is of"):
            self.simulation.restore(other.save())
        state = self.simulation.save()
        for changed in ({"impactor.motion.mass": 6.9}, {"contact.friction": 0.31}, {"vent.0.area": 2.1e-3}):
            similar = gasjet.Simulation(case("guided_headform"), set={"scene.end_time": 5e-4, **changed})
            with self.assertRaisesRegex(gasjet.InputError, "state: is of"):
                similar.restore(state)

    def test_at_the_end_steps_are_refused(self):
        self.simulation.advance(1.0)
        with self.assertRaisesRegex(gasjet.InputError, "at its end"):
            self.simulation.step()
        self.simulation.step(0)

    def test_failures_stay_and_are_named(self):
        self.simulation.own_force[:] = np.nan
        for _ in range(2):
            with self.assertRaisesRegex(gasjet.DomainError, "S8_advance"):
                self.simulation.step()
        self.assertEqual(self.simulation.results.summary["status"], "failed")
        self.simulation.reset()
        self.simulation.step()

    def test_callbacks_stop_and_raise(self):
        simulation = gasjet.Simulation(case("passenger_sharp"))
        with self.assertRaises(gasjet.StoppedError):
            simulation.advance(1.0, progress=lambda time, end: True)
        with self.assertRaises(ZeroDivisionError):
            simulation.advance(1.0, progress=lambda time, end: 1 // 0)
        with self.assertRaises(gasjet.StoppedError):
            simulation.advance_exactly(0.001, progress=lambda time, end: True)
        simulation.advance_exactly(2e-4)
        self.assertEqual(simulation.time, 2e-4)

    def test_a_callback_cannot_step_its_simulation(self):
        simulation = gasjet.Simulation(case("passenger_sharp"))
        seen = []

        def step(time, end):
            try:
                simulation.step()
            except gasjet.BusyError as error:
                seen.append(str(error))
            return True

        with self.assertRaises(gasjet.StoppedError):
            simulation.advance(1.0, progress=step)
        self.assertIn("used by", seen[0])

    def test_two_threads_take_turns_or_are_told(self):
        told, done = [], []

        def work():
            for _ in range(100):
                try:
                    self.simulation.clone()
                    done.append(self.simulation.time)
                except gasjet.BusyError as error:
                    told.append(str(error))

        threads = [threading.Thread(target=work) for _ in range(4)]
        for one in threads:
            one.start()
        for one in threads:
            one.join()
        self.assertEqual(len(told) + len(done), 400)

    def test_views_outlive_the_simulation(self):
        simulation = gasjet.Simulation(case("ball_impact"))
        views = [simulation.position, simulation.velocity, simulation.triangles, simulation.own_force]
        copies = [view.copy() for view in views]
        del simulation
        for view, kept in itertools.zip_longest(views, copies):
            np.testing.assert_array_equal(view, kept)

    def test_a_folder_is_finished_when_the_simulation_goes(self):
        with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
            out = os.path.join(folder, "out")
            simulation = gasjet.Simulation(case("rigid_tank"), out=out)
            simulation.step()
            for refused in (simulation.reset, lambda: simulation.assign(simulation.clone())):
                with self.assertRaisesRegex(gasjet.InputError, "folder"):
                    refused()
            del simulation
            with open(os.path.join(out, "summary.json")) as file:
                self.assertIn('"interrupted"', file.read())


if __name__ == "__main__":
    unittest.main()
