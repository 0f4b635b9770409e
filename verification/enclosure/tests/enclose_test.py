# SPDX-License-Identifier: Apache-2.0
"""`gasjet enclose`, in a build that has it."""

from fractions import Fraction

from bounds_test import GASJET, gasjet, read

import tubes


def test_bounds_computed_anew_meet_shipped_ones():
    for name in ("rigid_tank", "tank_blowdown", "tank_fixed_steps", "tank_steps"):
        new = read(tubes.enclose(GASJET, name))
        old = read((tubes.FOLDER / f"{name}.csv").read_text(encoding="utf-8"))
        assert [row["time_s"] for row in new] == [row["time_s"] for row in old]
        for mine, shipped in zip(new, old):
            for column in mine:
                if column.endswith("_lower"):
                    upper = column.replace("_lower", "_upper")
                    low, high = Fraction(mine[column]), Fraction(mine[upper])
                    assert low <= Fraction(shipped[upper]) and Fraction(shipped[column]) <= high, (name, column, mine)


def test_width_is_met():
    for width in (1e-6, 1e-18):
        done = gasjet("enclose", "cases/tank_blowdown.toml", "--width", width, "--times", "0:0.35:0.05")
        assert done.returncode == 0, done.stderr
        for row in read(done.stdout):
            low, high = Fraction(row["pressure_Pa_lower"]), Fraction(row["pressure_Pa_upper"])
            assert low <= high <= low * (1 + Fraction(width)), row


def test_literal_law_comes_to_rest():
    done = gasjet("enclose", "cases/tank_blowdown.toml", "--literal", "--times", "0.35")
    assert done.returncode == 0, done.stderr
    row = read(done.stdout)[0]
    assert Fraction(row["pressure_Pa_lower"]) <= 101325 <= Fraction(row["pressure_Pa_upper"])


def test_refusals_say_why():
    for words, code, said in (
        (["cases/driver_bag.toml"], 2, "has a bag; only tanks are enclosed"),
        (["cases/tank_triggers.toml"], 2, "depends on a sensor of pressure"),
        (["cases/tank_blowdown.toml", "--width", "1"], 2, "1e-25 to 0.1"),
        (["cases/tank_blowdown.toml", "--times", "1:0:1"], 2, "--times 1:0:1"),
        (["cases/tank_stiff.toml", "--longest", "0.1"], 3, "computing takes longer than 0.1 s"),
    ):
        done = gasjet("enclose", *words)
        assert done.returncode == code and said in done.stderr, done.stdout + done.stderr
