# SPDX-License-Identifier: Apache-2.0
"""What two places of the tree say alike: pages and the keys, columns and versions of the program, lists and what they change."""

import re
import subprocess

from tree import CMAKE, CPP, rule

MAX_MUTATIONS = 200  # by hand; more are left to scripts/tests/random_mutations.py


def differences(page, what, in_code, in_page):
    """Names that only one of the two has."""
    yield from (f"{page}: no row for the {what} {name}" for name in sorted(set(in_code) - set(in_page)))
    yield from (f"{page}: no code has the {what} {name}" for name in sorted(set(in_page) - set(in_code)))


def read_keys(tree, paths):
    """Keys that the code asks a table for."""
    text = "".join(tree.read(path) for path in paths).replace("\n", "")
    return re.findall(r'[^a-z_](?:at|number|table|optional_table|tables)\(\s*"([a-z_0-9]+)"', text) + re.findall(
        r'\(\*?(?:table|reader|base|tank), "([a-z_0-9]+)"', text) + re.findall(r'\{"([a-z_0-9]+)", &Options::', text)


def row_keys(text):
    return [key for cell in re.findall(r"^\| (`[^|]*)", text, re.M) for key in re.findall("[a-z_0-9]+", cell)]


@rule
def case_keys(tree):
    """Every key that the driver reads from a case or a plan has a row in its page, and every row's key is read."""
    page, study = "docs/case_files.md", "docs/study.md"
    of_cases = tree.files(*CPP, under="driver/(base|engine|compare)/")
    yield from differences(page, "key", read_keys(tree, of_cases), row_keys(tree.read(page)))
    if tree.exists(study):
        plan = tree.read(study).partition("## The plan")[2].partition("\n## ")[0]
        of_plans = tree.files(*CPP, under="driver/many_runs/src/study_plan")
        yield from differences(study, "key", read_keys(tree, of_plans), row_keys(plan))


@rule
def columns(tree):
    """Every column of the history and of the energy file has a row in docs/results.md, and every row's column is one."""
    page = "docs/results.md"
    text = "".join(tree.read(tree.named(name)) for name in ("columns.cpp", "energy_terms.cpp")).replace("\n", "")
    written = re.findall(r'\{("[A-Za-z0-9_]+"), ', text) + re.findall(r"add\(([^,]*), ", text)
    joined = re.compile(r'" \+ [^"]* \+ "')
    in_code = [joined.sub("*", name.replace("vent +", '"vent_*" +')).replace('" + "', "").strip('"') for name in written]
    rows = re.search(r"^## .(history|energy).*?^## .summary", tree.read(page), re.S | re.M)[0]
    yield from differences(page, "column", in_code, re.findall(r"^\| `([^`]+)`", rows, re.M))


@rule
def versions(tree):
    """Every place that says a version says that of cmake/GasjetVersion.cmake, formats.hpp or the reference data."""
    def first(pattern, path):
        return (re.findall(pattern, tree.read(path), re.M) or [""])[0]

    version = first(r"^set\(GASJET_VERSION ([0-9.]+)\)$", "cmake/GasjetVersion.cmake")
    formats = dict(re.findall(r"^inline constexpr int (\w+) = (\d+);", tree.read(tree.named("formats.hpp")), re.M))
    date = first(rf"^## {re.escape(version)} \(([0-9-]+)\)$", "CHANGELOG.md")
    says = [("CHANGELOG.md", "newest release", r"^## ([0-9].*) \(", version), ("CITATION.cff", "version", r"^version: (.*)", version),
            ("CITATION.cff", "date", r"^date-released: (.*)", date)]
    rows = {"program and libraries": version, "reference data": tree.read("cases/reference/VERSION").strip(), "case files": formats["case_file"],
            "result files": formats["results"], "JSON of commands": formats["json"]}
    says += [("docs/versions.md", name, rf"^\| {name} \| ([^ ]+) \|", now) for name, now in rows.items()]
    says += [(path, "format", r'^    "format": \{ "const": (\d+),', formats["json"]) for path in tree.files("*.json", under="verification/schemas/")]
    says += [(path, "format", r"^format = (.*)", formats["case_file"]) for path in tree.files("*.toml", under="cases/")
             if re.search(r"^\[scene\]", tree.read(path), re.M)]
    for path, what, pattern, now in says:
        if not now or first(pattern, path) != now:
            yield f"{path}: the {what} is '{first(pattern, path)}', not '{now}'"
    for place, _ in tree.code_matches(r"project\(.*VERSION [0-9]+\.[0-9]+\.[0-9]", tree.files(*CMAKE)):
        yield f"{place}: the version stands in cmake/GasjetVersion.cmake alone"


def list_lines(tree, path):
    """(place, name, file, sed expression) of each line."""
    return [(place, *found[0].split("\t")[:3]) for place, found in tree.matches(r"^[^#\s].*", [path])]


def without_effect(tree, lines):
    """Lines whose expression changes nothing in their file."""
    for place, _, path, expression in lines:
        if not tree.exists(path):
            yield f"{place}: no file {path}"
        elif subprocess.run(["sed", "-e", expression, tree.path(path)], capture_output=True).stdout == open(tree.path(path), "rb").read():
            yield f"{place}: '{expression}' changes nothing in {path}"


@rule
def mutation_lines(tree):
    """Every line of a list of mutations matches a test of the build and changes its file."""
    listed = subprocess.run(["ctest", "--test-dir", tree.build, "-N"], capture_output=True, text=True, stdin=subprocess.DEVNULL).stdout
    tests = [name for name in re.findall(r"^ *Test +#[0-9]+: (.*)", listed, re.M) if not name.endswith("_NOT_BUILT")]
    for path in tree.files("mutations.tsv", "safeguards.tsv", under="verification/"):
        lines = list_lines(tree, path)
        yield from (f"{place}: '{test}' matches no test" for place, test, *_ in lines if not any(re.search(test, name) for name in tests))
        yield from without_effect(tree, lines)
        if len(lines) > MAX_MUTATIONS:
            yield f"{path}: {len(lines)} lines, {MAX_MUTATIONS} at most: what is no error of physics is left to scripts/tests/random_mutations.py"


@rule
def ablation_lines(tree):
    """Every line of ablation.tsv still turns its heuristic off: it changes its file."""
    return without_effect(tree, list_lines(tree, "benchmarks/ablation.tsv"))
