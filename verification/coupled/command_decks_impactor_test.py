# SPDX-License-Identifier: Apache-2.0
"""Impactors in decks of other programs: what the decks say, read by columns, against what the cases say."""
import json
import math
import tomllib
from pathlib import Path

import pytest
from command import ROOT, has, numbers, ok, refused
from deck_impactor import FILES, cross, read_impactor, unit
from small_decks import lsdyna, row, taken

forms = pytest.mark.parametrize("form", FILES)
BAG = "cases/guided_headform.toml"


def case(name):
    return tomllib.loads((ROOT / f"cases/{name}.toml").read_text(encoding="utf-8"))


def inline(value):
    """A value as TOML in one line."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key} = {inline(item)}" for key, item in value.items()) + "}"
    return "[" + ", ".join(map(inline, value)) + "]" if isinstance(value, list) else json.dumps(value)


def dot(a, b):
    return sum(map(float.__mul__, a, b))


OBLIQUE = {"direction": [3.0, -1.0, 0.5], "type": "rail", "mass": 20.0, "velocity": 5.0}
STOPPED = OBLIQUE | {"force": {"time": [0.01, 0.06], "value": [-900.0, -300.0]}, "stop": {"at": 0.1, "stiffness": 2.0e5},
                     "spring": {"stiffness": 4.0e3, "damping": 30.0, "at": 0.02}}
ELLIPSOID = {"type": "ellipsoid", "half_axes": [0.075, 0.098, 0.115]}
PULSE = {"time": [0.0, 0.03, 0.08], "value": [[0.0, 0.0, 0.0], [-150.0, 0.0, 40.0], [0.0, 0.0, 9.0]]}
SCENES = {  # what each has of its own; the bag is that of the guided headform
    "guided_headform": case("guided_headform"),
    "sled_pulse": case("sled_pulse"),
    "rail_stop": {"scene": {"gravity": PULSE}, "impactor": {"centre": [0.6, 0.0, 0.0], "shape": case("rail_stop")["impactor"]["shape"], "motion": STOPPED}},
    "free_headform": {"scene": {}, "impactor": {
        "centre": [0.55, 0.02, 0.06], "axis": [0.2, 0.4, 1.0], "second_axis": [1.0, 0.3, 0.0], "shape": case("free_headform")["impactor"]["shape"],
        "motion": {"type": "free", "mass": 4.54, "velocity": [-6.0, 0.5, 0.25], "angular_velocity": [3.0, -20.0, 7.0],
                   "inertia": [0.022, 0.018, 0.015, 0.002, -0.001, 0.003]}}},
    "pendulum": {"scene": {"gravity": [0.0, 0.0, -9.81]}, "impactor": {
        "axis": [0.3, 0.1, 1.0], "second_axis": [1.0, 0.0, 0.0], "shape": ELLIPSOID,
        "motion": {"type": "pendulum", "pivot": [0.5, 0.0, 0.9], "axis": [0.0, -2.0, 0.0], "rest_direction": [0.0, 0.0, -1.0], "mass": 5.0,
                   "inertia_cg": 0.1, "cg_distance": 0.8, "impactor_distance": 0.88, "initial_angle": -0.1, "initial_angular_velocity": 3.0,
                   "driving_moment": {"time": [0.0, 0.05], "value": [4.0, 0.0]}}}},
}


def words(scene):
    """Settings of the command."""
    settings = {"impactor": scene["impactor"], "scene.gravity": scene["scene"].get("gravity", [0.0, 0.0, 0.0])}
    return [word for key, value in settings.items() for word in ("--set", f"{key}={inline(value)}")]


def exported(name, form, units="t-mm-s", more=()):
    out = f"{name}.{form}.{units}"
    ok(f"export {BAG} --format {form} --units {units} --out {out}", *words(SCENES[name]), *more)
    return out, read_impactor(form, out, units)


def value_at(points, t):
    """Of a curve, straight between its points, and zero outside of them."""
    for (a, low), (b, high) in zip(points, points[1:]):
        if a <= t <= b:
            return low + (high - low) * (t - a) / (b - a)
    return 0.0


def turned(vector, axis, angle):
    along = dot(axis, vector)
    side = cross(axis, vector)
    return [math.cos(angle) * v + math.sin(angle) * s + (1 - math.cos(angle)) * along * a for v, s, a in zip(vector, side, axis)]


def body_axes(impactor):
    """The body's z is along its axis, or the rail; without a second axis its x is any, as all shapes but one are round about z."""
    z = unit(impactor.get("axis", impactor["motion"].get("direction", [0.0, 0.0, 1.0])))
    second = impactor.get("second_axis", [float(abs(c) == min(map(abs, z))) for c in z])
    x = unit([a - dot(second, z) * c for a, c in zip(second, z)])
    return [x, cross(z, x), z]


def expected(impactor):
    """Mass, centres, inertia, speeds and axes of the body, of the case's own numbers."""
    motion = impactor["motion"]
    axes = body_axes(impactor)
    e = {"mass": motion["mass"], "axes": axes, "spin": [0.0] * 3}
    if motion["type"] == "pendulum":
        axis, angle = unit(motion["axis"]), motion["initial_angle"]
        arm = turned(motion["rest_direction"], axis, angle)
        e["cg"] = [p + motion["cg_distance"] * a for p, a in zip(motion["pivot"], arm)]
        e["centre"] = [p + motion["impactor_distance"] * a for p, a in zip(motion["pivot"], arm)]
        e["spin"] = [motion["initial_angular_velocity"] * a for a in axis]
        e["velocity"] = [motion["cg_distance"] * v for v in cross(e["spin"], arm)]
        e["axes"] = [turned(v, axis, angle) for v in axes]
        e["inertia"] = [[motion["inertia_cg"] * (i == j) for j in range(3)] for i in range(3)]
        return e
    e["cg"] = e["centre"] = impactor["centre"]
    if motion["type"] == "rail":
        e["velocity"] = [motion.get("velocity", 0.0) * d for d in unit(motion["direction"])]
        return e
    xx, yy, zz, xy, yz, zx = motion["inertia"]
    own = [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]]
    e["inertia"] = [[sum(axes[a][i] * own[a][b] * axes[b][j] for a in range(3) for b in range(3)) for j in range(3)] for i in range(3)]
    return e | {"velocity": motion["velocity"], "spin": motion["angular_velocity"]}


def near(found, wanted, scale):
    """Fields of ten columns hold five digits."""
    if isinstance(wanted, list):
        return len(found) == len(wanted) and all(near(a, b, scale) for a, b in zip(found, wanted))
    return abs(found - wanted) <= 2e-5 * scale


@forms
@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize("units", ["t-mm-s", "kg-mm-ms"])
def test_decks_impactor_body(form, name, units):
    impactor = SCENES[name]["impactor"]
    motion, e, (out, deck) = impactor["motion"], expected(SCENES[name]["impactor"]), exported(name, form, units)
    assert near(deck["mass"], e["mass"], e["mass"]) and near(deck["cg"], e["cg"], 1.0)
    assert near(deck["velocity"], e["velocity"], 10.0) and near(deck["spin"], e["spin"], 20.0)
    if "inertia" in e:
        assert near(deck["inertia"], e["inertia"], 0.02)
    assert deck["held"] == ([0, 1, 1, 1, 1, 1] if motion["type"] == "rail" else [0] * 6)
    if motion["type"] == "rail":
        assert near(deck["axes"][0], unit(motion["direction"]), 1.0)
    drive, kind = motion.get("force", motion.get("driving_moment")), "force" if motion["type"] == "rail" else "moment"
    assert (deck["load"] is None) == (drive is None)
    if drive:
        points, found, way = deck["load"]
        assert found == kind and near(way, unit(motion["direction"] if kind == "force" else motion["axis"]), 1.0)
        for t in (0.0, 0.003, 0.02, 0.0449, 0.07, 0.085):
            assert abs(value_at(points, t) - value_at(list(zip(drive["time"], drive["value"])), t)) < 1e-9 * max(map(abs, drive["value"]))
    gravity = SCENES[name]["scene"].get("gravity", [0.0] * 3)
    for axis in range(3):
        given = list(zip(gravity["time"], [v[axis] for v in gravity["value"]])) if isinstance(gravity, dict) else [(-1.0, gravity[axis]), (1.0, gravity[axis])]
        for t in (0.0, 0.01, 0.05, 0.079, 0.085):
            assert abs(value_at(deck["gravity"][axis], t) - value_at(given, t)) <= 2e-4 * max(abs(v) for _, v in given)


# Half of the width along a direction, and the volume, of a shape less a gap. That of an ellipsoid less a gap is inside the
# ellipsoid with half axes less the gap.
def support(shape, n, gap):
    if shape["type"] == "ellipsoid":
        return math.hypot(*(a * c for a, c in zip(shape["half_axes"], n))) - gap
    core = {"sphere": 0.0, "cylinder": shape.get("half_length", 0.0) * abs(n[2]), "disc": shape.get("radius", 0.0) * math.hypot(n[0], n[1])}
    return core[shape["type"]] + (shape["rim_radius"] if shape["type"] == "disc" else shape["radius"]) - gap


def volume(shape, gap):
    if shape["type"] == "ellipsoid":
        return 4 / 3 * math.pi * math.prod(a - gap for a in shape["half_axes"])
    r = (shape["rim_radius"] if shape["type"] == "disc" else shape["radius"]) - gap
    ball = 4 / 3 * math.pi * r**3
    if shape["type"] == "disc":  # a flat disc and all within r, by Steiner's formula
        R = shape["radius"]
        return 2 * math.pi * R**2 * r + math.pi**2 * R * r**2 + ball
    return ball + 2 * math.pi * r**2 * shape.get("half_length", 0.0)


@forms
@pytest.mark.parametrize("name", SCENES)
def test_decks_impactor_surface(form, name):
    """Closed, outward, inside the shape by the gap within what 32 edges around leave, and where the body is."""
    impactor = SCENES[name]["impactor"]
    shape, e, (_, deck) = impactor["shape"], expected(SCENES[name]["impactor"]), exported(name, form)
    edges = [(face[i], face[(i + 1) % 3]) for face in deck["faces"] for i in range(3)]
    assert len(set(edges)) == len(edges) and set(edges) == {(b, a) for a, b in edges}
    assert len(deck["x"]) - len(edges) // 2 + len(deck["faces"]) == 2
    own = [[dot([a - c for a, c in zip(x, e["centre"])], axis) for axis in e["axes"]] for x in deck["x"]]
    inside = sum(dot(own[a], cross(own[b], own[c])) for a, b, c in deck["faces"]) / 6
    # 1 - sin(t)/t, t = pi/16, is 0.64 %: once around and once along the outline.
    assert 0.98 < inside / volume(shape, deck["gap"]) <= 1.0 + 1e-4
    reach = max(support(shape, n, 0.0) for n in ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]))
    assert 0.0 < deck["gap"] <= 0.02 * reach
    for k in range(60):  # evenly over a sphere; an edge takes 1 - cos(pi/32)^2 at most
        z, turn = 1 - (2 * k + 1) / 60, 2.4 * k
        n = [math.sqrt(1 - z * z) * math.cos(turn), math.sqrt(1 - z * z) * math.sin(turn), z]
        short = support(shape, n, deck["gap"]) - max(dot(n, x) for x in own)
        assert -2e-5 * reach <= short <= 0.01 * reach


def moved(deck, end, step):
    """Displacements along the rail by the deck alone, by the midpoint rule: no step sees a jump at its end."""
    way, mass = deck["axes"][0], deck["mass"]

    def rate(t, s, v):
        force = value_at(deck["load"][0], t) * dot(way, deck["load"][2]) + mass * sum(value_at(deck["gravity"][i], t) * way[i] for i in range(3))
        for points, damping, fixed in deck["springs"]:  # a spring pulls its ends together
            line = [c + s * w - f for c, w, f in zip(deck["cg"], way, fixed)]
            longer = math.hypot(*line) - math.dist(deck["cg"], fixed)
            force -= (value_at(points, longer) + damping * v) * dot(unit(line), way)
        return v, force / mass

    t, s, v, found = 0.0, 0.0, dot(deck["velocity"], way), [0.0]
    while len(found) <= round(end / step):
        speed, push = rate(t, s, v)
        speed, push = rate(t + step / 2, s + step / 2 * speed, v + step / 2 * push)
        s, v = s + step * speed, v + step * push
        t += step
        found.append(s)
    return found


@forms
def test_decks_impactor_motion(form):
    """Springs, stop, force and gravity of the deck move the body as the run without a bag does."""
    deck = exported("rail_stop", form)[1]
    assert len(deck["springs"]) == (2 if form == "radioss" else 3)
    ok("run cases/rail_stop.toml --out run", *words(SCENES["rail_stop"]))
    run = numbers("run/history.csv")
    step = run["time_s"][1]
    mine = moved(deck, run["time_s"][-1], step)
    assert len(mine) == len(run["time_s"]) and max(run["impactor_displacement_m"]) > 0.11 > 0.05 > run["impactor_displacement_m"][-1]
    # In the stop, half a turn at 100 rad/s, the midpoint rule is off by pi (100 * 1e-4)^2/6 = 5e-5, which 3 m/s carry on for 0.05 s.
    assert max(abs(a - b) for a, b in zip(mine, run["impactor_displacement_m"])) < 1e-5


@forms
def test_decks_impactor_notes(form):
    """What a deck lacks is a note with its number; what it has is not lost."""
    out, _ = exported("rail_stop", form, more=("--set", "impactor.motion.stop.damping=200.0"))
    assert has(f"{out}/export.md", r"`impactor.motion.stop.damping`: 200(\.0)? has no counterpart: the stop is a spring alone")
    assert has(f"{out}/export.md", "`impactor.shape`: the surface is made of 1088 flat triangles")
    assert not has(f"{out}/export.md", "by hand")
    assert not has(f"{exported('pendulum', form)[0]}/export.md", "by hand")


@forms
def test_decks_gravity_read_back(form):
    """Gravity over time is that of the case again, and its jumps stay."""
    out, _ = exported("rail_stop", form)
    ok(f"import {out}/{FILES[form]} --out back")
    (path,) = Path("back").glob("*.toml")
    table = tomllib.loads(path.read_text())["scene"]["gravity"]
    for axis in range(3):
        for t in [i * 1e-3 for i in range(90)]:
            wanted = value_at(list(zip(PULSE["time"], [row[axis] for row in PULSE["value"]])), t)
            assert abs(value_at(list(zip(table["time"], [row[axis] for row in table["value"]])), t) - wanted) < 0.05  # a jump in 1e-7 s


def test_decks_gravity_jump():
    curve = "*DEFINE_CURVE\n" + row(5) + "".join(row(*knot, width=20) for knot in ((0.0, 0.0), (5.0, 2.0), (5.0, 1.0), (8.0, 1.0)))
    scene = tomllib.loads(taken(lsdyna(more=curve + "*LOAD_BODY_Z\n" + row(5, 0.00981))))["scene"]["gravity"]
    assert scene["time"] == pytest.approx([0.0, 5e-3, 5e-3, 8e-3, 20e-3]) and [g[:2] for g in scene["value"]] == [[0.0, 0.0]] * 5
    assert [g[2] for g in scene["value"]] == pytest.approx([0.0, -19.62, -9.81, -9.81, -9.81])
    flat = "*DEFINE_CURVE\n" + row(5) + row(0.0, 1.0, width=20) + row(5.0, 1.0, width=20)
    scene = tomllib.loads(taken(lsdyna(more=flat + "*LOAD_BODY_Z\n" + row(5, 0.00981)), out="flat"))["scene"]["gravity"]
    assert scene == pytest.approx([0.0, 0.0, -9.81])


@pytest.mark.parametrize("says, more", [
    ("impactor.motion.mass: is -1", ("--set", "impactor.motion.mass=-1.0")), ("impactor.shape.radius", ("--set", "impactor.shape.radius=0.0")),
    ("unknown key", ("--set", "impactor.motion.inertia=[1.0,1.0,1.0]"))])
def test_decks_impactor_bad_input(says, more):
    refused(says, f"export {BAG} --format lsdyna --units kg-m-s --out none", *more)
