# SPDX-License-Identifier: Apache-2.0
"""Makes a wheel of package, program and shipped cases by CMake; pip calls it (PEP 517), as pyproject.toml says.

The wheel holds all shared libraries but those of glibc and gcc. Its bytes depend on nothing but sources and tools.
config_settings: build-dir, a folder where Gasjet is built already; else build/wheel is, for the Python that asks.
"""
import base64
import hashlib
import importlib.util
import os
import pathlib
import re
import shutil
import stat
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

import pip_libraries

ROOT = pathlib.Path(__file__).resolve().parents[2]
TARGETS = ("gasjet", "gasjet_c", "gasjet_exact", "_gasjet", "_exact")
PACKAGES = "scripts/setup_debian12.sh installs all that a build needs"
COMPONENTS = ("command", "c", "exact", "python", "python_exact")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    require_tools()
    version, tag = version_and_tag()
    built = folder_of(config_settings or {})
    with tempfile.TemporaryDirectory() as prefix, tempfile.TemporaryDirectory() as package:
        install(built, prefix)
        libraries = gather(pathlib.Path(prefix), pathlib.Path(package))
        files = {f"gasjet/{path}": file.read_bytes() for path, file in package_files(pathlib.Path(package))}
        licences = {"gasjet/copyright": (pathlib.Path(prefix) / "share/doc/gasjet/copyright").read_bytes(), **pip_libraries.licences_of(libraries)}
    info = f"gasjet-{version}.dist-info"
    files.update(description())
    files.update({f"{info}/licenses/{name}": text for name, text in licences.items()})
    files[f"{info}/RECORD"] = record(files, f"{info}/RECORD")
    name = f"gasjet-{version}-{tag}.whl"
    with zipfile.ZipFile(os.path.join(wheel_directory, name), "w", zipfile.ZIP_DEFLATED, compresslevel=9) as wheel:
        for path, content in files.items():
            entry = zipfile.ZipInfo(path)  # of 1980: no time of a build
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.create_system = 3  # Unix, as the modes are
            entry.external_attr = (stat.S_IFREG | (0o755 if path == "gasjet/gasjet" else 0o644)) << 16
            wheel.writestr(entry, content, compresslevel=9)
    return name


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """What pip wants to know before a build that takes minutes."""
    require_tools()
    for path, content in description().items():
        file = pathlib.Path(metadata_directory) / path
        file.parent.mkdir(exist_ok=True)
        file.write_bytes(content)
    return file.parent.name


def fail(message):
    raise SystemExit(f"gasjet: {message}")


def require_tools():
    """Says what to install before minutes are spent."""
    if sys.implementation.name != "cpython" or sys.version_info < (3, 9):
        fail("{} is {} {}.{}, allowed: CPython 3.9 or later".format(sys.executable, sys.implementation.name, *sys.version_info))
    tools = {"cmake": "cmake", "patchelf": "patchelf"}
    if (ROOT / ".git").exists():
        tools["git"] = "git"  # the program names its commit
    for tool, package in tools.items():
        if not shutil.which(tool):
            fail(f"{tool} is missing: install Debian's package {package} (scripts/setup_debian12.sh installs all)")
    if not os.path.isfile(os.path.join(sysconfig.get_path("include"), "Python.h")):
        fail(f"{sys.executable} has no Python.h: install its headers (Debian's package python3-dev, for /usr/bin/python3)")
    if not importlib.util.find_spec("numpy"):
        fail(f"{sys.executable} has no NumPy: install Debian's package python3-numpy, and make the environment of /usr/bin/python3 with "
             "--system-site-packages")


def version_and_tag():
    version = re.search(r"set\(GASJET_VERSION ([0-9.]+)\)", (ROOT / "cmake/GasjetVersion.cmake").read_text())[1]
    python = "cp{}{}".format(*sys.version_info)
    return version, f"{python}-{python}-{platform()}"


def platform():
    """Machines with this glibc or a later one."""
    libc = re.fullmatch(r"glibc (\d+)\.(\d+).*", os.confstr("CS_GNU_LIBC_VERSION") or "") if "CS_GNU_LIBC_VERSION" in os.confstr_names else None
    if not libc:
        fail(f"{sys.executable} runs on no glibc, allowed: Linux with glibc, such as Debian")
    return "manylinux_{}_{}_{}".format(*libc.groups(), re.sub("[-.]", "_", sysconfig.get_platform().removeprefix("linux-")))


def folder_of(settings):
    """Where the package is built; builds it unless the user has."""
    unknown = sorted(set(settings) - {"build-dir"})
    if unknown:
        fail(f"config-settings: {unknown[0]} is unknown, allowed: build-dir")
    if "build-dir" not in settings:
        return build(ROOT / "build" / "wheel")
    folder = ROOT / settings["build-dir"]
    if not (folder / "cmake_install.cmake").is_file():
        fail(f"build-dir: {folder} is no folder of a build, allowed: one that CMake has configured")
    return folder


def build(folder):
    """What the package consists of, and no more."""
    cmake = ["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", f"-DPython3_EXECUTABLE={sys.executable}",
             "-DGASJET_BINDINGS=ON", "-DGASJET_TESTS=OFF", "-DGASJET_BENCHMARKS=OFF"]
    run(*cmake, hint=PACKAGES)
    if not (folder / "python").is_dir():
        fail("pybind11 is missing: install Debian's package pybind11-dev (scripts/setup_debian12.sh installs all)")
    run("cmake", "--build", folder, "--parallel", str(os.cpu_count()), "--target", *TARGETS, hint=PACKAGES)
    return folder


def install(folder, prefix):
    for component in COMPONENTS:
        run("cmake", "--install", folder, "--prefix", prefix, "--component", component, "--strip",
            hint=f"all of {folder} must be built first")


def run(*command, hint):
    if subprocess.run(command).returncode:
        fail(f"{' '.join(map(str, command[:2]))} failed, see above; {hint}")


def gather(prefix, package):
    """Copies what is installed to where it is in the package. Returns the libraries of the system that it takes in."""
    modules = list(prefix.rglob("_gasjet" + sysconfig.get_config_var("EXT_SUFFIX")))
    if len(modules) != 1:
        fail(f"build-dir: has no module for {sys.executable}, allowed: a build with this Python")
    libraries = [file for file in prefix.rglob("libgasjet*.so.*") if file.is_symlink()]  # the names by which modules ask for them
    for file in [*modules[0].parent.iterdir(), *libraries, *prefix.rglob("gasjet_enclosure-*.so"), prefix / "bin/gasjet"]:
        shutil.copy(file, package)
    found = pip_libraries.take_in(package)
    shutil.copytree(prefix / "share/gasjet/cases", package / "cases")
    return found


def package_files(package):
    """Path in the package and file, in one order everywhere."""
    return sorted((file.relative_to(package).as_posix(), file) for file in package.rglob("*") if file.is_file())


def description():
    """What a wheel says of itself."""
    version, tag = version_and_tag()
    folder = f"gasjet-{version}.dist-info"
    about = f"Metadata-Version: 2.1\nName: gasjet\nVersion: {version}\nSummary: Airbags inflated with an analytical gas jet\n" \
            "License: GPL-3.0-or-later as a whole, Apache-2.0 without the libraries that it holds\n" \
            "Requires-Python: >=3.9\nRequires-Dist: numpy<2\n"  # all that Debian 12's pybind11 knows
    wheel = f"Wheel-Version: 1.0\nGenerator: pip_build\nRoot-Is-Purelib: false\nTag: {tag}\n"
    return {f"{folder}/METADATA": about.encode(), f"{folder}/WHEEL": wheel.encode(), f"{folder}/LICENSE": (ROOT / "LICENSE").read_bytes(),
            f"{folder}/entry_points.txt": b"[console_scripts]\ngasjet = gasjet.program:main\n"}


def record(files, own_name):
    """Sum and size of each file."""
    lines = []
    for path, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
        lines.append(f"{path},sha256={digest},{len(content)}")
    return "\n".join([*lines, f"{own_name},,", ""]).encode()
