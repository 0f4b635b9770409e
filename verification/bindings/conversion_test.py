# SPDX-License-Identifier: Apache-2.0
"""What the Python package takes beside its own kinds of arrays, and what it says of a mesh."""
import types
import unittest

import numpy as np

import gasjet
from coupling_test import pendulum

# A box of 4 x 2 x 6 around the origin, outward; its coordinates are exact in every type of numbers.
CORNERS = np.array([[x, y, z] for x in (-2, 2) for y in (-1, 1) for z in (-3, 3)])
BOX = np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]])
FABRIC = dict(thickness=4e-4, density=800.0, young_modulus=3e8, poisson=0.3)
ROUND = dict(centre=(0.0, 0.0, 0.0), axis=(1.0, 0.0, 0.0), decay_coefficient=0.08)


class Conversions(unittest.TestCase):
    def test_nodes_of_other_numbers_are_those_of_float64(self):
        nodes = CORNERS.astype(float)
        jet = gasjet.Jet(radius=0.3, **ROUND)
        lit = gasjet.visible(nodes, BOX)
        pressure, _ = jet.pressure(nodes, BOX, velocity=400.0, density=1.0)
        volume = gasjet.Membrane(nodes, BOX, **FABRIC).evaluate(nodes)["volume_m3"]
        self.assertEqual(volume, 48.0)
        for kind in ("f2", "f4", ">f4", ">f8", "i1", ">i2", "i4", "i8"):
            other = np.asfortranarray(CORNERS.astype(kind))
            np.testing.assert_array_equal(gasjet.visible(other, BOX.astype(">i8")), lit)
            np.testing.assert_array_equal(jet.pressure(other, BOX, velocity=400.0, density=1.0)[0], pressure)
            self.assertEqual(gasjet.Membrane(other, BOX, **FABRIC).evaluate(other)["volume_m3"], volume)
        mesh = types.SimpleNamespace(points=CORNERS.astype("f4"), cells_dict={"triangle": BOX})  # as meshio has it
        np.testing.assert_array_equal(gasjet.visible(mesh), lit)

    def test_numbers_that_float64_does_not_hold_are_refused(self):
        for nodes in (CORNERS.astype("i8") + 2**53, CORNERS.astype(complex), CORNERS.astype(object), CORNERS.astype(bool)):
            with self.assertRaisesRegex(TypeError, "nodes: have .*, allowed: .*float64"):
                gasjet.visible(nodes, BOX)

    def test_no_times_give_no_rows(self):
        none = gasjet.exact("blowdown", times=[])
        self.assertEqual(set(none), set(gasjet.exact("blowdown")))
        self.assertEqual({len(values) for values in none.values()}, {0})
        self.assertGreater(len(gasjet.exact("blowdown")["time_s"]), 1)

    def test_compare_of_some_columns(self):
        mine = {"time_s": [0.0, 1.0, 2.0], "pressure_Pa": [1.0, 2.0, 3.0], "volume_m3": [1.0, 1.0, 2.0]}
        reference = dict(mine, volume_m3=[1.0, 1.0, 1.0])
        self.assertEqual(gasjet.compare(mine, reference, tolerance=0.01)["verdict"], "outside")
        judged = gasjet.compare(mine, reference, tolerance=0.01, columns=["pressure_Pa"])
        self.assertEqual(judged["verdict"], "inside")
        with self.assertRaisesRegex(gasjet.InputError, "presure_Pa"):
            gasjet.compare(mine, reference, columns=["presure_Pa"])

    def test_messages_name_what_python_names(self):
        with self.assertRaisesRegex(gasjet.InputError, "^step: is -0.001"):
            pendulum().advance(-1e-3)
        with self.assertRaisesRegex(gasjet.InputError, "blow_down.*is 'blowdown' meant"):
            gasjet.exact("blow_down")

    def test_sizes_of_a_jet_that_do_not_fit_are_refused(self):
        slot = dict(short_side=0.02, long_side=0.1, long_direction=(0.0, 1.0, 0.0))
        gasjet.Jet(**ROUND, **slot)
        for wrong, message in ((dict(slot, short_side=0.2), "short_side is 0.2.*long_side"), (dict(slot, radius=0.02), "radius: is given with short_side"),
                               ({}, "radius, or short_side and long_side"), (dict(slot, cone_half_angle=0.2), "cone_half_angle: .* cone_initial_width")):
            with self.assertRaisesRegex(gasjet.InputError, message):
                gasjet.Jet(**ROUND, **wrong)


class SurfaceCheck(unittest.TestCase):
    def test_a_closed_box_is_fine(self):
        found = gasjet.check_surface(CORNERS, BOX)
        self.assertEqual((found["ok"], found["findings"]), (True, []))

    def test_holes_and_wrong_winding_are_told(self):
        turned = BOX.copy()
        turned[3] = turned[3, ::-1]
        for triangles, fault, count in ((BOX[1:], "boundary_edges", 3), (turned, "inconsistent_edges", 3), (BOX[:, ::-1], "inward", True)):
            found = gasjet.check_surface(CORNERS, triangles)
            self.assertEqual((found["ok"], found[fault]), (False, count))
            self.assertGreater(len(found["findings"]), 0)


if __name__ == "__main__":
    unittest.main()
