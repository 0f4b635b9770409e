# SPDX-License-Identifier: Apache-2.0
"""Calls of the Python package with one wrong argument each: an exception that names it, and no crash.

The build with sanitizers runs them too, over its own libraries for C.
"""
import os
import re
import threading
import unittest

import numpy as np

import gasjet

NODES = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
TRIANGLES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], np.int32)
CENTRE, AXIS, NAN = (0.1, 0.1, 0.1), (1.0, 0.0, 0.0), float("nan")
CASE = os.path.join(os.environ["GASJET_SOURCE_DIR"], "cases", "tank_blowdown.toml")


def with_row(row):
    nodes = NODES.copy()
    nodes[2] = row
    return nodes


def between_numbers():
    packed = np.zeros(4, np.dtype([("byte", "u1"), ("x", "f8", 3)]))
    packed["x"] = NODES
    return packed["x"]


NUMBERS = [None, "1", [1.0, 2.0], 1j, NAN, float("inf"), object()]
ARRAYS = [None, "1", ["1"], [300.0, None], [300.0, NAN], [[300.0], [float("inf")]], [[1.0], [1.0, 2.0]], 1j, [1j], NAN, np.ma.masked_equal([300.0, 1.0], 1.0), object()]
VECTORS = [None, "abc", 1.0, (1.0, 0.0), (1.0, 0.0, 0.0, 0.0), (1.0, NAN, 0.0), (1.0, None, 0.0), (float("inf"), 0.0, 0.0)]
POINTS = [None, "nodes", 1.0, NODES.astype(np.longdouble), NODES.astype(np.int64) + 2**53, NODES.astype(bool), NODES.astype(complex), NODES.astype(object), NODES[:, :2],
          NODES.ravel(), NODES[None], NODES[:0], NODES.tolist()[:3] + [[0.0, 1.0]], with_row(NAN), with_row([0.0, 0.0, -np.inf]),
          between_numbers(), np.ma.masked_equal(NODES, 1.0), np.asfortranarray(with_row(NAN)), with_row(NAN)[:, ::-1]]
TRIANGLE_LISTS = ["triangles", 1, TRIANGLES.astype(float), TRIANGLES.astype(bool), TRIANGLES[:, :2], TRIANGLES.ravel(), TRIANGLES[:0],
                  TRIANGLES + 1, TRIANGLES - 1, TRIANGLES + 2**40, TRIANGLES.astype(np.uint64) + 2**63, np.asfortranarray(TRIANGLES) - 1,
                  TRIANGLES[::-1, ::-1] + 1, np.broadcast_to(np.array([0, 1, 9]), (4, 3)), np.ma.masked_equal(TRIANGLES, 1)]
INDICES = ["x", 0.5, [0.5], [4], [-1], [10**20], [[0, 1]], [True], [None]]
TEXTS = [None, 1, ["N2=1"], "N2\0=1", object()]
NAMED_AS = {"nodes": "nodes?|node_count", "points": "points", "reference": "reference|node_count", "triangles": "triangles|triangle_count",
            "springs": "springs?", "stops": "stops?|springs"}
FLAGS = [None, "yes", [1]]
COLUMNS = ["x", [1.0, None], [0.0, NAN], [0.0, 1j], [0.0], np.ma.masked_equal([0.0, 1.0], 1.0), {"a": 1}, [[0.0, 1.0]]]


class BadCalls(unittest.TestCase):
    calls = 0

    @classmethod
    def tearDownClass(cls):
        print(f"{cls.calls} bad calls")

    def refused(self, argument, call, value=None):
        with self.subTest(argument=argument, value=value):
            type(self).calls += 1
            with self.assertRaises((gasjet.Error, TypeError, ValueError)) as caught:
                call()
            what = re.split("allowed|must|needed", str(caught.exception), 1)
            self.assertEqual(len(what), 2, what)  # the rest says what is allowed
            self.assertRegex(what[0], rf"(\b|_)({NAMED_AS.get(argument, argument)})\b")

    def each(self, function, good, **bad):
        """Every bad value of every argument beside good ones of the others."""
        function(**good)
        for argument, values in bad.items():
            for value in values:
                self.refused(argument, lambda: function(**{**good, argument: value}), value)

    def test_the_library_is_that_of_the_build(self):
        gasjet.Gas("N2=1")
        with open("/proc/self/maps", encoding="utf-8") as file:
            self.assertIn(os.path.realpath(os.environ["GASJET_LIBRARY"]), file.read())

    def test_gas(self):
        air = gasjet.Gas("N2=0.78, O2=0.22")
        self.each(gasjet.Gas, dict(composition="N2=1", constant_cp_at=0.0), composition=TEXTS, constant_cp_at=NUMBERS)
        self.each(gasjet.Gas.ideal, dict(gas_constant=297.0, cp=1039.0), gas_constant=NUMBERS, cp=NUMBERS)
        self.each(air.properties, dict(temperature=300.0), temperature=ARRAYS)
        self.each(air.temperature, dict(internal_energy=3e5), internal_energy=ARRAYS)
        self.each(air.entropy, dict(temperature=300.0, pressure=1e5), temperature=ARRAYS, pressure=ARRAYS)
        hole = dict(effective_area=1.0, pressure=2e5, temperature=300.0, gas_constant=297.0, cp=1039.0, ambient_pressure=1e5)
        self.each(gasjet.orifice, hole, **{argument: NUMBERS for argument in hole})
        fabric = dict(leak_area=1.0, density=1.0, overpressure=1.0)
        self.each(gasjet.fabric_leak, fabric, **{argument: NUMBERS for argument in fabric})
        outlet = dict(area=1.0, mass_flow=1.0, temperature=300.0, cp=1039.0, gas_constant=297.0)
        self.each(gasjet.outlet, outlet, law=[None, 1, "sonic"], **{argument: NUMBERS for argument in outlet})
        self.each(gasjet.outlet, {**outlet, "law": "pressure_matched", "bag_pressure": 1e5}, bag_pressure=NUMBERS)
        self.each(gasjet.outlet, {**outlet, "law": "expanded", "bag_pressure": 1e3}, bag_pressure=NUMBERS + [0.0, -1.0])

    def test_tank(self):
        air = gasjet.Gas("N2=1")
        made = dict(gas=air, pressure=2e5, temperature=300.0, volume=0.1, ambient_pressure=1e5, tolerance=1e-8)
        self.each(gasjet.Tank, made, gas=[None, "N2=1", 1, NODES, gasjet.Surface(TRIANGLES, 4)], pressure=NUMBERS, temperature=NUMBERS,
                  volume=NUMBERS, ambient_pressure=NUMBERS, tolerance=NUMBERS)
        tank = gasjet.Tank(**made)
        inflow = dict(gas=air, time=[0.0, 1.0], mass_flow=[1.0, 1.0], temperature=[300.0, 300.0], start_time=0.0)
        self.each(tank.add_inflow, inflow, gas=[None, "N2=1", tank], time=COLUMNS, mass_flow=COLUMNS, temperature=COLUMNS,
                  start_time=NUMBERS)
        self.each(tank.add_vent, dict(area=1e-3, discharge_coefficient=1.0, opens_at=0.0), area=NUMBERS, discharge_coefficient=NUMBERS,
                  opens_at=NUMBERS)
        self.each(tank.add_fabric, dict(leak_area=1e-6), leak_area=NUMBERS)
        vents = [None, -1, 2**40, 1.5, "0"]
        self.each(tank.add_backflow, dict(vent=0, gas=air, temperature=300.0), vent=vents, gas=[None, "N2=1", tank], temperature=NUMBERS)
        self.each(tank.set_vent, dict(vent=0, area=1e-3), vent=vents, area=NUMBERS)
        self.each(tank.set_heat_loss, dict(conductance=1.0, outside_temperature=300.0), conductance=NUMBERS, outside_temperature=NUMBERS)
        before = tank.state
        for argument, value in [("time", bad) for bad in NUMBERS] + [("volume", bad) for bad in NUMBERS[1:]]:
            self.refused(argument, lambda: tank.advance(**{"time": 0.1, "volume": 0.1, argument: value}), value)
        self.assertEqual(tank.state, before)

    def test_surface_and_jet(self):
        surface = gasjet.Surface(TRIANGLES, 4)
        made = dict(triangles=TRIANGLES, node_count=4, null_elements=[0], attachment_elements=[1])
        self.each(gasjet.Surface, made, triangles=[None, *TRIANGLE_LISTS], node_count=[None, 0, -1, 4.5, 2**70, "4"], null_elements=INDICES,
                  attachment_elements=INDICES)
        asked = dict(nodes=NODES, centre=CENTRE, axis=AXIS, long_direction=(0.0, 1.0, 0.0), half_long=0.01, candidates=[0],
                     displacement_bound=0.0)
        self.each(surface.visible, asked, nodes=POINTS, centre=VECTORS, axis=VECTORS, long_direction=VECTORS, half_long=NUMBERS,
                  candidates=INDICES, displacement_bound=[value for value in NUMBERS if value is not NAN])
        self.assertEqual(len(surface.visible(NODES, CENTRE, AXIS, candidates=[])), 0)
        self.each(gasjet.visible, dict(nodes=NODES, triangles=TRIANGLES, centre=CENTRE, axis=AXIS), nodes=POINTS, triangles=TRIANGLE_LISTS)
        model = dict(centre=CENTRE, axis=AXIS, decay_coefficient=0.08, radius=0.03, restitution=1.0, cut_off=1e-3, radial=False)
        self.each(gasjet.Jet, model, centre=VECTORS, axis=VECTORS, decay_coefficient=NUMBERS, restitution=NUMBERS, cut_off=NUMBERS,
                  radial=FLAGS, radius=NUMBERS, cone_half_angle=[0.1], short_side=[0.1], long_side=[0.1])
        jet = gasjet.Jet(**model)
        self.each(jet.velocity, dict(points=NODES), points=[value for value in POINTS if getattr(value, "size", 1) > 0])
        self.each(jet.pressure, dict(nodes=NODES, triangles=TRIANGLES, velocity=1.0, density=1.0, occlusion=True), nodes=POINTS,
                  triangles=TRIANGLE_LISTS, velocity=NUMBERS, density=NUMBERS, occlusion=FLAGS, null_elements=INDICES[:-1])
        self.each(jet.pressure, dict(nodes=NODES, triangles=TRIANGLES, velocity=1.0, density=1.0, area_ratio=1.2, reflected=0.8, restitution=0.3),
                  area_ratio=NUMBERS + [0.0, -1.0], reflected=NUMBERS + [0.0, -1.0, 1.001], restitution=NUMBERS[1:] + [-0.51, 4.01])

    def test_membrane_contact_and_pendulum(self):
        fabric = dict(reference=NODES, triangles=TRIANGLES, thickness=4e-4, density=800.0, young_modulus=3e8, poisson=0.3)
        self.each(gasjet.Membrane, fabric, reference=POINTS[3:], triangles=TRIANGLE_LISTS, thickness=NUMBERS, density=NUMBERS,
                  young_modulus=NUMBERS, poisson=NUMBERS, law=[None, 0, "steel"], wrinkles=FLAGS, fixed_nodes=INDICES)
        bag = gasjet.Membrane(**fabric)
        self.each(bag.evaluate, dict(nodes=NODES, gamma=1.4, pressure=1e5), nodes=POINTS, gamma=NUMBERS, pressure=NUMBERS)
        masses = [None, "x", [1.0], np.ones((4, 1)), [1.0, 1.0, 1.0, NAN], [1.0, 1.0, 1.0, -1.0]]
        skin = dict(reference=NODES, triangles=TRIANGLES, masses=np.ones(4), effective_mass=1.0, radius=0.1, stiffness=1e5, friction=0.1)
        self.each(gasjet.Contact, skin, triangles=TRIANGLE_LISTS, masses=masses,
                  effective_mass=NUMBERS, radius=NUMBERS, stiffness=NUMBERS, friction=NUMBERS)
        pad = gasjet.Contact(**skin)
        self.each(pad.evaluate, dict(nodes=NODES, centre=(0.0, 0.0, -5.0), turn=(0.0, 0.0, 0.0)), nodes=POINTS, centre=VECTORS, turn=VECTORS)
        plain = {name: value for name, value in skin.items() if name != "radius"}
        disc, bar = dict(plain, radius=0.1, rim_radius=0.1), dict(plain, radius=0.1, half_length=0.1)
        self.each(gasjet.Contact, disc, radius=NUMBERS[1:] + [-0.1], rim_radius=NUMBERS[1:] + [0.0])
        self.each(gasjet.Contact, bar, radius=NUMBERS[1:] + [0.0], half_length=NUMBERS[1:] + [-0.1])
        self.each(gasjet.Contact, dict(plain, half_axes=(0.1, 0.1, 0.1)), half_axes=VECTORS[1:] + [(0.1, 0.0, 0.1)])
        spoilt = np.eye(3)
        spoilt[2, 1] = NAN
        self.each(gasjet.Contact(**disc).evaluate, dict(nodes=NODES, centre=(0.0, 0.0, -5.0), axes=np.eye(3)),
                  axes=[None, "abc", 1.0, NODES, np.eye(2), np.eye(3) > 0.0, spoilt, 2.0 * np.eye(3), -np.eye(3)])
        layers = dict(reference=NODES, triangles=TRIANGLES, masses=np.ones(4), thickness=0.1, stiffness=1e5, friction=0.1)
        self.each(gasjet.SkinContact, layers, reference=[value for value in POINTS[3:] if getattr(value, "size", 1) > 0], triangles=TRIANGLE_LISTS,
                  masses=masses, thickness=NUMBERS + [0.0, -0.1, 0.8], stiffness=NUMBERS + [0.0, -1.0], friction=NUMBERS + [-0.1])
        self.each(gasjet.SkinContact(**layers).evaluate, dict(nodes=NODES), nodes=POINTS)
        share = dict(share=0.5, other_frequency=1e8, surface_density=0.3)
        self.each(gasjet.SkinContact.default_stiffness, share, **{argument: NUMBERS + [0.0, -1.0] for argument in share})
        rod = dict(pivot=CENTRE, axis=AXIS, rest_direction=(0.0, 0.0, -1.0), mass=1.0, inertia_cg=1.0, cg_distance=1.0,
                   impactor_distance=1.0, impactor_radius=0.1, gravity=(0.0, 0.0, -9.8), angle=0.1, angular_velocity=0.1)
        self.each(gasjet.Pendulum, rod, **{name: VECTORS if np.ndim(value) else NUMBERS for name, value in rod.items()})
        swing = gasjet.Pendulum(**rod)
        self.each(swing.moment, dict(force=AXIS, point=CENTRE), force=VECTORS, point=VECTORS)

    def test_rigid_bodies_and_head_injury(self):
        springs = [None, 1.0, "x", [1.0, 2.0, 3.0], [[1.0, 2.0]], [[-1.0, 0.0, 0.0]], [[1.0, -1.0, 0.0]], [[1.0, 0.0, NAN]], [[1.0, 0.0, 0.0]] * 5]
        guided = dict(centre=CENTRE, mass=2.0, rail=AXIS, springs=[[1e4, 1.0, 0.0]], stops=[[1e5, 1.0, 0.1]], velocity=(3.0, 0.0, 0.0),
                      axes=np.eye(3), gravity=(0.0, 0.0, -9.8))
        mirrored = np.diag([1.0, 1.0, -1.0])
        self.each(gasjet.RigidBody, guided, centre=VECTORS, mass=NUMBERS + [0.0, -1.0], rail=VECTORS[1:] + [(0.0, 0.0, 0.0)], springs=springs[1:],
                  stops=springs[1:], velocity=VECTORS + [(0.0, 1.0, 0.0)], gravity=VECTORS, angular_velocity=VECTORS + [AXIS],
                  axes=[None, "abc", np.eye(2), NODES, 2.0 * np.eye(3), mirrored])
        free = dict(centre=CENTRE, mass=2.0, inertia=np.eye(3), angular_velocity=AXIS)
        spoilt, skewed = np.eye(3), np.eye(3)
        spoilt[2, 1] = NAN
        skewed[0, 1] = 0.5
        self.each(gasjet.RigidBody, free, angular_velocity=VECTORS, springs=springs[5:6], stops=springs[5:6],
                  inertia=[None, "x", 1.0, np.ones(3), np.eye(2), NODES, spoilt, skewed, mirrored, 0.0 * np.eye(3), np.diag([1.0, 1.0, 3.0])])
        body = gasjet.RigidBody(**free)
        before = body.state["displacement_m"], tuple(body.centre), tuple(body.velocity)
        self.each(body.advance, dict(step=1e-9, force=AXIS, couple=AXIS), step=NUMBERS + [-1.0], force=VECTORS, couple=VECTORS)
        lost = gasjet.RigidBody(**free)
        self.refused("step", lambda: lost.advance(0.0), 0.0)
        self.assertEqual((lost.state["displacement_m"], tuple(lost.centre), tuple(lost.velocity)), before)
        self.each(body.effective_mass, dict(reach=0.1), reach=NUMBERS + [-1.0])
        self.each(body.frequency, dict(contact_force=1.0, reach=0.1), contact_force=NUMBERS + [-1.0], reach=NUMBERS + [-1.0])
        for name, values in dict(centre=VECTORS, velocity=VECTORS, angular_momentum=VECTORS, axes=[None, "abc", np.eye(2), spoilt, mirrored]).items():
            for value in values:
                body = gasjet.RigidBody(**free)
                setattr(body, name, value)
                self.refused(name, lambda: body.state, value)
                self.refused(name, lambda: body.advance(1e-3), value)
        self.each(gasjet.Contact.reach, dict(radius=0.1, rim_radius=0.1), radius=NUMBERS[1:] + [-0.1], rim_radius=NUMBERS[1:] + [0.0])
        pulse = dict(time=[0.0, 0.1], acceleration=[1.0, 2.0], window=0.015)
        self.each(gasjet.head_injury_criterion, pulse, time=[None, *COLUMNS, [0.1, 0.0], [0.0, 0.0], [0.0, 11.0], [0.0]],
                  acceleration=[None, [[1.0, 2.0, 3.0], [1.0]], *COLUMNS[:4], NODES[:2, :2], with_row(NAN)[1:3]], window=NUMBERS + [0.0, -1.0, 1.0])

    def test_run_compare_and_exact(self):
        self.each(gasjet.run, dict(case=CASE, set={"scene.end_time": 0.01}, threads=1), case=[None, 1, "", "a\0b"], out=[1, "", "a\0b"],
                  set=[1, [1], "x", {1: 2}, {"": 1}, {"a\nb": 1}, {"scene.end_time": {1}}, {"scene.end_time": 1j}, {"scene.end_time": NAN}],
                  threads=[None, 0, 1.5, 2**40, "1"], progress=[1, "x"], text=[1, "\0"])
        for case in ("absent.toml", b"absent\xff.toml", os.fsdecode(b"absent\xff.toml")):
            type(self).calls += 1
            with self.assertRaisesRegex(gasjet.InputError, r"absent(\\xff)?.toml: no such file"):
                gasjet.run(case)
        self.each(gasjet.check_surface, dict(nodes=NODES, triangles=TRIANGLES), nodes=POINTS, triangles=TRIANGLE_LISTS)
        history = {"time_s": [0.0, 1.0, 2.0], "pressure_Pa": [1.0, 2.0, 3.0]}
        wrong = [None, 1, {}, {"time_s": [0.0, 1.0], "a": [1.0]}, {1: [1.0]}, {"a,b": [1.0]}, {"time_s": [[0.0]]}, {"time_s": 1.0}]
        for value in wrong + [{"time_s": column} for column in COLUMNS]:
            self.refused("mine", lambda: gasjet.compare(value, history), value)
            self.refused("reference", lambda: gasjet.compare(history, value), value)
        for value in ["pressure_Pa", [1], [""], ["a,b"], 1]:
            self.refused("columns", lambda: gasjet.compare(history, history, columns=value), value)
        for value in NUMBERS:
            self.refused("tolerance", lambda: gasjet.compare(history, history, tolerance=value), value)
        self.each(gasjet.exact, dict(name="blowdown", times=[0.1], volume=0.06), times=COLUMNS[:4] + COLUMNS[5:], volume=NUMBERS, name=[None, 1, "none", "a\0"])

    def test_a_callback_that_fails_stops_the_run(self):
        class Odd:
            def __bool__(self):
                raise KeyError("progress")

        def fail(*_):
            raise KeyError("progress")

        for progress in (fail, lambda now, end: Odd(), lambda now: KeyError("progress"), lambda now, end: np.ones(2)):
            type(self).calls += 1
            with self.assertRaises((KeyError, TypeError, ValueError)):
                gasjet.run(CASE, progress=progress)

    def test_one_object_serves_one_thread_at_a_time(self):
        grid = np.arange(40000).reshape(200, 200)
        nodes = np.stack([grid // 200, grid % 200, np.ones_like(grid)], -1).reshape(-1, 3) / 200.0
        triangles = np.stack([grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:]], -1).reshape(-1, 3)
        surface, refusals, start = gasjet.Surface(triangles, len(nodes)), [], threading.Barrier(2)

        def work():
            start.wait()
            for _ in range(200):
                try:
                    surface.visible(nodes, (0.5, 0.5, 0.0), (0.0, 0.0, 1.0))
                except gasjet.BusyError as error:
                    refusals.append(str(error))
                if refusals:
                    return

        threads = [threading.Thread(target=work) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertRegex(refusals[0], "surface: is used by another thread, allowed: one at a time")
        type(self).calls += len(refusals)


if __name__ == "__main__":
    unittest.main()
