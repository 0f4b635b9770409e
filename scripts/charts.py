#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the tables and pictures of docs/charts and docs/figures: those of the plans of cases/studies, and
  ladders       all of: ladder_passenger, the paper's scene, each rung the mean of 16 runs; ladder_passenger_5, to 5 % with a mesh four
                times as fine; ladder_passenger_effects, its effects alone on its own mesh to 5 %, more runs where a
                verdict is open; ladder_sharp and ladder_sharp_5, the scene with friction to 2 and to 5 %,
                a mesh four times as fine
  jet_cost      what the jet and the other parts of the scene cost: the one source of such numbers in README and docs
  jet_effect    README's figure and table: ensembles with and without jet, 32 runs each
  figure_3      Fig. 3 of the paper: mass flow of nitrogen at 673 K through 8.5 dm2 of hole, (G.6), and of porous fabric, (G.7). It
                states neither ambient pressure nor porosity: 101325 Pa, and the fabric for the 0.05 of its scene and over eta^2
  jet_decay     centreline decay, spreading and entrainment of the jet model against bands of measured jets (docs/theory/jet.md), and
                against three measured jets, cold, hot and sonic (docs/theory/jet_decay.md)
  jet_push      restitution that computed flows in closed cavities have, from docs/data (docs/theory/jet_push.md)
  growth        CPU time and memory of the paper's scene from 2744 to 2.8 million elements, with the exponents, beside peers; some minutes
  damaged       what damaged input does: an hour of the fuzzers, 10,000 damaged cases and 5,000 damaged decks by class
  frames        the scene with and without jet at the same times, as the paper's Figures 10 and 11
  concepts      drawings of what words say poorly
  unfolding     layers of a bag that starts folded, at six times; needs matplotlib
  examples      pictures that the programs of docs/examples draw; needs a build with bindings, scipy and matplotlib
  forecast, detection, heat_loss, ablation and the work-precision charts: see the programs of these names and benchmarks.py in
                docs/make/charts
Runs that results/studies has are not computed again. GASJET names the program."""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "docs/make/charts"))
import ablation  # noqa: E402
import benchmarks  # noqa: E402
import decay  # noqa: E402
import detection  # noqa: E402
import forecast  # noqa: E402
import growth  # noqa: E402
import heat_loss  # noqa: E402
import limits  # noqa: E402
import studies  # noqa: E402
from common import draw, gasjet, gnuplot_file, machine, build_version, output, provenance  # noqa: E402

THREADS, OUT = "1", ROOT / "docs/charts"  # options of the command
FIGURES, RESULTS = ROOT / "docs/figures", ROOT / "results"
LADDERS = {  # name: case, options
    "ladder_passenger": "passenger_pendulum --tolerance 10%",
    "ladder_passenger_5": "passenger_pendulum --tolerance 5% --finer 2 --most-runs 256",
    "ladder_passenger_effects": "passenger_pendulum --tolerance 5% --hold mesh,pieces,step,gas --most-runs 512",
    "ladder_sharp": "passenger_sharp --tolerance 2% --finer 2 --most-runs 32",
    "ladder_sharp_5": "passenger_sharp --tolerance 5% --finer 2 --most-runs 128"}


def run(*command, allowed=(0,)):
    """The program, whose progress is seen; its exit code."""
    done = subprocess.run([gasjet(), *map(str, command)], cwd=ROOT)
    if done.returncode not in allowed:
        sys.exit(f"charts.py: exit code {done.returncode} of gasjet {' '.join(map(str, command))}")


def write(path, text):
    path.write_text(text, encoding="utf-8")
    print(path)


def keep(name, text, picture, folder=None):
    """A table and, unless `picture` is none, its picture, drawn by the script of its name or by picture["script"]."""
    folder = folder or OUT
    write(folder / f"{name}.csv", text)
    if picture is not None:
        variables = dict(picture)
        draw(variables.pop("script", name), data=gnuplot_file(folder / f"{name}.csv"), out=gnuplot_file(folder / f"{name}.svg"), **variables)


def rows(path):
    return "".join(line + "\n" for line in path.read_text(encoding="utf-8").splitlines() if not line.startswith("#"))


# --- plans

def make_meshes(folder):
    """Of the plan mesh_parts."""
    folder.mkdir(parents=True, exist_ok=True)
    design, initial = folder / "design.obj", folder / "initial.obj"
    output(gasjet(), "mesh", "case", "cases/passenger_pendulum_no_jet.toml", "--initial", initial, "--out", design, cwd=ROOT)
    for part in ("none", "front", "rest", "main,attachment", "side_left,side_right", "all"):
        name = part.replace(",", "+")
        output(sys.executable, ROOT / "docs/make/charts/refine_part.py", design, initial, folder / f"{name}_design.obj",
               folder / f"{name}_initial.obj", part)


def study(name):
    folder = RESULTS / "studies" / name
    if name == "mesh_parts":
        make_meshes(folder)
    run("study", "run", f"cases/studies/{name}.toml", "--out", folder, "--threads", THREADS, allowed=(0, 3))  # 3: some runs are in no mean
    status = [line for line in (folder / "means.csv").read_text(encoding="utf-8").splitlines() if line.startswith("# status: ")]
    text = provenance() + "\n".join(status + studies.table(name, folder)) + "\n"
    keep(name, text, {} if (ROOT / f"docs/charts/gnuplot/{name}.gp").exists() else None)
    if name == "impulse_limits":
        write(OUT / "impulse_limits_fits.csv", "\n".join(limits.of_impulse(OUT)) + "\n")
    both = ("ensemble_convergence", "first_contact_seed")
    if name in both and all((OUT / f"{one}.csv").exists() for one in both):
        write(OUT / "mesh_limits.csv", "\n".join(limits.of_mesh(OUT)) + "\n")


# --- what no plan says

def ladder(name):
    case, *options = LADDERS[name].split()
    folder = RESULTS / "ladders" / name
    run("ladder", f"cases/{case}.toml", "--quantity", "pendulum_angle", "--threads", THREADS, "--out", folder, *options,
        allowed=(0, 4))  # 4: undecided is an answer too
    keep(name, (folder / "ladder.csv").read_text(encoding="utf-8"), {} if name == "ladder_passenger" else None)


def ladders():
    for name in LADDERS:
        ladder(name)


def jet_cost():
    output(gasjet(), "cost", "cases/passenger_pendulum.toml", "--runs", 9, "--quiet", "--out", "results/cost", cwd=ROOT)
    keep("jet_cost", machine("one thread used") + build_version() + rows(RESULTS / "cost/cost.csv"), None)


def jet_effect():
    folder = RESULTS / "figures"
    run("ensemble", "cases/passenger_pendulum.toml", "--against", "cases/passenger_pendulum_no_jet.toml", "--runs", 32, "--threads", THREADS,
        "--out", folder)
    write(FIGURES / "jet_effect.csv", provenance() + (folder / "effects.csv").read_text(encoding="utf-8"))
    output(ROOT / "scripts/plot.py", "ensemble", "--title", "The gas jet swings the pendulum more than twice as far", "--name", "with jet",
           "--name", "without jet", folder / "plot", folder / "passenger_pendulum", folder / "passenger_pendulum_no_jet")
    shutil.copy(folder / "plot.svg", FIGURES / "passenger_pendulum.svg")


def of_flow(name, **settings):
    """A closed form at 0 to 100 kPa. It rises like a root: finely spaced to 1 kPa."""
    options = [f"--set={key}={value}" for key, value in settings.items()]
    for times in ("0:980:20", "1000:100000:1000"):
        said = output(gasjet(), "exact", name, "--times", times, "--set", "temperature=673", "--set", "ambient_pressure=101325", *options)
        yield from [line.split(",")[1] for line in said.splitlines() if not line.startswith("#")][1:]


def figure_3():
    pressures = [*range(0, 981, 20), *range(1000, 100001, 1000)]
    columns = (of_flow("orifice_flow", area=0.085, discharge_coefficient=1), of_flow("porous_flow", fabric_area=0.085, porosity=1),
               of_flow("porous_flow", fabric_area=0.085, porosity=0.05))
    text = (provenance() + "# N2 (R = 296.8 J/(kg K), gamma = 1.4), T = 673 K, A = 0.085 m2, Cd = 1, p_a = 101325 Pa (assumed)\n"
            "overpressure_Pa,hole_kg_s,fabric_over_eta2_kg_s,fabric_eta_0.05_kg_s\n")
    keep("figure_3", text + "".join(",".join(map(str, line)) + "\n" for line in zip(pressures, *columns)), {}, FIGURES)


def jet_decay():
    folder = RESULTS / "jet_decay"
    folder.mkdir(parents=True, exist_ok=True)
    for spread in ("0.066", "0.08"):  # R0 = 1/2: distances are in diameters
        said = output(gasjet(), "exact", "round_jet", "--set", "radius=0.5", "--set", f"spread={spread}", "--set", "outlet_velocity=1",
                      "--times", "0:40:0.5")
        (folder / f"round_{spread}.csv").write_text(said, encoding="utf-8")
    said = output(gasjet(), "exact", "jet_far_field", "--times", "0.06:0.125:0.001")
    (folder / "constants.csv").write_text(said, encoding="utf-8")
    draw("jet_decay", data=gnuplot_file(folder), out=gnuplot_file(OUT / "jet_decay.svg"))
    for name, text in decay.tables().items():
        keep(name, text, {} if name == "jet_decay_sonic" else None)


def jet_push():
    draw("jet_push", data=gnuplot_file(ROOT / "docs/data/jet_cavity_cfd.csv"), out=gnuplot_file(OUT / "jet_push.svg"))


def damaged():
    output(ROOT / "scripts/tests/fuzz.sh", 450)
    keep("fuzz", provenance() + rows(ROOT / "build-fuzz/fuzz.csv"), None)
    for what, number in ("damaged_cases", 10000), ("damaged_decks", 5000):
        keep(what, provenance() + output(ROOT / f"verification/fuzz/{what}.py", gasjet(), ".", number, cwd=ROOT).replace("\t", ","), None)


def frames():
    output(ROOT / "scripts/setup_debian12.sh", "python3-vtk9", "xvfb", "xauth", "libgl1-mesa-dri")
    for case in ("passenger_pendulum", "passenger_pendulum_no_jet"):
        run("run", f"cases/{case}.toml", "--out", f"results/frames/{case}", "--quiet", "--set", "output.fields_every=5e-3")
    output("xvfb-run", "-a", "-s", "-screen 0 1600x1200x24", "/usr/bin/python3", "-B", "docs/make/figures/render_frames.py", "docs/figures/frames.jpg",
           "with jet=results/frames/passenger_pendulum", "without jet=results/frames/passenger_pendulum_no_jet", 5, 10, 20, 30, 50, 90, cwd=ROOT)


def concepts():
    for program in ("draw_concepts", "draw_folds"):
        output(sys.executable, f"docs/make/figures/{program}.py", cwd=ROOT, env={**os.environ, "GASJET": gasjet()})


def unfolding():
    output(sys.executable, "docs/make/figures/draw_unfolding.py", cwd=ROOT, env={**os.environ, "GASJET": gasjet()})


def examples():
    environment = {**os.environ, "MATPLOTLIBRC": str(ROOT / "docs/examples/examples.mplstyle"), "SOURCE_DATE_EPOCH": "0", "MPLBACKEND": "Agg"}
    for page in sorted(ROOT.glob("docs/examples/*.md")):
        if page.name != "README.md":
            output(ROOT / "verification/rules/tutorial_test.py", "--pictures", "docs/examples", gasjet(), page, cwd=ROOT, env=environment)


def forecasts():
    for name, text in forecast.tables().items():
        keep(name, text, None)


def detections():
    keep("detection", provenance() + "".join(line + "\n" for line in detection.lines(THREADS)), None)


def heat_losses():
    keep("heat_loss", provenance() + "".join(line + "\n" for line in heat_loss.lines()), None)


def growths():
    keep("growth", machine("one thread used") + build_version() + "".join(line + "\n" for line in growth.lines()), {})


def ablations():
    keep("jet_ablation", ablation.text(), None)


def benchmark(name):
    for table, (text, picture) in benchmarks.CHARTS[name]().items():
        keep(table, text, picture)


# ---

CHARTS = {**{name: ladder for name in LADDERS}, **{name: benchmark for name in benchmarks.CHARTS}, "forecast": forecasts, "detection": detections,
          "heat_loss": heat_losses, "growth": growths, "ablation": ablations, **{chart.__name__: chart for chart in (ladders, jet_cost, jet_effect, figure_3, jet_decay, jet_push, damaged, frames,
                                                                        concepts, unfolding, examples)}}
PLANS = sorted(plan.stem for plan in ROOT.glob("cases/studies/*.toml"))


def main():
    global THREADS, OUT
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--threads", default=THREADS)
    parser.add_argument("--out", type=pathlib.Path, default=OUT, help="a folder in place of docs/charts")
    parser.add_argument("--list", action="store_true", help="print the names")
    parser.add_argument("names", nargs="*", metavar="NAME")
    options = parser.parse_args()
    if options.list:
        print("\n".join([*PLANS, *CHARTS]))
        return
    for name in options.names:
        if name not in PLANS and name not in CHARTS:
            parser.error(f"no chart '{name}'; --list prints the names")
    if not options.names:
        parser.error("no name; --list prints them")
    if not os.access(gasjet(), os.X_OK):
        parser.error(f"{gasjet()} is missing: scripts/run_main_case.sh builds it")
    THREADS, OUT = options.threads, options.out.resolve()
    OUT.mkdir(parents=True, exist_ok=True)
    for name in options.names:
        if name in PLANS:
            study(name)
        elif CHARTS[name] in (ladder, benchmark):
            CHARTS[name](name)
        else:
            CHARTS[name]()


if __name__ == "__main__":
    main()
