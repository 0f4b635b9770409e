# SPDX-License-Identifier: Apache-2.0
"""Runs the paper's scene, short, with options of every kind at once: each pair of values of two factors is run.

All are allowed together. Each run must end, with balances that close and finite rows, and the jet must blow once the inflator has fired.
"""

import itertools
import math
import random

from command import gasjet, load, numbers

LENGTH = 5e-3  # [s]
MASS, ENERGY = 1e-12, 5e-3  # largest residuals: some roundings; the drift of a short run, a thousandth as a rule
LOGIC = ('sensor=[{name="a",time=0.001},{name="b",signal={time=[0,0.01],value=[0,1]},above=0.2}]',
         'trigger=[{name="s",all=["a","b"],delay=0.001,latch=true}]', "inflator.0.trigger=s")
FACTORS = [
    [(), ("gas.thermodynamics=nasa7",)],
    [(), ("inflator.0.temperature={time=[0,0.01],value=[500,300]}",),
     ("inflator.0.temperature={time=[0,0.004,0.004],value=[500,400,300]}",)],
    [(), ("inflator.0.mass_flow=1.5",), ("inflator.0.mass_flow={time=[0,0.002,0.002,0.01],value=[0,1,2,0]}",)],
    [(), ("inflator.0.start_time=0.002",), ('sensor=[{name="s",time=0.002}]', "inflator.0.trigger=s"),
     ('sensor=[{name="s",overpressure=-1e5}]', "inflator.0.trigger=s"), LOGIC],
    [(), ("vent.0.area={time=[0,0.005,0.01],value=[0,1e-3,2e-3]}",),
     ("vent.0.area={overpressure=[0,5e3,2e4],value=[0,1e-3,4e-3]}",),
     ("vent.0.backflow=true", "gas.initial.pressure=1.0e5")],
    [(), ("gas.heat_loss={coefficient=50.0,area=1.0,outside_temperature=293.0}",)],
    [("inflator.0.jet.outlet=sonic",), ("inflator.0.jet.outlet=pressure_matched", "inflator.0.jet.temperature=stagnation"),
     ("inflator.0.jet.jet_work=from_gas", "inflator.0.jet.temperature=stagnation")],
    [(), ("inflator.0.jet.relative_to_skin=true",), ("inflator.0.jet.subdivisions=2",), ("inflator.0.jet.restitution=0.3",)],
    [(), ("inflator.0.jet.occlusion=false",)],
    [(), ("inflator.0.jet.direction=radial",)],
    [(), ("fabric.compression=linear",), ("fabric.law=hencky",), ("fabric.porosity=0.05", "fabric.leak_law=screen")],
    [(), ("time.gas_method=rosenbrock",), ("time.gas_method=runge_kutta",), ("time.gas_tolerance=1e-4",)],
    [(), ("contact.friction=0.3",)],
    [(), ("membrane.mass_damping=20.0",), ("membrane.stiffness_damping=1e-6",)],
    [(), ("output.streams=true",), ("output.channel_classes=[180]",), ("output.frames=5",)],
]


def covering_rows(rng):
    """Rows of one value of each factor, so that each pair of values of two factors is in one; made greedily."""
    sizes = [len(values) for values in FACTORS]
    open_pairs = {(i, a, j, b) for i, j in itertools.combinations(range(len(sizes)), 2)
                  for a in range(sizes[i]) for b in range(sizes[j])}
    pairs = lambda row: {(i, row[i], j, row[j]) for i, j in itertools.combinations(range(len(sizes)), 2)}
    while open_pairs:
        tried = [tuple(rng.randrange(n) for n in sizes) for _ in range(40)]
        i, a, j, b = rng.choice(sorted(open_pairs))
        tried = [tuple({i: a, j: b}.get(k, v) for k, v in enumerate(row)) for row in tried]
        row = max(tried, key=lambda row: len(pairs(row) & open_pairs))
        open_pairs -= pairs(row)
        yield row


def fault_of(settings, folder):
    """What is wrong with the run; nothing: it is as it has to be."""
    done = gasjet(f"run cases/passenger_pendulum.toml --quiet --out {folder}", *(word for s in settings for word in ("--set", s)), timeout=120)
    if done.code != 0:
        return done.what
    residual = load(f"{folder}/summary.json")["residual"]
    if residual["mass_rel"] > MASS or residual["energy_rel"] > ENERGY:
        return f"residuals {residual}"
    history = numbers(f"{folder}/history.csv")
    if not all(map(math.isfinite, itertools.chain(*history.values()))):
        return "a number that is not finite"
    return None if max(history["jet_force_N"]) > 0.0 else "no jet"


def test_combined_cases():
    rows = list(covering_rows(random.Random(1)))
    faults = []
    for n, row in enumerate(rows):
        settings = [f"scene.end_time={LENGTH}", *(s for values, k in zip(FACTORS, row) for s in values[k])]
        if fault := fault_of(settings, f"run_{n}"):
            faults.append((fault, *settings))
    assert not faults, f"{len(faults)} of {len(rows)} runs: {faults}"
