# SPDX-License-Identifier: Apache-2.0
"""Pendulum, contacts, fabric law and expanded jet of the Python package against closed forms, and a mesh of meshio."""
import os
import unittest

import numpy as np

import gasjet

try:
    import meshio
except ImportError:
    meshio = None

PAPER = dict(mass=10.9, inertia_cg=2.07, cg_distance=1.065, impactor_distance=1.31, impactor_radius=0.041)


def pendulum(**change):
    return gasjet.Pendulum((0, 0, 0), (0, -1, 0), (0, 0, -1), gravity=(0, 0, -9.80665), **{**PAPER, **change})


def square(side, cells):
    """A flat skin at z = 0, its outer side up."""
    at = np.linspace(-side / 2, side / 2, cells + 1)
    x, y = np.meshgrid(at, at, indexing="ij")
    number = np.arange((cells + 1) ** 2).reshape(cells + 1, cells + 1)
    a, b, c, d = number[:-1, :-1], number[1:, :-1], number[1:, 1:], number[:-1, 1:]
    triangles = np.concatenate([np.stack([a, b, c], -1).reshape(-1, 3), np.stack([a, c, d], -1).reshape(-1, 3)])
    return np.column_stack([x.ravel(), y.ravel(), 0 * x.ravel()]), triangles


class Pendulums(unittest.TestCase):
    def test_swing_converges_to_the_elliptic_function(self):
        errors = []
        for steps in (250, 500, 1000):
            swing = pendulum(angle=np.pi / 3)
            for _ in range(steps):
                swing.advance(1.0 / steps)
            errors.append(abs(swing.angle - gasjet.exact("pendulum_swing", times=[1.0])["pendulum_angle_rad"][0]))
        for coarse, fine in zip(errors, errors[1:]):  # second order
            self.assertTrue(3.8 < coarse / fine < 4.2, errors)

    def test_moment_of_a_force_adds_to_gravity(self):
        # F L_i = m g L sin(angle): at rest under a horizontal force at the impactor of a pendulum that hangs at an angle.
        still = pendulum(angle=0.3)
        moment = still.moment((20.0, 0.0, 0.0), still.state["impactor_centre_m"])
        self.assertAlmostEqual(moment, 20.0 * 1.31 * np.cos(0.3), 12)
        still.advance(1e-3, moment=-still.state["gravity_moment_Nm"])
        self.assertEqual(still.angle, 0.3)
        self.assertAlmostEqual(still.state["effective_mass_kg"], (2.07 + 10.9 * 1.065**2) / 1.31**2, 12)

    def test_refusals_name_the_argument(self):
        for name, change in (("mass", dict(mass=0.0)), ("impactor_radius", dict(impactor_radius=2.0)), ("angle", dict(angle=np.nan))):
            with self.assertRaisesRegex(gasjet.InputError, name):
                pendulum(**change)
        with self.assertRaisesRegex(gasjet.InputError, "^step"):
            pendulum().advance(0.0)
        with self.assertRaisesRegex(gasjet.InputError, "moment"):
            pendulum().advance(1e-3, moment=np.nan)
        with self.assertRaises(TypeError):
            gasjet.Pendulum((0, 0), (0, -1, 0), (0, 0, -1), **PAPER)


class Contacts(unittest.TestCase):
    def setUp(self):
        self.nodes, self.triangles = square(0.4, 40)
        self.masses = np.full(len(self.nodes), 1e-4)
        self.pad = gasjet.Contact(self.nodes, self.triangles, masses=self.masses, effective_mass=3.0, radius=0.1, stiffness=1e6)

    def test_force_on_a_flat_skin(self):
        # kappa times the integral of (r - d) cos over the disc where d < r, at height h: pi kappa h (r - h)^2.
        touch = self.pad.evaluate(self.nodes, (0.003, 0.004, 0.08))
        exact = np.pi * 1e6 * 0.08 * 0.02**2
        # The rim's elements are h = 10 mm long, and there the integrand has a kink of slope 0.48 kappa: the midpoints are off by at
        # most 0.48 kappa h/8 on the rim's area 2 pi 60 mm h, which is 2.3 % of the force.
        self.assertAlmostEqual(touch["force_N"][2] / exact, 1.0, delta=0.023)
        np.testing.assert_allclose(touch["node_force_N"].sum(0), -touch["force_N"], rtol=1e-12, atol=1e-9)
        self.assertTrue(0.019 < touch["penetration_m"] <= 0.02)
        free = self.pad.evaluate(self.nodes, (0.0, 0.0, 0.2))
        self.assertEqual((free["deepest_element"], free["energy_J"], abs(free["node_force_N"]).max()), (-1, 0.0, 0.0))

    def test_refusals_name_the_argument(self):
        with self.assertRaises(gasjet.DomainError):
            self.pad.evaluate(self.nodes, (0.0, 0.0, 0.04))
        with self.assertRaisesRegex(gasjet.InputError, "centre"):
            self.pad.evaluate(self.nodes, (0.0, np.nan, 0.2))
        with self.assertRaisesRegex(ValueError, "nodes"):
            self.pad.evaluate(self.nodes[1:], (0.0, 0.0, 0.2))
        with self.assertRaisesRegex(TypeError, "masses"):
            gasjet.Contact(self.nodes, self.triangles, masses=self.masses[1:], effective_mass=3.0, radius=0.1, stiffness=1e6)
        with self.assertRaisesRegex(gasjet.InputError, "stiffness"):
            gasjet.Contact(self.nodes, self.triangles, masses=self.masses, effective_mass=3.0, radius=0.1, stiffness=-1.0)

    def body(self, **dimensions):
        return gasjet.Contact(self.nodes, self.triangles, masses=self.masses, effective_mass=3.0, stiffness=1e6, **dimensions)

    def test_other_shapes(self):
        # A disc of 80 mm with a rim of 40 mm, 10 mm in the skin: pi kappa (R^2 d + 2 R h s + h d^2), s = r arsinh(w/h) - w (K.52).
        wide, rim, depth = 0.08, 0.04, 0.01
        height = rim - depth
        width = np.sqrt(rim**2 - height**2)
        strip = rim * np.arcsinh(width / height) - width
        flat = self.body(radius=wide, rim_radius=rim).evaluate(self.nodes, (0.003, 0.004, height))
        exact = np.pi * 1e6 * (wide**2 * depth + 2.0 * wide * height * strip + height * depth**2)
        self.assertAlmostEqual(flat["force_N"][2] / exact, 1.0, delta=0.01)
        # On edge, axes turned: 10 mm deep again, by a single point of its rim.
        edge = ((1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, -1.0, 0.0))
        upright = self.body(radius=wide, rim_radius=rim).evaluate(self.nodes, (0.003, 0.004, wide + height), axes=edge)
        self.assertTrue(0.008 < upright["penetration_m"] <= 0.01)
        self.assertLess(upright["area_m2"], 0.5 * flat["area_m2"])
        # A cylinder that tilts about y has a couple about y; a ball of equal half axes has none.
        tilt = ((0.8, 0.0, 0.6), (0.0, 1.0, 0.0), (-0.6, 0.0, 0.8))
        tilted = self.body(radius=0.05, half_length=0.06).evaluate(self.nodes, (0.0, 0.0, 0.048 + 0.04), axes=tilt)
        self.assertAlmostEqual(tilted["couple_Nm"][1] / tilted["force_N"][2], 0.036, delta=0.004)
        ball = self.body(half_axes=(0.1, 0.1, 0.1)).evaluate(self.nodes, (0.003, 0.004, 0.08), axes=tilt)
        sphere = self.pad.evaluate(self.nodes, (0.003, 0.004, 0.08))
        np.testing.assert_allclose(ball["node_force_N"], sphere["node_force_N"], rtol=1e-9, atol=1e-9)
        self.assertLess(abs(ball["couple_Nm"]).max(), 1e-9)
        self.assertIn("radius 0.05 m, half length 0.06 m", repr(self.body(radius=0.05, half_length=0.06)))

    def test_refused_shapes_name_the_dimension(self):
        for dimensions in ({}, dict(half_length=0.1), dict(radius=0.1, half_axes=(0.1, 0.1, 0.1)), dict(radius=(0.1, 0.1))):
            with self.assertRaisesRegex(TypeError, "^radius"):
                self.body(**dimensions)
        with self.assertRaisesRegex(TypeError, "^half_axes"):
            self.body(half_axes=(0.1, 0.1))
        for name, dimensions in (("radius", dict(radius=0.0)), ("half_axes", dict(half_axes=(0.1, 0.0, 0.1))),
                                 ("half_length", dict(radius=0.1, half_length=-1.0)), ("rim_radius", dict(radius=0.1, rim_radius=np.nan))):
            with self.assertRaisesRegex(gasjet.InputError, f"impactor.{name}"):
                self.body(**dimensions)
        disc = self.body(radius=0.1, rim_radius=0.1)
        with self.assertRaisesRegex(TypeError, "axes"):
            disc.evaluate(self.nodes, (0.0, 0.0, 0.3), axes=(1.0, 0.0, 0.0))
        with self.assertRaisesRegex(gasjet.InputError, "axes"):
            disc.evaluate(self.nodes, (0.0, 0.0, 0.3), axes=2.0 * np.eye(3))


class SkinContacts(unittest.TestCase):
    """Two plates, the upper one with other squares."""

    THICKNESS, STIFFNESS, AREA = 0.01, 1e7, 0.3**2

    def setUp(self):
        (lower, below), (upper, above) = square(0.3, 6), square(0.3, 5)
        self.upper = slice(len(lower), None)
        self.nodes = np.concatenate([lower, upper])
        self.triangles = np.concatenate([below, len(lower) + above])

    def layers(self, friction=0.0):
        self.nodes[self.upper, 2] = 3 * self.THICKNESS
        return gasjet.SkinContact(self.nodes, self.triangles, masses=np.full(len(self.nodes), 1e-3), thickness=self.THICKNESS,
                                  stiffness=self.STIFFNESS, friction=friction)

    def at(self, gap):
        """Positions with that gap, in thicknesses."""
        nodes = self.nodes.copy()
        nodes[self.upper, 2] = gap * self.THICKNESS
        return nodes

    def test_pressure_is_the_stiffness_times_the_depth(self):
        layers = self.layers()
        free = layers.evaluate(self.nodes)
        self.assertEqual((free["contacts"], free["gap_m"], free["first_nodes"], free["second_nodes"], abs(free["node_force_N"]).max()),
                         (0, np.inf, (), (), 0.0))
        touch = layers.evaluate(self.at(0.9))
        pressure = self.STIFFNESS * 0.1 * self.THICKNESS
        self.assertAlmostEqual(touch["node_force_N"][self.upper, 2].sum() / (pressure * self.AREA), 1.0, 12)
        self.assertAlmostEqual(touch["energy_J"] / (0.5 * pressure**2 / self.STIFFNESS * self.AREA), 1.0, 11)
        np.testing.assert_allclose(touch["node_force_N"].sum(0), 0.0, atol=1e-11)
        self.assertAlmostEqual(touch["gap_m"], 0.9 * self.THICKNESS, 15)
        self.assertEqual((len(touch["first_nodes"]), len(touch["second_nodes"])), (1, 3))
        self.assertAlmostEqual(touch["approach"], 2.1 / 0.8, 12)  # 2.1 thicknesses nearer; the reach of edges is 0.8 of one
        self.assertGreater(touch["contacts"], 0)

    def test_bound_is_met_by_the_default_stiffness(self):
        self.assertEqual(gasjet.SkinContact.default_stiffness(0.5, 4e8, 0.2), 0.5 * 4e8 * 0.2 / 4)

    def test_layers_that_start_close_start_at_rest_and_a_restart_is_such_a_start(self):
        layers = self.layers()
        layers.evaluate(self.nodes)
        pressed = layers.evaluate(self.at(0.6))
        self.assertEqual(pressed["limited_nodes"], 0)
        layers.restart()
        rest = layers.evaluate(self.at(0.6))
        self.assertEqual((rest["energy_J"], rest["limited_nodes"], abs(rest["node_force_N"]).max()), (0.0, len(self.nodes), 0.0))

    def test_layouts_give_the_same_bits(self):
        results = []
        for layout in (np.array, np.asfortranarray, lambda x: np.pad(x, ((0, 0), (0, 1)))[:, :3], lambda x: x[::-1].copy()[::-1]):
            layers = self.layers(friction=0.3)
            layers.evaluate(layout(self.nodes))
            pressed = self.at(0.7)
            pressed[self.upper] += (0.003, 0.002, 0.0)
            layers.evaluate(layout(self.at(0.75)))
            results.append(layers.evaluate(layout(pressed)))
        self.assertGreater(abs(results[0]["node_force_N"][:, 0]).max(), 1.0)  # friction
        for result in results[1:]:
            np.testing.assert_array_equal(result.pop("node_force_N"), results[0]["node_force_N"])
            self.assertEqual(result, {name: value for name, value in results[0].items() if name != "node_force_N"})

    def test_layers_that_meet_are_refused_until_a_restart(self):
        layers = self.layers()
        layers.evaluate(self.nodes)
        with self.assertRaisesRegex(gasjet.DomainError, "nodes?.*"):
            layers.evaluate(self.at(-3.0))
        with self.assertRaisesRegex(gasjet.InputError, "^skin_contact: failed at the last call"):
            layers.evaluate(self.nodes)
        layers.restart()
        self.assertEqual(layers.evaluate(self.at(-3.0))["contacts"], 0)

    def test_refusals_name_the_argument(self):
        with self.assertRaisesRegex(gasjet.InputError, "thickness = 0.2 m: must be at most"):
            gasjet.SkinContact(self.nodes, self.triangles, masses=np.ones(len(self.nodes)), thickness=0.2, stiffness=1.0)
        with self.assertRaisesRegex(ValueError, "nodes"):
            self.layers().evaluate(self.nodes[1:])


class Fabrics(unittest.TestCase):
    def test_energy_of_an_even_stretch_is_that_of_the_law(self):
        # Of an area: h E/(1 - nu) ((s^2 - 1)/2)^2, and h E/(1 - nu) (s^2 ln s - (s^2 - 1)/2) for logarithmic strain.
        nodes, triangles = square(1.0, 2)
        s, modulus = 1.2, 4e-4 * 3e8 / 0.7
        half = (s * s - 1.0) / 2.0
        for law, exact in (("saint_venant_kirchhoff", half * half), ("hencky", s * s * np.log(s) - half)):
            fabric = gasjet.Membrane(nodes, triangles, thickness=4e-4, density=800.0, young_modulus=3e8, poisson=0.3, law=law)
            self.assertAlmostEqual(fabric.evaluate(s * nodes)["strain_energy_J"] / (modulus * exact), 1.0, 12)
        for change, message in ((dict(law="steel"), "law"), (dict(law="hencky", wrinkles=False), "wrinkles")):
            with self.assertRaisesRegex(ValueError, message):
                gasjet.Membrane(nodes, triangles, thickness=4e-4, density=800.0, young_modulus=3e8, poisson=0.3, **change)


@unittest.skipUnless(meshio, "meshio is not installed (package python3-meshio)")
class Meshes(unittest.TestCase):
    def test_a_mesh_of_meshio_stands_for_nodes_and_triangles(self):
        mesh = meshio.read(os.path.join(os.environ["GASJET_SOURCE_DIR"], "cases", "reference", "sphere_vent.obj"))
        lit = gasjet.visible(mesh, centre=(0.0, 0.0, 0.0), axis=(1.0, 0.0, 0.0))
        self.assertEqual(len(lit), len(mesh.cells_dict["triangle"]))
        self.assertTrue(lit.all())  # a sphere seen from its centre
        bag = gasjet.Membrane(mesh, thickness=4e-4, density=800.0, young_modulus=3e8, poisson=0.3)
        self.assertGreater(bag.evaluate(mesh.points)["volume_m3"], 0.0)
        with self.assertRaisesRegex(TypeError, "mesh with triangles"):
            gasjet.visible(meshio.Mesh([[0.0, 0, 0], [1, 0, 0]], [("line", [[0, 1]])]))


class ExpandedJet(unittest.TestCase):
    def test_expanded_jet_on_a_plate(self):
        area, flow, gas = np.pi * 0.03**2, 4.0, dict(temperature=500.0, cp=1038.8, gas_constant=296.8)
        sonic = gasjet.outlet(area, flow, law="sonic_stagnation", **gas)
        nozzle = gasjet.outlet(area, flow, law="expanded", bag_pressure=101325.0, **gas)
        self.assertEqual(nozzle["pressure_Pa"], 101325.0)
        thrust = flow * sonic["velocity_m_s"] + (sonic["pressure_Pa"] - 101325.0) * area
        self.assertAlmostEqual(flow * nozzle["velocity_m_s"] / thrust, 1.0, 12)
        air = dict(velocity=nozzle["velocity_m_s"], density=nozzle["density_kg_m3"])
        ratio, reflected = flow / (air["density"] * air["velocity"] * area), sonic["velocity_m_s"] / air["velocity"]
        nodes, triangles = square(0.4, 40)
        blow = dict(centre=(0.0, 0.0, -0.3), axis=(0.0, 0.0, 1.0), decay_coefficient=0.08, cut_off=1e-12)
        jet, wider = gasjet.Jet(**blow, radius=0.03), gasjet.Jet(**blow, radius=0.03 * ratio**0.5, restitution=0.0)
        exact = wider.pressure(nodes, triangles, **air)[0]
        for e in (-0.5, 0.0, 0.3, 4.0):
            pressure = jet.pressure(nodes, triangles, **air, area_ratio=ratio, reflected=reflected, restitution=e)[0]
            np.testing.assert_allclose(pressure, (1.0 + e * reflected) * exact, rtol=1e-12)
            load = thrust + e * flow * sonic["velocity_m_s"]
            np.testing.assert_allclose(pressure.sum() * 0.4**2 / len(triangles), load, rtol=1e-3)  # beyond the plate's edge
        plain = gasjet.Jet(**blow, radius=0.03)
        for one, other in zip(jet.pressure(nodes, triangles, **air), plain.pressure(nodes, triangles, **air)):
            np.testing.assert_array_equal(one, other)  # nothing is kept from call to call


if __name__ == "__main__":
    unittest.main()
