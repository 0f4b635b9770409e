#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws results against time, each time as OUT.svg and OUT.png, columns found by name, by the style sheet docs/charts/gnuplot/style.gp.
  history   history.csv of one folder of `gasjet run`, or of two against each other (with and without jet): angle, acceleration of
            the pendulum's centre of gravity (filtered, where the table has it) and pressure, those that the scene has
  ensemble  the same of `gasjet ensemble`: means, each in a band of two standard errors either side
  compare   what `gasjet compare --rows` wrote: each quantity of mine and of the reference, its band in grey where it states one
  identify  curves of `gasjet identify` with their 95 % bands where they are claimed; what is masked is dotted, triangles mark where
            a band goes on above the panel. TRUE.csv: the curves that are known, as `gasjet exact tank_test_pulse` writes them
usage: scripts/plot.py history|ensemble [--title TEXT] [--name TEXT]... OUT FOLDER [FOLDER]
       scripts/plot.py compare OUT ROWS.csv
       scripts/plot.py identify [--title TEXT] OUT CURVES.csv [TRUE.csv]"""
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "docs/make/charts"))
from common import gnuplot_file, gnuplot_text  # noqa: E402

PANELS = (  # column, factor to the plot's unit, axis label
    ("pendulum_angle_rad", "180/pi", "Pendulum angle [°]"),
    ("impactor_displacement_m", "1e3", "Displacement of the impactor [mm]"),
    ("impactor_acceleration_m_s2", "1", "Acceleration of the impactor [m/s²]"),
    ("pendulum_cg_acceleration_cfc180_m_s2", "1", "Acceleration of c.g., CFC 180 [m/s²]"),
    ("pendulum_cg_acceleration_m_s2", "1", "Acceleration of c.g. [m/s²]"),
    ("pressure_Pa", "1e-3", "Pressure [kPa]"))
FILLS, BAND = ("blue_band", "vermilion_band"), 2  # the band in standard errors
TIME = "1e3*column('time_s')"


def fail(text):
    sys.stderr.buffer.write(os.fsencode(f"plot.py: {text}\n"))
    sys.exit(2)


class Table:
    """A CSV file with a column time_s, whose run has come to its end."""

    def __init__(self, path, *needed):
        self.path = path
        if not os.path.isfile(path):
            fail(f"no file {path}")
        text = pathlib.Path(path).read_text(encoding="utf-8", errors="surrogateescape")
        self.require_whole(text)
        rows = [line.split(",") for line in text.splitlines() if not line.startswith("#")]
        self.names, self.rows = rows[0] if rows else [], rows[1:]
        for column in ("time_s", *needed):
            if column not in self.names:
                fail(f"{path}: no column {column}")
        self.file = gnuplot_file(path)

    def require_whole(self, text):
        """Its folder does not say that the run has not ended, was interrupted before all was done, or is another."""
        status = pathlib.Path(os.path.dirname(self.path) or ".", "gasjet.status")
        lines = status.read_text(encoding="utf-8", errors="surrogateescape").splitlines() if status.is_file() else []
        if f"file: {os.path.basename(self.path)}" not in lines:
            return
        says = dict(line.split(": ", 1) for line in lines if ": " in line)
        if not text.endswith("\n"):
            fail(f"{self.path}: its last row has no end of line: the file is cut")
        if says.get("status", "running") == "running":
            fail(f"{self.path}: its run has not ended (see {status}): wait for its end; if it was killed, run it again")
        if says["status"] == "interrupted" and "file: journal.jsonl" in lines:
            fail(f"{self.path}: was interrupted before all runs were done (see {status}): run the same command to continue")
        own = re.search("^# run: (.*)$", text.partition("\n\n")[0], flags=re.M)
        if (own[1] if own else "") != says.get("run", ""):
            fail(f"{self.path}: is of the run '{own[1] if own else ''}', but its folder of '{says.get('run', '')}' (see {status}): run the case again")

    def __contains__(self, column):
        return column in self.names

    def values(self, column):
        at = self.names.index(column)
        return [float(row[at]) for row in self.rows if row[at]]


def bounds(column, tables):
    """The axis starts at 0 for what is never negative but for noise and comes near 0."""
    values = [value for table in tables for value in table.values(column)]
    low, high = (min(values), max(values)) if values else (0, 0)
    return f"set yrange [{'0' if high > 0 and -0.02 * high <= low < 0.3 * high else '*'}:*]\n"


def render(out, title, panels):
    """Draws the panels, gnuplot's commands of each, as OUT.svg and OUT.png; the legend stands above the first panel alone."""
    height = 90 + 230 * len(panels)
    if os.path.dirname(out):
        os.makedirs(os.path.dirname(out), exist_ok=True)
    for made, terminal in ((f"{out}.svg", f"svg size 820,{height} font face background paper"),
                           (f"{out}.png", f"pngcairo size 1640,{2 * height} font face fontscale 2 linewidth 2")):
        part = f"{made}.part"
        name = gnuplot_file(part)
        try:
            open(part, "w", encoding="utf-8").close()
        except OSError:
            fail(f"{made}: not writable")
        commands = f"""load {gnuplot_file(ROOT / 'docs/charts/gnuplot/style.gp')}
set terminal {terminal} noenhanced
set output {name}
set multiplot layout {len(panels)},1 margins screen 0.11, screen 0.97, screen {55 / height:.6g}, \\
  screen {1 - 66 / height:.6g} spacing screen 0, screen {62 / height:.6g}
set key at screen 0.97, screen {1 - 58 / height:.6g} right bottom vertical maxrows 1 Left reverse samplen 3 width -1 font small_face
set label 1 {gnuplot_text(title)} noenhanced
set xlabel 'Time [ms]' offset 0, 0.4
set autoscale xfix
set ylabel offset 0.5
{''.join(panel + chr(10) + 'unset key' + chr(10) + 'unset label 1' + chr(10) for panel in panels)}unset multiplot
"""
        drawn = subprocess.run(["gnuplot"], input=os.fsencode(commands))
        # gnuplot says nothing of a full disk.
        if drawn.returncode or not re.search(b"</svg>|IEND", pathlib.Path(part).read_bytes()[-16:]):
            os.remove(part)
            fail(f"{made}: write failed (disk full?)")
        os.replace(part, made)
        sys.stdout.buffer.write(os.fsencode(f"{made}\n"))


def draw_folders(kind, title, names, out, *folders):
    """One panel a quantity that every folder's table has."""
    suffix = "" if kind == "history" else "_mean"
    tables = [Table(f"{folder}/{kind}.csv") for folder in folders]
    shown = [panel for panel in PANELS if all(panel[0] + suffix in table for table in tables)]
    if not shown:
        fail(f"no quantity to plot is in every {kind}.csv")
    filtered = any("_cfc180_" in panel[0] for panel in shown)
    panels = []
    for column, factor, label in shown:
        if filtered and column == "pendulum_cg_acceleration_m_s2":
            continue
        curves = []
        for number, (folder, table) in enumerate(zip(folders, tables)):
            legend = names[number] if number < len(names) else os.path.basename(folder.rstrip("/")).replace("_", " ")
            if kind == "history":
                curves.append(f"{table.file} using ({TIME}):({factor}*column('{column}')) with lines linestyle {number + 1} title {gnuplot_text(legend)}")
            else:
                mean, error = f"column('{column}_mean')", f"{BAND}*column('{column}_standard_error')"
                curves.append(f"{table.file} using ({TIME}):({factor}*({mean}-{error})):({factor}*({mean}+{error})) with filledcurves "
                              f"fillcolor rgb {FILLS[number]} notitle")
                curves.append(f"{table.file} using ({TIME}):({factor}*{mean}) with lines linestyle {number + 1} "
                              f"title {gnuplot_text(f'{legend}, mean ± {BAND} s.e.')}")
        panels.append(f"{bounds(column + suffix, tables)}set ylabel '{label}'\nplot {', '.join(curves)}")
    render(out, title, panels)


def label(name):
    """The name with its unit in brackets, by the endings that the program knows."""
    header = next(ROOT.glob("driver/**/unit_endings.hpp")).read_text(encoding="utf-8")
    for ending, unit in re.findall(r'\{"(_[^"]+)", "([^"]+)"\}', header):
        if name.endswith(ending):
            return f"{name.removesuffix(ending).replace('_', ' ')} [{unit}]"
    return name.replace("_", " ")


def draw_comparison(out, path):
    table = Table(path)
    shown = [name for name in table.names if f"{name}_reference" in table]
    if not shown:
        fail(f"{path}: no column with a column <name>_reference beside it")
    legend, panels = "title 'band'", []
    for name in shown:
        value, reference, width = (f"column({gnuplot_text(name + part)})" for part in ("", "_reference", "_band"))
        band = ""
        if f"{name}_band" in table:
            band = f"{table.file} using ({TIME}):({reference}-{width}):({reference}+{width}) with filledcurves fillcolor rgb measured {legend}, "
        elif legend != "notitle" and any("_band" in column for column in table.names):
            band = f"keyentry with filledcurves fillcolor rgb measured {legend}, "
        legend = "notitle" if band else legend
        panels.append(f"{bounds(name, [table])}set ylabel {gnuplot_text(label(name))}\n"
                      f"plot {band}{table.file} using ({TIME}):({value}) with lines linestyle 1 title 'mine', \\\n"
                      f"  '' using ({TIME}):({reference}) with lines linestyle 2 title 'reference'")
    render(out, "", panels)


def draw_identified(title, out, path, known=None):
    quantities = (("mass_flow", "kg_s", "Mass flow [kg/s]", "inflow_kg_s"), ("temperature", "K", "Temperature [K]", "inflow_temperature_K"))
    table = Table(path, "masked", *(f"{name}{end}_{unit}" for name, unit, _, _ in quantities for end in ("", "_low", "_high")))
    known = Table(known, "inflow_kg_s", "inflow_temperature_K") if known else None
    claimed = "column('band_claimed') == 1" if "band_claimed" in table else "column('masked') == 0"
    panels = []
    for name, unit, text, true in quantities:
        value, low, high = (f"column('{name}{end}_{unit}')" for end in ("", "_low", "_high"))
        largest = max([0, *(v for v, masked in zip(table.values(f"{name}_{unit}"), table.values("masked")) if not masked)])
        top = f"{1.5 * float(f'{largest:.6g}'):.6g}"  # the band is cut where nothing is known; marks say where it goes on
        truth = f"column('{true}') > 0 && column('inflow_kg_s') > 0 ? column('{true}') : NaN"
        panels.append(f"""set ylabel '{text}'
set yrange [0:{top}]
plot {table.file} using ({TIME}):({claimed} ? {low} : NaN):({claimed} ? {high} : NaN) \\
  with filledcurves fillcolor rgb blue_band title '95 % band', \\
  '' using ({TIME}):({claimed} && {high} > {top} ? {top} : NaN) with points linestyle 1 pointtype 9 notitle, \\
  '' using ({TIME}):(column('masked') == 0 ? {value} : NaN) with lines linestyle 1 title 'estimate', \\
  '' using ({TIME}):(column('masked') == 1 ? {value} : NaN) with lines linestyle 4 title 'masked'"""
                      + (f", {known.file} using ({TIME}):({truth}) with lines linestyle 2 title 'known, to be found'" if known else ""))
    render(out, title, panels)


def main(kind="", *arguments):
    if kind not in ("history", "ensemble", "compare", "identify"):
        fail(f"cannot draw '{kind}'; allowed: history, ensemble, compare, identify")
    title, names, arguments = "", [], list(arguments)
    while arguments and arguments[0].startswith("--"):
        option, text = arguments.pop(0), arguments.pop(0) if arguments else None
        if text is None:
            fail(f"{option} needs a text")
        if option == "--title" and kind != "compare":
            title = text
        elif option == "--name" and kind in ("history", "ensemble"):
            names.append(text)
        else:
            fail(f"unknown option '{option}'; allowed: --title TEXT, --name TEXT")
    if len(arguments) not in ((2,) if kind == "compare" else (2, 3)):
        fail("usage: " + next(line for line in __doc__.replace("usage:", "      ").splitlines() if re.search(rf"plot.py \S*\b{kind}\b", line))[7:])
    if kind == "compare":
        draw_comparison(*arguments)
    elif kind == "identify":
        draw_identified(title, *arguments)
    else:
        draw_folders(kind, title, names, *arguments)


if __name__ == "__main__":
    main(*sys.argv[1:])
