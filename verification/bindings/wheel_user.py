# SPDX-License-Identifier: Apache-2.0
"""Uses the wheel where nothing else of Gasjet is: cases by name, references, the command, jets, steps, commands as functions, a report."""
import pathlib
import subprocess
import tempfile
import warnings

import numpy as np

import gasjet

CASES, REFERENCES = gasjet.cases(), gasjet.references()


def cases_and_command(out):
    for name in ("tank_blowdown", "plate_jet"):
        run = gasjet.run(CASES[name], out=out / name)
        assert gasjet.compare(run, REFERENCES[name])["verdict"] == "inside", name
        subprocess.run(["gasjet", "run", CASES[name], "--quiet", "--out", out / "command"], check=True)
        commanded = gasjet.load(out / "command").history
        np.testing.assert_array_equal(list(commanded.values()), list(run.history.values()))
    subprocess.run(["gasjet", "compare", out / "command" / "history.csv", REFERENCES["plate_jet"]], check=True, stdout=subprocess.DEVNULL)
    for name, case in CASES.items():
        gasjet.check(case)


def steps(end):
    run = gasjet.run(CASES["jet_bag"], {"scene.end_time": end})
    sim = gasjet.Simulation(CASES["jet_bag"], {"scene.end_time": end})
    sim.advance(end)
    sim.finish()
    np.testing.assert_array_equal(sim.results.history["pressure_Pa"], run.history["pressure_Pa"])


def jet():
    """The axial force is positive and at most the momentum that the outlet gives."""
    bag = gasjet.mesh("passenger")
    low, high = bag.nodes.min(axis=0), bag.nodes.max(axis=0)
    blows = gasjet.Jet((low + high) / 2, (1, 0, 0), radius=0.02, decay_coefficient=6.0)
    pressure, force = blows.pressure(bag.nodes, bag.triangles, velocity=400.0, density=1.2)
    assert blows.counters["lit"] > 0 and pressure.max() > 0
    assert 0 < force[0] <= 1.2 * 400.0**2 * np.pi * 0.02**2, force


def commands(out):
    page = pathlib.Path(gasjet.report([out / "tank_blowdown"], out / "page.html", against=REFERENCES["tank_blowdown"])).read_text()
    assert "</html>" in page and "three.js" in page
    enclosed = subprocess.run(["gasjet", "enclose", CASES["tank_blowdown"]], stdout=subprocess.PIPE, text=True)
    assert enclosed.returncode == 0 and "pressure" in enclosed.stdout
    assert gasjet.exact("blowdown", times=[0.0])["pressure_Pa"][0] == 5e5


warnings.simplefilter("ignore", gasjet.GasjetWarning)
with tempfile.TemporaryDirectory() as folder:
    cases_and_command(pathlib.Path(folder))
    steps(1e-3)
    jet()
    commands(pathlib.Path(folder))
print(f"wheel: {len(CASES)} cases, {len(REFERENCES)} references: holds")
