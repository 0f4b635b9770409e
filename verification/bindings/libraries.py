#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The shared libraries: what they export, and what they are made of. Run as a program, it writes anew what the interface is compared with."""
import os
import re
import shutil
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("GASJET_BUILD", ROOT / "build"))
LIBRARIES, HEADERS = BUILD / "bindings/c", ROOT / "bindings/c/include"
INTERFACE = ROOT / "bindings/c/interface.txt"
# What goes into the library that has no part under the GPL.
OBJECTS = (r"^(bindings/c/CMakeFiles/gasjet_(c|border)|driver/(base|engine|forecast|results|compare)/|libgas/CMakeFiles/gasjet_gas|"
           r"libjet/CMakeFiles/gasjet_jet[.]|libmembrane/|libcoupling/)")


def output(*words):
    return subprocess.run([*map(str, words)], check=True, capture_output=True, text=True).stdout


def exported(library):
    return {line.split()[2] for line in output("nm", "-D", "--defined-only", LIBRARIES / library).splitlines()}


def declared(*headers):
    """Functions of the headers."""
    return {name for header in headers for name in re.findall(r"(?m)^GASJET_API [a-z0-9_ ]+\*? ?(gasjet_[a-z0-9_]+)\(", header.read_text())}


def of_c():
    """Headers of the library for C."""
    return list((HEADERS / "gasjet").glob("*.h"))


def dependencies(pattern):
    """All files that the objects of the build whose names match were compiled from."""
    found, on = set(), False
    for line in output("ninja", "-C", BUILD, "-t", "deps").splitlines():
        if line.startswith("    "):
            found |= {line.strip()} if on else set()
        elif line:
            on = re.search(pattern, line) is not None
    return found


def gpl_of(library, objects):
    """What is GPL in it: static libraries on its link line, headers that its objects include."""
    linked = re.findall(r"(?m)^.*lib(?:gsl|gasjet_(?:jet_tree|closed_form|tank_test)).*$",
                        output("ninja", "-C", BUILD, "-t", "query", f"bindings/c/{library}"))
    needed = re.findall("NEEDED.*gsl.*", output("readelf", "-d", LIBRARIES / library))
    included = [file for file in dependencies(objects) if re.search("/CGAL/license/|/gsl/", file) and not file.endswith("/lgpl.h")]
    return linked + needed + included


def file_of(name):
    return (LIBRARIES / name).resolve().name


def interface(bindings, scratch):
    """What a compiled program relies on: enumerations, structures, functions, without comments, in fixed lines."""
    empty = Path(scratch, "empty")
    empty.mkdir(exist_ok=True)
    for name in ("stddef.h", "stdint.h"):
        (empty / name).touch()
    headers = bindings / "c/include"
    text = "".join(output("cc", "-E", "-P", "-nostdinc", "-isystem", empty, "-I", headers, headers / name) for name in ("gasjet.h", "gasjet_exact.h"))
    text = re.sub(r' ?__attribute__\(\(visibility\("default"\)\)\) ?', "\n", re.sub(r"[ \n]+", " ", text))
    text = re.sub("; (typedef|enum) ", r";\n\1 ", text)
    return [line for line in dict.fromkeys(line.removesuffix(" ") for line in text.split("\n"))]


def version():
    return re.search(r"(?m)^set.GASJET_VERSION (\d+\.\d+)\.", (ROOT / "cmake/GasjetVersion.cmake").read_text())[1]


def test_exports():
    """A library exports what its headers declare, and nothing else."""
    assert exported("libgasjet.so") == declared(*of_c())
    assert exported("libgasjet_exact.so") == declared(HEADERS / "gasjet_exact.h")
    assert f"libgasjet.so.{version()}]" in output("readelf", "-d", LIBRARIES / "libgasjet.so")


def test_permissive():
    assert not gpl_of(file_of("libgasjet.so"), OBJECTS)


def test_abi(work):
    assert interface(ROOT / "bindings", work) == INTERFACE.read_text().splitlines(), (
        f"the interface differs. If version {version()} is released, raise it (docs/versions.md); write the new interface: {__file__}")


def test_valgrind(work):
    subprocess.run(["cc", "-g", ROOT / "verification/bindings/every_kind.c", f"-I{HEADERS}", f"-L{LIBRARIES}", f"-Wl,-rpath,{LIBRARIES}", "-lgasjet",
                    "-lgasjet_exact", "-o", "every_kind"], check=True)
    every_kind = ["./every_kind", "cases/tank_blowdown.toml"]
    subprocess.run(every_kind, check=True)
    if not shutil.which("valgrind"):
        import pytest
        pytest.skip("no valgrind here")
    subprocess.run(["valgrind", "-q", "--leak-check=full", "--errors-for-leak-kinds=definite,indirect,possible", "--error-exitcode=1", *every_kind],
                   check=True)


def test_can_fail(work):
    shutil.copytree(ROOT / "bindings", "bindings")
    bindings = Path(work, "bindings")
    before = interface(bindings, work)
    header = bindings / "c/include/gasjet/membrane.h"
    header.write_text(header.read_text().replace("double poisson;", "float poisson;"))
    assert interface(bindings, work) != before  # a member of another type
    # The same questions to what is under the GPL, and to a header that lacks a function.
    assert gpl_of(file_of("libgasjet_exact.so"), "^nothing")
    assert any(file.endswith("/CGAL/license/AABB_tree.h") for file in dependencies("^libjet/CMakeFiles/gasjet_jet_tree[.]"))
    gas = bindings / "c/include/gasjet/gas.h"
    gas.write_text("".join(line for line in gas.open() if "gasjet_tank_read(" not in line))
    assert exported("libgasjet.so") != declared(*(bindings / "c/include/gasjet").glob("*.h"))


if __name__ == "__main__":
    import tempfile
    with tempfile.TemporaryDirectory() as scratch:
        INTERFACE.write_text("\n".join(interface(ROOT / "bindings", scratch)) + "\n")
