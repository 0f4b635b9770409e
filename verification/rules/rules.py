#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Says where the source tree breaks its rules, as `file:line: what`.
usage: rules.py [--root ROOT] [--build BUILD] [RULE...]
Without RULE all of them but mutation_lines, which asks a build for its tests.
Exit code 0: kept, 1: broken, 2: no such rule."""

import argparse
import pathlib
import sys

sys.dont_write_bytecode = True  # the tree keeps its files
import agreement  # noqa: E402,F401 (they register their rules)
import class_sizes  # noqa: E402,F401
import includes  # noqa: E402,F401
import texts  # noqa: E402,F401
from tree import RULES, Tree  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent


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
