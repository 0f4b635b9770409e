# SPDX-License-Identifier: Apache-2.0
"""Runs of the shipped tanks against their proved bounds, and `gasjet compare --enclosure`."""

import os
import subprocess

import tubes

GASJET = os.environ.get("GASJET", "")


def gasjet(*words):
    return subprocess.run([GASJET, *map(str, words)], cwd=tubes.ROOT, capture_output=True, text=True)


def run(tmp_path, name, *settings):
    """History at the times of the bounds, at the tightest tolerance."""
    end = tubes.TUBES[name][0]
    words = ["time.gas_tolerance=1e-12", f"output.history_every={end / 10:.12g}", "output.streams=true", *settings]
    if name == "tank_fixed_steps":
        words.append("time.gas_method=dormand_prince")
    options = [word for setting in words for word in ("--set", setting)]
    if name == "tank_fixed_steps":
        options += ["--unset", "time.gas_step"]
    done = gasjet("run", tubes.case_of(name), *options, "--out", tmp_path / name, "--quiet")
    assert done.returncode == 0, done.stderr
    return tmp_path / name / "history.csv"


def judge(history, bounds, *words):
    return gasjet("compare", history, bounds, "--enclosure", *words)


def test_runs_lie_within_their_limit_of_proved_bounds(tmp_path):
    for name, (_, _, limit) in tubes.TUBES.items():
        done = judge(run(tmp_path, name), tubes.FOLDER / f"{name}.csv", "--tolerance", limit)
        assert done.returncode == 0, done.stdout + done.stderr
        rows = {line.split()[1] for line in done.stdout.splitlines()[2:-1]}
        assert rows == {"11"}, done.stdout


def test_change_of_1e_10_is_outside(tmp_path):
    for name, setting in (
        ("tank_blowdown", "vent.0.discharge_coefficient=0.9999999999"),
        ("tank_backflow", "gas.heat_loss.coefficient=200.00000002"),
        ("rigid_tank", "inflator.0.temperature=700.00000007"),
        ("tank_steps", "tank.volume=0.060000000006"),
    ):
        done = judge(run(tmp_path, name, setting), tubes.FOLDER / f"{name}.csv", "--tolerance", tubes.TUBES[name][2])
        assert done.returncode == 1, name + done.stdout + done.stderr


def history(tmp_path, rows):
    path = tmp_path / "mine.csv"
    path.write_text("time_s,pressure_Pa\n" + "".join(f"{t},{p!r}\n" for t, p in rows), encoding="utf-8")
    return path


def bounds(tmp_path, text="time_s,pressure_Pa_lower,pressure_Pa_upper\n0,1,1\n1,2,2.002\n2,1,1.001\n"):
    path = tmp_path / "bounds.csv"
    path.write_text(text, encoding="utf-8")
    return path


def test_verdicts_on_a_history(tmp_path):
    tube = bounds(tmp_path)
    for rows, words, code, said in (
        ([(0, 1.0), (1, 2.001), (2, 1.0)], [], 0, "inside"),
        ([(0, 1.0), (1, 2.003), (2, 1.0)], [], 1, "off by 0.001 or more at 1 s, a share of 0.0005"),
        ([(0, 1.0), (1, 2.003), (2, 1.0)], ["--tolerance", "0.002"], 0, "inside"),
        ([(0, 1.0), (1, 2.003), (2, 1.0)], ["--tolerance", "0.001"], 4, "wider than the tolerance"),
        ([(0, 1.0), (1, 2.003), (2, 1.0)], ["--tolerance", "0.0004"], 1, "outside"),
        ([(0, 1.0), (1.1, 2.001), (2, 1.0)], [], 4, "mine has no row at 1 s"),
    ):
        done = judge(history(tmp_path, rows), tube, *words)
        assert done.returncode == code and said in done.stdout, done.stdout + done.stderr


def test_refuses_what_are_no_bounds(tmp_path):
    mine = history(tmp_path, [(0, 1.0), (1, 2.0), (2, 1.0)])
    for text, said in (
        ("time_s,pressure_Pa\n0,1\n1,2\n2,1\n", "has no column NAME_lower"),
        ("time_s,pressure_Pa_lower,pressure_Pa_upper\n0,1,1\n1,2,1\n2,1,1\n", "is above its upper bound"),
        ("time_s,pressure_Pa_lower,pressure_Pa_upper\n0,1,1\n0,2,2\n2,1,1\n", "is not later"),
    ):
        done = judge(mine, bounds(tmp_path, text))
        assert done.returncode == 2 and said in done.stderr, done.stdout + done.stderr
    done = judge(bounds(tmp_path), bounds(tmp_path))
    assert done.returncode == 2 and "mine has no column of pressure_Pa; give a history as MINE" in done.stderr
    done = judge(mine, bounds(tmp_path), "--columns", "volume_m3")
    assert done.returncode == 2 and "is no column of the enclosure" in done.stderr
