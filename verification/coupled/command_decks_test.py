# SPDX-License-Identifier: Apache-2.0
"""Scenes as decks of other programs, read by parsers of their own."""
import re
import shutil
from pathlib import Path

import pytest
from command import ROOT, change, expect, has, ok, read, refused
from deck_curves import judge_curves
from deck_structure import read_deck
from deck_units import judge_units

FILES = {"radioss": "bag_0000.rad", "lsdyna": "bag.k"}
UNITS = {"kg-m-s": (1, 1), "t-mm-s": (1e6, 1), "kg-mm-ms": (1e9, 1e-3)}  # Pa, s
PASSENGER, SPHERE = "cases/passenger_pendulum.toml", "cases/sphere_inflation.toml"
forms = pytest.mark.parametrize("form", FILES)


def export(case, form, out, *words, units="kg-m-s"):
    return expect(0, "export.md are in", f"export {case} --format {form} --units {units} --out {out}", *words)


def whole(form, path):
    counts, faults = read_deck(form, path)
    assert not faults and counts["nodes"]


# Keys that stand below one that the table names.
BELOW = set("""file time value strain mass_ratio strain_column overpressure_column mass_ratio_column time_column column cumulative offset
    scale shift time_scale units species initial radius levels generator refine heat_loss nasa7 rings vents time_ fabric ambient gas
    inflator jet vent sensor trigger membrane strap plate pendulum contact scene output weave panel depth width height back_radius
    front_radius depth_cells width_cells height_cells attachment_width_cells attachment_height_cells vent_depth_cell vent_height_cell
    inflator_radius opening inflator_rings vent_ring holes first angle impactor motion spring stop at
    damping second_axis half_axes half_length rim_radius velocity angular_velocity inertia direction force centre normal side columns rows cap cap_length self_contact area step safety unsafe_step gas_tolerance
    gas_step gas_method""".split())


def test_decks_keys():
    """Every key of a case has a row of its own, or stands below one, in the table of what becomes of it."""
    features = "".join(map(read, ROOT.glob("driver/**/feature_table*.cpp")))
    documented = re.findall(r"(?m)^\| (`[^|]*)\|", read(ROOT / "docs/case_files.md").split("## Map of a foreign")[0])
    for key in {word for cell in documented for word in re.findall("[a-z_0-9]+", cell)} - BELOW:
        assert re.search(rf'"([a-z_0-9.]+\.)?{key}"', features), f"no row names the key {key}"


@forms
def test_decks(form):
    cases = [path for folder in ("cases", "cases/reference") for path in Path(folder).glob("*.toml") if has(path, r"^\[membrane\]")]
    assert len(cases) >= 20
    for case in cases:
        settings = len(re.findall(r"(?m)^  [a-z_]+\.[^ ]+(?: \*)? = ", ok(f"check {case}").out))
        for units in UNITS:
            out = f"{case.stem}.{units}"
            export(case, form, out, units=units)
            assert has(f"{out}/export.md", "^## no counterpart")
            kinds = re.findall('"mapping": "(?:exact|approximated|no counterpart|left out)"', read(f"{out}/export.json"))
            assert len(kinds) == settings, f"{out}: export.json does not name all {settings} settings"
            whole(form, out)
    # Numbers with a name are those of the case, in each system of units; a deck under another system's name is seen.
    assert not judge_units(form, PASSENGER, [f"passenger_pendulum.{units}" for units in UNITS])
    shutil.copytree("passenger_pendulum.t-mm-s", "wrong.kg-mm-ms")
    assert any("in the first deck" in fault for fault in judge_units(form, PASSENGER, ["passenger_pendulum.kg-m-s", "wrong.kg-mm-ms"]))
    for name in ("measured_fabric", "clamped_disc", "damped_sphere"):
        for units, sizes in UNITS.items():
            assert not judge_curves(form, f"cases/{name}.toml", f"{name}.{units}", *sizes)
    if form == "radioss":  # strain is logarithmic, and linear for woven fabric
        assert has("sphere_inflation.kg-m-s/bag_0000.rad", "^         0         4         2")
        assert has("driver_bag.kg-m-s/bag_0000.rad", "^         0        11         2")


@pytest.mark.parametrize("form, pattern, new", [
    # A field moved by one column, a number that nothing defines, a lost line, another keyword, another option.
    ("radioss", r"^( +5 .*)$", r" \1"), ("radioss", r"(?s)(^/PART/1\n.*?)         1", r"\1      4711"),
    ("radioss", r"(?s)(^/RBODY/1\n.*?)^[^\n]*Jxx[^\n]*\n[^\n]*\n", r"\1"), ("radioss", "^/GRAV", "/GRAF"), ("radioss", r"^/LEAK.*\n(.*\n){7}", ""),
    ("radioss", r"(Iformps.*\n *[0-9]*)         3", r"\1         0"),
    ("lsdyna", r"^( +5 +[0-9].*)$", r" \1"), ("lsdyna", r"(?s)(^\*PART\n.*?)         1", r"\1      4711"),
    ("lsdyna", r"(?s)(^\*PART_INERTIA\n.*?)^[^\n]*TM[^\n]*\n[^\n]*\n", r"\1"), ("lsdyna", r"^\*LOAD_BODY_Z", "*LOAD_BODY_W"),
    ("lsdyna", r"(LCIDM.*\n)         0", r"\1         1"), ("lsdyna", r"(^\*CONSTRAINED_JOINT.*\n.*\n(?:\$.*\n)?)( +[0-9]+) ( *[0-9]+)", r"\1\3\2 "),
    ("lsdyna", r"(^\*SECTION_SHELL\n(?:.*\n)?)^.*SECID.*\n.*\n", r"\1")])
def test_decks_reader(form, pattern, new):
    """The parser sees what is wrong."""
    export(PASSENGER, form, "deck")
    change(f"deck/{FILES[form]}", (pattern, new), to=FILES[form])
    _, faults = read_deck(form, FILES[form])
    assert faults and re.search(rf"{FILES[form]}:\d+", faults[0])


@forms
def test_decks_curves(form):
    """Several panels, and fabric that leaks."""
    case = "cases/measured_fabric.toml"
    export(case, form, "threads", "--set", "fabric.leak_law=printed", "--set", "fabric.porosity=0.1", "--set",
           'fabric.panel=[{panels=["skin"],thickness=0.4e-3,weave={shear_modulus=2e6,warp=[0.0,0.0,1.0]}}]')
    whole(form, "threads")
    assert not judge_curves(form, case, "threads", 1, 1) and has("threads/export.md", "stops, it is extrapolated")


FABRIC, DISC = "measured_fabric", "clamped_disc"


@pytest.mark.parametrize("form, name, pattern, new, says", [
    # Warp for weft, another measure of strain, stress in compression, a pressure the other way.
    ("radioss", FABRIC, r"(^#   FCT_ID.*\n)         2", r"\1         3", "off by"),
    ("radioss", FABRIC, r"(?s)(^/FUNCT/2\n.*?^) *0\.22 ", r"\g<1>                0.27", "off by"),
    ("radioss", FABRIC, r"^( *-1\. *)-.*", r"\1-1e6", "off by"), ("radioss", DISC, r"(^#  surf_ID  funct.*\n.*) 1\.$", r"\1-1.", "pressure at"),
    ("lsdyna", FABRIC, r"( LCA .*\n.*?)         3", r"\1         2", "off by"), ("lsdyna", FABRIC, r"^( *)0\.2442 ", r"\1  0.22 ", "off by"),
    ("lsdyna", DISC, r"(?s)(^\*LOAD_SHELL_SET.*?)-1\.", r"\1 1.", "pressure at")])
def test_decks_curves_judge(form, name, pattern, new, says):
    export(f"cases/{name}.toml", form, "deck")
    change(f"deck/{FILES[form]}", (pattern, new))
    assert any(says in fault for fault in judge_curves(form, f"cases/{name}.toml", "deck", 1, 1))


@pytest.mark.parametrize("form, name, pattern, new, says", [
    # What does not go together, and a curve that is nowhere.
    ("radioss", FABRIC, r"^( *-1\. *)-.*", r"\g<1>1e6", "falls"), ("radioss", FABRIC, "SH_FABR", "SH_ORTH", "do not go together"),
    ("radioss", DISC, r"^/PLOAD.*\n(.*\n){3}", "", "neither gas nor pressure"), ("lsdyna", FABRIC, r"(FORM.*\n.*?)       14\.", r"\1       12.", "lines"),
    ("lsdyna", FABRIC, r"( LCA .*\n.*?)         3", r"\1      4711", "curve 4711"),
    ("lsdyna", FABRIC, r"(ISREFG.*\n.*) 0$", r"\1 1", "goes with FORM 12"),
    ("lsdyna", DISC, r"^\*LOAD_SHELL_SET.*\n(.*\n){3}", "", "neither gas nor pressure")])
def test_decks_curves_reader(form, name, pattern, new, says):
    export(f"cases/{name}.toml", form, "deck")
    change(f"deck/{FILES[form]}", (pattern, new))
    assert any(says in fault for fault in read_deck(form, f"deck/{FILES[form]}")[1])


@forms
def test_decks_self_contact(form):
    """The fabric against itself, null panels not: the thickness in the deck's unit, and beside the impactor's contact."""
    contact = ("--set", "membrane.self_contact={thickness=1.5e-3,friction=0.25}")
    export(PASSENGER, form, "folded", *contact, units="t-mm-s")
    whole(form, "folded")
    deck = read(f"folded/{FILES[form]}")
    if form == "radioss":
        assert len(re.findall("(?m)^/INTER/TYPE7/", deck)) == 2
        card, parts = re.search(r"(?m)^/INTER/TYPE7/2\n(?:.*\n){8}(.*)\n", deck)[1], re.search(r"(?m)^/SURF/PART/3\n.*\n(.*)\n", deck)[1]
        assert [float(value) for value in card.split()][1:3] == [0.25, 1.5]
    else:
        block = re.search(r"(?s)\*CONTACT_AIRBAG_SINGLE_SURFACE_ID\n(.*?)\n\*", deck)[1].split("\n")
        assert block[4].split()[:2] == [".25", ".25"] and block[6].split()[2] == "1.5"
        parts = re.search(r"(?m)^\*SET_PART_LIST\n.*SID\n +2\n(.*)\n", deck)[1]
    assert len(parts.split()) == 4  # of five panels one, the vent, is null
    assert has("folded/export.md", "the distance of layers is below 0.0015 m")


@forms
def test_decks_texts(form):
    # A vent that stays closed, and a name that would begin keywords of its own.
    export(PASSENGER, form, "closed", "--set", "vent.0.area={time=[0.0,0.1],value=[0.0,0.0]}", "--set", r'scene.name="*END\n/END"')
    whole(form, "closed")
    assert has(f"closed/{FILES[form]}", "^_[*]END_/END$")
    # What is left out is told loudly. The run goes on past the scene's end, by an interval of the histories and a hundredth.
    sensor = ("--set", 'sensor=[{name="p",overpressure=5e3}]', "--set", 'inflator.0.trigger="p"')
    expect(0, "^warning: the deck has none of the case's 1 inflators", f"export {SPHERE} --format {form} --units kg-m-s --out without", *sensor)
    ends = re.findall(r"(?m)^(?:/RUN/|.*ENDTIM).*\n +(0?\.0607)$", "".join(read(path) for path in sorted(Path("without").glob("bag*"))))
    assert ends


@pytest.mark.parametrize("says, words", [
    (r"has no \[membrane\]", "cases/rigid_tank.toml --format radioss --units kg-m-s --out none"),
    ("longest extent is 680 m", f"{SPHERE} --set membrane.mesh.radius=340.0 --format radioss --units kg-m-s --out none"),
    ("--format", f"{PASSENGER} --format abaqus --units kg-m-s --out none"), ("--units", f"{PASSENGER} --format radioss --units inches --out none"),
    ("required", f"{PASSENGER} --format radioss --units kg-m-s"),
    ("/proc/none: (No such file|Permission|Not permitted|Operation)", f"{PASSENGER} --format radioss --units kg-m-s --out /proc/none")])
def test_decks_bad_input(says, words):
    refused(says, f"export {words}")


def test_decks_any_size():
    export(SPHERE, "radioss", "large", "--set", "membrane.mesh.radius=340.0", "--any-size")
