# SPDX-License-Identifier: Apache-2.0
"""`gasjet identify`: tank test analysis."""
import os
import random
import re
from pathlib import Path

import pytest
from command import bare, change, expect, has, numbers, ok, program, line, read, refused, table, write, write_table

BASE = "--method dual --volume 0.06 --mass 0.08 --gas N2 --thermodynamics constant --points 601"
SHIPPED = "identify cases/tank_test_readings.csv " + BASE.replace("601", "241")


@pytest.fixture
def data():
    """Readings without noise."""
    pulse = ok("exact tank_test_pulse --times 0:0.06:1e-4 --set gas_constant=296.79670 --set heat_capacity_ratio=1.3995470"
               " --set tank_gas_constant=287.04164 --set tank_heat_capacity_ratio=1.3999531 --set outlet_area=1e-4").out
    Path("data.csv").write_text(pulse.replace("inflow_kg_s", "true_flow"))


def comments(path):
    return re.findall("(?m)^# (.*)", read(path))


def misses(mine, reference):
    """The largest relative difference of two columns, each of a file, at times that both have."""
    columns = [numbers(path) for path, _ in (mine, reference)]
    first, second = ({round(t, 6): x for t, x in zip(c["time_s"], c[name])} for c, (_, name) in zip(columns, (mine, reference)))
    both = first.keys() & second.keys()
    assert len(both) >= 20
    return max(abs(first[t] / second[t] - 1) for t in both)


TANK_PRESSURE = ("data.csv", "tank_pressure_Pa")


@pytest.mark.parametrize("method", ["dual", "average"])
def test_identify(data, method):
    """What comes out runs to the readings' pressure; the limit is the one that the analysis states."""
    expect(0, "mean_temperature_K: 600", f"identify data.csv {BASE.replace('dual', method)} --out curves.csv")
    assert not [text for text in comments("curves.csv") if text.startswith("warning")]
    curve = lambda column: f"{{ file = '{os.getcwd()}/curves.csv', column = '{column}' }}"
    ok("run cases/tank_identified.toml --out run --quiet --set", f"inflator.0.mass_flow={curve('mass_flow_kg_s')}", "--set",
       f"inflator.0.temperature={curve('temperature_K')}")
    (limit,) = [float(found[1]) for text in comments("curves.csv") if (found := re.match("forward_model: .* by at most ([0-9.e+-]+) %", text))]
    assert misses(("run/history.csv", "pressure_Pa"), TANK_PRESSURE) <= 0.01 * limit + 1e-5


def test_identify_shipped(data):
    """The curve in the shipped example is the one of its script's command, row by row: 1e-5 of each column's largest value, for its eight
    digits and the last bits of another machine's functions that the search for lambda carries on."""
    ok(f"{SHIPPED} --out shipped.csv")
    assert not [text for text in comments("shipped.csv") if text.startswith("warning")]
    mine, shipped = numbers("shipped.csv"), numbers("cases/tank_test_curves.csv")
    assert list(mine) == list(shipped) and len(mine["time_s"]) >= 200
    for name, column in shipped.items():
        assert mine[name] == pytest.approx(column, abs=1e-5 * max(map(abs, column)), rel=0), name
    # With closed descriptors too: what would be printed is lost, the table is not.
    assert program("bash", "-c", 'exec "$@" <&- >&- 2>&-', "-", *line(f"{SHIPPED} --out closed.csv")).code == 0
    assert bare("shipped.csv") == bare("closed.csv")
    # Its case runs to the truth within the readings' noise (1 %).
    ok("run cases/tank_identified.toml --out run --quiet")
    assert misses(("run/history.csv", "pressure_Pa"), TANK_PRESSURE) <= 0.01


INITIAL = ("^initial.*", r"\g<0>\n")
OWN = '{ name = "own", molar_mass = 0.044009, cp = 1168.6 }'
RECORD = "--method average --tank-column pressure_Pa --volume 0.0283 --mass 0.07"


def write_co2():
    """The program's own tank with cp(T): 0.07 kg of CO2 at 800 K into 28.3 litres of air."""
    write("co2.toml", "[scene]", 'name = "co2"', "end_time = 0.06", "[gas]", 'thermodynamics = "nasa7"',
          "initial = { composition = { air = 1.0 }, pressure = 101325.0, temperature = 293.15 }", "[tank]", "volume = 0.0283", "[[inflator]]",
          "composition = { CO2 = 1.0 }", "temperature = 800.0", "mass_flow = { time = [0.0, 0.01, 0.04], value = [0.0, 3.5, 0.0] }", "[output]",
          "history_every = 1e-4")


def test_identify_gases():
    write_co2()
    ok("run co2.toml --out co2 --quiet")
    expect(0, "mean_temperature_K: (800|799.99|800.00)", f"identify co2/history.csv {RECORD} --gas CO2 --out co2.csv")
    # The same with a CO2 of one's own: another case gives its constant cp, of 800 K, and the record is one of that gas.
    write("own.toml", "[gas]", "[[gas.species]]", 'name = "own"', "molar_mass = 0.044009", "cp = 1168.6")
    change("co2.toml", ("CO2", "own"), ('"co2"', '"own"'), (INITIAL[0], INITIAL[1] + f"species = [{OWN}]"), to="own_tank.toml")
    ok("run own_tank.toml --out own --quiet")
    own = f"identify own/history.csv {RECORD} --gas own"
    expect(0, "mean_temperature_K: (800|799.99|800.00)", f"{own} --species own.toml --out own.csv")
    assert any(re.match("species: built-in and .*own.toml", text) for text in comments("own.csv"))
    assert not [text for name in ("co2.csv", "own.csv") for text in comments(name) if text.startswith("warning")]
    refused("--gas: species = .own.: must be one of N2", f"{own} --out none.csv")
    refused("own.csv: would overwrite|would overwrite .*own.toml", f"{own} --species own.toml --out own.toml")
    refused("co2.toml:4:1: gas.species: is missing", f"{own} --species co2.toml --out none.csv")
    change("own.toml", ("0.044009", "-1"), to="bad.toml")
    refused("bad.toml:4:1: gas.species.0.molar_mass: is -1", f"{own} --species bad.toml --out none.csv")
    # A tank that loses heat to its walls is not adiabatic: the miss is no noise, so there is no band.
    change("co2.toml", (INITIAL[0], INITIAL[1] + "heat_loss = { coefficient = 200.0, area = 0.6 }"), to="loss.toml")
    ok("run loss.toml --out loss --quiet")
    expect(0, "warning: .* noise explains 0.* and --heat-loss fit for a tank that loses heat", f"identify loss/history.csv {RECORD} --gas CO2 --out loss.csv")
    assert has("loss.csv", "^# mean_temperature_K: .*, no band$")
    assert {list(row.values())[-1] for row in table("loss.csv")} == {"0"}


def found(file, name):
    """Number and 95 % band of a line above the table."""
    (line,) = [text for text in comments(file) if text.startswith(f"{name}: ")]
    return [float(x) for x in re.findall(r"-?[0-9.]+(?:e[+-]?[0-9]+)?", line.replace("95 %", ""))][:3]


def test_identify_heat_loss():
    """A hot tank that loses its heat with a time constant of 250 ms: the loss is found, and with it the temperature."""
    write("hot.toml", "[scene]", 'name = "hot"', "end_time = 0.25", "[gas]", 'thermodynamics = "nasa7"',
          "initial = { composition = { air = 1.0 }, pressure = 101325.0, temperature = 293.15 }",
          "heat_loss = { coefficient = 350.0, area = 0.9, outside_temperature = 293.15 }", "[tank]", "volume = 0.06", "[[inflator]]", "composition = { N2 = 1.0 }",
          "temperature = 900.0", "mass_flow = { time = [0.005, 0.015, 0.045], value = [0.0, 1.7, 0.0] }", "[output]", "history_every = 5e-4")
    ok("run hot.toml --out hot --quiet")
    rows = numbers("hot/history.csv")
    noise = random.Random(3)
    write_table("hot.csv", {"time_s": rows["time_s"], "tank_pressure_Pa": [p * (1 + 0.003 * noise.gauss(0, 1)) for p in rows["pressure_Pa"]]})
    base = "identify hot.csv --method average --volume 0.06 --mass 0.034 --gas N2 --points 201"
    hot = f"{base} --out hot_curves.csv"
    expect(0, "warning: .*--heat-loss fit for a tank that loses heat", hot)
    assert found("hot_curves.csv", "mean_temperature_K")[0] < 850
    expect(0, "heat_loss_W_K: .*, 95 %: .* from the fall of the pressure after 0.0[0-9]+ s", f"{hot} --heat-loss fit")
    for name, truth in (("heat_loss_W_K", 315), ("mean_temperature_K", 900)):
        value, low, high = found("hot_curves.csv", name)
        assert low < truth < high and value == pytest.approx(truth, rel=0.01)
    assert not [text for text in comments("hot_curves.csv") if text.startswith("warning")]
    expect(0, "heat_loss_W_K: 315, as given", f"{hot} --heat-loss 315")
    value, low, high = found("hot_curves.csv", "mean_temperature_K")
    assert low < 900 < high
    # The curves run, in the same tank, to the pressure.
    curve = lambda column: f"{{ file = '{os.getcwd()}/hot_curves.csv', column = '{column}' }}"
    ok("run hot.toml --out back --quiet --set", f"inflator.0.mass_flow={curve('mass_flow_kg_s')}", "--set", f"inflator.0.temperature={curve('temperature_K')}")
    assert misses(("back/history.csv", "pressure_Pa"), ("hot/history.csv", "pressure_Pa")) < 0.01
    text = read("hot.csv").splitlines()
    write("short.csv", *[line for line in text if not re.match("0.(0[5-9]|[12])", line)])
    refused("gasjet: --heat-loss = fit: after the rise .*; give its value .W/K. instead", f"{base.replace('hot.csv', 'short.csv')} --heat-loss fit --out none.csv")
    refused(r"gasjet: --heat-loss \[W/K\] = -1: must be 0 or more", f"{base} --heat-loss=-1 --out none.csv")
    refused("gasjet: --heat-loss much: is neither a number .W/K. nor fit", f"{base} --heat-loss much --out none.csv")


def test_identify_units(data):
    """Milliseconds, semicolons, decimal commas and gauge pressures of two units give the curves of the same readings in SI units, but for
    the last bits of the readings, which the search for lambda carries on: 1e-5 as in test_identify_shipped. Readings without noise leave
    little to tell a band's width from: its ends may move by 2 % of it."""
    readings = numbers("data.csv")
    write("foreign.csv", "Zeit [ms];Kammer [MPa];Kanne [bar]", *(f"{1e3 * t:.17g};{1e-6 * c:.17g};{(p - 98000) / 1e5:.17g}".replace(".", ",") for t, c, p in zip(
        readings["time_s"], readings["chamber_pressure_Pa"], readings["tank_pressure_Pa"])))
    names = ["--time-column", "Zeit [ms]", "--tank-column", "Kanne [bar]", "--chamber-column", "Kammer [MPa]"]
    units = ["--time-unit", "ms", "--tank-unit", "bar gauge", "--ambient-pressure", "98000", "--chamber-unit", "MPa"]
    ok(f"identify data.csv {BASE} --out curves.csv")
    ok(f"identify foreign.csv {BASE} --out foreign_curves.csv", *names, *units)
    assert has("foreign_curves.csv", "^# units: time in ms, tank pressure in bar gauge, chamber pressure in MPa, ambient pressure 98000 Pa$")
    mine, foreign = numbers("curves.csv"), numbers("foreign_curves.csv")
    for name, column in mine.items():
        if name == "amplification":  # four digits
            continue
        ends = [re.sub("_(low|high)_", end, name) for end in ("_low_", "_high_")]
        for x, y, low, high in zip(column, foreign[name], mine[ends[0]], mine[ends[1]]):
            assert abs(x - y) <= 1e-5 * max(map(abs, column)) + 0.02 * (high - low if name in ends and ends[0] != ends[1] else 0.0), name
    refused('--tank-unit is "km", allowed: Pa, .*, also with gauge or absolute', f"identify data.csv {BASE} --out none.csv", "--tank-unit", "km")
    refused('--time-unit is "kPa", allowed: s, ms, us$', f"identify data.csv {BASE} --out none.csv", "--time-unit", "kPa")
    refused("--ambient-pressure needs a gauge unit", f"identify data.csv {BASE} --out none.csv --ambient-pressure 98000 --tank-unit Pa")
    average = f"identify data.csv {BASE.replace('dual', 'average')} --out none.csv"
    refused("--chamber-unit needs --method dual", f"{average} --chamber-unit Pa")
    refused("--ambient-pressure needs a gauge unit", f"{average} --ambient-pressure 98000")


def test_identify_doubtful(data):
    readings = numbers("data.csv")
    # Noise that is the same over the record, 0.2 % of the largest reading.
    seed, noisy = 7, []
    for pressure in readings["chamber_pressure_Pa"]:
        seed = 16807 * seed % 2147483647
        noisy.append(pressure + 1e4 * (2 * seed / 2147483647 - 1) * 1.7)
    write_table("noisy.csv", {**readings, "chamber_pressure_Pa": noisy})
    refused("chamber pressure: .* use --noise full-scale", f"identify noisy.csv {BASE} --out none.csv")
    expect(0, "of the largest reading", f"identify noisy.csv {BASE} --noise full-scale --out curves.csv")
    # Gauge pressures, told by the start, and a record of temperatures that nothing explains.
    second, third = list(readings)[1:3]
    write_table("gauge.csv", {name: [f"{x - 101225:.6g}" for x in column] if name in (second, third) else column for name, column in readings.items()})
    told = expect(0, "warning: the tank is at (99.99|100|100.[0-9]+) Pa at first, less than a tenth of an atmosphere: check that pressures are absolute",
                  f"identify gauge.csv {BASE} --out gauge_curves.csv").said
    assert re.search("warning: .* differs from the smoothed tank pressure by [2-9][0-9] %, noise explains 0.* pressures are absolute", told)
    assert sum(text.startswith("warning: ") for text in comments("gauge_curves.csv")) == 2
    # A record that is cut short.
    n = sum(t <= 0.03 for t in readings["time_s"])
    write_table("cut.csv", {name: column[:n] for name, column in readings.items()})
    expect(0, r"warning: the record ends while gas still flows \([0-9.]+ % of the largest flow\), but .* all of --mass",
           f"identify cut.csv {BASE} --out cut_curves.csv")


def test_identify_bad_readings(data):
    """Place, name, nothing written."""
    lines = read("data.csv").splitlines()
    at = next(i for i, text in enumerate(lines) if text.startswith("0.01,"))
    before = lines[at - 1].split(",")[0]
    for says, pattern, new in (
            ("[0-9]+:1: tank_pressure_Pa: no such column", "tank_pressure_Pa", "p"),
            (f"{at + 1}:1: time_s: time: 0.002 s: must be finite and later", "^0.01,", "0.002,"),
            (f"{at + 1}:1: time_s: time: 0.0099[0-9]* s: must be finite and later", "^0.01,", before + ","),
            (f"{at + 1}:6: 'nan'", "^0.01,[^,]*", "0.01,nan"),
            (f"{at + 1}:6: tank_pressure_Pa: tank pressure: -5: must be above 0; pressures are absolute unless their unit says gauge$", "^0.01,[^,]*", "0.01,-5"),
            (f"{at + 1}:[0-9]+: chamber_pressure_Pa: chamber pressure: -5: must be above 0; pressures are absolute unless their unit says gauge; for noise .* use --noise full-scale", "^(0.01,[^,]*),[^,]*",
             r"\1,-5"),
            (f"{at + 1}:[0-9]+: chamber_pressure_Pa: chamber pressure: 91234 Pa is below the tank's", "^(0.01,[^,]*),[^,]*", r"\1,91234"),
            (f"{at - 89}:1: time_s: has [0-9]+ readings, needed: 20 or more", rf"(?s)^{lines[at - 89]}.*", ""),
            ("[0-9]+:1: time_s: -0.1 s: time counts from firing", "^0,", "-0.1,")):
        change("data.csv", (pattern, new), to="bad.csv")
        refused(f"bad.csv:{says}", f"identify bad.csv {BASE} --out none.csv")


@pytest.mark.parametrize("says, option, value", [
    (r"gasjet: --volume \[m3\] = 0: must be above 0", "--volume", "0"), (r"gasjet: --mass \[kg\] = -0.08: must be above 0", "--mass", "-0.08"),
    (r"gasjet: --initial-temperature \[K\] = -1: must be above 0", "--initial-temperature", "-1"),
    ("gasjet: --threshold = 2: must be 0.001 to 0.9", "--threshold", "2"), ("gasjet: --points = 3: must be 20 to", "--points", "3"),
    ("gasjet: --draws = 1: must be 40 to", "--draws", "1"), ("--gas: species = .Xe.: must be one of", "--gas", "Xe"),
    ("--gas N2=0.5: sum of fractions = 0.5: must be 1", "--gas", "N2=0.5"), ("--tank-gas N2=x: 'N2=x' is not NAME=FRACTION", "--tank-gas", "N2=x"),
    ("--method", "--method", "triple"), ("--noise", "--noise", "none"), ("--draws: is empty", "--draws", "''")])
def test_identify_bad_options(data, says, option, value):
    refused(says, f"identify data.csv {re.sub(f'{option} [^ ]+', '', BASE)} --out none.csv {option} {value}")


def test_identify_bad_input(data):
    refused(r"gasjet: --initial-temperature \[K\] = 100: must be 200 to 6000$",
            f"identify data.csv {BASE.replace('constant', 'nasa7')} --initial-temperature 100 --out none.csv")
    refused("--out .*would overwrite", f"identify data.csv {BASE} --out data.csv")
    refused("not writable", f"identify data.csv {BASE} --out nowhere/none.csv")
    refused("no such file", f"identify missing.csv {BASE} --out none.csv")
    refused("required", "identify data.csv --out none.csv")
    # A hundredth of the mass: no gas is that hot.
    expect(3, "do not fit", "identify data.csv --method average --volume 0.06 --mass 0.0008 --gas N2 --out none.csv")
    assert not os.path.exists("none.csv")
