# SPDX-License-Identifier: Apache-2.0
"""Histories against references."""
import hashlib
import os
import re
import shutil
from pathlib import Path

import pytest
from command import (GASJET, ROOT, as_json, change, ended, expect, gasjet, numbers, ok, program, read, refused, table, write,
                     write_table)

TABLES = Path("cases/reference")


def with_bands(to, pressure, temperature, *options):
    """The closed form with bands: eps x 100 steps of a number of order 1e5 and 1e3."""
    write("exact.csv", ok("exact tank_fill --times 0:0.1:0.01", *options).out)
    form = numbers("exact.csv")
    bands = {"pressure_Pa_band": [pressure] * 11, "temperature_K_band": [temperature] * 11}
    write_table(to, {**form, **bands}, comments=[line[2:] for line in read("exact.csv").splitlines() if line.startswith("# ")])


@pytest.fixture
def tank():
    ok("run cases/rigid_tank.toml --out tank --quiet")
    os.rename("tank/history.csv", "mine.csv")
    with_bands("reference.csv", 2e-8, 2e-10)
    with_bands("other.csv", 2e-8, 2e-10, "--set", "mass_flow=1.0001")


def test_compare(tank):
    expect(0, "^inside", "compare mine.csv reference.csv --rows rows.csv")
    rows = table("rows.csv")
    assert len(rows) == 11 and list(rows[0])[:5] == ["time_s", "pressure_Pa", "pressure_Pa_reference", "pressure_Pa_band", "temperature_K"]
    assert as_json("compare mine.csv reference.csv --format json")["quantities"]["pressure_Pa"]["phase_lag_s"] == 0.0
    expect(0, "^inside", "compare mine.csv reference.csv --columns pressure_Pa,temperature_K")
    # Outside, and no band to be inside of.
    expect(1, "^outside: pressure_Pa: 10 of 11 rows outside", "compare mine.csv other.csv")
    assert as_json("compare mine.csv other.csv --format json", code=1)["verdict"] == "outside"
    expect(4, "^undecided: the reference has no band; use --tolerance", "compare mine.csv mine.csv")
    # 1e-4 too much inflow is 9e-5 of the pressure, less of the temperature. Without any band the tolerance is the band.
    write("bare.csv", ok("exact tank_fill --times 0:0.1:0.01 --set mass_flow=1.0001").out)
    both = "compare mine.csv bare.csv --columns pressure_Pa,temperature_K --tolerance"
    expect(0, "^inside", f"{both} 1e-4")
    expect(1, "^outside: pressure_Pa", f"{both} 8e-5")
    expect(4, "^undecided: the reference has no band", f"{both} 0")
    for code, says, tolerances in ((0, "^inside", "1e-4"), (0, "^inside", "0.01%"), (0, "^inside", "pressure_Pa=1e-4 --tolerance 1e-4"),
                                   (1, "^outside: pressure_Pa", "pressure_Pa=1e-6 --tolerance 1e-4"),
                                   (1, "^outside: temperature_K", "pressure_Pa=1e-4")):
        expect(code, says, f"compare mine.csv other.csv --tolerance {tolerances}")
    for how in ("", " --format json"):
        with open("/dev/full", "w") as full:
            expect(3, "standard output: write failed", f"compare mine.csv reference.csv{how}", stdout=full)


def test_compare_end():
    """A value that does not depend on time, as the time of the end, is no column: the history of the case is all of it."""
    write("inrush.toml", "[scene]", 'name = "inrush"', "end_time = 0.4", "[ambient]", "composition = { N2 = 1 }", "[gas]",
          "initial = { composition = { N2 = 1 }, pressure = 20000 }", "[tank]", "volume = 0.06", "[[vent]]", "area = 1e-3", "backflow = true",
          "[output]", "history_exact = true", "history_every = 0.01")
    ok("run inrush.toml --out inrush --quiet")
    write("inrush.csv", ok("exact ambient_inrush --times 0:0.4:0.01 --set gas_constant=296.7966951578939"
                           " --set heat_capacity_ratio=1.399547035325335").out)
    assert re.search("(?m)^# end_time_s: 0.227", read("inrush.csv"))
    expect(0, "^inside", "compare inrush/history.csv inrush.csv --tolerance 1e-8")
    assert 0.227 < as_json("exact ambient_inrush --format json")["constants"]["end_time_s"] < 0.228


def test_compare_maps(tank):
    """Time in ms and pressure in bar above ambient, brought back by a map; without it there are no such columns."""
    mine = numbers("mine.csv")
    rows = [f"{1e3 * t:.17g},{(p - 101325) / 1e5:.17g}" for t, p in zip(mine["time_s"], mine["pressure_Pa"])]
    write("foreign.csv", "\ufeffms,bar", *rows)  # begun by a byte order mark, as spreadsheets write it, which is none of the text
    write("map.toml", 'format = "csv"', "[time]", 'column = "ms"', "scale = 1e-3", "[[quantity]]", 'name = "pressure_Pa"', 'column = "bar"',
          "scale = 1e5", "offset = 101325")
    judge = "compare foreign.csv reference.csv"
    expect(0, "^inside", f"{judge} --map map.toml --columns pressure_Pa")
    expect(4, "undecided: temperature_K: mine does not have it", f"{judge} --map map.toml")
    refused("foreign.csv:1:1: time_s: no such column, the header has ms, bar; --map names the columns", judge)
    write("semicolons.csv", read("foreign.csv").replace(",", ";").replace(".", ","))
    expect(0, "^inside", "compare semicolons.csv reference.csv --map map.toml --columns pressure_Pa")
    write("units.toml", 'format = "csv"', "[time]", 'column = "ms"', 'unit = "ms"', "[[quantity]]", 'name = "pressure_Pa"', 'column = "bar"',
          'unit = "bar"', "offset = 101325")
    expect(0, "^inside", f"{judge} --map units.toml --columns pressure_Pa")
    change("units.toml", ('"bar"\noffset', '"bar gauge"\noffset'), to="bad.toml")
    refused('bad.toml:8:1: quantity.0.unit: is "bar gauge", which needs the ambient pressure', f"{judge} --map bad.toml")
    change("units.toml", ('unit = "ms"', 'unit = "K"'), to="bad.toml")
    refused('bad.toml:4:1: time.unit: is "K", allowed: s, ms, us', f"{judge} --map bad.toml")
    # A column that is needed has to be there, a name to be one of the reference; what a map for many scenes has beside is left out.
    change("map.toml", ('"bar"', '"barr"'), to="bad.toml")
    refused(r"bad.toml:7:1: quantity.0.column: 'barr' is not in .*foreign.csv, the header has ms, bar; is 'bar' meant\?", f"{judge} --map bad.toml")
    change("map.toml", ("pressure_Pa", "presure_Pa"), to="bad.toml")
    refused(r"bad.toml:6:1: quantity.0.name: the reference has no column 'presure_Pa'; is 'pressure_Pa' meant\?", f"{judge} --map bad.toml")
    write("wide.toml", read("map.toml") + '[[quantity]]\nname = "skin_area_m2"\ncolumn = "none"')
    expect(4, "wide.toml:11:1: quantity.1.name: 'skin_area_m2' is ignored: the reference has no such column", f"{judge} --map wide.toml")
    expect(0, "^inside", f"{judge} --map wide.toml --columns pressure_Pa")


def test_compare_bad_input(tank):
    with_bands("negative.csv", -0.1, 2e-10)
    for says, words in (
            ("--columns volume_m3: .* allowed: pressure_Pa, temperature_K", "mine.csv reference.csv --columns volume_m3"),
            ("--columns '': a name is empty, allowed: pressure_Pa", "mine.csv reference.csv --columns pressure_Pa,"),
            ("negative.csv:[0-9]+:[0-9]+: pressure_Pa_band: -0.1: is not a half width of 0 or more", "mine.csv negative.csv"),
            ("no such file", "none.csv reference.csv"), ("no such file", "mine.csv reference.csv --map none.toml"), ("required", "mine.csv"),
            ("not writable", "mine.csv reference.csv --rows nowhere/rows.csv"), ("--rows.*is empty", "mine.csv reference.csv --rows ''"),
            ("/dev/zero:1:1: the line is longer than 1 MiB", "/dev/zero reference.csv"),
            ("--tolerance volume: the reference has no such quantity, allowed: pressure_Pa", "mine.csv reference.csv --tolerance volume=0"),
            ("--tolerance 2e-3: is given twice", "mine.csv reference.csv --tolerance 1e-3 --tolerance 2e-3")):
        refused(says, f"compare {words}")
    for share in ("nan", "-1", "1.5", "x", "", "pressure_Pa=", "pressure_Pa=nan"):
        refused(f"--tolerance {share}: .* a finite number from 0 to 1, such as 0.02 or 2%, or COLUMN=SHARE",
                "compare mine.csv reference.csv --tolerance", share)
    kept = read("reference.csv")
    refused("--rows .*would overwrite", "compare mine.csv reference.csv --rows ./reference.csv")
    assert read("reference.csv") == kept
    # Thousands of columns take no longer than their bytes: a second, or a minute if each were looked for among all.
    write("wide.csv", *(",".join([str(row) if row else "time_s", *(f"{'' if row else 'q'}{c}" for c in range(20000))]) for row in range(5)))
    expect(4, "has no band", "compare wide.csv wide.csv", timeout=30)
    # What a run can write is read, however long.
    write("long.csv", "time_s,pressure_Pa", *(f"{i}.0000000000,101325.0000" for i in range(2600000)))
    assert os.path.getsize("long.csv") > 64 << 20
    expect(4, "has no band", "compare long.csv mine.csv")


def test_compare_means():
    """Means of many runs: what ensemble.csv holds is judged as it is; its number of runs has to be there."""
    case, short = "cases/sphere_inflation.toml", "--quiet --set scene.end_time=2e-3 --set membrane.mesh.levels=1"
    mine, other = (f"{folder}/sphere_inflation/ensemble.csv" for folder in ("mine", "other"))
    ok(f"ensemble {case} --runs 4 {short} --out mine")
    ok(f"ensemble {case} --runs 4 {short} --out other --first-seed 5")
    assert table(mine) != table(other)
    expect(0, "the mean of 4 runs against the mean of 4", f"compare {mine} {other}")
    verdict = as_json(f"compare {mine} {other} --format json")
    assert verdict["reference_runs"] == 4 and "seen_share" in str(verdict)
    ok(f"run {case} {short} --out run --set membrane.perturbation=1e-4 --set membrane.perturbation_seed=9")
    expect(0, "one run against the mean of 4", f"compare run/history.csv {other}")
    ok(f"run {case} {short} --out run --set ambient.temperature=294")
    expect(1, "^outside: temperature_K", f"compare run/history.csv {other} --columns temperature_K")
    for runs in ("", "1", "0", "-4", "4.5", "x", "99999999999"):
        change(mine, ("^# runs: .*", f"# runs: {runs}"), to="wrong.csv")
        refused(f"wrong.csv:[0-9]+:1: runs: '{runs}' is not a number of runs, which .*_standard_error needs", f"compare wrong.csv {other}")
    change(mine, ("^# runs: .*\n", ""), to="wrong.csv")
    refused("wrong.csv:[0-9]+:1: runs: '' is not a number", f"compare wrong.csv {other}")
    change(mine, (r"^([0-9][^,]*,[^,]*),[^,]*", r"\1,-1"), to="wrong.csv")
    refused("wrong.csv:[0-9]+:[0-9]+: .*-1: is not a standard error of 0 or more", f"compare wrong.csv {other}")
    write("wrong.csv", "# runs: 4", "time_s,alone_standard_error", "0,1", "1,1", "2,1")
    refused("wrong.csv:1:1: alone_standard_error: has no column alone beside it", f"compare wrong.csv {other}")


def whole_set(folder):
    """Every file is that of its checksum."""
    sums = dict(reversed(line.split("  ", 1)) for line in read(folder / "SHA256SUMS").splitlines())
    for name, digest in sums.items():
        assert hashlib.sha256((folder / name).read_bytes()).hexdigest() == digest, name
    return sums


def test_reference():
    """The reference set is what its checksums say; every scene, run anew, lies within the bands. The passenger scenes with a seed that is
    none of the ensemble's, in optimised builds only: minutes under the sanitizers."""
    tables = sorted(TABLES.glob("*.csv"))
    assert len(tables) == 14 and {file.name for file in tables} <= set(whole_set(TABLES))
    for file in tables:
        scene, text = file.stem, read(file)
        comments = dict(re.findall("(?m)^# ([^:]*): (.*)", text))
        assert re.search("(?m)^# band", text), f"{scene} does not say where its bands are from"
        kinds = ("", "_standard_error", "_scatter", "_band") if "runs" in comments else ("", "_band")
        columns = list(table(file)[0])[1:]
        assert columns == [base + kind for base in columns[::len(kinds)] for kind in kinds], scene
        case = comments["case"]
        if TABLES.joinpath(f"{scene}.obj").exists() and gasjet(f"mesh case {case} --out {scene}.obj").code == 0:
            assert read(f"{scene}.obj") == read(TABLES / f"{scene}.obj"), f"{scene}: the mesh is not the case's"
        displaced = [word for setting in comments.get("initial shape", "").split() for word in ("--set", setting)]
        if displaced and "Release" not in ok("--version").out:
            continue
        ok(f"run {case} --quiet --out {scene}", *displaced)
        expect(0, "^inside", f"compare {scene}/history.csv {file}")
        if displaced:
            ok(f"run {case} --quiet --out {scene} --set vent.0.area=2.1e-3", *displaced)
            expect(1, "^outside", f"compare {scene}/history.csv {file}")


def test_reference_anew():
    """The command that made the set makes it: a scene whose case reads the mesh that is written beside it."""
    os.mkdir("set")
    shutil.copy(TABLES / "plate_jet_shadow.toml", "set")
    ended(0, "plate_jet_shadow: 22 rows", program(ROOT / "scripts/reference_set.py", "plate_jet_shadow",
                                                  env={"GASJET": GASJET, "REFERENCE_OUT": os.path.abspath("set")}))
    expect(0, "^inside", f"compare set/plate_jet_shadow.csv {TABLES}/plate_jet_shadow.csv")
    for name in ("plate_jet_shadow.obj", "plate_jet_shadow.k"):
        assert read(f"set/{name}") == read(TABLES / name)
    assert whole_set(Path("set"))


@pytest.mark.parametrize("scene, setting, column", [("sphere_vent", "vent.0.area=3.2e-4", ""),
                                                    *(("cushion_impact", f"contact.{wrong}", "contact_force_N .* outside: ")
                                                      for wrong in ("friction=0.25", "stiffness=0.9e8"))])
def test_reference_is_sharp(scene, setting, column):
    ok(f"run {TABLES}/{scene}.toml --quiet --out wrong --set {setting}")
    expect(1, column or "^outside", f"compare wrong/history.csv {TABLES}/{scene}.csv")


ABSTAT = ("      time   airbag/cv #  volume        pressure    internal energy      dm/dt in      density dm/dt out  total mass gas temp. "
          "surface area   reaction")


def abstat(vent, factor=1.0):
    """A history as LS-DYNA prints it, in kg, mm and ms, with l2a's formats of four to five digits; the factor is of the vent's flow."""
    lines = ["", "  airbag/control volume statistics"]
    for t, p, T, V, m, into, out, area in zip(*(vent[name] for name in (
            "time_s", "pressure_Pa", "temperature_K", "volume_m3", "gas_mass_kg", "inflow_kg_s", "vent_outflow_kg_s", "skin_area_m2"))):
        wide = "".join(f"{x:15.4E}" for x in (1e9 * V, p / 1e9, 0, into / 1e3, m / V / 1e9))
        narrow = "".join(f"{x:11.3E}" for x in (factor * out / 1e3, m, T, 1e6 * area, 0))
        lines += ["", "", ABSTAT, f"{1e3 * t:12.5E}{1:8d}{wide}{narrow}"]
    return lines


def test_foreign_history():
    """A whole history as foreign programs print it, by the shipped maps: abstat, and th_to_csv with six decimals, which is nothing of a
    pressure in GPa."""
    ok("run cases/reference/sphere_vent.toml --quiet --out vent")
    vent = numbers("vent/history.csv")
    judge = lambda name, kind: f"compare {name} {TABLES}/sphere_vent.csv --map cases/maps/{kind}.toml"
    write("abstat", *abstat(vent))
    expect(0, "^inside", f"{judge('abstat', 'lsdyna_abstat')} --tolerance 1e-3")
    for factor in (-1, 1.1):
        write("wrong", *abstat(vent, factor))
        expect(1, "^outside: vent_outflow_kg_s", f"{judge('wrong', 'lsdyna_abstat')} --tolerance 1e-3")
    write("cut", *abstat(vent)[:400])
    expect(4, r"^undecided: .*covers 0 to 0.0[0-9]+ s, the reference 0 to 0.06 s", f"{judge('cut', 'lsdyna_abstat')} --tolerance 1e-3")
    Path("torn").write_text(read("abstat")[:20000])
    refused("torn:[0-9]+:[0-9]+: the row ends in field", judge("torn", "lsdyna_abstat"))
    head = ["time", "MASS", *(f"TH_BAG  1 bag       {name:10s}" for name in ("MASS", "VOL", "P", "A", "T"))]
    rows = zip([1e3 * t for t in vent["time_s"]], [9] * len(vent["time_s"]), vent["gas_mass_kg"], [1e9 * V for V in vent["volume_m3"]],
               [p / 1e9 for p in vent["pressure_Pa"]], [1e6 * area for area in vent["skin_area_m2"]], vent["temperature_K"])
    write("bagT01.csv", ",".join(f'"{name}"' for name in head), *(",".join(f"{x:f}" for x in row) for row in rows))
    columns = "--columns volume_m3,temperature_K,gas_mass_kg,skin_area_m2"
    bag = judge("bagT01.csv", "openradioss_monvol")
    expect(0, "^inside", f"{bag} {columns}")
    expect(1, "^outside: pressure_Pa", bag)
    expect(4, "undecided: inflow_kg_s: mine does not have it", f"{bag} {columns},inflow_kg_s")
