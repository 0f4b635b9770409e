#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Says where the source tree breaks its rules, as `file:line: what`.
usage: rules.py [--root ROOT] [--build BUILD] [RULE...]
Without RULE all of them but mutation_lines, which asks a build for its tests.
Exit code 0: kept, 1: broken, 2: no such rule."""

import argparse
import pathlib
import subprocess
import sys

sys.dont_write_bytecode = True  # the tree keeps its files
import agreement  # noqa: E402,F401 (they register their rules)
import class_sizes  # noqa: E402,F401
import includes  # noqa: E402,F401
import texts  # noqa: E402,F401
from tree import RULES, Tree, rule  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
PAGES = HERE.parent.parent / "docs/make/pages"


def said_by(tree, command):
    return subprocess.run(["bash", "-c", command], cwd=tree.root, capture_output=True, text=True).stdout.splitlines()


@rule
def table_heads(tree):
    """Every table of the pages says what it was made on and by, and docs/provenance.tsv says from what."""
    return said_by(tree, f"perl {HERE}/table_heads.pl docs/provenance.tsv")


@rule
def numbers(tree):
    """Each number that docs/numbers.tsv lists says what its source file says."""
    return said_by(tree, f"awk -F'\\t' -f {PAGES}/csv_number.awk -f <(echo '{{ print /^#/ || NF < 7 ? \"\" : formatted($3, $4, $5, $6, $7) }}') "
                   f"docs/numbers.tsv | perl {HERE}/numbers.pl docs/numbers.tsv 100")


@rule
def tables(tree):
    """Each table that docs/tables.tsv lists is in a page and says what its CSV files say."""
    return said_by(tree, f"{PAGES}/write.sh --check . 2>&1 || echo 'docs/tables.tsv: docs/make/pages/write.sh writes the tables anew'")


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1])
    parser.add_argument("--root", type=pathlib.Path, default=HERE.parent.parent)
    parser.add_argument("--build", type=pathlib.Path)
    parser.add_argument("rules", nargs="*")
    options = parser.parse_args()
    if unknown := set(options.rules) - set(RULES):
        parser.error(f"no rule {', '.join(unknown)}; there are {', '.join(RULES)}")
    tree = Tree(options.root, options.build or options.root / "build")
    broken = False
    for name in options.rules or [name for name in RULES if name != "mutation_lines"]:
        violations = list(RULES[name](tree))
        broken |= bool(violations)
        print(*violations, f"rule {name} is broken: {len(violations)} violations" if violations else f"rule {name} is kept", sep="\n")
    sys.exit(broken)


if __name__ == "__main__":
    main()
