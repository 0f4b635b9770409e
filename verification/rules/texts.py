# SPDX-License-Identifier: Apache-2.0
"""What holds of each file by itself, and of names in texts: licence, length, format, words, links, equations."""

import os
import re
import shutil
import subprocess

from tree import CMAKE, CPP, PAGES, SCRIPTS, rule

MAX_FILE_LINES = 300


@rule
def spdx(tree):
    for path in tree.files(*CPP, "CMakeLists.txt", "*.cmake", *SCRIPTS):
        if not re.match(r"(#!.*\n)?(//|#) SPDX-License-Identifier: Apache-2\.0\n", tree.read(path) + "\n"):
            yield f"{path}:1: does not begin with the line SPDX-License-Identifier: Apache-2.0"


@rule
def file_size(tree):
    for path in tree.files(*CPP, *CMAKE, *SCRIPTS, under="(?!docs/make/figures/)"):  # drawings are long as data are
        if tree.read(path).count("\n") > MAX_FILE_LINES:
            yield f"{path}:{MAX_FILE_LINES + 1}: more than {MAX_FILE_LINES} lines"


@rule
def format(tree):
    """Every C++ file is as clang-format writes it."""
    if not shutil.which("clang-format"):
        return ["clang-format is not installed"]
    paths = [path for path in tree.files(*CPP) if not path.endswith(".in")]
    said = subprocess.run(["clang-format", "--dry-run", *paths], cwd=tree.root, capture_output=True, text=True).stderr
    return [line for line in said.splitlines() if "warning:" in line]


@rule
def forbidden_words(tree):
    """Compiler options that change values, paths of one machine, unfinished work."""
    options = r"-(ffast-math|Ofast|funsafe-math-optimizations|fassociative-math|ffinite-math-only)"
    for place, found in tree.code_matches(options, tree.files(*CPP, *CMAKE, *SCRIPTS)):
        yield f"{place}: {found[0]} changes values"
    paths = tree.files(*CPP, *CMAKE, *SCRIPTS, *PAGES, "*.in", "*.json", "*.toml", "*.tsv", "*.csv", "*.yaml", "*.j2")
    for place, found in tree.matches(r"(^|[^A-Za-z0-9_./$}\n-])/(work|home|root|tmp|Users|mnt)/.*|\b(TODO|FIXME|XXX)\b", paths):
        yield f"{place}: {found[0]}"


@rule
def equation_tags(tree):
    """Every tag such as (G.3) in code, pages and cases is an equation of docs/theory, each of which is named in the code and defined once."""
    defined = {}
    for place, found in tree.matches(r"\\tag\{([GMJK]\.[0-9]+)\}", tree.files(*PAGES, under="docs/theory/")):
        if found[1] in defined:
            yield f"{place}: equation {found[1]} defined twice"
        defined[found[1]] = place
    for place, found in tree.matches(r"(?<![A-Za-z0-9_.])[GMJK]\.[0-9]+", tree.files(*CPP, *PAGES, "*.toml")):
        if found[0] not in defined:
            yield f"{place}: no equation {found[0]} in docs/theory"
    named = {found[0] for _, found in tree.matches(r"(?<=[(, ])[GMJK]\.[0-9]+(?=[),])", tree.files(*CPP))}
    yield from (f"{place}: no code names equation {tag}" for tag, place in defined.items() if tag not in named)


@rule
def links(tree):
    """Every relative link of a Markdown file, code blocks aside, leads to a file of the tree."""
    for place, found in tree.matches(r"^```(?:.*\n)*?```|\]\(([^)]+)\)", tree.files(*PAGES)):
        target = found[1] or "#"
        file = os.path.join(os.path.dirname(place), target.split("#")[0])
        if "://" not in target and not target.startswith("#") and not tree.exists(file):
            yield f"{place}: no file {target}"


@rule
def exact_names(tree):
    """Every closed form that a text, a case or a script names as `gasjet exact NAME` is in the catalogue."""
    known = re.findall(r"^\*\*`([a-z0-9_]+)`\*\*:", tree.read("docs/exact.md"), re.M)
    paths = tree.files(*PAGES, "*.toml", "*.sh", "*.py", "*.csv", under="(?!verification/)")  # tests name absent ones
    for place, found in tree.matches(r'gasjet"? exact ([a-z0-9_]+)', paths):
        if found[1] not in known:
            yield f"{place}: no closed form {found[1]} in docs/exact.md"
