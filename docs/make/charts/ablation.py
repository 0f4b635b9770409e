# SPDX-License-Identifier: Apache-2.0
"""What each heuristic of the fast visibility route is worth: builds benchmarks/jet_ablation.cpp of HEAD as it is and once for each name
in benchmarks/ablation.tsv with that heuristic turned off, demands the same masks of all, and lets them run in turns on one core.
Lines of jet_ablation.csv: for each heuristic and state the time of a query with it and without [us], medians over the turns, the
median of their ratios in a turn, and half of what the quartiles of these differ by. Programs are kept in results/ablation/COMMIT."""
import csv
import os
import shutil
import statistics
import subprocess
import sys

from common import ROOT, machine, output

AS_IT_IS, TURNS = "as it is", 12


def changes():
    """{heuristic: [(file, expression of sed's that turns it off)]}"""
    found = {}
    for line in (ROOT / "benchmarks/ablation.tsv").read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            name, file, expression, *_ = line.split("\t")
            found.setdefault(name, []).append((file, expression))
    return found


def extract(commit, source, *files):
    archive = subprocess.run(["git", "archive", commit, *files], cwd=ROOT, stdout=subprocess.PIPE, check=True).stdout
    subprocess.run(["tar", "-xm", "-C", source], input=archive, check=True)


def build(scratch, name):
    """Warnings stay warnings: a variable may be unused. Files are compiled together as in a release, ccache or not."""
    source, folder = scratch / "source", scratch / "build"
    output("cmake", "-S", source, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON", "-DGASJET_WERROR=OFF",
           "-DGASJET_BENCHMARKS=ON", "-DGASJET_TESTS=OFF", "-DGASJET_BINDINGS=OFF")
    done = subprocess.run(["cmake", "--build", folder, "--target", "jet_ablation", "-j", str(os.cpu_count())], capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{done.stdout[-4000:]}\nablation.py: does not build: {name}")
    shutil.copy(folder / "benchmarks/jet_ablation", scratch / "programs" / name)


def build_all(scratch, commit, heuristics):
    """An archive names its commit, whatever is changed in it: the driver is compiled once."""
    (scratch / "programs").mkdir(parents=True, exist_ok=True)
    (scratch / "source").mkdir(exist_ok=True)
    if not (scratch / "programs" / AS_IT_IS).exists():
        extract(commit, scratch / "source")
        build(scratch, AS_IT_IS)
    for name, lines in heuristics.items():
        if not (scratch / "programs" / name).exists():
            for file, expression in lines:
                output("sed", "-i", "-e", expression, scratch / "source" / file)
            build(scratch, name)
            extract(commit, scratch / "source", *{file for file, _ in lines})


def parsed(text):
    """{(state, elements): mean time of a query}, and the rows without their times."""
    rows = [row for row in csv.reader(line for line in text.splitlines() if not line.startswith("#"))][1:]
    return {tuple(row[:2]): statistics.fmean(map(float, row[5].split())) for row in rows}, [row[:5] for row in rows]


def compared(times, name):
    """The lines of a heuristic, of its times and of those as it is, a dictionary a turn."""
    def quantile(values, share):
        return sorted(values)[int(share * (len(values) - 1) + 0.5)]
    for key in times[AS_IT_IS][0]:
        own, without = ([turn[key] for turn in times[which]] for which in (AS_IT_IS, name))
        ratios = [b / a for a, b in zip(own, without)]
        yield (f"{name},{','.join(key)},{quantile(own, 0.5):.3f},{quantile(without, 0.5):.3f},{quantile(ratios, 0.5):.3f},"
               f"{(quantile(ratios, 0.75) - quantile(ratios, 0.25)) / 2:.3f}")


def text():
    commit, heuristics = output("git", "rev-parse", "HEAD", cwd=ROOT).strip(), changes()
    scratch = ROOT / "results/ablation" / commit[:12]
    build_all(scratch, commit, heuristics)
    times, first = {AS_IT_IS: [], **{name: [] for name in heuristics}}, None
    for _ in range(TURNS):
        for name, turns in times.items():
            said = output("taskset", "-c", os.cpu_count() - 1, scratch / "programs" / name)
            first = first or said
            means, masks = parsed(said)
            if masks != parsed(first)[1]:
                sys.exit(f"ablation.py: other masks without: {name}")
            turns.append(means)
    head = "".join(line + "\n" for line in first.splitlines() if line.startswith("#"))
    note = (f"# medians of {TURNS} turns; without: this heuristic alone turned off, with the same masks; ratio: of the two programs of a turn; "
            "spread: half of what its quartiles differ by\nheuristic,state,elements,query_us,without_us,ratio,spread\n")
    return machine("one used") + head + note + "".join(line + "\n" for name in heuristics for line in compared(times, name))
