#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes docs/gallery.md: each case with the first sentence of its file and pictures of its run, in docs/gallery.
Needs build/gasjet.

usage: docs/make/pages/gallery.py [--check]    --check: only compare the page with the cases, run nothing"""
import itertools
import math
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "charts"))
from common import ROOT, gasjet, output, rows_of  # noqa: E402

PAGE, PICTURES = ROOT / "docs/gallery.md", ROOT / "docs/gallery"
# What a picture may show, the first three that a case has and that change in it: column, factor, label
QUANTITIES = (
    ("pressure_Pa", "1e-3", "Pressure [kPa]"), ("pendulum_angle_rad", "180/pi", "Pendulum angle [°]"), ("impactor_displacement_m", "1e3", "Displacement of the impactor [mm]"), ("jet_force_N", "1e-3", "Jet force [kN]"),
    ("contact_force_N", "1e-3", "Contact force [kN]"), ("strap_force_N", "1e-3", "Strap force [kN]"), ("volume_m3", "1e3", "Volume [l]"),
    ("vent_outflow_kg_s", "1e3", "Outflow, vents [g/s]"), ("fabric_outflow_kg_s", "1e3", "Outflow, fabric [g/s]"),
    ("temperature_K", "1", "Temperature [K]"), ("jet_lit_elements", "1", "Elements that the jet meets"),
    ("overpressure_Pa", "1e-3", "Overpressure [kPa]"), ("skin_displacement_m", "1e3", "Largest displacement [mm]"))
HEAD = """# Gallery

Each case of the repository, with the first sentence of its file, histories of its run and, where it has one, its bag at the end.
The bag is drawn to no common scale; a history shows at most 120 of its rows. `docs/make/pages/gallery.py` writes this page and its pictures.
The paper's scene at six times, with and without jet, is [above the table of the README](../README.md#what-the-jet-does-and-what-it-costs).
[`gasjet report`](report.md) shows any run in motion, in a browser.
[Programs](examples/README.md) in Python, Fortran and C that use Gasjet have pages of their own.
"""


def cases():
    return [path for folder in ("cases", "cases/reference") for path in sorted((ROOT / folder).glob("*.toml"))]


def first_sentence(case):
    """Of the comment at the top of the file, behind the line of the licence."""
    lines = itertools.takewhile(lambda line: line.startswith("#"), case.read_text(encoding="utf-8").splitlines()[1:])
    text = " ".join(re.sub("^# *", "", line) for line in lines)
    return re.sub(r"[:.]?$", ".", re.sub(r'([a-z)"])\. .*', r"\1.", text, count=1), count=1)


def has_bag(case):
    return re.search(r"^\[membrane\]", case.read_text(encoding="utf-8"), flags=re.M)


def page():
    text = HEAD
    for case in cases():
        name = case.stem
        bag = f" ![{name}: the bag at the end](gallery/{name}.png)" if has_bag(case) else ""
        text += (f"\n## [{name}](../{case.relative_to(ROOT)})\n\n{first_sentence(case)}\n\n"
                 f"![{name}: histories](gallery/{name}.svg){bag}\n")
    return text


def shown(rows):
    """The first three quantities that change; if none does, the first three that there are."""
    there = [quantity for quantity in QUANTITIES if quantity[0] in rows[0]]
    changing = [quantity for quantity in there if any(float(row[quantity[0]]) != float(rows[0][quantity[0]]) for row in rows)]
    return (changing or there)[:3]


def draw_history(history, picture):
    """Ticks at a round quarter to half of the range; what gnuplot writes is thinned of what does not show."""
    rows, commands = rows_of(history), ""
    for column, factor, label in shown(rows):
        value = f"({factor}*column('{column}'))"
        commands += f"""set yrange [*:*]
stats '{history}' using {value} nooutput
constant = STATS_max <= STATS_min
if (constant && STATS_max > 0) set yrange [0:2*STATS_max]
set ytics tick(constant ? 0 : STATS_min, constant ? 2*STATS_max : STATS_max)
set title '{label}'
plot '{history}' every {(len(rows) + 1) // 120 + 1} using (1e3*column('time_s')):{value} with lines linestyle 1 linewidth 1.4 notitle
"""
    drawn = gnuplot(f"""load 'docs/charts/gnuplot/style.gp'
set terminal svg size 600,180 font small_face background paper
set datafile columnheaders
unset label 1 # the page has the name of the case
set xlabel 'Time [ms]'
decade(range) = 10**floor(log10(range))
round_part(range) = decade(range) * (range / decade(range) > 4 ? 2 : range / decade(range) > 2 ? 1 : 0.5)
tick(low, high) = high > low ? round_part(high - low) : 1
stats '{history}' using (1e3*column('time_s')) nooutput
set xtics tick(STATS_min, STATS_max)
set multiplot layout 1,3
{commands}
unset multiplot
""")
    drawn = re.sub(r"^.*<defs>(?:.*\n)*?.*</defs>.*\n", "", drawn, flags=re.M)
    lines = [re.sub(r" *<tspan[^>]*>|</tspan>", "", line.lstrip(" \t")) for line in drawn.split("\n")]
    picture.write_text("\n".join(line if "<text" in line else re.sub(r"(\.[0-9])[0-9]\b", r"\1", line) for line in lines), encoding="utf-8")


def gnuplot(commands):
    done = subprocess.run(["gnuplot"], input=commands, capture_output=True, encoding="utf-8", cwd=ROOT, check=True)
    sys.stderr.writelines(line + "\n" for line in done.stderr.splitlines() if not re.search("empty . range", line))
    return done.stdout


def draw_bag(frame, picture):
    """The triangles of a .vtp file, as large as the picture allows."""
    part, points, corners = "", [], []
    for line in frame.read_text(encoding="utf-8").splitlines():
        if line.lstrip().startswith("<"):
            name = re.search('Name="([^"]*)"', line)
            part = name[1] if name else ""
        elif part == "Points":
            points.append(line.split())
        elif part == "connectivity":
            corners += map(int, line.split())
    polygons = frame.with_suffix(".polygons")
    polygons.write_text("".join(f"{' '.join(points[corner])}\n" + ("\n\n" if i % 3 == 2 else "") for i, corner in enumerate(corners)),
                        encoding="utf-8")
    # The bag stands in a cube about its centre, seen turned by 40 and tilted by 65 degrees.
    turn, tilt = math.radians(40), math.radians(65)
    seen = [tuple(map(float, points[corner])) for corner in sorted(set(corners))]
    middle = [(min(p[c] for p in seen) + max(p[c] for p in seen)) / 2 for c in range(3)]
    longest = max(max(p[c] for p in seen) - min(p[c] for p in seen) for c in range(3))
    across = up = 0.0
    for point in seen:
        x, y, z = ((point[c] - middle[c]) / longest for c in range(3))
        across = max(across, abs(x * math.cos(turn) + y * math.sin(turn)))
        up = max(up, abs((y * math.cos(turn) - x * math.sin(turn)) * math.cos(tilt) + z * math.sin(tilt)))
    view = "".join(f"set {axis}range [{m - longest / 2:.9g}:{m + longest / 2:.9g}]\n" for axis, m in zip("xyz", middle))
    view += f"set view 65, 40, {1 / (across / 1.76 if across > 1.2 * up else up / 1.46):.4g}"
    gnuplot(f"""load 'docs/charts/gnuplot/style.gp'
set terminal pngcairo size 220,180 background paper
set output '{picture}'
unset border
unset tics
unset key
unset colorbox
set margins 0, 0, 0, 0
set origin 0.06, -0.05 # gnuplot leaves room for axes
{view}
set view equal xyz
set xyplane relative 0
set pm3d depthorder border linecolor rgb '#909090' linewidth 0.2 lighting primary 0.3 specular 0.1
set style fill solid 1
set datafile separator whitespace # style.gp reads tables with commas
splot '{polygons}' with polygons fillcolor rgb '#e8c890'
""")


def make_pictures():
    PICTURES.mkdir(exist_ok=True)
    for picture in PICTURES.iterdir():
        picture.unlink()
    with tempfile.TemporaryDirectory() as runs:
        for case in cases():
            folder, fields = pathlib.Path(runs, case.stem), []
            if has_bag(case):
                end = re.search(r"^ *scene\.end_time = ([^ \n]*)", output(gasjet(), "check", case), flags=re.M)[1]
                fields = ["--set", f"output.fields_every={end}"]
            output(gasjet(), "run", case.relative_to(ROOT), "--out", folder, "--quiet", *fields, cwd=ROOT)
            draw_history(folder / "history.csv", PICTURES / f"{case.stem}.svg")
            if fields:
                draw_bag(sorted(folder.rglob("bag_*.vtp"))[-1], PICTURES / f"{case.stem}.png")


def main(arguments):
    if arguments == ["--check"]:
        text = PAGE.read_text(encoding="utf-8")
        wrong = [f"docs/gallery.md: no picture docs/{name}" for name in re.findall(r"gallery/[a-z0-9_]+\.(?:svg|png)", text)
                 if not (ROOT / "docs" / name).is_file()]
        if text != page():
            wrong.append("docs/gallery.md differs from the cases: docs/make/pages/gallery.py writes it anew")
        print("\n".join(wrong) or "docs/gallery.md shows each case")
        return 1 if wrong else 0
    if arguments:
        print(f"gallery.py: unknown argument '{arguments[0]}'; allowed: --check", file=sys.stderr)
        return 2
    make_pictures()
    PAGE.write_text(page(), encoding="utf-8")
    print("docs/gallery.md")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
