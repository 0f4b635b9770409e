# SPDX-License-Identifier: Apache-2.0
"""Results as Python objects: folders, frames, tables, meshio, pandas, notebooks; and gases at arrays of temperatures."""
import json
import os
import pathlib
import pickle
import re
import sys
import tempfile
import types
import unittest
import warnings
import xml.etree.ElementTree
from unittest import mock

import numpy as np

import gasjet
from gasjet import display, frames, tables

try:
    import meshio
except ImportError:
    meshio = None

CASES = os.path.join(os.environ["GASJET_SOURCE_DIR"], "cases")
BAG, TANK = (os.path.join(CASES, name) for name in ("jet_bag.toml", "tank_blowdown.toml"))


class Loaded(unittest.TestCase):
    """A bag's run of 3 ms, in which a jet reaches the skin."""

    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.folder = os.path.join(cls.scratch.name, "run")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", gasjet.GasjetWarning)  # the second inflator is later
            cls.made = gasjet.run(BAG, {"scene.end_time": 0.003, "output.frames": 6}, out=cls.folder)

    def test_a_folder_has_the_bits_of_its_run(self):
        loaded = gasjet.load(self.folder)
        for mine, its in ((loaded.history, self.made.history), (loaded.energy, self.made.energy)):
            self.assertEqual(list(mine), list(its))
            for name in mine:
                np.testing.assert_array_equal(mine[name], its[name])
        self.assertEqual((loaded.summary, loaded.folder, repr(loaded)), (self.made.summary, self.folder, repr(self.made)))
        self.assertEqual(loaded.history.about["run"], self.made.summary["run"])
        again = pickle.loads(pickle.dumps(self.made))
        np.testing.assert_array_equal(again.history["pressure_Pa"], self.made.history["pressure_Pa"])
        np.testing.assert_array_equal(again.frames[-1].nodes, self.made.frames[-1].nodes)
        self.assertEqual(gasjet.compare(loaded, self.made)["verdict"], gasjet.compare(self.made, self.made)["verdict"])

    def test_frames_are_levels_of_the_simulation(self):
        bag = gasjet.Simulation(BAG, {"scene.end_time": 0.003})
        shown = self.made.frames
        self.assertEqual((len(shown), shown[0].time, shown[-1].time), (7, 0.0, 0.003))
        np.testing.assert_array_equal(shown.times, [frame.time for frame in shown])
        for frame in shown:
            while bag.time < frame.time:
                bag.step()
            self.assertEqual(bag.time, frame.time)
            step = frame.values["position_step_m"]
            self.assertLess(step, 0.5 / 65535)  # the bag is 0.4 m wide
            np.testing.assert_allclose(frame.nodes, bag.position, rtol=0.0, atol=0.5000001 * step)  # half a step of the file
            jets = bag.overpressure(0) + bag.overpressure(1)
            np.testing.assert_allclose(frame.jet_overpressure, jets, rtol=0.0, atol=0.5000001 * frame.values["jet_step_Pa"])
            np.testing.assert_allclose(frame.overpressure - frame.jet_overpressure, bag.pressure - 101325.0, rtol=0.0, atol=1e-8)
            self.assertFalse((frame.lit & frame.hidden).any())
            self.assertTrue((frame.jet_overpressure[~frame.lit] == 0.0).all())
            np.testing.assert_array_equal(frame.lit & (jets > 0.0), jets > 0.0)
            np.testing.assert_array_equal(frame.triangles, bag.triangles)
            self.assertEqual(set(frame.panels), {"sphere"})
        self.assertGreater(shown[-1].lit.sum(), 10)
        self.assertGreater(shown[-1].strain.max(), 1e-4)
        self.assertGreater(shown[-1].speed.max(), 1.0)
        self.assertEqual([frame.time for frame in shown[-2:]], shown.times[-2:].tolist())
        for number in (7, -8):
            with self.assertRaisesRegex(IndexError, f"no number {number}, allowed: -7 to 6"):
                shown[number]

    def test_masks_count_what_the_history_counts(self):
        """In a folded bag layers hide others from the jet; a rigid target has no panels."""
        with tempfile.TemporaryDirectory() as scratch, warnings.catch_warnings():
            warnings.simplefilter("ignore", gasjet.GasjetWarning)
            bag = gasjet.run(os.path.join(CASES, "passenger_letter.toml"), {"scene.end_time": 5e-5, "output.frames": 1}, out=os.path.join(scratch, "bag"))
            last, rows = bag.frames[-1], bag.history
            self.assertEqual((last.hidden.sum(), last.lit.sum()), (rows["jet_hidden_elements"][-1], rows["jet_lit_elements"][-1]))
            self.assertGreater(last.hidden.sum(), 0)
            self.assertEqual(last.panels.count("vent"), (gasjet.mesh("case", os.path.join(CASES, "passenger_letter.toml")).panel == 4).sum())
            plate = gasjet.run(os.path.join(CASES, "plate_jet.toml"), {"scene.end_time": 1e-3, "output.frames": 1}, out=os.path.join(scratch, "plate"))
            self.assertEqual((plate.frames[-1].panels, len(plate.frames[-1].triangles)), ([], 1800))
            self.assertGreater(plate.frames[-1].jet_overpressure.max(), 0.0)

    def test_a_simulation_with_a_folder_gives_frames(self):
        with tempfile.TemporaryDirectory() as folder:
            bag = gasjet.Simulation(BAG, {"scene.end_time": 0.0005, "output.frames": 2}, out=os.path.join(folder, "run"))
            bag.step(10**6)
            bag.finish()
            np.testing.assert_allclose(bag.results.frames[-1].nodes, bag.position, atol=1e-5)

    @unittest.skipUnless(meshio, "meshio is not installed (package python3-meshio)")
    def test_meshio_reads_what_it_writes(self):
        last = self.made.frames[-1]
        file = os.path.join(self.scratch.name, "bag.vtu")
        self.made.to_meshio().write(file)
        mesh = meshio.read(file)
        np.testing.assert_array_equal(mesh.points, last.nodes)
        np.testing.assert_array_equal(mesh.cells_dict["triangle"], last.triangles)
        for name, values in (("overpressure_Pa", last.overpressure), ("principal_strain", last.strain), ("jet_mask", last.hidden + 2 * last.lit)):
            np.testing.assert_array_equal(mesh.cell_data[name][0], values)
        np.testing.assert_array_equal(mesh.point_data["speed_m_s"], last.speed)

    def test_pandas_gets_the_columns_by_time(self):
        class DataFrame(dict):  # as of pandas
            columns = property(lambda self: list(self))

            def set_index(self, name):
                self.index = self.pop(name)
                return self

        with mock.patch.dict(sys.modules, {"pandas": types.SimpleNamespace(DataFrame=DataFrame)}):
            for table, frame in ((self.made.history, self.made.to_pandas()), (self.made.energy, self.made.to_pandas(energy=True))):
                self.assertEqual(["time_s", *frame], list(table))
                np.testing.assert_array_equal(frame.index, table["time_s"])
        with mock.patch.dict(sys.modules, {"pandas": None}), self.assertRaisesRegex(ImportError, "python3-pandas"):
            self.made.to_pandas()
        with mock.patch.dict(sys.modules, {"meshio": None}), self.assertRaisesRegex(ImportError, "python3-meshio"):
            self.made.to_meshio()

    def test_a_notebook_shows_table_charts_and_bag(self):
        page = xml.etree.ElementTree.fromstring(re.sub(' xmlns="[^"]*"', "", self.made._repr_html_()))
        titles = [picture.find("text").text for picture in page.iter("svg")]
        self.assertEqual(titles[:2], ["pressure_Pa", "jet_force_N"])
        self.assertRegex(titles[2], r"^the surface at 0.003 s, ..: 0.4\d* m by 0.4")
        cells = [[cell.text for cell in row] for row in page.iter("tr")]
        self.assertIn(["status", "done"], cells)
        self.assertIn(["steps", str(self.made.summary["steps"])], cells)
        self.assertLess(len(self.made._repr_html_()), 20000)
        tank = gasjet.run(TANK, {"scene.name": "<b> & more"})
        page = xml.etree.ElementTree.fromstring(re.sub(' xmlns="[^"]*"', "", tank._repr_html_()))
        self.assertEqual(len(list(page.iter("svg"))), 2)  # it has no skin
        self.assertEqual(page.find("table/caption").text, "gasjet: <b> & more")
        curve = np.array([point.split(",") for point in next(page.iter("polyline")).get("points").split()], float)
        self.assertEqual((len(curve), curve[0, 1], curve[-1, 1]), (200, 24.0, 150.0))  # it falls from the highest to the lowest

    def test_damage_is_named(self):
        place = pathlib.Path(self.scratch.name, "damaged")
        whole = {file.name: file.read_bytes() for file in pathlib.Path(self.folder).iterdir()}
        first, rest = whole["frames.bin"].split(b"\n", 1)
        header = json.loads(first)

        def headed(**changes):
            return json.dumps({**header, **changes}).encode() + b"\n" + rest

        status, history = whole["gasjet.status"], whole["history.csv"]
        faults = [("gasjet.status", None, "no readable gasjet.status"), ("gasjet.status", b"# of mine\nstatus: done\n", "not a status file"),
                  ("gasjet.status", status.replace(b"status: done\n", b""), "its run has not ended"),
                  ("gasjet.status", status[:-1], "its run has not ended"),
                  ("history.csv", None, "history.csv: No such file"), ("summary.json", b"{", "summary.json: is no whole JSON file"),
                  ("history.csv", history[:-1] + b",1\n", r"history.csv:\d+: has \d+ cells, allowed: \d+"), ("energy.csv", b"# a\n", "energy.csv: has no names"),
                  ("history.csv", history.replace(b"# run: ", b"# run: 0"), "history.csv: is of run 0"), ("history.csv", b"\xff\n", "CSV file in UTF-8"),
                  ("frames.bin", None, "frames.bin: No such file"), ("frames.bin", whole["frames.bin"][:-1], "whole frames of"),
                  ("frames.bin", first + b"\n", "has 0 bytes of frames"), ("frames.bin", b"\x00\xff", "its header is damaged"),
                  ("frames.bin", b"[]\n", "its header is damaged"), ("frames.bin", headed(format=2), "does not begin as"),
                  ("frames.bin", headed(run="0"), "is of run 0, allowed"), ("frames.bin", headed(nodes=641), "its header is damaged"),
                  ("frames.bin", headed(frame_bytes=8), "its header is damaged"), ("frames.bin", headed(elements=-1), "its header is damaged")]
        place.mkdir()
        for name, content, words in faults:
            with self.subTest(name=name, words=words):
                for file, all_of_it in whole.items():
                    (place / file).write_bytes(all_of_it)
                (place / name).unlink() if content is None else (place / name).write_bytes(content)
                with self.assertRaisesRegex(gasjet.InputError, words):
                    gasjet.load(place).frames
        for given, words in ((3, "^folder: "), (None, "^folder: ")):
            with self.assertRaisesRegex(TypeError, words):
                gasjet.load(given)
        with self.assertRaisesRegex(gasjet.InputError, "^frames: the run has no folder"):
            gasjet.run(TANK).frames


class Pieces(unittest.TestCase):
    def test_the_outline_of_a_cube_is_a_square(self):
        corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
        faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        triangles = np.array([t for a, b, c, d in faces for t in ((a, b, c), (a, c, d))])
        edges = display.silhouette(corners[:, :2], triangles)  # from above
        self.assertEqual({tuple(edge) for edge in edges.tolist()}, {(1, 3), (1, 5), (3, 7), (5, 7)})
        self.assertEqual(len(display.silhouette(corners[:, :2], triangles[:0])), 0)

    def test_tables_have_numbers_gaps_and_texts(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "a.csv")
            file.write_text('# made by: hand\n# no key\nx,y,z\n1e-3,,"a, b"\n2,3,\n')
            table = tables.read_table(file)
        np.testing.assert_array_equal(table["x"], [1e-3, 2.0])
        np.testing.assert_array_equal(table["y"], [np.nan, 3.0])
        self.assertEqual((table["z"].tolist(), table.about), (["a, b", ""], {"made by": "hand"}))
        self.assertEqual(repr(table), "<gasjet.Table 2 rows: x, y, z>")

    def test_frames_of_no_file(self):
        with self.assertRaisesRegex(gasjet.InputError, "^no_such: No such file"):
            frames.read_frames("no_such")


class Gases(unittest.TestCase):
    def test_colons_separate_as_equal_signs_do(self):
        one, two = gasjet.Gas("N2:0.78, O2:0.22"), gasjet.Gas("N2=0.78, O2=0.22")
        self.assertEqual((one.properties(400.0), repr(one)), (two.properties(400.0), repr(two)))
        with self.assertRaisesRegex(gasjet.InputError, "composition"):
            gasjet.Gas("N2:0.78; O2:0.22")
        for gas in (gasjet.Gas("N2:1", constant_cp_at=300.0), gasjet.Gas.ideal(296.8, 1038.8)):
            again = pickle.loads(pickle.dumps(gas))
            self.assertEqual((again.properties(900.0), repr(again)), (gas.properties(900.0), repr(gas)))

    def test_arrays_have_the_bits_of_single_numbers(self):
        gas = gasjet.Gas("N2:0.7, H2O:0.3")
        hot = np.linspace(300.0, 3000.0, 6).reshape(2, 3)
        many = gas.properties(hot)
        for place, kelvin in np.ndenumerate(hot):
            self.assertEqual({name: values[place] for name, values in many.items()}, gas.properties(kelvin))
            self.assertEqual(gas.entropy(hot, [[1e5], [2e5]])[place], gas.entropy(kelvin, (1e5, 2e5)[place[0]]))
        np.testing.assert_allclose(gas.temperature(many["internal_energy_J_kg"]), hot, rtol=1e-12)
        self.assertEqual(gas.properties([])["gamma"].shape, (0,))
        self.assertIsInstance(gas.temperature(1e5), float)
        for words, kind, call in ((r"^temperature = 1 K.*at \[1\]", gasjet.DomainError, lambda: gas.properties([300.0, 1.0])),
                                  (r"^temperature.*at \[0, 2\]", gasjet.DomainError, lambda: gas.entropy([[300.0, 400.0, 9e9]], 1e5)),
                                  (r"^temperature, pressure: have the shapes \(2,\) and \(3,\)", TypeError, lambda: gas.entropy([300.0] * 2, [1e5] * 3)),
                                  ("temperature", TypeError, lambda: gas.properties(["x"])), ("temperature", TypeError, lambda: gas.properties("x")),
                                  ("pressure", gasjet.InputError, lambda: gas.entropy(300.0, [None]))):
            with self.assertRaisesRegex(kind, words):
                call()


if __name__ == "__main__":
    unittest.main()
