# SPDX-License-Identifier: Apache-2.0
"""What the Python package says: warnings, messages in its own terms, keys in the help, what objects are."""
import os
import signal
import subprocess
import sys
import unittest
import warnings

import numpy as np

import gasjet

CASES = os.path.join(os.environ["GASJET_SOURCE_DIR"], "cases")
TANK, BAG = (os.path.join(CASES, name) for name in ("tank_blowdown.toml", "jet_bag.toml"))
NODES = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
TRIANGLES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], np.int32)
CENTRE, AXIS = (0.1, 0.1, 0.1), (1.0, 0.0, 0.0)


def objects():
    """One of each class, made as a user does."""
    gas = gasjet.Gas("N2=0.78, O2=0.22")
    fabric = dict(thickness=4e-4, density=800.0, young_modulus=3e8, poisson=0.3)
    return {
        "gas": gas, "ideal": gasjet.Gas.ideal(297.0, 1039.0), "tank": gasjet.Tank(gas, 2e5, 300.0, 0.1),
        "surface": gasjet.Surface(TRIANGLES, 4), "jet": gasjet.Jet(CENTRE, AXIS, decay_coefficient=0.08, radius=0.03),
        "membrane": gasjet.Membrane(NODES, TRIANGLES, **fabric),
        "contact": gasjet.Contact(NODES, TRIANGLES, masses=np.ones(4), effective_mass=1.0, radius=0.1, stiffness=1e5),
        "skin_contact": gasjet.SkinContact(NODES, TRIANGLES, masses=np.ones(4), thickness=0.1, stiffness=1e5),
        "pendulum": gasjet.Pendulum(CENTRE, AXIS, (0.0, 0.0, -1.0), mass=1.0, inertia_cg=1.0, cg_distance=1.0, impactor_distance=1.0,
                                    impactor_radius=0.1, angle=0.25),
        "body": gasjet.RigidBody(CENTRE, mass=1.0, rail=AXIS, velocity=(3.0, 0.0, 0.0)), "run": gasjet.run(TANK),
    }


class Warnings(unittest.TestCase):
    def test_a_run_warns_of_what_the_command_does(self):
        with self.assertWarns(gasjet.GasjetWarning) as told:
            run = gasjet.run(BAG, {"scene.end_time": 1e-3, "fabric.thickness": 0.5})
        self.assertTrue(any("fabric.thickness" in str(warning.message) for warning in told.warnings), told.warnings)
        self.assertEqual([str(warning.message) for warning in told.warnings], run.warnings)
        self.assertEqual({warning.filename for warning in told.warnings}, {__file__})  # the caller's line
        self.assertIn(f"{len(run.warnings)} warnings", repr(run))

    def test_a_run_without_warnings_is_quiet(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.assertNotIn("warning", repr(gasjet.run(TANK)))

    def test_a_warning_as_an_error_has_the_run(self):
        with warnings.catch_warnings():
            warnings.simplefilter("error", gasjet.GasjetWarning)
            with self.assertRaises(gasjet.GasjetWarning) as caught:
                gasjet.run(BAG, {"scene.end_time": 1e-3})
        self.assertEqual(caught.exception.run.summary["status"], "done")

    def test_a_run_past_its_domain_warns_too(self):
        with self.assertWarns(gasjet.GasjetWarning), self.assertRaises(gasjet.DomainError):
            gasjet.run(BAG, {"scene.end_time": 0.02, "time.step": 1e-3, "time.unsafe_step": True, "fabric.thickness": 0.5})


class Stopped(unittest.TestCase):
    def test_interrupts_and_exceptions_of_the_caller_have_the_run(self):
        class Closed(Exception):
            """As classes with slots are, it takes no attribute."""

            def __setattr__(self, name, value):
                raise AttributeError(name)

        def interrupt(now, end):
            if now > 0.0:
                os.kill(os.getpid(), signal.SIGINT)

        def raises(error):
            def progress(now, end):
                if now > 0.0:
                    raise error
            return progress

        for progress, kind in ((interrupt, KeyboardInterrupt), (raises(KeyboardInterrupt()), KeyboardInterrupt),
                               (raises(KeyError("mine")), KeyError), (raises(SystemExit(3)), SystemExit)):
            with warnings.catch_warnings(), self.assertRaises(kind) as caught:
                warnings.simplefilter("ignore")
                gasjet.run(os.path.join(CASES, "passenger_sharp.toml"), progress=progress)
            self.assertEqual(caught.exception.run.summary["status"], "interrupted")
            self.assertGreater(caught.exception.run.summary["time_end_s"], 0.0)
        with warnings.catch_warnings(), self.assertRaises(Closed):
            warnings.simplefilter("ignore")
            gasjet.run(BAG, progress=raises(Closed()))

    def test_where_the_callers_exception_was_raised_is_told(self):
        script = f"import gasjet\ndef fails(now, end):\n  return 1 / 0\ngasjet.run({TANK!r}, progress=fails)\n"
        told = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=False).stderr
        self.assertRegex(told, r"line 3, in fails(.|\n)*ZeroDivisionError")


class Objects(unittest.TestCase):
    def test_a_misspelt_attribute_is_refused(self):
        for name, made in objects().items():
            for attribute in ("presure", "temperature_K", "radius"):
                with self.assertRaises(AttributeError, msg=f"{name}.{attribute}"):
                    setattr(made, attribute, 1.0)

    def test_an_object_says_what_it_is(self):
        made = objects()
        made["tank"].advance(0.5)
        for name, words in {
                "gas": "<gasjet.Gas N2=0.78, O2=0.22>", "ideal": "gas constant 297 .*cp 1039 ", "tank": "at 0.5 s: 0.1 m3, 200000 Pa, 300 K",
                "surface": "4 elements, 4 nodes", "jet": r"round, radius 0.03 m, at \(0.1, 0.1, 0.1\) m along \(1, 0, 0\)",
                "membrane": "4 elements, 4 nodes, saint_venant_kirchhoff, with wrinkles", "contact": "radius 0.1 m, 100000 N/m3, .*4 elements",
                "skin_contact": "thickness 0.1 m, 100000 N/m3, .*4 elements",
                "pendulum": "at 0.25 rad, 0 rad/s", "body": "0 m from its start, 3 m/s", "run": "tank_blowdown: done, 351 rows>"}.items():
            self.assertRegex(repr(made[name]), words)
        slot = gasjet.Jet(CENTRE, AXIS, decay_coefficient=0.1, short_side=0.01, long_side=0.2, long_direction=(0.0, 1.0, 0.0))
        self.assertIn("0.01 m by 0.2 m", repr(slot))
        self.assertIn("constant cp at 300 K", repr(gasjet.Gas("N2=1", 300.0)))

    def test_help_names_the_keys_of_what_is_returned(self):
        made, tank, pendulum = objects(), gasjet.Tank, gasjet.Pendulum
        made["jet"].pressure(NODES, TRIANGLES, velocity=400.0, density=1.0)
        reference = os.path.join(CASES, "reference", "tank_blowdown.csv")
        compared = gasjet.compare(made["run"], reference)
        quantity = compared["quantities"]["pressure_Pa"]
        for given, described in (
                (made["gas"].properties(300.0), gasjet.Gas.properties), (made["tank"].state, tank.state), (made["tank"].balance, tank.balance),
                (gasjet.outlet(1e-3, 1.0, 500.0, 1039.0, 297.0), gasjet.outlet), (made["jet"].counters, gasjet.Jet),
                (gasjet.check_surface(NODES, TRIANGLES), gasjet.check_surface), (made["membrane"].evaluate(NODES), gasjet.Membrane.evaluate),
                (made["contact"].evaluate(NODES, (0.0, 0.0, -5.0)), gasjet.Contact.evaluate), (made["pendulum"].state, pendulum.state),
                (made["body"].state, gasjet.RigidBody.state), (made["body"].advance(1e-3), gasjet.RigidBody.advance),
                (compared, gasjet.compare), (quantity, gasjet.compare)):
            for key in given:
                self.assertIn(key, described.__doc__)


class Messages(unittest.TestCase):
    """Where a dict was given nothing is said of options, of files or of their rows."""

    def told(self, call, words):
        with self.assertRaises(ValueError) as caught:
            call()
        self.assertRegex(str(caught.exception), words)
        self.assertNotRegex(str(caught.exception), r"--|\.csv|\brows?\b|/tmp")

    def test_of_set(self):
        for changes, words in (
                ({"tank.volum": 0.03}, r"^set: tank.volum=0.03: tank.volum: unknown key, .*is 'volume' meant\?"),
                ({"tank.volume": -1}, "^set: tank.volume=-1: tank.volume: is -1, "), ({"tank.volume": "a: b"}, "^set: tank.volume="),
                ({"tank.depth": None}, "^set: tank.depth=None: the case has no such key"),
                ({"vent.area": 1e-4}, "^set: vent.area=0.0001: vent is a list of one, allowed: vent.0.area"),
                ({"scene": {"name": "x", "end_tim": 1.0}}, "^set: scene="), ({"vent": [{"area": 1.0, "aera": 1.0}]}, "^set: vent=")):
            self.told(lambda: gasjet.run(TANK, changes), words)

    def test_of_out(self):
        self.told(lambda: gasjet.run(TANK, out="/dev/null/x"), "^out: /dev/null/x")

    def test_of_histories(self):
        good = {"time_s": [0.0, 1.0, 2.0], "pressure_Pa": [1.0, 2.0, 3.0]}
        for name, call in (("mine", lambda bad: gasjet.compare(bad, good)), ("reference", lambda bad: gasjet.compare(good, bad))):
            for bad, words in (
                    ({"time": [0.0, 1.0, 2.0]}, "has no column time_s, only time"),
                    ({"time_s": [0.0, 1.0], "pressure_Pa": [1.0, 2.0]}, "has 2 numbers in each column, allowed: 3 or more"),
                    ({**good, "time_s": [0.0, 2.0, 1.0]}, r"time_s\[2\]: 1 s follows 2 s"),
                    ({**good, "pressure_Pa": [1.0, np.inf, 2.0]}, r"pressure_Pa\[1\]: is inf, allowed: finite numbers"),
                    ({**good, "pressure_Pa": [1.0, 2.0, 1e200]}, r"pressure_Pa\[2\]: 1e\+200"),
                    ({**good, "pressure_Pa_band": [1.0, -1.0, 1.0]}, r"pressure_Pa_band\[1\]: -1")):
                self.told(lambda: call(bad), f"^{name}: {words}")

    def test_of_names_and_bands(self):
        good = {"time_s": [0.0, 1.0, 2.0], "pressure_Pa": [1.0, 2.0, 3.0]}
        self.told(lambda: gasjet.compare(good, good, columns=["volume_m3"]), "^columns: volume_m3: the reference has no such quantity")
        verdict = gasjet.compare(good, good)
        self.assertEqual(verdict["reason"], "the reference has no band; use tolerance")
        self.assertEqual((verdict["mine"], verdict["reference"]), ("a dict", "a dict"))


if __name__ == "__main__":
    unittest.main()
