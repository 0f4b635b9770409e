# SPDX-License-Identifier: Apache-2.0
"""Accelerations behind channel filters."""
import math
import os

import pytest
from command import change, expect, numbers, refused, write_table

CASE = "cases/pendulum_pulse.toml"
INTERVAL, FREQUENCY = 1e-5, 1000.0  # [s], [Hz]; the cut-off of CFC 600


def test_channels():
    # A sine of a moment on a pendulum without gravity: each column has the gain of its class.
    write_table("sine.csv", {"time_s": [n * INTERVAL for n in range(10001)],
                             "moment": [100 * math.sin(2 * math.pi * FREQUENCY * n * INTERVAL) for n in range(10001)]})
    change(CASE, (r"(?s)^\[pendulum.driving_moment\].*?(?=^\[time\])", ""),
           ("^impactor_radius.*", r'\g<0>\ndriving_moment = { file = "sine.csv", column = "moment" }'), to="sine.toml")
    expect(0, "done", "run sine.toml --set scene.gravity=[0,0,0] --set scene.end_time=0.1 --set time.step=1e-5 --set output.history_every=1e-5"
           " --set output.channel_classes=[1000,60,600,180] --out out")
    history, filtered = numbers("out/history.csv"), numbers("out/accelerations.csv")
    classes = (60, 180, 600, 1000)
    assert list(filtered) == ["time_s", *(f"pendulum_cg_acceleration_cfc{c}_m_s2" for c in classes)]
    assert filtered["time_s"] == history["time_s"]
    middle = slice(len(history["time_s"]) // 4, 3 * len(history["time_s"]) // 4)  # the ends have died away there
    size = max(map(abs, history["pendulum_cg_tangential_m_s2"][middle]))
    for channel_class in classes:
        # SAE J211-1: 1/(1 + (f/f_c)^4) with f_c = 2.0775 CFC, where the bilinear transform bends the axis: tan(pi f T) for f.
        bent = math.tan(math.pi * FREQUENCY * INTERVAL) / math.tan(math.pi * 2.0775 * channel_class * INTERVAL)
        gain = max(filtered[f"pendulum_cg_acceleration_cfc{channel_class}_m_s2"][middle]) / size
        # Samples miss a peak by (pi f T)^2/2 at most: 5e-4 of both.
        assert gain == pytest.approx(1 / (1 + bent**4), rel=1e-3)
        if channel_class == 600:  # -3 dB at CFC/0.6
            assert gain == pytest.approx(math.sqrt(0.5), abs=1e-3)
    # compare makes the same columns of the components, and says when rows are too few.
    name = "pendulum_cg_acceleration_cfc600_m_s2"
    write_table("reference.csv", {**filtered, name + "_band": [1e-6] * len(filtered["time_s"])})
    expect(0, "cfc600.*inside", f"compare out/history.csv reference.csv --columns {name}")
    write_table("coarse.csv", {column: values[::40] for column, values in history.items()})
    expect(4, "mine has rows 0.0004 s apart, CFC 600 needs 0.000166 s or less", f"compare coarse.csv reference.csv --columns {name}")
    # A run that asks for none has no such file, and takes one of the run before away.
    expect(0, "done", f"run {CASE} --out out")
    assert not os.path.exists("out/accelerations.csv")
    # Without a step of its own, a bag steps as fast as the class needs.
    expect(0, r"channel_classes = \[1000\]", "check cases/ball_impact.toml --set output.channel_classes=[1000]")
    for pattern, setting in (("has 100, allowed: an array of 60, 180, 600, 1000", "[100]"), ("has a string, allowed: an array of", '["60"]'),
                             ("is a number, allowed: an array of", "60"), ("has 60 twice, allowed: once", "[60,60]")):
        refused(f"output.channel_classes: {pattern}", f"check {CASE} --set", f"output.channel_classes={setting}")
    refused("output.channel_classes: 1000 needs steps of 0.0001 s or less, time.step is 0.0002 s",
            f"check {CASE} --set time.step=2e-4 --set output.channel_classes=[60,1000]")
    refused("output.channel_classes: the scene has no impactor", "check cases/sphere_inflation.toml --set output.channel_classes=[60]")
