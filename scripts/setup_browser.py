#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Installs what `cmake --preset browser` needs beside scripts/setup_debian12.sh: Debian's emscripten and node (root or sudo),
and GSL for WebAssembly, which Debian does not have: its source package is compiled to build-browser/gsl/libgsl.a. Does
nothing when all is there.
usage: setup_browser.py"""
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIBRARY = ROOT / "build-browser" / "gsl" / "libgsl.a"
PACKAGES = ["emscripten", "nodejs", "dpkg-dev", "brotli", "zopfli"]
FOLDERS = """block blas bspline cblas cdf complex eigen err integration linalg matrix multifit ode-initval2 permutation poly qrng
randist rng roots sort specfunc statistics sys utils vector""".split()
# What GSL's configure finds for musl and WebAssembly.
CONFIG = "".join(f"#define HAVE_{name} 1\n" for name in """DECL_ACOSH DECL_ASINH DECL_ATANH DECL_EXPM1 DECL_FINITE DECL_FREXP DECL_HYPOT
DECL_ISFINITE DECL_ISINF DECL_ISNAN DECL_LDEXP DECL_LOG1P C99_INLINE INLINE COMPLEX_H EXIT_SUCCESS_AND_FAILURE IEEE_COMPARISONS
IEEE_DENORMALS MEMCPY MEMMOVE STRDUP STRTOL STRTOUL VPRINTF""".split()) + """
#define GSL_COERCE_DBL(x) (x)
#define DISCARD_POINTER(p) do { ; } while (p ? 0 : 0);
#define GSL_RANGE_CHECK 0
#define RETURN_IF_NULL(x) if (!x) { return ; }
"""


def run(*command, **options):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"setup_browser.py: {' '.join(map(str, command))}: exit {done.returncode}\n{done.stdout}")
    return done.stdout


def source_of_gsl(folder):
    """Debian's source package, from Debian's archive; the machine's settings of apt stay as they are."""
    lists = folder / "lists"
    (lists / "partial").mkdir(parents=True)
    (folder / "sources").write_text("deb-src http://deb.debian.org/debian bookworm main\n")
    apt = ["apt-get", "-q", "-o", f"Dir::Etc::sourcelist={folder}/sources", "-o", "Dir::Etc::sourceparts=/dev/null", "-o",
           f"Dir::State::lists={lists}"]
    run(*apt, "update")
    run(*apt, "source", "gsl", cwd=folder)
    return next(path for path in folder.glob("gsl-*") if path.is_dir())


def compiled(source, folder, objects):
    here = objects / folder
    here.mkdir(parents=True, exist_ok=True)
    # Files that others include are no sources of their own.
    parts = set(re.findall(r'#include "(\w+\.c)"', "".join(file.read_text("latin-1") for file in (source / folder).glob("*.c"))))
    files = [str(file) for file in sorted((source / folder).glob("*.c"))
             if file.name not in parts and not file.name.startswith(("test", "demo", "bench"))]
    run("emcc", "-O2", "-ffp-contract=off", "-w", "-c", "-DHAVE_CONFIG_H", f"-I{source}", f"-I{source / folder}", *files, cwd=here)
    return sorted(here.glob("*.o"))


def main():
    if any(shutil.which(program) is None for program in ("emcc", "node", "dpkg-source", "brotli", "zopfli")):
        run(str(ROOT / "scripts" / "setup_debian12.sh"), *PACKAGES)
    if LIBRARY.exists():
        return
    with tempfile.TemporaryDirectory() as scratch:
        source = source_of_gsl(pathlib.Path(scratch))
        (source / "config.h").write_text(CONFIG)
        for folder in [*source.iterdir()]:
            for header in folder.glob("gsl_*.h") if folder.is_dir() and folder.name != "gsl" else ():
                shutil.copy(header, source / "gsl")
        for header in source.glob("gsl_*.h"):
            shutil.copy(header, source / "gsl")
        objects = pathlib.Path(scratch) / "objects"
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            parts = [part for found in pool.map(lambda name: compiled(source, name, objects), FOLDERS) for part in found]
        LIBRARY.parent.mkdir(parents=True, exist_ok=True)
        # Archives hold names without folders: each object gets one of its own.
        named = [part.rename(part.with_name(f"{part.parent.name}_{part.name}")) for part in parts]
        (LIBRARY.parent / "include").mkdir(exist_ok=True)
        shutil.copytree(source / "gsl", LIBRARY.parent / "include" / "gsl", dirs_exist_ok=True)
        run("emar", "rcs", str(LIBRARY), *map(str, named))


if __name__ == "__main__":
    main()
