# SPDX-License-Identifier: Apache-2.0
"""`gasjet enclose`, in a build that has it."""

import json
from fractions import Fraction

import tubes
from bounds_test import GASJET, gasjet
from tubes import read


def test_bounds_computed_anew_meet_shipped_ones():
    for name in tubes.TUBES:
        tubes.expect_shipped(GASJET, name)


def test_width_is_met():
    for width in (1e-6, 1e-18):
        done = gasjet("enclose", "cases/tank_blowdown.toml", "--width", width, "--times", "0:0.2:0.05")
        assert done.returncode == 0, done.stderr
        for row in read(done.stdout):
            low, high = Fraction(row["pressure_Pa_lower"]), Fraction(row["pressure_Pa_upper"])
            assert low <= high <= low * (1 + Fraction(width)), row


def test_literal_law_comes_to_rest():
    done = gasjet("enclose", "cases/tank_blowdown.toml", "--literal", "--times", "0.35")
    assert done.returncode == 0, done.stderr
    row = read(done.stdout)[0]
    assert Fraction(row["pressure_Pa_lower"]) <= 101325 <= Fraction(row["pressure_Pa_upper"])


def test_flow_that_sets_in_keeps_to_the_tolerance(tmp_path):
    """Flow that sets in at p_a passes the laminar range within microseconds; sub-steps that miss it are off by 2e-10."""
    scene = ["cases/rigid_tank.toml", "--set", "vent=[{area=1e-3}]", "--set", "inflator.0.mass_flow=0.01", "--set", "scene.end_time=0.01"]
    small = ["cases/rigid_tank.toml"]  # balanced 40 Pa above p_a, far beyond the laminar range
    for setting in ("vent=[{area=1e-6}]", "inflator.0.mass_flow=1e-5", "inflator.0.temperature=293.15", "tank.volume=1e-3", "scene.end_time=0.01"):
        small += ["--set", setting]
    for tank in (scene, small):
        expect_tight_runs(tmp_path, tank)


def expect_tight_runs(tmp_path, scene):
    proved = gasjet("enclose", *scene, "--times", "0.001:0.01:0.001")
    assert proved.returncode == 0, proved.stderr
    for method in ("dormand_prince", "runge_kutta", "rosenbrock"):
        options = ["--set", f'time.gas_method="{method}"', "--set", "time.gas_tolerance=1e-13", "--quiet", "--out", str(tmp_path / method)]
        done = gasjet("run", *scene, *options)
        assert done.returncode == 0, done.stderr
        rows = read((tmp_path / method / "history.csv").read_text())
        for bounds in read(proved.stdout):
            mass = next(float(row["gas_mass_kg"]) for row in rows if abs(float(row["time_s"]) - float(bounds["time_s"])) < 1e-9)
            assert abs(mass / float(bounds["gas_mass_kg_lower"]) - 1) < 5e-12, (method, bounds["time_s"], mass)


def test_vent_that_a_sensor_opens(tmp_path):
    scene = ["cases/rigid_tank.toml", "--set", 'sensor=[{name="s",time=0.02}]', "--set", 'vent=[{area=1e-3,trigger="s"}]']
    (tmp_path / "bounds.csv").write_text(gasjet("enclose", *scene).stdout, encoding="utf-8")
    done = gasjet("run", *scene, "--quiet", "--out", tmp_path / "run")
    assert done.returncode == 0, done.stderr
    done = gasjet("compare", tmp_path / "run/history.csv", tmp_path / "bounds.csv", "--enclosure", "--tolerance", "1e-9")
    assert done.returncode == 0, done.stdout + done.stderr


def test_refusals_say_why():
    for words, code, said in (
        (["cases/driver_bag.toml"], 2, "has a bag; only tanks are enclosed"),
        (["cases/tank_blowdown.toml", "--width", "1"], 2, "1e-25 to 0.1"),
        (["cases/tank_blowdown.toml", "--times", "1:0:1"], 2, "--times 1:0:1"),
        (["cases/tank_stiff.toml", "--longest", "0.1"], 3, "computing takes longer than 0.1 s"),
    ):
        done = gasjet("enclose", *words)
        assert done.returncode == code and said in done.stderr, done.stdout + done.stderr


def test_closed_forms_have_bounds(tmp_path):
    """The printed form is inside its bounds to one unit of its 13 or 15 digits; bounds are decimals that enclose known numbers."""
    for words, tolerance in ((["blowdown", "--times", "0:0.35:0.01"], 1e-12), (["tank_fill", "--set", "V=0.05"], 1e-14)):
        mine, proved = gasjet("exact", *words), gasjet("exact", *words, "--proved")
        assert proved.returncode == 0, proved.stderr
        (tmp_path / "mine.csv").write_text(mine.stdout, encoding="utf-8")
        (tmp_path / "bounds.csv").write_text(proved.stdout, encoding="utf-8")
        done = gasjet("compare", tmp_path / "mine.csv", tmp_path / "bounds.csv", "--enclosure", "--tolerance", tolerance)
        assert done.returncode == 0, done.stdout + done.stderr
    # j_01 / (2 pi) with 1 m of radius and 1 m/s: j_01 = 2.404825557695772768621631879... (NIST DLMF 10.21)
    done = gasjet("exact", "drum_frequency", "--proved", "--format", "json", *"--set N=1 --set rho_h=1 --set a=1".split())
    low, high = (Fraction(text) for text in json.loads(done.stdout)["rows"][0][0])
    pi = Fraction("3.1415926535897932384626433832795")
    assert low < Fraction("2.404825557695772768621631879") / (2 * pi) < high < low * (1 + Fraction("1e-20")), done.stdout


def test_forms_without_bounds_say_why():
    for words, said in (
        (["clamped_disc"], "exact clamped_disc: --proved: a boundary value problem"),
        (["tank_fill", "--set", "volume=-1"], "volume = -1"),
        (["--list", "--format", "markdown"], "--format markdown: --list --proved prints text or json"),
        (["--list", "blowdown"], "leave out NAME"),
    ):
        done = gasjet("exact", *words, "--proved")
        assert done.returncode == 2 and said in done.stderr, done.stdout + done.stderr
    assert "# not proved: period_s: an integral" in gasjet("exact", "gas_spring", "--proved").stdout
    assert "hencky_membrane: not proved: a power series" in gasjet("exact", "--list", "--proved").stdout
    names = json.loads(gasjet("exact", "--list", "--proved", "--format", "json").stdout)["closed_forms"]
    assert {"name": "tank_fill", "proved": True, "reason": ""} in names and len(names) > 90


def test_small_numbers_zeros_and_many_divisions_have_bounds():
    def bounds(*words):
        done = gasjet("exact", *words, "--proved", "--format", "json")
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout)["rows"]

    # Lowest order in the force: s = 2 F V/(gamma p_a S^2).
    (_, (low, high), *_), = bounds("gas_spring", "--times", "1e-6")
    expected = Fraction("2e-6") * Fraction("0.009") / (Fraction("1.4") * 101325 * Fraction("0.0009"))
    assert expected * (1 - Fraction("1e-8")) < Fraction(low) < Fraction(high) < expected, (low, high)
    assert bounds("orifice_flow", "--set", "area=1e-300", "--times", "1e3")[0][1][0].startswith("3.184055988300788")
    assert bounds("mylar_balloon", "--times", "1e-100")[0][3][0].startswith("1.2185242161185697")
    assert bounds("pendulum_swing", "--times", "0")[0][2] == ["-1e-300", "1e-300"]
    assert bounds("pendulum_swing", "--set", "theta0=0", "--times", "1") == [[1.0, ["0", "0"], ["0", "0"]]]
    assert len(bounds("square_deflection", "--times", "4096")) == 1


def test_wide_bounds_are_named_beside_the_others():
    done = gasjet("exact", "sphere_fill", "--proved", "--times", "0:1e4:1e4")
    assert done.returncode == 3 and "wider than 1e-20 of the value" in done.stderr, done.stdout + done.stderr
    assert "where inflow_mass_kg is" in done.stdout and len(done.stdout.split("inflow_mass_kg,")[1].splitlines()) == 3
