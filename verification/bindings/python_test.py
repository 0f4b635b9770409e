# SPDX-License-Identifier: Apache-2.0
"""The Python package: same bits as the command, layouts, refusals, signals, what a call costs."""
import csv
import ctypes
import gc
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import numpy as np

import gasjet

SOURCE = os.environ["GASJET_SOURCE_DIR"]
CASES = os.path.join(SOURCE, "cases")


def mesh(name):
    """Nodes and triangles of an OBJ file."""
    lines = pathlib.Path(CASES, "reference", name).read_text(encoding="utf-8").splitlines()
    nodes = [[float(x) for x in line.split()[1:4]] for line in lines if line.startswith("v ")]
    triangles = [[int(x) - 1 for x in line.split()[1:4]] for line in lines if line.startswith("f ")]
    return np.array(nodes), np.array(triangles)


class Runs(unittest.TestCase):
    def test_run_has_the_bits_of_the_command(self):
        case, end = os.path.join(CASES, "jet_bag.toml"), "scene.end_time=0.001"
        with tempfile.TemporaryDirectory() as folder:
            command = [os.environ["GASJET"], "run", case, "--quiet", "--out", folder, "--set", end]
            told = subprocess.run(command, check=True, capture_output=True, text=True).stderr.splitlines()
            run = gasjet.run(case, {"scene.end_time": 0.001}, out=os.path.join(folder, "own"))
            for name, table in (("history.csv", run.history), ("energy.csv", run.energy)):
                for place in (folder, os.path.join(folder, "own")):
                    with open(os.path.join(place, name), encoding="utf-8") as file:
                        rows = list(csv.reader(line for line in file if not line.startswith("#")))
                    self.assertEqual(rows[0], list(table))
                    np.testing.assert_array_equal(np.array(rows[1:], float).T, np.array(list(table.values())))
            commanded, own = (json.loads(pathlib.Path(folder, place, "check.json").read_text()) for place in (".", "own"))
        # What pip builds from a copy without git knows no commit.
        self.assertEqual({**own, "run": commanded["run"], "commit": commanded["commit"]}, commanded)
        self.assertEqual(run.summary["status"], "done")
        self.assertEqual([f"warning: {warning}" for warning in run.warnings], told)
        self.assertEqual(len(told), 2)  # the second inflator and its jet: later than the end
        self.assertEqual(gasjet.run(os.path.join(CASES, "tank_blowdown.toml")).warnings, [])

    def test_views_keep_the_run_and_are_read_only(self):
        history = gasjet.run(os.path.join(CASES, "tank_blowdown.toml")).history
        gc.collect()
        pressure = history["pressure_Pa"]
        self.assertFalse(pressure.flags.owndata)
        self.assertEqual(pressure[0], 5e5)
        with self.assertRaises(ValueError):
            pressure[0] = 1.0

    def test_text_and_overrides_of_all_kinds(self):
        with open(os.path.join(CASES, "tank_blowdown.toml"), encoding="utf-8") as file:
            text = file.read()
        changes = {"tank.volume": np.float64(0.03), "output.history_exact": True, "scene.name": "mine",
                   "gas.initial": {"composition": {"model_N2": 1.0}, "pressure": 4e5, "temperature": 500.0},
                   "output.history_every": None}
        with self.assertRaisesRegex(gasjet.InputError, "output.history_every"):
            gasjet.run("unknown.toml", changes | {"output.history_every": 0}, text=text)
        changes["output.history_every"] = 0.05
        run = gasjet.run("unknown.toml", changes, text=text)
        self.assertEqual(run.summary["scene"], "mine")
        self.assertEqual(run.history["pressure_Pa"][0], 4e5)
        self.assertEqual(run.history["volume_m3"][0], 0.03)

    def test_a_decimal_comma_of_the_callers_locale_changes_nothing(self):
        script = ("import locale, sys, gasjet\n"
                  "locale.setlocale(locale.LC_ALL, 'de_DE.UTF-8')\n"
                  f"run = gasjet.run({os.path.join(CASES, 'tank_blowdown.toml')!r}, {{'tank.volume': 0.03}}, out=sys.argv[1])\n"
                  "print(gasjet.Gas('N2=0.25, O2=0.75').properties(300.0)['cp_J_kgK'], locale.format_string('%.1f', 0.5))\n"
                  "print(gasjet.exact('blowdown', times=[0.1], volume=0.03)['pressure_Pa'][0], run.history['volume_m3'][0])\n")
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", os.path.join(folder, "de_DE.UTF-8")], check=True)
            out = subprocess.run([sys.executable, "-c", script, os.path.join(folder, "out")], env={**os.environ, "LOCPATH": folder},
                                 check=True, capture_output=True, text=True).stdout.split()
            with open(os.path.join(folder, "out", "history.csv"), encoding="utf-8") as file:
                self.assertEqual([line for line in file if line[0] == "0"][0].split(",")[:4], ["0", "500000", "600", "0.03"])
        exact = gasjet.exact("blowdown", times=[0.1], volume=0.03)["pressure_Pa"][0]
        self.assertEqual(out, [str(gasjet.Gas("N2=0.25, O2=0.75").properties(300.0)["cp_J_kgK"]), "0,5", str(exact), "0.03"])

    def test_progress_stops_and_its_exception_arrives(self):
        case = os.path.join(CASES, "jet_bag.toml")
        times = []
        gasjet.run(case, {"scene.end_time": 1e-3}, progress=lambda now, end: times.append((now, end)))
        self.assertEqual(times[-1], (1e-3, 1e-3))
        with self.assertRaises(gasjet.StoppedError) as caught:
            gasjet.run(case, progress=lambda now, end: True)
        self.assertEqual(caught.exception.run.summary["status"], "interrupted")

        def fail(now, end):
            raise KeyError("mine")

        with self.assertRaisesRegex(KeyError, "mine"):
            gasjet.run(case, progress=fail)

    def test_a_run_past_its_domain_gives_what_it_has(self):
        with self.assertRaises(gasjet.DomainError) as caught:
            gasjet.run(os.path.join(CASES, "jet_bag.toml"), {"scene.end_time": 0.02, "time.step": 1e-3, "time.unsafe_step": True})
        self.assertGreater(len(caught.exception.run.history["time_s"]), 0)

    def test_interrupt_ends_a_run(self):
        script = ("import gasjet, sys\ntry:\n  print('begun', flush=True)\n"
                  f"  gasjet.run({os.path.join(CASES, 'tank_blowdown.toml')!r}, {{'scene.end_time': 1e3}})\n"  # takes seconds
                  "except KeyboardInterrupt:\n  sys.exit(7)\n")
        with subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE) as process:
            process.stdout.readline()
            time.sleep(0.3)  # reading the case takes less
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(30), 7)

    def test_other_threads_go_on_during_a_run(self):
        running, counts = threading.Event(), []

        def count():
            n = 0
            running.wait()
            while running.is_set():
                n += 1
                time.sleep(1e-3)
            counts.append(n)

        thread = threading.Thread(target=count)
        thread.start()
        running.set()
        gasjet.run(os.path.join(CASES, "jet_bag.toml"), {"scene.end_time": 3e-3})
        running.clear()
        thread.join()
        self.assertGreater(counts[0], 2)


class ClosedForms(unittest.TestCase):
    def test_exact_and_catalogue(self):
        form = gasjet.catalogue()["blowdown"]
        self.assertIn("pressure_Pa", form["columns"])
        table = gasjet.exact("blowdown", times=[0.0, 0.1], initial_pressure=4e5)
        self.assertEqual(table["pressure_Pa"][0], 4e5)
        self.assertGreater(gasjet.exact("ambient_inrush")["end_time_s"][0], 0.2)
        with self.assertRaisesRegex(gasjet.InputError, "no_such"):
            gasjet.exact("blowdown", no_such=1.0)
        with self.assertRaises(gasjet.InputError):
            gasjet.exact("nothing_of_that_name")

    def test_compare_takes_files_runs_and_dicts(self):
        reference = os.path.join(CASES, "reference", "tank_blowdown.csv")
        run = gasjet.run(os.path.join(CASES, "tank_blowdown.toml"))
        self.assertEqual(gasjet.compare(run, reference)["verdict"], "inside")
        off = {"time_s": run.history["time_s"], "pressure_Pa": 1.2 * run.history["pressure_Pa"]}
        verdict = gasjet.compare(off, reference)
        self.assertEqual(verdict["quantities"]["pressure_Pa"]["verdict"], "outside")
        with self.assertRaisesRegex(gasjet.InputError, "absent.csv"):
            gasjet.compare("absent.csv", reference)


class Visible(unittest.TestCase):
    source = dict(centre=(0.1, 0.01, 0.0), axis=(1.0, 0.2, 0.1))

    def setUp(self):
        self.nodes, self.triangles = mesh("plate_jet_shadow.obj")

    def test_layouts_and_types_give_one_mask(self):
        lit = gasjet.visible(self.nodes, self.triangles, **self.source)
        self.assertEqual(lit.dtype, bool)
        self.assertTrue(0 < lit.sum() < len(lit))
        wide = np.full((len(self.nodes), 8), np.nan)
        wide[:, 1:7:2] = self.nodes
        for nodes in (np.asfortranarray(self.nodes), wide[:, 1:7:2], self.nodes[::-1].copy()[::-1], self.nodes.tolist()):
            for kind in (np.int32, np.int64, np.uint16):
                np.testing.assert_array_equal(gasjet.visible(nodes, self.triangles.astype(kind), **self.source), lit)
        np.testing.assert_array_equal(gasjet.visible(self.nodes, np.asfortranarray(self.triangles, np.int32), **self.source), lit)

        flat = np.broadcast_to(np.array([[0.1], [0.5], [0.2]]), (3, 3))
        np.testing.assert_array_equal(gasjet.visible(flat, [[0, 1, 2]], **self.source), gasjet.visible(flat.copy(), [[0, 1, 2]], **self.source))

        class Mesh:  # as of meshio
            points, cells_dict = self.nodes, {"triangle": self.triangles}

        np.testing.assert_array_equal(gasjet.visible(Mesh, **self.source), lit)
        surface = gasjet.Surface(self.triangles, len(self.nodes))
        np.testing.assert_array_equal(surface.visible(self.nodes, candidates=[3, 1], **self.source), lit[[3, 1]])

    def test_refusals_name_the_argument(self):
        good, bad = self.nodes.copy(), self.nodes.copy()
        bad[7, 1] = np.nan
        calls = [
            (TypeError, "nodes", lambda: gasjet.visible(good.astype(object), self.triangles, **self.source)),
            (TypeError, "nodes", lambda: gasjet.visible(good[:, :2], self.triangles, **self.source)),
            (TypeError, "nodes", lambda: gasjet.visible(good.ravel(), self.triangles, **self.source)),
            (TypeError, "nodes", lambda: gasjet.visible("nodes", self.triangles, **self.source)),
            (TypeError, "nodes", lambda: gasjet.visible(good.astype(complex), self.triangles, **self.source)),
            (TypeError, "triangles", lambda: gasjet.visible(good, self.triangles.astype(float), **self.source)),
            (TypeError, "triangles", lambda: gasjet.visible(good, self.triangles[:, :2], **self.source)),
            (TypeError, "triangles", lambda: gasjet.visible(good, None, **self.source)),
            (ValueError, "triangles", lambda: gasjet.visible(good, self.triangles - 1, **self.source)),
            (ValueError, "triangles", lambda: gasjet.visible(good, self.triangles + 1, **self.source)),
            (ValueError, "triangles", lambda: gasjet.visible(good, self.triangles + 2**40, **self.source)),
            (ValueError, "triangle_count", lambda: gasjet.visible(good, self.triangles[:0], **self.source)),
            (ValueError, "", lambda: gasjet.visible(bad, self.triangles, **self.source)),
            (ValueError, "source.centre", lambda: gasjet.visible(good, self.triangles, centre=(np.nan, 0, 0), axis=(1, 0, 0))),
            (ValueError, "null_elements", lambda: gasjet.visible(good, self.triangles, null_elements=[10**9], **self.source)),
            (TypeError, "null_elements", lambda: gasjet.visible(good, self.triangles, null_elements=[0.5], **self.source)),
            (TypeError, "", lambda: gasjet.visible(good, self.triangles, centre=(0, 0), axis=(1, 0, 0))),
        ]
        for kind, argument, call in calls:
            with self.assertRaisesRegex(kind, argument):
                call()

    def test_a_call_costs_less_than_20_us_above_the_library(self):
        nodes, triangles = mesh("passenger_jet.obj")
        triangles = triangles.astype(np.int32)
        self.assertEqual(len(triangles), 2744)
        library = ctypes.CDLL(os.environ["GASJET_LIBRARY"])
        source = np.array([0.1, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0])  # a gasjet_source
        asked = np.arange(0, 2744, 7, dtype=np.int32)
        lit = np.zeros(len(asked), bool)
        x, t, s, some, to = (array.ctypes.data_as(ctypes.c_void_p) for array in (nodes, triangles, source, asked, lit))
        handle, none, zero = ctypes.c_int64(), None, ctypes.c_int64(0)
        n, m, k = (ctypes.c_int64(len(array)) for array in (nodes, triangles, asked))
        bound = ctypes.c_double(0.0)
        library.gasjet_surface_create(t, m, none, n, none, zero, none, zero, ctypes.byref(handle))
        surface = gasjet.Surface(triangles, len(nodes))

        def bare():
            library.gasjet_surface_visible(handle, x, n, none, s, some, k, bound, to, k, none)

        def package():
            return surface.visible(nodes, (0.1, 0.0, 0.0), (1.0, 0.0, 0.0), candidates=asked, displacement_bound=0.0)

        fastest = {bare: np.inf, package: np.inf}
        for _ in range(1000):  # in turn, so that both meet the same machine
            for call in fastest:
                begin = time.perf_counter()
                call()
                fastest[call] = min(fastest[call], time.perf_counter() - begin)
        np.testing.assert_array_equal(package(), lit)
        self.assertEqual(library.gasjet_free(handle), 0)
        above = 1e6 * (fastest[package] - fastest[bare])
        print(f"visible on 2744 elements: {1e6 * fastest[bare]:.0f} us in the library, {above:.1f} us above it")
        self.assertLess(above, 20.0)


class Bodies(unittest.TestCase):
    def test_jet_on_a_plate(self):
        nodes, triangles = mesh("plate_jet_shadow.obj")
        jet = gasjet.Jet((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), radius=0.03, decay_coefficient=0.08)
        pressure, force = jet.pressure(nodes, triangles, velocity=400.0, density=1.0)
        self.assertEqual(pressure.shape, (len(triangles),))
        edges = nodes[triangles[:, 1]] - nodes[triangles[:, 0]], nodes[triangles[:, 2]] - nodes[triangles[:, 0]]
        np.testing.assert_allclose(force, pressure @ (np.cross(*edges) / 2.0), rtol=1e-12, atol=1e-12)
        again, _ = jet.pressure(np.asfortranarray(nodes), triangles, velocity=400.0, density=1.0, displacement_bound=0.0)
        np.testing.assert_array_equal(again, pressure)
        along = jet.velocity(np.array([[0.1, 0.0, 0.0], [1.0, 0.0, 0.0]]))
        self.assertEqual(along[0, 0], 1.0)
        self.assertLess(along[1, 0], 0.5)
        for change in (dict(radius=-1.0), dict(radius=0.03, restitution=4.1), dict(short_side=0.1)):
            with self.assertRaises(gasjet.InputError):
                gasjet.Jet((0, 0, 0), (1, 0, 0), decay_coefficient=0.08, **change)

    def test_membrane_forces_balance(self):
        nodes, triangles = mesh("sphere_vent.obj")
        bag = gasjet.Membrane(nodes, triangles, thickness=4e-4, density=800.0, young_modulus=3e8, poisson=0.3)
        self.assertAlmostEqual(bag.masses.sum(), bag.evaluate(nodes)["mass_kg"], 12)
        state = bag.evaluate(1.01 * nodes, gamma=1.4, pressure=2e5)
        np.testing.assert_allclose(state["force_N"].sum(0), 0.0, atol=1e-9)
        self.assertLess((state["force_N"] * nodes).sum(), 0.0)  # it pulls back
        # V is homogeneous of degree 3 in the positions.
        self.assertAlmostEqual((state["gradient_m2"] * 1.01 * nodes).sum() / (3.0 * state["volume_m3"]), 1.0, 12)
        with self.assertRaises(ValueError):
            bag.evaluate(nodes[:-1])

    def test_tank_and_gas(self):
        nitrogen = gasjet.Gas.ideal(296.8, 1038.8)
        tank = gasjet.Tank(nitrogen, 5e5, 600.0, 0.06)
        tank.add_vent(1e-3)
        pressure = tank.advance(0.1)["pressure_Pa"]
        self.assertAlmostEqual(pressure / gasjet.exact("blowdown", times=0.1)["pressure_Pa"][0], 1.0, 9)
        with self.assertRaisesRegex(ValueError, "time"):
            tank.advance(0.05)
        with self.assertRaisesRegex(TypeError, "mass_flow"):
            tank.add_inflow(nitrogen, [0.0, 1.0], [1.0], [700.0, 700.0])
        hot = gasjet.Gas("N2=0.7, H2O=0.3").properties(900.0)
        self.assertAlmostEqual(gasjet.Gas("N2=0.7, H2O=0.3").temperature(hot["internal_energy_J_kg"]), 900.0, 9)
        self.assertGreater(gasjet.orifice(1e-3, 2e5, 300.0, 296.8, 1038.8, 1e5), gasjet.fabric_leak(1e-4, 1.2, 1e5))
        self.assertGreater(gasjet.outlet(1e-3, 1.0, 600.0, 1038.8, 296.8)["velocity_m_s"], 300.0)


if __name__ == "__main__":
    unittest.main()
