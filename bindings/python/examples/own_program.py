# SPDX-License-Identifier: Apache-2.0
"""A program of one's own, NumPy alone, for run_external.py: a swinging pendulum and a round jet on a plate.

usage: own_program.py METHOD SCENE.json HISTORY.csv      METHOD: euler or runge_kutta, for the pendulum
Exit code 77: it does not do this scene.
"""
import json
import sys

import numpy as np

DECAY = {"contracting_nozzle": 0.066, "cylindrical_tube": 0.08, "guide_vane_fan": 0.12}  # Abramovich's a


def swing(scene, method):
    """A rigid pendulum under gravity; axis and gravity are normal to each other."""
    body = scene["settings"]["pendulum"]
    gravity = np.linalg.norm(scene["settings"]["scene"]["gravity"])
    arm, mass = body["cg_distance"], body["mass"]
    inertia = body["inertia_cg"] + mass * arm**2

    def rates(state):
        return np.array([state[1], -mass * gravity * arm / inertia * np.sin(state[0])])

    def step(state, dt):
        k1 = rates(state)
        if method == "euler":
            return state + dt * k1
        k2 = rates(state + dt / 2 * k1)
        k3 = rates(state + dt / 2 * k2)
        k4 = rates(state + dt * k3)
        return state + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)

    times = scene["times"]
    states = [np.array([body["initial_angle"], body["initial_angular_velocity"]], float)]
    for before, now in zip(times, times[1:]):
        states.append(states[-1])
        for _ in range(10):
            states[-1] = step(states[-1], (now - before) / 10)
    angle, omega = np.array(states).T
    along, inward = arm * rates((angle, omega))[1], arm * omega**2
    joint = mass * np.hypot(along + gravity * np.sin(angle), inward + gravity * np.cos(angle))
    return {"pendulum_angle_rad": angle, "pendulum_angular_velocity_rad_s": omega, "pendulum_cg_tangential_m_s2": along,
            "pendulum_cg_radial_m_s2": inward, "pendulum_cg_acceleration_m_s2": np.hypot(along, inward),
            "pendulum_joint_force_N": joint}


def blow(scene):
    """A round jet along x that meets a square plate head-on; sonic outlet, static temperature."""
    settings = scene["settings"]
    plate, inflator, gas = settings["target"], settings["inflator"][0], settings["gas"]["species"][0]
    jet = inflator["jet"]
    velocity = np.sqrt((gas["cp"] / (gas["cp"] - gas["gas_constant"]) - 1) * gas["cp"] * inflator["temperature"])
    density = inflator["mass_flow"] / (np.pi * jet["radius"] ** 2 * velocity)
    left = min(1.0, 0.96 / (DECAY[jet["outlet_type"]] * (plate["centre"][0] - jet["centre"][0]) / jet["radius"] + 0.29))
    width = np.sqrt(2.0) * jet["radius"] / left

    cell = np.array([plate["width"] / plate["columns"], plate["height"] / plate["rows"]])
    corner = np.stack(np.meshgrid(np.arange(plate["columns"]), np.arange(plate["rows"])), -1).reshape(-1, 2)
    thirds = np.array([[1, 2], [2, 1]]) / 3.0  # centroids of a cell's two triangles
    at = (corner[:, None, :] + thirds).reshape(-1, 2) * cell - [plate["width"] / 2, plate["height"] / 2]
    share = np.exp(-2 * (at**2).sum(1) / width**2)  # (V/V_max)^2
    share[share < jet["cut_off"]] = 0.0
    force = (1 + jet["restitution"]) * density * (left * velocity) ** 2 * share.sum() * cell.prod() / 2
    ones = np.ones(len(scene["times"]))
    return {"jet_force_N": force * ones, "jet_lit_elements": np.count_nonzero(share) * ones, "jet_hidden_elements": 0 * ones}


method, scene_file, history_file = sys.argv[1:]
with open(scene_file, encoding="utf-8") as file:
    scene = json.load(file)
if scene["scene"] == "pendulum_swing":
    columns = swing(scene, method)
elif scene["scene"] == "plate_jet":
    columns = blow(scene)
else:
    sys.exit(77)
table = {"time_s": scene["times"], **columns}
np.savetxt(history_file, np.column_stack(list(table.values())), delimiter=",", header=",".join(table), comments="", fmt="%.17g")
