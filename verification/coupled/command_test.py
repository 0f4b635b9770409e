# SPDX-License-Identifier: Apache-2.0
"""The command as a user meets it: exit codes, bad input, signals, progress, closed forms."""
import os
import re
import shutil
import signal
import subprocess
import time

import pytest
from command import (ROOT, as_json, change, expect, fits, gasjet, has, limited, line, load, ok, read, refused, same, started, stop, table,
                     until, whole_rows, write)

TANK = "cases/rigid_tank.toml"


def lost(command):
    """What cannot be printed is said, and told by the exit code."""
    with open("/dev/full", "w") as full:
        expect(3, "standard output: write failed", command, stdout=full)


def test_exit_codes():
    expect(0, "done", f"run {TANK} --out tank")
    assert all(has(f"tank/{file}") for file in ("history.csv", "energy.csv", "summary.json"))
    refused("^gasjet: .*not expected.*no-such-option", f"run {TANK} --no-such-option")
    refused("^gasjet: .*subcommand is required", "")
    refused(r"^gasjet: 'no_such_command' is not a command of gasjet, allowed: run, .*compare, .*\(see --help", "no_such_command")
    refused("^gasjet: 'nope' is not a command of mesh, allowed: driver, passenger, convert, case", "mesh nope")
    refused("no.x1bsuch. is not a command of gasjet", "", "no\x1bsuch")
    for command in (f"check {TANK}", f"check {TANK} --format json", "mesh passenger --out lost.obj", "exact tank_fill", "--version"):
        lost(command)
    expect(0, "ensemble", "--help")
    expect(0, "gasjet [0-9]", "--version")
    expect(3, "is unstable: the limit", "run cases/sphere_inflation.toml --out bound --set time.step=1e-3")
    assert load("bound/summary.json")["status"] == "failed"
    expect(3, "stage S", "run cases/sphere_inflation.toml --out unsafe --set time.step=4e-4 --set time.unsafe_step=true"
           " --set gas.initial.pressure=121325.0")
    assert whole_rows("unsafe/history.csv") > 1  # the history of the blow-up is kept
    assert not re.search("(?i)nan|inf", str([list(row.values()) for row in table("unsafe/history.csv")]))
    expect(0, "done", "run cases/tank_backflow.toml --out rest --set time.gas_method=rosenbrock --set tank.volume=1e-3"
           " --set vent.0.backflow=false --unset ambient.composition --unset ambient.composition_by --set gas.initial.temperature=200.5"
           " --set gas.initial.pressure=101325.0 --set gas.heat_loss.outside_temperature=400.0")
    for quiet in ("", "--quiet"):
        expect(0, "^warning: jet of inflator 0: the outlet pressure is below ambient",
               f"run cases/passenger_pendulum.toml --out warned --set scene.end_time=1e-4 {quiet}")
    expect(0, "2744 elements", "mesh passenger --out bag.obj")
    refused("not writable|No such|Permission|writ", "mesh passenger --out nowhere/bag.obj")


def test_fields():
    short = "run cases/sphere_inflation.toml --set scene.end_time=2e-4 --quiet --out fields"
    ok(f"{short} --set output.fields_every=1e-4")
    assert re.findall("bag_0000[0-9].vtp", read("fields/fields.pvd")) == [f"bag_0000{i}.vtp" for i in range(3)]
    assert has("fields/bag_00002.vtp", 'Name="principal_stress_Pa"')
    ok(short)
    write("fields/bag_notes.vtp")  # the user's
    write("fields/bag_00001.vtp")
    ok(short)
    assert sorted(os.listdir("fields")) == ["bag_00001.vtp", "bag_notes.vtp", "check.json", "energy.csv", "frames.bin", "gasjet.status",
                                            "history.csv", "summary.json"]
    expect(3, "bag_00001.vtp exists, but gasjet did not write it: move it away", f"{short} --set output.fields_every=1e-4")
    assert read("fields/bag_00001.vtp") == "\n"


def test_lost_output():
    os.mkdir("own")
    for name, command in (("history", "run"), ("ladder", "ladder --quantity pressure")):
        shutil.copy("cases/tank_test_curves.csv", f"own/{name}.csv")
        change("cases/tank_identified.toml", ("tank_test_curves", name), to=f"own/{name}.toml")
        refused(f"--out own: contains files, but gasjet {command.split()[0]} did not create it", f"{command} own/{name}.toml --out own")
        assert read(f"own/{name}.csv") == read("cases/tank_test_curves.csv")
    ok(f"run {TANK} --out used --quiet")
    change("cases/tank_identified.toml", ("tank_test_curves", "used/history"), to="used.toml")
    refused("--out used/history.csv: would overwrite", "run used.toml --out used", "--set", 'inflator.0.mass_flow={file="used/history.csv",column="inflow_kg_s"}')
    os.makedirs("way/summary.json")
    expect(2, "--out .*way: summary.json exists, but gasjet did not write it", f"run {TANK} --out way")
    expect(3, "jet_force_N is not a finite number", "run cases/plate_jet.toml --out inf --set inflator.0.mass_flow=1e300")
    assert not re.search("(?i)'-?(nan|inf)", str([list(row.values()) for row in table("inf/history.csv")]))
    expect(0, "too coarse", "run cases/plate_jet.toml --out coarse --set target.rows=6 --set target.columns=6")
    expect(0, "delivers nothing", f"run {TANK} --out idle --set inflator.0.start_time=5")


DEEP = "a." * 200 + "a"
SPHERE = "ensemble cases/sphere_inflation.toml --runs 2 --out out"


@pytest.mark.parametrize("pattern, command", [
    ("inflator.0.jet.radius: makes an outlet of 0 m2", "check cases/jet_bag.toml --set inflator.0.jet.radius=1e-200"),
    ("no such file", "run missing.toml --out out"),
    (r"--set vent.0.area=1e-3: the case has no \[\[vent\]\]$", f"check {TANK} --set vent.0.area=1e-3"),
    ("is a folder", "run . --out out"),
    ("unknown key", f"run {TANK} --out out --set scene.no_such_key=1"),
    ("unknown key", f"run {TANK} --out out --set no_such_table.key=1"),
    ("key.path=value", f"run {TANK} --out out --set novalue"),
    ("--out", f"run {TANK} --out /proc/no_such_folder"),
    ("--set scene.end_time=0.1,0.2", f"run {TANK} --out out --set scene.end_time=0.1,0.2"),
    ("--set a.b=1: a: unknown key", f"run {TANK} --out out --set a.b=1"),
    *((f"--set inflator.0.temperature={t}: inflator.0.temperature: .*1 to 1e5 .K.",
       f"run cases/plate_jet.toml --out out --set inflator.0.temperature={t}") for t in ("1e300", "1e-300")),
    ("ambient.temperature: .*1 to 1e5 .K.", f"check {TANK} --set ambient.temperature=1e300"),
    ("gas.initial.temperature: .*1 to 1e5 .K.", f"check {TANK} --set gas.initial.temperature=1e300"),
    ("outside_temperature: .*1 to 1e5 .K.", "check cases/tank_backflow.toml --set gas.heat_loss.coefficient=1 --set gas.heat_loss.area=1"
     " --set gas.heat_loss.outside_temperature=1e300"),
    ("scene.end_time: is 9e-10, allowed: 1e-9 or more .s.", f"check {TANK} --set scene.end_time=9e-10"),
    ("end_time: is missing", f"check {TANK} --set scene.end_time=0.01 --unset scene.end_time"),
    (r"end_time: is missing, needed: .*; is 'end_tme' meant\?", f"check {TANK} --unset scene.end_time --set scene.end_tme=1"),
    (r"volume: is missing, needed: .*; is 'voluem' meant\?", f"check {TANK} --unset tank.volume --set tank.voluem=1"),
    ("a key has more than 100 parts", f"check {TANK} --set {DEEP}=1"),
    ("a key has more than 100 parts", f"check {TANK} --set 'scene.name={{ {DEEP}=1 }}'"),
    (r"--set scene.xx+\.\.\.: scene.xx+\.\.\.: unknown key", f"check {TANK} --set scene.{'x' * 50000}=1"),
    ("tank.volume: is .*, allowed: 1e-100 to 1e100 .m³.", f"check {TANK} --set tank.volume=1e308"),
    ("tank.volume: is .*, allowed: 1e-100 to 1e100 .m³.", f"check {TANK} --set tank.volume=1e-320"),
    ("part of the path", f"run {TANK} --out out --set scene.end_time.=1"),
    ("longer than 64 MiB", "run /dev/zero --out out"),
    ("another file name", f"{SPHERE} --against cases/sphere_inflation.toml"),
    ("no such file", f"{SPHERE} --against none.toml"),
    ("the scene has none", f"{SPHERE} --against {TANK}"),
    ("sets the perturbation itself", f"{SPHERE} --set membrane.perturbation=1e-6"),
    ("--amplitude.*allowed: 1e-18 to 1e-3 m", f"{SPHERE} --amplitude nan"),
], ids=lambda value: value[:40])
def test_bad_input(pattern, command):
    refused(pattern, command)


def test_bad_input_files():
    write("syntax.toml", "[scene", 'name = "x"')
    refused("syntax.toml:1:[0-9]+: TOML syntax", "run syntax.toml --out out")
    write("file", "in the way")
    refused("--out", f"run {TANK} --out file/below")
    change(TANK, ("^volume =", "volumne ="), to="misspelt.toml")
    at = 1 + read("misspelt.toml").splitlines().index(re.search("^volumne.*", read("misspelt.toml"), re.MULTILINE).group())
    refused(rf"misspelt.toml:{at}:1: tank.volume: is missing, .*; is 'volumne' meant\?", "check misspelt.toml")
    # A misspelt table is named itself, not what its absence leaves another one without.
    for name in "ambient gas fabric membrane pendulum contact inflator vent".split():
        change("cases/passenger_pendulum.toml", (rf"^(\[+){name}\b", rf"\g<1>{name[:-1]}"), to="misspelt.toml")
        refused(rf"misspelt.toml:[0-9]+:[0-9]+: {name[:-1]}: unknown key, .*; is '{name}' meant\?", "check misspelt.toml")
    write("no_gas.toml", read("cases/pendulum_swing.toml"), "[gas]")
    refused("no_gas.toml:[0-9]+:1: gas: has no gas", "check no_gas.toml")
    write("deep.toml", DEEP + " = 1")
    refused("deep.toml:1:1: a key has more than 100 parts", "check deep.toml")
    write("vents.toml", read(TANK), *["[[vent]]"] * 1001)
    refused("vent: has 1001 tables, allowed: at most 1000", "check vents.toml")
    expect(3, "gas_step", "run cases/tank_fixed_steps.toml --set time.gas_step=1e-9 --out small_steps")
    expect(0, "warning: inflator.1 delivers nothing before end_time",
           "ensemble cases/jet_bag.toml --runs 2 --quiet --set scene.end_time=1e-4 --out warned")


def test_bad_input_sizes():
    if fits(60000):  # a build with sanitizers does not even start
        expect(3, "gasjet: mesh: out of memory: [0-9]+ MiB of addresses are in use, .* the limit of 59 MiB",
               "mesh passenger --refine 5 --out large.obj", preexec_fn=limited(60000))
        expect(3, "check: .*jet_bag.toml: membrane.*: out of memory: [0-9]+ MiB", "check cases/jet_bag.toml --set membrane.mesh.levels=7",
               preexec_fn=limited(60000))
    # Long values are not told whole.
    nines = "9" * 50000
    for command, most in ((f"check {TANK} --set a={'[' * 50000}", 600), (f"exact tank_fill --set volume={nines}", 3000), (nines, 3000),
                          (f"ladder {TANK} --quantity {nines}", 3000), (f"mesh passenger --out o.obj --set {nines}", 3000)):
        assert len(gasjet(command).said) < most


def test_interrupt(work):
    endless = started("run cases/passenger_pendulum_no_jet.toml --out stopped --set scene.end_time=100")
    until(lambda: has("stopped/history.csv"))
    assert stop(endless) == 130
    assert load("stopped/summary.json")["status"] == "interrupted"
    assert whole_rows("stopped/history.csv") > 0
    # While a file is read, here of a pipe into which nobody writes, nothing is there to keep.
    os.mkfifo("nothing.csv")
    for how in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        waits = started(f"run {TANK} --out waiting --set", f"inflator.0.mass_flow={{file='{work}/nothing.csv',column='flow'}}")
        time.sleep(0.5)
        assert stop(waits, how) in (-how, 128 + how, 130) and not os.path.exists("waiting")


def on_terminal(columns, command):
    """Lines of a run on a terminal of so many columns, whole and as they were overwritten."""
    shell = f"stty cols {columns}; " + " ".join(f"'{word}'" for word in line(command))
    subprocess.run(["script", "-qec", shell, "terminal"], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, check=True)
    return [re.sub("\x1b\\[K.*", "", text) for text in re.split("[\r\n]", read("terminal"))]


def test_progress():
    bag = "run cases/passenger_pendulum_no_jet.toml --out bar"
    narrow = [text for text in on_terminal(40, bag) if " s left," in text]
    assert narrow and max(map(len, narrow)) < 40
    short_bar = [text for text in on_terminal(100, bag) if "[#" in text]
    assert short_bar and max(map(len, short_bar)) < 100
    wide = on_terminal(140, bag)
    assert any(re.search(r"100 %, 0.0 s left, 100 ms, [0-9.]+ kPa, [0-9.]+ deg", text) for text in wide)
    percent = [int(found[1]) for text in wide if (found := re.search(r"\[[#.]{40}\] +([0-9]+) %", text))]
    assert percent == sorted(percent) and percent[-1] == 100
    target = on_terminal(140, "run cases/plate_jet.toml --out target --set scene.end_time=1 --set output.history_every=1e-4")
    assert any(re.search(r" s left, [0-9.]* ms$", text) for text in target)  # nothing has a pressure
    assert "\r" not in ok(f"{bag} --set scene.end_time=0.002").said
    assert ok(f"{bag} --set scene.end_time=0.002 --quiet").said == ""


@pytest.mark.parametrize("command", ["passenger_pendulum_no_jet.toml --set membrane.mesh.refine=1",  # enough blocks for two threads
                                     "passenger_pendulum.toml"])
def test_same_bytes(command):
    near = f"run cases/{command} --set scene.end_time=0.001 --quiet --set pendulum.pivot=[0.12,0.0,1.31] --set inflator.0.mass_flow=4.0"
    ok(f"{near} --out a")
    ok(f"{near} --out b --threads 2")
    assert has("a/summary.json", '"first_contact_s": [0-9]')
    same("a", "b", "history.csv", "energy.csv")
    costs = r'(?m)^.*"(date|wall_s|cpu_s|real_time_factor|S[0-9]+_[a-z_]+|rest)".*\n'
    assert re.sub(costs, "", read("a/summary.json")) == re.sub(costs, "", read("b/summary.json"))


def expect_known_digits():
    """Digits that rounding spoils are not printed, as of the phase after a million swings."""
    form = as_json("exact pendulum_swing --times 2e6 --format json")
    (_, angle, _), (exact, unit, _) = form["rows"][0], form["within"][0]
    assert exact == 0.0 and 1e-11 < unit < 1e-7 and abs(angle / unit - round(angle / unit)) < 1e-6, (angle, unit)
    expect(0, "^0,1.0471975512,0$", "exact pendulum_swing --times 0")
    # p - p_a is known where p rounds to p_a: Cd A sqrt(2 p_a dp/(R T)), 1e-17 of which is compressibility.
    row = ok("exact orifice_flow --times 1e-12").out.splitlines()[-1].split(",")
    assert abs(float(row[1]) / (0.085 * (2 * 101325 * 1e-12 / (296.8 * 673)) ** 0.5) - 1) < 1e-14, row
    refused("a number on the way overflows", "exact vent_equalisation --set gas_constant=1e-200 --set temperature=1e-200")


def test_exact():
    catalogue = as_json("exact --list --format json")
    names = re.findall("^([a-z0-9_]+): ", ok("exact --list").out, re.MULTILINE)
    assert catalogue["format"] == 1 and [form["name"] for form in catalogue["closed_forms"]] == names and "tank_fill" in names
    markdown = ok("exact --list --format markdown").out
    assert markdown == read(ROOT / "docs/exact.md")
    required = re.findall("^- `[a-z0-9_]+`.*, required: ", markdown, re.MULTILINE)
    assert len(required) == sum(p["default"] is None for form in catalogue["closed_forms"] for p in form["parameters"])
    for name in names:
        rows = [text for text in ok(f"exact {name}").out.splitlines() if not text.startswith("#")]
        assert not re.search("(?im)(^|,)-?(nan|inf)", "\n".join(rows[1:])), name
    expect(0, "^# volume: 1$", "exact tank_fill --set volume=+1")
    expect_known_digits()
    for pattern, command in (
            ("no_such", "no_such"), ("; is 'blowdown' meant.$", "blowdow"), ("'nan' is not a finite number", "tank_fill --set volume=nan"),
            ("given twice", "tank_fill --set volume=1 --set volume=2"), ("--list: prints the whole catalogue", "tank_fill --list"),
            ("--format csv: prints one NAME; for --list use markdown or json", "--list --format csv"),
            ("--times.*is empty, needed: first:last:step", "tank_fill --times="), ("--times 1,2: .*first:last:step", "tank_fill --times 1,2"), ("--times.*is empty", "--list --times="),
            ("prints --list only", "tank_fill --format markdown"), ("patch_angle", "pressed_balloon --times 1e-300"),
            ("overpressure", "pressed_balloon --set young_modulus=3"), ("no_such_parameter", "tank_fill --set no_such_parameter=1")):
        refused(pattern, f"exact {command}")


BLOWDOWN, BACKFLOW, PASSENGER = (f"cases/{name}.toml" for name in ("tank_blowdown", "tank_backflow", "passenger_pendulum"))
EMPTY = "--set gas.initial.pressure=0.0"
CLOSED = "--set vent.0.backflow=false --unset ambient.composition --unset ambient.composition_by"


@pytest.mark.parametrize("pattern, command", [
    (r"critical step .*fabric [0-9.e-]+, gas [0-9.e-]+, straps [0-9.e-]+, plate [0-9.e-]+\)", PASSENGER),
    (r"critical step .*alone: fabric [0-9.e-]+, gas [0-9.e-]+\)", "cases/sphere_inflation.toml"),
    ("matters .* pressure's on the impactor", PASSENGER),
    ("scene.end_time = 0.01", f"{TANK} --unset scene.end_time --set scene.end_time=0.01"),
    ("does not fill the volume", f"{PASSENGER} --set scene.end_time=0.001"),
    (r"inflator 0: at its peak \(t = 0.012 s\) 4 kg/s at 406 K, R 296.8 J/\(kg K\), gamma 1.3995", PASSENGER),
    (r"ambient.pressure \* = 101325$", "cases/piston_leak.toml"),  # which names none
    ("vents: choked at the start, choked from 1918", BLOWDOWN),
    # An empty volume has the gamma of the gas that fills it: of the initial composition, 7/5, or of an inflator's.
    ("^gas: 0 kg at 0 Pa, 600 K, gamma 1.4 of the gas that fills it$", f"{BLOWDOWN} {EMPTY}"),
    ("^vents: not choked at the start, choked from 191801 Pa at that gamma$", f"{BLOWDOWN} {EMPTY}"),
    ("^gas: 0 kg .* gamma 1.6667 of the gas that fills it$",
     f"{BLOWDOWN} {EMPTY} --set 'inflator=[{{composition={{He=1.0}},mass_flow=1.0,temperature=500.0}}]'"),
    # Nothing flows from a vacuum into a vacuum.
    ("^vents: not choked at the start, choked above 0 Pa", f"{BLOWDOWN} {EMPTY} --set ambient.pressure=0.0"),
    # Ambient air comes in at the speed of sound below 0.528 of its pressure, through vents that let it in.
    ("^vents: choked inwards at the start, outwards from 1[0-9.]+ Pa", f"{BACKFLOW} {EMPTY}"),
    ("^vents: choked inwards at the start, outwards from 1[0-9.]+ Pa", f"{BACKFLOW} --set gas.initial.pressure=53.4e3"),
    ("^vents: not choked at the start, choked from 1", f"{BACKFLOW} --set gas.initial.pressure=53.6e3"),
    ("^vents: not choked at the start, choked from 1", f"{BACKFLOW} --set gas.initial.pressure=53.4e3 {CLOSED}"),
    # Peaks of what waits for a trigger are told by the time after it.
    (r"^inflator 0: at its peak \(t = 0.004 s after its trigger\) 2.5 kg/s", "cases/tank_triggers.toml"),
    (r"^jet of inflator 0: at its peak \(t = 0.012 s after its trigger\) V0",
     f"{PASSENGER} --set 'sensor=[{{name=\"s\",time=0.005}}]' --set inflator.0.trigger=s"),
    (r"^jet of inflator 0: at its peak \(t = 0.012 s\) V0", PASSENGER),
])
def test_check(pattern, command):
    expect(0, pattern, f"check {command}")


def test_check_numbers():
    assert abs(as_json(f"check {BLOWDOWN} {EMPTY} --format json")["derived"]["gas_at_start"]["gamma"] - 1.4) < 1e-4
    # A warning names the inflator that is wrong.
    refused("^warning: inflator.1.temperature is 7000 K, usual are .*: check its unit", "check cases/tank_triggers.toml --set inflator.1.temperature=7000.0")
