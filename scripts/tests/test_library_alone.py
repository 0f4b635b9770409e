#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Shows that one library stands alone: configures, builds and installs a copy of it that has no other library beside it, then compiles
the first ```cpp block of its README against the installed package, without a warning, and runs it. It prints each line of the ```text
block that follows.
usage: scripts/tests/test_library_alone.py [--of BUILD] NAME [SCRATCH]   (NAME: gas, membrane, mesh, jet, coupling, closed_form)
  --of BUILD  installs the library of that build of the whole tree instead: does its package need another?
  SCRATCH     keeps copy and build there; a later call builds incrementally"""

import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDERS = {"closed_form": "verification/closed_form", "mesh": "libmembrane/mesh"}
MAX_EXAMPLE_LINES = 20


def cmake(*arguments):
    subprocess.run(["cmake", *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def install(library, whole, scratch):
    if whole:
        return cmake("--install", whole / library, "--prefix", scratch / "prefix")
    # The copy keeps file times, so that an unchanged library is not compiled again.
    for folder in (library, "cmake", "elementary"):
        shutil.copytree(ROOT / folder, scratch / "source" / folder, ignore=shutil.ignore_patterns("mesh") if folder == "libmembrane" else None)
    # Without optimisation: whether it stands alone does not depend on it.
    cmake("-S", scratch / "source" / library, "-B", scratch / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0",
          f"-DCMAKE_INSTALL_PREFIX={scratch}/prefix", "-DGASJET_WERROR=ON", "-DCMAKE_UNITY_BUILD=ON")
    cmake("--build", scratch / "build", "-j2")
    cmake("--install", scratch / "build")


def run_example(name, example, consumer, prefix):
    (consumer / "example.cpp").write_text(example)
    (consumer / "CMakeLists.txt").write_text(
        f"cmake_minimum_required(VERSION 3.25)\nproject(example LANGUAGES CXX)\nfind_package(gasjet_{name} REQUIRED)\n"
        f"add_executable(example example.cpp)\ntarget_link_libraries(example PRIVATE gasjet::{name})\n")
    cmake("-S", consumer, "-B", consumer / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
          "-DCMAKE_CXX_FLAGS_RELEASE=-O3 -Wall -Wextra -Werror", f"-DCMAKE_PREFIX_PATH={prefix}")
    cmake("--build", consumer / "build")
    return subprocess.run([consumer / "build/example"], cwd=consumer, check=True, capture_output=True, text=True).stdout


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1])
    parser.add_argument("--of", type=pathlib.Path)
    parser.add_argument("name")
    parser.add_argument("scratch", type=pathlib.Path, nargs="?")
    options = parser.parse_args()
    library = FOLDERS.get(options.name, f"lib{options.name}")
    readme = (ROOT / library / "README.md").read_text()
    found = re.search(r"^```cpp\n(.*?)^```.*?^```text\n(.*?)^```", readme, re.M | re.S)
    if not found or found[1].count("\n") > MAX_EXAMPLE_LINES:
        sys.exit(f"{library}/README.md: its first ```cpp block has {MAX_EXAMPLE_LINES} lines at most, and a ```text block says what it prints")
    with tempfile.TemporaryDirectory() as temporary:
        scratch = (options.scratch or pathlib.Path(temporary)).resolve()
        for folder in ("source", "prefix", "consumer"):
            shutil.rmtree(scratch / folder, ignore_errors=True)
        (scratch / "consumer").mkdir(parents=True)
        install(library, options.of and options.of.resolve(), scratch)
        printed = run_example(options.name, found[1], scratch / "consumer", scratch / "prefix")
    print(printed)
    if missing := set(found[2].splitlines()) - set(printed.splitlines()):
        sys.exit("\n".join([f"{library}/README.md: its example does not print these lines:", *missing]))


if __name__ == "__main__":
    main()
