# SPDX-License-Identifier: Apache-2.0
"""The commands as Python functions: what they give, how they fail, and the program that they run."""
import functools
import json
import os
import pathlib
import signal
import stat
import subprocess
import sys
import tempfile
import time
import unittest
import warnings
from unittest import mock

import numpy as np

import gasjet
from gasjet import program

CASES = os.path.join(os.environ["GASJET_SOURCE_DIR"], "cases")
SHORT = {"scene.end_time": 0.0005}


def case(name):
    return os.path.join(CASES, name + ".toml")


class Here(unittest.TestCase):
    """In an empty working folder."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        caught = warnings.catch_warnings()
        caught.__enter__()
        self.addCleanup(caught.__exit__, None, None, None)
        warnings.simplefilter("ignore", gasjet.GasjetWarning)  # the second inflator of jet_bag is later than the end


class Commands(Here):
    def test_check_has_what_a_run_writes(self):
        gasjet.run(case("jet_bag"), SHORT, out="out")
        written, checked = json.loads(pathlib.Path("out/check.json").read_text()), gasjet.check(case("jet_bag"), SHORT)
        for key in ("settings", "defaults", "derived", "forecast"):
            self.assertEqual(checked[key], written[key])
        with open(case("jet_bag"), encoding="utf-8") as file:
            self.assertEqual(gasjet.check("mine.toml", SHORT, text=file.read())["settings"], checked["settings"])
        self.assertEqual(gasjet.check({**checked["settings"]})["settings"], checked["settings"])
        self.assertEqual(os.listdir("."), ["out"])  # the dict's file is gone

    def test_ensemble_means_are_those_of_its_runs(self):
        made = gasjet.ensemble(case("jet_bag"), SHORT, runs=3)
        self.assertEqual((made.command, made.status, made.folder, os.listdir(".")), ("ensemble", "done", None, []))
        mean, runs = made.tables["ensemble"], made.tables["runs"]
        single = np.mean([runs[f"pressure_Pa_run_{seed}"] for seed in (1, 2, 3)], axis=0)
        np.testing.assert_allclose(mean["pressure_Pa_mean"], single, rtol=1e-5)  # runs.csv has six digits
        peak = made.data["quantities"]["peak_pressure_Pa"]
        self.assertAlmostEqual(np.mean(peak["values"]) / peak["mean"], 1.0, 14)
        self.assertEqual(made.tables["quantities"]["quantity"][0], "peak_pressure_Pa")
        self.assertEqual(mean.about["runs"], "3")
        self.assertIn("peak_pressure_Pa", made.printed)
        with self.assertWarnsRegex(gasjet.GasjetWarning, "inflator.1 delivers nothing"):
            two = gasjet.ensemble(case("jet_bag"), SHORT, out="two", runs=2, against=case("sphere_inflation"))
        self.assertEqual((list(two.parts), two.folder), (["jet_bag", "sphere_inflation"], "two"))
        effects = two.tables["effects"]
        np.testing.assert_allclose(effects["mean"] - effects["mean_against"], effects["difference"], rtol=1e-12)
        self.assertEqual(repr(gasjet.load("two")), repr(two))

    def test_a_study_of_dicts_goes_on_where_it_was(self):
        plan = {"study": {"case": case("tank_steps"), "set": ["scene.end_time=0.05"], "quantities": ["pressure_Pa"]},
                "factor": [{"key": "gas.initial.pressure", "values": [101325.0, 2e5]}]}
        whole = gasjet.study(plan, "out")
        table = whole.tables["results"]
        np.testing.assert_array_equal(table["gas.initial.pressure"], [101325.0, 2e5])
        single = gasjet.run(case("tank_steps"), {"scene.end_time": 0.05, "gas.initial.pressure": 2e5})
        self.assertEqual(table["pressure_Pa"][1], single.history["pressure_Pa"][-1])
        self.assertEqual((whole.command, whole.status, os.listdir(".")), ("study", "done", ["out"]))
        self.assertEqual(gasjet.study(plan, "out").tables["timing"]["cpu_s"].tolist(), whole.tables["timing"]["cpu_s"].tolist())  # not again
        command = [os.environ["GASJET"], "study", "run", "out/plan.toml", "--out", "shares", "--quiet", "--share"]
        for share, status in (("1/2", "incomplete"), ("2/2", "done")):
            subprocess.run([*command, share], check=True)
            self.assertEqual(gasjet.merge_study("shares").status, status)
        np.testing.assert_array_equal(gasjet.load("shares").tables["results"]["pressure_Pa"], table["pressure_Pa"])

    def test_ladder_and_cost(self):
        steps = gasjet.ladder(case("tank_steps"), "pressure_Pa", 0.02, {"scene.end_time": 0.05})
        self.assertEqual(steps.data["tolerance"], 0.02)
        self.assertIn(steps.data["cheapest"], steps.tables["ladder"]["rung"])
        self.assertIn("end_time = 0.05", steps.texts["cheapest.toml"])
        parts = gasjet.cost(case("tank_steps"), {"scene.end_time": 0.05}, runs=3)
        self.assertEqual(parts.data["runs"], 3)
        self.assertEqual([variant["variant"] for variant in parts.data["variants"]], list(parts.tables["cost"]["variant"]))

    def test_identify_takes_files_and_columns(self):
        test = dict(method="dual", volume=0.06, mass=0.08, gas="N2", points=21, draws=40)
        file = os.path.join(CASES, "tank_test_readings.csv")
        curves = gasjet.identify(file, out="curves.csv", **test)
        # A quadrature of 21 rows, and 1 % of noise: 80 g within 2 %.
        self.assertAlmostEqual(np.trapz(curves["mass_flow_kg_s"], curves["time_s"]) / 0.08, 1.0, delta=0.02)
        again = gasjet.identify(gasjet.tables.read_table(file), **test)
        for name, values in curves.items():
            np.testing.assert_array_equal(values, again[name])
        self.assertEqual(curves.about["gas"], again.about["gas"])

    def test_meshes(self):
        bag = gasjet.mesh("case", case("jet_bag"))
        np.testing.assert_array_equal(bag.nodes, gasjet.Simulation(case("jet_bag")).position)
        np.testing.assert_array_equal(bag.triangles, gasjet.Simulation(case("jet_bag")).triangles)
        self.assertTrue(gasjet.check_surface(bag)["ok"])  # as if of meshio
        driver = gasjet.mesh("driver", set={"rings": 10}, out="bag.k")
        self.assertEqual(driver.panels, ["front", "back", "attachment", "vent_left", "vent_right"])
        self.assertTrue(gasjet.check_surface(driver.initial, driver.triangles)["ok"])
        self.assertIn(f"{len(driver.triangles)} elements, {len(driver.nodes)} nodes", driver.printed)
        back = gasjet.mesh("convert", "bag.k", panel=["front", "back"], report=True)
        self.assertEqual(len(back.triangles), (driver.panel < 2).sum())
        self.assertEqual(len(gasjet.mesh("convert", os.path.join(CASES, "cargo_drop.obj"), refine=1).triangles), 4 * 64)

    def test_decks_and_pages(self):
        deck = gasjet.export(case("sphere_inflation"), "lsdyna", "kg-m-s", "deck")
        self.assertIn({"key": "scene.end_time", "value": "0.06", "mapping": "exact", "how": "as in the case"}, deck.data["keys"])
        back = gasjet.import_deck("deck/bag.k", "back")
        self.assertIn("*NODE", [card["card"] for card in back.data["cards"]])
        self.assertEqual(len(gasjet.mesh("case", "back/bag.toml").triangles), len(gasjet.mesh("case", case("sphere_inflation")).triangles))
        run = gasjet.run(case("jet_bag"), SHORT, out="run")
        self.assertEqual(gasjet.report([run, "run"], "page.html"), "page.html")
        self.assertIn("jet_bag", pathlib.Path("page.html").read_text())


class Faults(Here):
    def test_bad_input_is_named(self):
        bag, tank = case("jet_bag"), case("tank_steps")
        readings = os.path.join(CASES, "tank_test_readings.csv")
        calls = [("no_such.toml", lambda: gasjet.check("no_such.toml")), ("set: scene.end_tim=3", lambda: gasjet.check(bag, {"scene.end_tim": 3})),
                 ("scene.end_time: is missing", lambda: gasjet.check(bag, {"scene.end_time": None})),
                 ("^case.toml:1", lambda: gasjet.check({"scene": {"name": "x"}})), ("^mine.toml:", lambda: gasjet.check("mine.toml", text="x")),
                 ("^case: ", lambda: gasjet.check(3)), ("^plan: ", lambda: gasjet.study(3)), ("no_such.toml", lambda: gasjet.study({"study": {"case": "no_such.toml"}})),
                 ("^runs: ", lambda: gasjet.ensemble(bag, runs=1)), ("^runs: ", lambda: gasjet.ensemble(bag, runs="x")),
                 ("^amplitude: ", lambda: gasjet.ensemble(bag, amplitude=object())), ("^against: ", lambda: gasjet.ensemble(bag, against="")),
                 ("quantity", lambda: gasjet.ladder(tank, "x")), ("^hold: ", lambda: gasjet.ladder(tank, "pressure_Pa", hold="x")),
                 ("^readings:1:1: tank_pressure_Pa", lambda: gasjet.identify({"time_s": [0, 1, 2]}, "dual", 0.06, 0.08, "N2")),
                 ("^points = 3", lambda: gasjet.identify(readings, "dual", 0.06, 0.08, "N2", points=3)),
                 ("no_such=3", lambda: gasjet.identify(readings, "dual", 0.06, 0.08, "N2", no_such=3)),
                 ("^kind: ", lambda: gasjet.mesh("x")), ("^source: ", lambda: gasjet.mesh("driver", "x")), ("^source: ", lambda: gasjet.mesh("case")),
                 ("no_such.obj", lambda: gasjet.mesh("convert", "no_such.obj")), ("^set: a=3", lambda: gasjet.mesh("driver", set={"a": 3})),
                 ("^set: ", lambda: gasjet.mesh("driver", set={"rings": None})), ("^set: ", lambda: gasjet.mesh("convert", "x.obj", set={"a": 1})),
                 ("membrane", lambda: gasjet.export(tank, "lsdyna", "kg-m-s", "out")), ("format", lambda: gasjet.export(bag, "x", "kg-m-s", "out")),
                 ("no_such.k", lambda: gasjet.import_deck("no_such.k", "out")), ("no_such", lambda: gasjet.report("no_such", "page.html")),
                 ("^results: ", lambda: gasjet.report(gasjet.run(tank), "page.html")), ("^results: ", lambda: gasjet.report(3, "page.html")),
                 ("^out: ", lambda: gasjet.export(bag, "lsdyna", "kg-m-s", "a\0b"))]
        for words, call in calls:
            with self.subTest(words), self.assertRaisesRegex((gasjet.InputError, TypeError), words):
                call()
        self.assertEqual(os.listdir("."), [])

    def test_runs_that_fail_leave_what_there_is(self):
        wild = {"scene.end_time": 0.02, "time.step": 1e-3, "time.unsafe_step": True}
        with self.assertRaisesRegex(gasjet.DomainError, "stage S10_gas") as caught:
            gasjet.ensemble(case("jet_bag"), wild, runs=2)
        self.assertEqual(len(caught.exception.run.parts["jet_bag"].data["failures"]), 2)

    def test_a_dict_is_run_twice_at_the_same_time(self):
        plan = {"study": {"case": case("sphere_inflation")}}
        with program.case_words(plan, None) as (first, _):
            with program.case_words(plan, None) as (second, _):
                content = pathlib.Path(first[0]).read_text()
            self.assertEqual((second, pathlib.Path(first[0]).read_text()), (first, content))
            self.assertIn("sphere_inflation", content)
        self.assertEqual(os.listdir("."), [])

    def test_interrupt_ends_the_command_and_keeps_its_runs(self):
        script = f"import gasjet\ngasjet.ensemble({case('sphere_inflation')!r}, runs=100000, out='out')\n"
        heed = functools.partial(signal.signal, signal.SIGINT, signal.SIG_DFL)  # a shell's background jobs ignore it
        with subprocess.Popen([sys.executable, "-c", script], stderr=subprocess.PIPE, text=True, preexec_fn=heed) as process:
            journal = pathlib.Path("out/sphere_inflation/journal.jsonl")
            ends = time.monotonic() + 60
            while time.monotonic() < ends and not (journal.exists() and journal.read_text().count("\n") > 4):
                time.sleep(0.02)
            process.send_signal(signal.SIGINT)
            self.assertIn("KeyboardInterrupt", process.communicate()[1])
        made = gasjet.load("out")  # that is refused while the command runs
        self.assertEqual(made.parts["sphere_inflation"].status, "interrupted")
        self.assertGreater(len(made.parts["sphere_inflation"].data["quantities"]["peak_volume_m3"]["values"]), 1)


class Program(Here):
    def stand_in(self, lines, version=gasjet.__version__):
        """A program of that name, which alone is there."""
        file = pathlib.Path("program").absolute()
        file.write_text(f'#!/bin/sh\nif [ "$1" = --version ]; then echo "gasjet {version} (x)"; exit; fi\n{lines}\n')
        file.chmod(file.stat().st_mode | stat.S_IXUSR)
        program._of_this_version.cache_clear()
        self.addCleanup(program._of_this_version.cache_clear)
        return mock.patch.multiple(program, _beside=lambda: ()), mock.patch.dict(os.environ, {"GASJET": str(file), "PATH": ""})

    def fault(self, kind, words, environment, lines="exit 0", version=gasjet.__version__):
        beside, there = self.stand_in(lines, version)
        with beside, there, mock.patch.dict(os.environ, environment), self.assertRaisesRegex(kind, words):
            gasjet.check("x.toml")

    def test_a_program_that_is_missing_or_another_is_named(self):
        self.fault(gasjet.InputError, "the program is not found.*environment variable GASJET", {"GASJET": ""})
        self.fault(gasjet.InputError, "GASJET: /no/such is no program", {"GASJET": "/no/such"})
        self.fault(gasjet.InputError, f"GASJET: {os.getcwd()}/build/gasjet is no program", {"GASJET": os.getcwd()})
        self.fault(gasjet.InputError, "is of version 9.9.9, allowed: " + gasjet.__version__, {}, version="9.9.9")

    def test_it_is_found_on_path(self):
        beside, there = self.stand_in('echo "{\\"a\\": 1}"')
        os.rename("program", "gasjet")
        with beside, there, mock.patch.dict(os.environ, {"GASJET": "", "PATH": os.getcwd()}):
            self.assertEqual(gasjet.check("x.toml"), {"a": 1})

    def test_exit_codes_are_exceptions(self):
        for code, kind in ((1, gasjet.Error), (2, gasjet.InputError), (3, gasjet.DomainError), (130, gasjet.StoppedError), (4, gasjet.Error)):
            with self.subTest(code=code):
                self.fault(kind, "^runs: wrong$", {}, f'echo "warning: w" >&2; echo "gasjet: --runs: wrong" >&2; exit {code}')
        self.fault(gasjet.Error, "gasjet check ended with exit code -9", {}, "kill -9 $$")


if __name__ == "__main__":
    unittest.main()
