# SPDX-License-Identifier: Apache-2.0
"""What the heat-loss term of `gasjet identify` contributes: a tank of 60 litres that takes 34 g of nitrogen at 900 K and loses its heat,
identified from its own pressure without the term and with it. Lines of heat_loss.csv: heat transfer coefficient times area, time constant
of the loss, mean temperature without and with the term, coefficient times area found."""
import re

from common import ROOT, gasjet, output

WORK = ROOT / "results/heat_loss"
LOSSES = (0, 90, 315)  # W/K
VOLUME, MASS, AIR = 0.06, 0.034, 101325 * 0.06 / (287.05 * 293.15)  # m3, kg, kg
HEAT_CAPACITY = 743 * MASS + 718 * AIR  # J/K, at constant volume and room temperature
CASE = """[scene]
name = "hot_tank"
end_time = 0.25
[gas]
thermodynamics = "nasa7"
initial = {{ composition = {{ air = 1.0 }} }}
{loss}
[tank]
volume = {volume}
[[inflator]]
composition = {{ N2 = 1.0 }}
temperature = 900.0
mass_flow = {{ time = [0.005, 0.015, 0.045], value = [0.0, 1.7, 0.0] }}
[output]
history_every = 5e-4
"""


def identified(folder, *options):
    """Lines `# key: number` above the curves that identify finds."""
    curves = folder / "curves.csv"
    output(gasjet(), "identify", folder / "run/history.csv", "--method", "average", "--tank-column", "pressure_Pa", "--volume", VOLUME, "--mass", MASS,
           "--gas", "N2", "--out", curves, *options)
    found = re.findall(r"^# (mean_temperature_K|heat_loss_W_K): ([-+.0-9e]+)", curves.read_text(encoding="utf-8"), flags=re.M)
    return {key: float(value) for key, value in found}


def lines():
    yield "loss_W_K,time_constant_s,temperature_K,temperature_without_K,temperature_with_K,found_W_K"
    for loss in LOSSES:
        folder = WORK / str(loss)
        folder.mkdir(parents=True, exist_ok=True)
        wall = f"heat_loss = {{ coefficient = {loss}, area = 1.0 }}" if loss else ""
        (folder / "case.toml").write_text(CASE.format(loss=wall, volume=VOLUME), encoding="utf-8")
        output(gasjet(), "run", folder / "case.toml", "--out", folder / "run", "--quiet")
        without, fitted = identified(folder), identified(folder, "--heat-loss", "fit") if loss else {}
        yield (f"{loss},{HEAT_CAPACITY / loss if loss else 'inf'},900,{without['mean_temperature_K']:.5g},"
               f"{fitted.get('mean_temperature_K', without['mean_temperature_K']):.5g},{fitted.get('heat_loss_W_K', 0):.4g}")
