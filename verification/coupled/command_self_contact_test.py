# SPDX-License-Identifier: Apache-2.0
"""Self-contact as a user meets it: check, run, and starts whose layers cross."""
import re

import pytest
from command import as_json, expect, has, load, ok, read, refused, table, write

SPHERE = "cases/sphere_inflation.toml"
FOLDED = "cases/driver_folded.toml"
# Two discs, laid on each other by the pressure outside, and let go again.
PRESSED = ["[scene]", 'name = "pressed"', "end_time = 0.06", "[fabric]", "young_modulus = 60.0e6", "poisson_ratio = 0.3", "density = 620.0",
           "thickness = 0.5e-3", "[membrane]", 'mesh = { generator = "driver", radius = 0.3, rings = 6, vent_ring = 4 }', "mass_damping = 200.0",
           "overpressure = { time = [0.0, 0.01, 0.03, 0.04], value = [0.0, -500.0, -500.0, 500.0] }", 'fixed_panels = ["attachment"]',
           "self_contact = { thickness = 0.01, stiffness = 1.0e5 }", "[time]", "safety = 0.3"]


def test_self_contact_check():
    write("pressed.toml", *PRESSED)
    assert "self-contact: 1e+05 N/m3 for layers closer than 0.01 m" in ok("check pressed.toml").out
    start = as_json("check pressed.toml --format json")["derived"]["self_contact"]
    assert start["limited_nodes"] == 0 and start["stiffness_N_m3"] == 1e5 and 0 < start["share_of_fabric"] < 0.1 and start["critical_step_s"] > 0
    # Folded layers start closer than the thickness.
    text = ok(f"check {FOLDED}").out
    nodes, gap = re.search(r"(\d+) nodes start closer than that to another layer, the closest at ([0-9.]+) m", text).groups()
    folded = as_json(f"check {FOLDED} --format json")["derived"]["self_contact"]
    assert folded["limited_nodes"] == int(nodes) > 1000 and folded["smallest_gap_m"] == pytest.approx(float(gap), rel=1e-2)
    assert "self_contact" not in as_json(f"check {SPHERE} --format json")["derived"]
    # By default twenty times that of the fabric, whatever the elements' shares of it.
    share = as_json(f"check {SPHERE} --set membrane.self_contact.thickness=1e-3 --format json")["derived"]["self_contact"]["share_of_fabric"]
    assert 10 < share < 40
    # Friction stiffens the contact, too; the share is that of both.
    rough = as_json(f"check {SPHERE} --set membrane.self_contact.thickness=1e-3 --set membrane.self_contact.friction=0.75 --format json")
    assert rough["derived"]["self_contact"]["share_of_fabric"] == pytest.approx(share, rel=1e-12)


def test_self_contact_run():
    write("pressed.toml", *PRESSED)
    ok("run pressed.toml --out pressed --quiet")
    summary, rows = load("pressed/summary.json"), table("pressed/history.csv")
    seen = summary["self_contact"]
    assert summary["warnings"] == [] and summary["self_intersection"]["largest"]["layers"] == 0
    assert seen["most_contacts"] >= max(float(row["self_contacts"]) for row in rows) > 0
    assert seen["smallest_gap_m"] <= min(float(row["self_gap_m"]) for row in rows) < 0.01
    assert 0.01 < seen["most_contacts_s"] < 0.04 and seen["limited_nodes_at_start"] == seen["limited_nodes_at_end"] == 0
    assert "one_room_from_s" not in seen, "there is no gas in any room"
    assert summary["counters"]["self_contact_looks"] > 0
    shares = summary["dt"]["shares"]
    assert shares["self_contact"] > 0 and shares["contact"] == 0 and summary["dt"]["limited_by_contact"] >= 0
    assert sum(shares.values()) == pytest.approx(1, abs=1e-9)
    assert max(float(row["self_contact_J"]) for row in table("pressed/energy.csv")) > 0.1


def test_self_contact_of_a_fixed_step():
    write("pressed.toml", *PRESSED[:-2])
    ok("run pressed.toml --out given --quiet --set time.step=2e-5 --set scene.end_time=0.02")
    assert 0 < load("given/summary.json")["dt"]["largest_approach"] < 0.3
    expect(3, r"is unstable: the limit is .*self-contact [0-9]+ %", "run pressed.toml --out stiff --quiet --set time.step=2e-5",
           "--set", "membrane.self_contact.stiffness=1e9")


def test_self_contact_crossed_start():
    ok(f"mesh case {SPHERE} --out design.obj")
    nodes = [line.split() for line in read("design.obj").splitlines()]
    # The two halves have passed through each other.
    write("start.obj", *(f"v {float(x[1]) - (0.04 if float(x[1]) > 0 else -0.04)} {x[2]} {x[3]}" if x and x[0] == "v" else " ".join(x) for x in nodes))
    write("crossed.toml", *(line for line in PRESSED if "mesh" not in line and "overp" not in line and "fixed" not in line),
          '[membrane.mesh]', 'file = "design.obj"', 'initial_file = "start.obj"', "[gas]", "initial = { composition = { N2 = 1.0 } }")
    said = r"crossed.toml:\d+:\d+: membrane.self_contact: layers cross at the start, \d+ pairs of elements .* near \[.*\] m, elements .*counted twice"
    for command in ("check crossed.toml", "run crossed.toml --out none"):
        refused(said, command)
    refused(r"perturbation.*up to 1e-05 m; or pull", "check crossed.toml --set membrane.perturbation=1e-5")
    expect(0, "passes through itself at the start", "check crossed.toml --unset membrane.self_contact")
    assert has("crossed.toml", "self_contact")


def test_self_contact_of_displaced_layers():
    write("near.toml", *(line.replace("radius = 0.3", "radius = 0.3, opening = 4e-4") for line in PRESSED))
    runs = "ensemble near.toml --runs 2 --set scene.end_time=1e-4"
    expect(3, "(?s)self_contact: layers cross at the start, .*: displaced by up to 0.001 m; lower the amplitude", f"{runs} --amplitude 1e-3 --out crossed")
    ok(f"{runs} --amplitude 1e-5 --out apart")
