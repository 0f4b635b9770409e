#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the sh blocks of tutorials in order, as a reader does: in one shell, which begins in a clone with the block of
docs/tutorials/README.md. Each line of a text block has to be a line that the block before it printed; `...` in it stands for any
characters.
usage: tutorial_test.py [--pictures FOLDER] GASJET TUTORIAL...     --pictures: where the pictures go that the blocks draw"""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
RUN_EACH = 'for block; do . "$block" >"$block.output" 2>&1 </dev/null; done'


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1])
    parser.add_argument("--pictures", type=pathlib.Path)
    parser.add_argument("gasjet", type=pathlib.Path)
    parser.add_argument("tutorials", type=pathlib.Path, nargs="+")
    options = parser.parse_args()
    pages = [ROOT / "docs/tutorials/README.md", *options.tutorials]
    blocks = [block for page in pages for block in re.findall(r"^```(\w*)\n(.*?)^```$", page.read_text(), re.M | re.S)]
    with tempfile.TemporaryDirectory() as temporary:
        scratch = pathlib.Path(temporary)
        clone = scratch / "clone"
        clone.mkdir()
        for path in ROOT.iterdir():
            if not path.name.startswith("build"):
                (clone / path.name).symlink_to(path)
        (clone / "build").symlink_to(options.gasjet.resolve().parent)

        commands, shown = [], []  # files of commands; (number of commands so far, line that the last one prints)
        for kind, text in blocks:
            if kind == "sh":
                commands.append(scratch / f"{len(commands):03}.sh")
                commands[-1].write_text(text)
            elif kind == "text":
                shown += [(len(commands), line) for line in text.splitlines()]
        ran = subprocess.run(["bash", "-euo", "pipefail", "-c", RUN_EACH, "bash", *commands], cwd=clone)
        printed = [path.read_text(errors="replace") for path in sorted(scratch.glob("*.output"))]
        if ran.returncode:
            sys.exit(f"{commands[len(printed) - 1].read_text()}\n{printed[-1]}\nthis block fails")
        for number, line in shown:
            pattern = ".*".join(map(re.escape, line.split("...")))
            if not any(re.fullmatch(pattern, said) for said in printed[number - 1].splitlines()):
                sys.exit(f"{printed[number - 1]}\nnot printed: {line}")
        if len(commands) < 2 or not shown:
            sys.exit("no commands, or nothing shown of what they print")
        for picture in (path for path in (scratch / "tutorials").glob("*") if options.pictures and path.suffix in (".svg", ".png", ".gif")):
            shutil.copy(picture, options.pictures)
    print(f"{len(commands)} blocks run, {len(shown)} lines as shown")


if __name__ == "__main__":
    main()
