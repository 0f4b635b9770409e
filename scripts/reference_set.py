#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the reference histories of cases/reference with their error bands, their meshes (OBJ and keyword) and SHA256SUMS.
Bands are half widths, one for each column, in the reference's own header with their reason:
  closed form: twice the largest difference to it;
  refinement: twice the largest change when the step is halved, plus 1.5 times that when each element of the same polyhedron is cut
  in 16 (of numbers of elements, a 16th of them then): an error of first order is 4/3 of that change, one of second 16/15;
  chaotic scenes: means of many runs with standard error and scatter; as band the error of the step. Fails unless runs and means of
  seeds of their own lie inside.
Fails where a band would be as wide as its signal.
At least round-off: 1e-12 of the column's largest magnitude, eps times some thousand additions.

usage: scripts/reference_set.py [--work FOLDER] [SCENE...]
  --work FOLDER  keep the runs there; ensembles that are there already are taken as they are
GASJET names the program, REFERENCE_OUT another folder than cases/reference."""
import argparse
import hashlib
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "docs/make/charts"))
from common import gasjet, output  # noqa: E402
from reference_meshes import baffle, disc  # noqa: E402

OUT = pathlib.Path(os.environ.get("REFERENCE_OUT", "cases/reference"))
WORK = None  # a folder for the runs
RUNS, RUNS_HALVED = 64, 32  # of the means, and of those at half the step


def program(*arguments, allowed=(0,)):
    return output(gasjet(), *arguments, allowed=allowed, cwd=ROOT)


def run(case, folder, *overrides):
    """The history of the case with these overrides."""
    program("run", case, "--quiet", "--out", WORK / folder, *(word for text in overrides for word in ("--set", text)))
    return WORK / folder / "history.csv"


def read(path):
    """Comment lines, names of the columns, rows of texts."""
    lines = path.read_text(encoding="utf-8").splitlines()
    names, *rows = [line.split(",") for line in lines if not line.startswith("#")]
    return [line for line in lines if line.startswith("#")], names, rows


def inside(mine, reference):
    done = subprocess.run([gasjet(), "compare", mine, reference], stdout=subprocess.DEVNULL, cwd=ROOT)
    return done.returncode == 0


# --- scenes by refinement

class Bands:
    """Half widths and reasons of the columns."""

    def __init__(self):
        self.width, self.reason = {}, {}

    def take(self, mine, reference, factor, reason, add=False):
        """From the largest differences in the columns that both have, to four digits; without a band they are undecided, exit code 4."""
        report = json.loads(program("compare", mine, reference, "--format", "json", allowed=(0, 1, 4)))
        for name, quantity in report["quantities"].items():
            if "max_error" not in quantity:
                continue
            width = float(f"{factor * float('%.4g' % quantity['max_error']['value']):.4g}")
            add_here = add and name in self.width
            self.width[name] = self.width[name] + width if add_here else width
            self.reason[name] = f"{self.reason[name]} + {reason}" if add_here else reason

    def write(self, scene, case, base, stride):
        """The base history with a band beside each column."""
        comments, names, rows = read(base)
        lines = [line for line in comments if not re.match("# (run|date|options|case):", line)]
        lines += [f"# scene: {scene}", f"# case: {case}", "# made by: scripts/reference_set.py"]
        for i, name in enumerate(names[1:], 1):
            values = [float(row[i]) for row in rows]
            top, variation = max(map(abs, values)), max(values) - min(values)
            if name not in self.width:
                sys.exit(f"{scene}: {name} has no band")
            if self.width[name] < 1e-12 * top:
                self.width[name], self.reason[name] = 1e-12 * top, "round-off"
            if self.width[name] >= variation > 1e-6 * top:
                sys.exit(f"{scene}: {name} has a band as wide as the signal, {self.width[name]:g}")
            lines.append(f"# band {name}: {self.width[name]:.3g}, {self.reason[name]}")
        lines.append(",".join([names[0], *(f"{name},{name}_band" for name in names[1:])]))
        for row in [*rows[:-1:stride], rows[-1]]:
            lines.append(",".join([row[0], *(f"{text},{self.width[name]:.3g}" for name, text in zip(names[1:], row[1:]))]))
        (OUT / f"{scene}.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


def sixteenth_of_elements(history):
    """Of a mesh whose elements are cut in 16, numbers of elements as of the uncut one."""
    comments, names, rows = read(history)
    rows = [[f"{float(text) / 16:.17g}" if name.endswith("_elements") else text for name, text in zip(names, row)] for row in rows]
    cut = history.with_name("cut.csv")
    cut.write_text("\n".join([*comments, *(",".join(row) for row in [names, *rows])]) + "\n", encoding="utf-8")
    return cut


def plate_force(end):
    """A steady force, as a history of the jet's plate: (1 + e) mdot V0 with e = 1."""
    flux = program("exact", "sonic_outlet", "--set", "temperature=406", "--times", "2").splitlines()[-1].split(",")[3]
    force = program("exact", "plate_force", "--times", flux).splitlines()[-1].split(",")[1]
    return "time_s,jet_force_N\n" + "".join(f"{end * i / 10:.17g},{force}\n" for i in range(11))


def by_refinement(scene, case, stride=1, step="", mesh="", exact="", force_until=None):
    """`step` and `mesh` are overrides, `exact` arguments of `gasjet exact`. Of a plate the force is known up to `force_until`; the band
    that its mesh gives stands alone, since that is not of the same polyhedron."""
    base, bands = run(case, f"{scene}.base"), Bands()
    if step:
        bands.take(run(case, f"{scene}.step", *step.split()), base, 2, f"step halved ({step})")
    if mesh:
        refined = sixteenth_of_elements(run(case, f"{scene}.mesh", *mesh.split()))
        bands.take(refined, base, 1.5, f"elements cut ({mesh})", add=force_until is None)
    if exact or force_until:
        table = WORK / f"{scene}.exact"
        table.write_text(plate_force(force_until) if force_until else program("exact", *exact.split()), encoding="utf-8")
        bands.take(table, base, 2, f"gasjet exact {exact or 'plate_force'}")
    bands.write(scene, case, base, stride)
    if not inside(base, OUT / f"{scene}.csv"):
        sys.exit(f"{scene}: its own history is outside")


# --- chaotic scenes

def ensemble(scene, case, name, runs, *options):
    """Its table, made unless it is there."""
    folder = WORK / f"{scene}.{name}"
    table = folder / pathlib.Path(case).stem / "ensemble.csv"
    if not table.is_file():
        program("ensemble", case, "--runs", runs, "--quiet", "--threads", os.cpu_count(), "--out", folder, *options)
    return table


def write_means(scene, case, halved, means):
    """Beside each column: its standard error, the scatter of a run (standard deviation), and as band the error of the step, 4/3
    of the change when it is halved as the scheme is of order 2, the largest within 20 rows. Numbers of elements jump, now and then in
    one run of many, so their band is five times their largest scatter; that of a single row, as where the flow ends, is its own."""
    comments, names, rows = read(means)
    rows, half = ([list(map(float, row)) for row in table] for table in (rows, read(halved)[2]))
    if [row[0] for row in rows] != [row[0] for row in half[:len(rows)]]:
        sys.exit(f"{scene}: the times of both ensembles differ")
    runs = next(line[8:] for line in comments if line.startswith("# runs: "))
    lines = [line for line in comments if not re.match("# (run|status|date|options|case|runs):", line)]
    lines += [f"# scene: {scene}", f"# case: {case}", "# made by: scripts/reference_set.py, gasjet ensemble", f"# runs: {runs}",
              "# initial shape: membrane.perturbation=1e-4 membrane.perturbation_seed=1001",
              "# standard error: of the mean; scatter: standard deviation of a run",
              "# bands: 4/3 of the change of the means when the step is halved, the largest within 20 rows",
              "# bands of numbers of elements: five times their largest scatter, in a row that scatters alone its own"]
    texts, columns = ["time_s"], range(1, len(names), 2)
    cells = [[f"{row[0]:.10g}"] for row in rows]
    for at in columns:
        name, root = names[at].removesuffix("_mean"), math.sqrt(int(runs))
        errors, top = [row[at + 1] for row in rows], max(abs(row[at]) for row in rows)
        change = [abs(b[at] - a[at]) for a, b in zip(rows, half)]
        widest = max(sorted(errors[r - 2:r + 1])[1] for r in range(2, len(rows)))

        def short(value):
            """Less than 1e-9 of the column's size is round-off."""
            return "0" if value < 1e-9 * top else f"{value:.3g}"
        texts.append(f"{name},{name}_standard_error,{name}_scatter,{name}_band")
        for r, row in enumerate(rows):
            band = 5 * root * max(errors[r], widest) if name.endswith("_elements") else 4 / 3 * max(change[max(0, r - 20):r + 21])
            cells[r].append(f"{row[at]:.7g},{short(errors[r])},{short(errors[r] * root)},{short(band)}")
    (OUT / f"{scene}.csv").write_text("\n".join([*lines, *(",".join(row) for row in [texts, *cells])]) + "\n", encoding="utf-8")


def by_ensemble(scene, case):
    """Mean of the runs; fails unless 19 of 20 single runs with seeds of their own lie inside, and each of 4 means of 16. One of a
    hundred may lie outside by chance."""
    halved = ensemble(scene, case, "halved", RUNS_HALVED, "--set", "time.safety=0.4")
    write_means(scene, case, halved, ensemble(scene, case, "means", RUNS))
    reference = OUT / f"{scene}.csv"
    single = sum(inside(run(case, f"{scene}.seed", "membrane.perturbation=1e-4", f"membrane.perturbation_seed={seed}"), reference)
                 for seed in range(1001, 1021))
    whole = sum(inside(ensemble(scene, case, seed, 16, "--first-seed", seed), reference) for seed in (2001, 2101, 2201, 2301))
    print(f"{scene}: {single} of 20 further runs are inside, and {whole} of 4 means of 16")
    if single < 19 or whole < 4:
        sys.exit(1)


def write_meshes(scene, case, *options):
    """The case's mesh in both formats, by way of the work folder: a case may read the file that is written."""
    for end, more in (("obj", options), ("k", ())):
        program("mesh", "case", case, "--out", WORK / f"{scene}.{end}", *more)
    for end in ("obj", "k"):
        shutil.move(WORK / f"{scene}.{end}", OUT / f"{scene}.{end}")


# --- all of them

FINER = "membrane.mesh.refine=2 time.step=6.25e-6"  # of the same polyhedron, as programs are handed the mesh; the step by its bound
SCENES = {  # case, how its bands are found
    "tank_fill": ("cases/rigid_tank.toml", {"step": "output.history_every=5e-4", "exact": "tank_fill --times 0:0.1:1e-3"}),
    "two_gas_fill": ("OUT", {"step": "output.history_every=1.25e-4 time.gas_tolerance=1e-12"}),
    "tank_blowdown": ("cases/tank_blowdown.toml", {"stride": 2, "step": "output.history_every=5e-4", "exact": "blowdown --times 0:0.35:1e-3"}),
    # 2e-5 s halves the pieces of the path too, which are 3.9e-5 s
    "piston_leak": ("cases/piston_leak.toml", {"stride": 4, "step": "output.history_every=2e-5 time.gas_tolerance=1e-12"}),
    "sphere_vent": ("OUT", {"step": "time.step=1.25e-5", "mesh": FINER}),
    "circular_membrane": ("OUT", {"step": "time.step=1.25e-5", "mesh": FINER}),
    "plate_jet": ("cases/plate_jet.toml", {"mesh": "target.rows=480 target.columns=480", "force_until": 0.02}),
    "plate_jet_shadow": ("OUT", {"step": "time.step=1e-5", "mesh": "membrane.mesh.refine=2", "force_until": 0.002}),
    "pendulum_swing": ("cases/pendulum_swing.toml", {"step": "time.step=5e-4", "exact": "pendulum_swing --times 0:2.5:0.01"}),
    "cushion_impact": ("OUT", {"step": "time.step=2.5e-6"}),  # of this mesh: another one breathes, and is hit, at other phases
    "passenger_jet": ("cases/passenger_pendulum.toml", None),
    "passenger_no_jet": ("cases/passenger_pendulum_no_jet.toml", None),
    "passenger_sharp_jet": ("cases/passenger_sharp.toml", None),
    "passenger_sharp_no_jet": ("cases/passenger_sharp_no_jet.toml", None)}
GENERATED = {"circular_membrane": lambda path: disc(path, 8), "plate_jet_shadow": lambda path: baffle(path, 10)}
# The passenger's shape at the start is that of a run which is in no mean.
MESHES = {"sphere_vent": [], "circular_membrane": [], "plate_jet_shadow": [], "cushion_impact": [], "passenger_jet": [
    "--initial", "OUT", "--set", "membrane.perturbation=1e-4", "--set", "membrane.perturbation_seed=1001"]}


def make(scene):
    case, how = SCENES[scene]
    if case == "OUT":
        case = f"{os.path.relpath(OUT, ROOT) if OUT.is_relative_to(ROOT) else OUT}/{scene}.toml"
    if scene in GENERATED:
        GENERATED[scene](OUT / f"{scene}.obj")
    if how is None:
        by_ensemble(scene, case)
    else:
        by_refinement(scene, case, **how)
    if scene in MESHES:
        write_meshes(scene, case, *(OUT / "passenger_initial.obj" if word == "OUT" else word for word in MESHES[scene]))
    _, names, rows = read(OUT / f"{scene}.csv")
    print(f"{scene}: {len(rows) + 1} rows, {sum(name.endswith('_band') for name in names)} bands")


def write_sums():
    """Of what the folder holds, and of the cases beside it."""
    names = {str(path.relative_to(OUT)) for path in OUT.rglob("*") if path.is_file()} - {"SHA256SUMS", "README.md"}
    for table in OUT.glob("*.csv"):
        names.update(f"../{case}" for case in re.findall(r"^# case: cases/([^/\n]*)$", table.read_text(encoding="utf-8"), flags=re.M))
    sums = [f"{hashlib.sha256((OUT / name).read_bytes()).hexdigest()}  {name}\n" for name in sorted(names) if (OUT / name).is_file()]
    (OUT / "SHA256SUMS").write_text("".join(sums), encoding="utf-8")


def main():
    global OUT, WORK
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--work", type=pathlib.Path)
    parser.add_argument("scenes", nargs="*", metavar="SCENE")
    options = parser.parse_args()
    for scene in options.scenes:
        if scene not in SCENES:
            parser.error(f"no scene '{scene}'; there are: {', '.join(SCENES)}")
    OUT = (ROOT / OUT).resolve()
    with tempfile.TemporaryDirectory() as scratch:
        WORK = (options.work or pathlib.Path(scratch)).resolve()
        WORK.mkdir(parents=True, exist_ok=True)
        for scene in options.scenes or SCENES:
            make(scene)
    write_sums()


if __name__ == "__main__":
    main()
