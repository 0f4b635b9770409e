# SPDX-License-Identifier: Apache-2.0
"""`gasjet mesh fold`, and [[membrane.fold]] of a case: one start shape by both ways."""
import re

import pytest
from command import change, expect, ok, read, refused, write

PRESS = '[[membrane.fold]]\ntype = "press"\ngap = 0.6e-3\n'
LETTER = '[[membrane.fold]]\ntype = "letter"\naxis = "z"\nat = [-0.2, 0.2]\ngap = 0.6e-3\n'
OPTIONS = "--letter --axis z --at -0.2,0.2 --gap 0.6e-3"


def folded(case, *folds, to="folded.toml"):
    change(f"cases/{case}.toml", (r"(?m)^\[output\]", "\n".join(folds) + "\n[output]"), to=to)


def nodes(file):
    return [float(number) for line in read(file).splitlines() if line.startswith("v ") for number in line.split()[1:4]]


def test_fold_case_and_options_agree():
    folded("driver_bag", PRESS, LETTER)
    said = expect(0, "largest tensile strain: 0.0[0-9]* in the bends, [0-9.]*e-06 elsewhere", "mesh fold folded.toml --out a.obj").out
    assert "strap 2: 0.0006 m long, free length 0.26 m\n" in said
    assert len(re.findall("fold at -?0.2 m: bend 1.83 mm high", said)) == 2
    ok(f"mesh fold cases/driver_bag.toml --press {OPTIONS} --out b.obj")
    ok("mesh driver --out design.obj --initial opened.obj")
    for file in ("opened", "design"):  # the discs are laid on each other, whatever the start; hoops of cones are shorter
        ok(f"mesh fold {file}.obj --design design.obj --fixed attachment --press {OPTIONS} --out {file}_folded.obj")
    assert read("a.obj") == read("b.obj") == read("opened_folded.obj")
    assert nodes("design_folded.obj") == pytest.approx(nodes("a.obj"), abs=1e-3)
    # The same nodes and elements: the start of a case with its own mesh, as the fold of the case itself.
    ok("mesh case folded.toml --out case.k --initial start.k")
    ok("mesh fold folded.toml --out c.k")
    assert read("start.k") == read("c.k")
    refused("a.obj: .*would overwrite", "mesh fold a.obj --letter --axis y --at 0.2 --gap 1e-4 --out a.obj")


def test_fold_again():
    folded("driver_bag", PRESS, LETTER, LETTER.replace('"z"', '"y"'), to="twice.toml")
    folded("driver_bag", PRESS, LETTER)
    ok("mesh fold twice.toml --out a.obj")
    ok("mesh fold folded.toml --letter --axis y --at -0.2,0.2 --gap 0.6e-3 --out b.obj")
    ok("mesh driver --out design.obj")
    ok("mesh fold folded.toml --out once.obj")
    ok("mesh fold once.obj --design design.obj --fixed attachment --letter --axis y --at -0.2,0.2 --gap 0.6e-3 --out c.obj")
    assert read("a.obj") == read("b.obj")
    assert nodes("a.obj") == pytest.approx(nodes("c.obj"), abs=1e-12)


@pytest.mark.parametrize("refine", (0, 1))
def test_folded_cases_run(refine):
    """Both shipped bags, folded: nothing pulls at the start, no layer passes through another."""
    folded("driver_bag", PRESS, LETTER, to="driver.toml")
    folded("passenger_sharp", LETTER.replace("0.2", "0.148"), to="passenger.toml")
    for case, more in (("driver", ""), ("passenger", "--set membrane.flatten=0.01")):
        said = ok(f"check {case}.toml --set membrane.mesh.refine={refine} {more}").out
        assert "passes through itself" not in said and "strained at the start" not in said and "pulls" not in said
        ok(f"run {case}.toml --set membrane.mesh.refine={refine} {more} --set scene.end_time=2e-3 --out {case} --quiet")


@pytest.mark.parametrize("says, change_of", [
    (r'folded.toml:\d+:\d+: membrane.fold.1: at = 0.4 m: the fold line must lie within the bag, between -0.349 m and 0.349 m', ("-0.2, 0.2", "0.4")),
    ("membrane.fold.1.gap: .*a number above 0", (r"0.2\]\ngap = 0.6e-3", "0.2]\ngap = 0")),
    ("membrane.fold.1: gap = 0.0007 m: layers of the pack are only 0.0006 m apart", (r"0.2\]\ngap = 0.6e-3", "0.2]\ngap = 0.7e-3")),
    ("membrane.fold.1: axis: must lie in the plane of the pack, which is thin along x", ('"z"', '"x"')),
    ("membrane.fold.1.axis: .*\"x\", \"y\", \"z\"", ('"z"', '"up"')),
    ("membrane.fold.1.type: .*\"press\", \"letter\", \"accordion\", \"roll\"", ("letter", "leter")),
    ("membrane.fold.1: at = 0.12 m: the bend over this line gathers the fabric within .* and the fixed nodes are 0.07 m away, allowed: about .* m to .* m; move the line", ("0.2]", "0.12]")),
    ("membrane.fold.1: .*the fold line must not cross the part that stays", ("0.2]", "0.02]")),
    ("membrane.fold.1: .*the flap has only", ("0.2]", "0.3]")),
    ("membrane.fold.0: gap = 1 m, allowed: up to 0.0699 m, a tenth of the sheets' extent", (r'"press"\ngap = 0.6e-3', '"press"\ngap = 1')),
    ("membrane.fold.0.at: unknown key", ('"press"', '"press"\nat = [0.2]')),
])
def test_fold_bad_case(says, change_of):
    folded("driver_bag", PRESS, LETTER)
    change("folded.toml", change_of)
    refused(says, "check folded.toml")


@pytest.mark.parametrize("says, command", [
    ("needs --press, --letter, --accordion or --roll", "cases/driver_bag.toml"), ("--gap: is missing", "cases/driver_bag.toml --press"),
    ("--axis, --at and --easing need", "cases/driver_bag.toml --press --gap 1e-3 --axis z"), ("needs --axis and --at", "cases/driver_bag.toml --roll --gap 1e-3"),
    ("0: allowed: a finite number above 0", "cases/driver_bag.toml --press --gap 0"), ("the scene has no membrane", "cases/rigid_tank.toml --press --gap 1e-3"),
    ("--fixed and --design are for mesh files", "cases/driver_bag.toml --press --gap 1e-3 --fixed attachment"), ("--set is for cases", "bag.obj --press --gap 1e-3 --set a=1"),
    ("lid", "bag.obj --fixed lid --press --gap 1e-3"), ("two sheets that are sewn", "bag.obj --press --gap 1e-3"),
    ("layers of the pack are only .* apart; press two sheets on each other first", f"cases/driver_bag.toml {OPTIONS.replace('0.6', '5')}"),
    ("open.obj: is not a closed bag, and nothing is written", "open.obj --press --gap 1e-3"), ("excludes", "cases/driver_bag.toml --letter --roll --gap 1e-3"),
    ("passes through itself in [0-9]+ pairs of elements, the first one at .*of panels front and front, and nothing is written; move the fold lines",
     "cases/driver_bag.toml --set membrane.mesh.refine=2 --press --roll --axis z --at 0.1,0.16,0.22,0.28 --gap 0.6e-3 --easing 1"),
])
def test_fold_bad_input(says, command):
    ok("mesh passenger --out bag.obj")
    write("open.obj", *read("bag.obj").splitlines()[:-1])
    refused(says, f"mesh fold {command} --out bad.obj")
