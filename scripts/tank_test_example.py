#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The worked example of the tank test: readings made up from a closed form with 1 % noise, their analysis, and the
picture of it. Rewrites cases/tank_test_readings.csv, cases/tank_test_curves.csv and docs/figures/tank_test.svg.
usage: scripts/tank_test_example.py [FOLDER]   writes to FOLDER/ instead; GASJET names another program"""
import math
import pathlib
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "docs/make/charts"))
from common import gasjet, output  # noqa: E402

NOISE = 0.01  # of the reading
# 80 g of nitrogen in 50 ms, 800 K falling to 400 K, into 60 l of air; cp of both constant, as at 298.15 K.
PULSE = ("tank_test_pulse --times 0:0.06:1e-4 --set gas_constant=296.79670 --set heat_capacity_ratio=1.3995470 --set tank_gas_constant=287.04164 "
         "--set tank_heat_capacity_ratio=1.3999531 --set outlet_area=1e-4")
HEAD = ("# synthetic: closed form tank_test_pulse (80 g of N2, 800 to 400 K, Cd A = 1e-4 m2) with 1 % noise, made by scripts/tank_test_example.py\n"
        "time_s,{},{}\n")


def noise():
    """Factors with Gaussian noise by Box and Muller's method from Park and Miller's generator: the same on every machine."""
    seed = 20260

    def uniform():
        nonlocal seed
        seed = (16807 * seed) % 2147483647
        return seed / 2147483647
    while True:
        yield 1 + NOISE * math.sqrt(-2 * math.log(uniform())) * math.cos(6.283185307179586 * uniform())


def main(folder=None):
    tables, figures = (pathlib.Path(folder).resolve(),) * 2 if folder else (ROOT / "cases", ROOT / "docs/figures")
    known = output(gasjet(), "exact", *PULSE.split())
    names, *rows = [line.split(",") for line in known.splitlines() if not line.startswith("#")]
    factors = noise()
    (tables / "tank_test_readings.csv").write_text(HEAD.format(*names[1:3]) + "".join(
        f"{float(time):.4f},{float(a) * next(factors):.0f},{float(b) * next(factors):.0f}\n" for time, a, b, *_ in rows), encoding="utf-8")
    options = "--method dual --volume 0.06 --mass 0.08 --gas N2 --thermodynamics constant --points 241 --out tank_test_curves.csv"
    output(gasjet(), "identify", "tank_test_readings.csv", *options.split(), cwd=tables)
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as curve:
        curve.write(known)
        curve.flush()
        output(ROOT / "scripts/plot.py", "identify", "--title", "Tank test of a known pulse, readings with 1 % noise", figures / "tank_test",
               tables / "tank_test_curves.csv", curve.name)
    (figures / "tank_test.png").unlink()  # the pages show the other


if __name__ == "__main__":
    main(*sys.argv[1:])
