# SPDX-License-Identifier: Apache-2.0
"""Rigid bodies of the Python package against a run of the command, Euler's top and closed forms."""
import os
import unittest

import numpy as np

import gasjet

CASES = os.path.join(os.environ["GASJET_SOURCE_DIR"], "cases")
MOMENTS = np.array([0.016, 0.021, 0.026])  # [kg m2] principal ones


def top(**change):
    """A body that tumbles about all its axes."""
    return gasjet.RigidBody((0, 0, 0), **{**dict(mass=4.5, inertia=np.diag(MOMENTS), angular_velocity=(20.0, 0.0, 30.0)), **change})


class Rails(unittest.TestCase):
    def test_a_rail_has_the_bits_of_a_run(self):
        run = gasjet.run(os.path.join(CASES, "rail_stop.toml"))
        body = gasjet.RigidBody((0, 0, 0), mass=20.0, rail=(1, 0, 0), velocity=(5, 0, 0), stops=[(2e5, 200.0, 0.2)])
        rows = {name: [] for name in ("impactor_displacement_m", "impactor_velocity_m_s", "impactor_acceleration_m_s2",
                                      "impactor_kinetic_J", "impactor_spring_J", "impactor_damping_J")}
        loss = 0.0
        for step in range(8000):
            now, kick = body.state, body.advance(1e-5, force=(-500.0, 0.0, 0.0))
            if step % 10 == 0:
                for column, value in zip(rows.values(), (now["displacement_m"], kick["velocity_m_s"][0], kick["acceleration_m_s2"][0],
                                                         kick["kinetic_energy_J"], now["spring_energy_J"],
                                                         loss + (0.5 if step else 0.0) * kick["damping_loss_J"])):
                    column.append(value)
            loss += kick["damping_loss_J"]
        history = {**run.history, **run.energy}
        self.assertGreater(max(rows["impactor_spring_J"]), 0.0)
        for name, values in rows.items():  # the run shortens its last step to end at its time
            np.testing.assert_array_equal(values, history[name][:-1], err_msg=name)

    def test_springs_damper_and_weight_keep_the_balance(self):
        body = gasjet.RigidBody((1.0, 2.0, 3.0), mass=6.8, rail=(0, 0, -2.0), velocity=(0, 0, -5.0), springs=[(30e3, 120.0, 0.01)],
                                stops=[(1e6, 0.0, 0.05), (1e6, 0.0, -0.02)], gravity=(0.0, 0.0, -9.81))
        total, kicks, loss = [], [], 0.0
        for step in range(3000):
            now, kick = body.state, body.advance(2e-5)
            kicks.append(kick["kinetic_after_J"] - kick["kinetic_before_J"] - kick["work_J"])
            lost = loss + (0.5 if step else 0.0) * kick["damping_loss_J"]
            total.append(kick["kinetic_energy_J"] + now["spring_energy_J"] + now["gravity_energy_J"] + lost)
            loss += kick["damping_loss_J"]
        self.assertEqual((tuple(body.centre[:2]), abs(body.angular_momentum).max()), ((1.0, 2.0), 0.0))
        self.assertLess(np.abs(kicks).max(), 1e-11)  # rounding of 85 J
        # Of second order: the square of step times frequency is 1.2e-4.
        np.testing.assert_allclose(total, 0.5 * 6.8 * 5.0**2 + 0.5 * 30e3 * 0.01**2, rtol=1.2e-4)
        self.assertGreater(loss, 10.0)
        self.assertAlmostEqual(body.frequency() * 6.8 / 2.03e6, 1.0, 12)
        self.assertEqual(body.effective_mass(0.1), 6.8)

    def test_a_step_beyond_the_limit_blows_up(self):
        # 2/sqrt(frequency) is the limit of a spring that always acts.
        largest = {}
        for share in (0.99, 1.01):
            body = gasjet.RigidBody((0, 0, 0), mass=2.0, rail=(1, 0, 0), velocity=(1, 0, 0), springs=[(800.0, 0.0, 0.0)])
            step = share * 2.0 / body.frequency() ** 0.5
            largest[share] = 0.0
            for _ in range(200):
                body.advance(step)
                largest[share] = max(largest[share], abs(body.state["displacement_m"]))
        self.assertLess(largest[0.99], 1.0)  # at most step/(2 sqrt(1 - 0.99^2)) times the speed
        self.assertGreater(largest[1.01], 1e10)


class FreeBodies(unittest.TestCase):
    def test_a_top_keeps_energy_and_momentum_and_is_of_order_2(self):
        ends, duration = [], 0.3
        for steps in (150, 300, 600, 1200):
            body = top()
            start, momentum = body.state["kinetic_energy_J"], np.array(body.angular_momentum)
            for _ in range(steps):
                body.advance(duration / steps)
            np.testing.assert_allclose(body.angular_momentum, momentum, rtol=1e-15)  # nothing acts on it
            np.testing.assert_allclose(body.axes.T @ body.axes, np.eye(3), atol=1e-14)
            # (I w)^2 of the body's own components is the momentum's.
            own = body.axes.T @ body.state["angular_velocity_rad_s"]
            self.assertAlmostEqual(np.linalg.norm(MOMENTS * own) / np.linalg.norm(momentum), 1.0, 12)
            ends.append((own, body.state["kinetic_energy_J"] / start - 1.0))
        self.assertLess(abs(ends[0][1]), 1e-2)
        # Differences of three levels: the error's own order without a reference.
        for value in (lambda end: end[0], lambda end: end[1:]):
            change = [np.linalg.norm(np.subtract(value(fine), value(coarse))) for coarse, fine in zip(ends, ends[1:])]
            for coarse, fine in zip(change, change[1:]):
                self.assertTrue(1.8 < np.log2(coarse / fine) < 2.2, change)

    def test_a_thrown_body_flies_its_parabola_and_turns_by_the_couple(self):
        body = top(velocity=(3.0, 0.0, 4.0), gravity=(0.0, 0.0, -9.81))
        momentum, work, start = np.array(body.angular_momentum), 0.0, body.state["kinetic_energy_J"]
        for n in range(101):  # the last one brings the speeds to the end
            kick = body.advance(0.002 if n < 100 else 0.0, force=(50.0, 0.0, 0.0), couple=(0.1, -0.2, 0.3))
            work += kick["load_work_J"]
        t = 0.2
        fall = np.array([50.0 / 4.5, 0.0, -9.81])
        np.testing.assert_allclose(body.centre, np.array([3.0, 0.0, 4.0]) * t + 0.5 * t * t * fall, rtol=1e-12, atol=1e-14)
        np.testing.assert_allclose(body.velocity, np.array([3.0, 0.0, 4.0]) + t * fall, rtol=1e-12, atol=1e-12)
        np.testing.assert_allclose(body.angular_momentum, momentum + t * np.array([0.1, -0.2, 0.3]), rtol=1e-13)
        now = body.state
        # Kinetic energy and weight come of the load's work; the rest is the splitting's, of order step^2.
        self.assertAlmostEqual(now["kinetic_energy_J"] + now["gravity_energy_J"] - start - work, 0.0, delta=2e-3 * start)
        self.assertGreater(abs(work), 10.0)

    def test_what_a_body_needs_for_contact(self):
        body = top(axes=((0, 0, 1), (1, 0, 0), (0, 1, 0)))
        self.assertAlmostEqual(body.effective_mass(0.1), 1.0 / (1.0 / 4.5 + 0.01 / 0.016), 12)
        self.assertAlmostEqual(body.frequency(1e3, 0.1), 1e3 * 0.1 / 0.016, 6)
        self.assertEqual(gasjet.Contact.reach(half_axes=(0.1, 0.3, 0.2)), 0.3)
        np.testing.assert_array_equal(body.state["turn_rad"], 0.0)
        body.advance(1e-3)
        np.testing.assert_array_equal(body.state["turn_rad"], 1e-3 * body.state["angular_velocity_rad_s"])
        again = top()
        again.centre, again.axes, again.velocity, again.angular_momentum = body.centre, body.axes, body.velocity, body.angular_momentum
        np.testing.assert_array_equal(again.state["angular_velocity_rad_s"], body.state["angular_velocity_rad_s"])
        self.assertIn("0 m from its start", repr(top()))


class HeadInjury(unittest.TestCase):
    def test_constants_and_directions(self):
        time, g = np.linspace(0.0, 0.1, 11), 9.80665
        along = gasjet.head_injury_criterion(time, np.full(11, 60.0 * g), window=0.036)
        self.assertAlmostEqual(along / (0.036 * 60.0**2.5), 1.0, 9)
        across = gasjet.head_injury_criterion(time, np.tile([0.0, 36.0 * g, 48.0 * g], (11, 1)), window=0.036)
        self.assertAlmostEqual(across / along, 1.0, 12)
        self.assertAlmostEqual(gasjet.head_injury_criterion(time, np.full(11, 60.0 * g)) / along, 0.015 / 0.036, 9)


if __name__ == "__main__":
    unittest.main()
