# SPDX-License-Identifier: Apache-2.0
"""Makes a wheel of the package by CMake; pip calls it (PEP 517), as pyproject.toml says.

config_settings: build-dir, a folder where Gasjet is built already; else build/wheel is, for the Python that asks.
"""
import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TARGETS = ("gasjet_c", "gasjet_exact", "_gasjet", "_exact")
COMPONENTS = ("c", "exact", "python", "python_exact")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    version, tag = version_and_tag()
    built = folder_of(config_settings or {})
    with tempfile.TemporaryDirectory() as prefix:
        install(built, prefix)
        files = {f"gasjet/{file.name}": file.read_bytes() for file in package_files(pathlib.Path(prefix))}
    files.update(description())
    sums = f"gasjet-{version}.dist-info/RECORD"
    files[sums] = record(files, sums)
    name = f"gasjet-{version}-{tag}.whl"
    with zipfile.ZipFile(os.path.join(wheel_directory, name), "w") as wheel:
        for path, content in files.items():
            wheel.writestr(zipfile.ZipInfo(path), content, zipfile.ZIP_DEFLATED)
    return name


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """What pip wants to know before a build that takes minutes."""
    for path, content in description().items():
        file = pathlib.Path(metadata_directory) / path
        file.parent.mkdir(exist_ok=True)
        file.write_bytes(content)
    return file.parent.name


def version_and_tag():
    version = re.search(r"set\(GASJET_VERSION ([0-9.]+)\)", (ROOT / "cmake/GasjetVersion.cmake").read_text())[1]
    python = "cp{}{}".format(*sys.version_info)
    return version, f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"


def folder_of(settings):
    """Where the package is built; builds it unless the user has."""
    unknown = sorted(set(settings) - {"build-dir"})
    if unknown:
        raise RuntimeError(f"config-settings: {unknown[0]} is unknown, allowed: build-dir")
    if "build-dir" not in settings:
        return build(ROOT / "build" / "wheel")
    folder = ROOT / settings["build-dir"]
    if not (folder / "cmake_install.cmake").is_file():
        raise RuntimeError(f"build-dir: {folder} is no folder of a build, allowed: one that CMake has configured")
    return folder


def build(folder):
    """What the package consists of, and no more."""
    cmake = ["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", f"-DPython3_EXECUTABLE={sys.executable}",
             "-DGASJET_BINDINGS=ON", "-DGASJET_TESTS=OFF", "-DGASJET_BENCHMARKS=OFF"]
    subprocess.run(cmake, check=True)
    if not (folder / "python").is_dir():
        raise RuntimeError("gasjet needs the headers of this Python, NumPy and pybind11; scripts/setup_debian12.sh installs Debian's")
    subprocess.run(["cmake", "--build", folder, "--parallel", str(os.cpu_count()), "--target", *TARGETS], check=True)
    return folder


def install(folder, prefix):
    for component in COMPONENTS:
        subprocess.run(["cmake", "--install", folder, "--prefix", prefix, "--component", component, "--strip"], check=True)


def package_files(prefix):
    """The package's files, and the libraries under the names by which the modules ask for them."""
    modules = list(prefix.rglob("_gasjet" + sysconfig.get_config_var("EXT_SUFFIX")))
    if len(modules) != 1:
        raise RuntimeError(f"build-dir: has no module for {sys.executable}, allowed: a build with this Python")
    libraries = [file for file in prefix.rglob("libgasjet*.so.*") if file.is_symlink()]
    return sorted(modules[0].parent.iterdir()) + sorted(libraries)


def description():
    """What a wheel says of itself."""
    version, tag = version_and_tag()
    folder = f"gasjet-{version}.dist-info"
    about = f"Metadata-Version: 2.1\nName: gasjet\nVersion: {version}\nSummary: Airbags inflated with an analytical gas jet\n" \
            "License: Apache-2.0\nRequires-Python: >=3.9\nRequires-Dist: numpy\n"
    wheel = f"Wheel-Version: 1.0\nGenerator: pip_build\nRoot-Is-Purelib: false\nTag: {tag}\n"
    return {f"{folder}/METADATA": about.encode(), f"{folder}/WHEEL": wheel.encode(), f"{folder}/LICENSE": (ROOT / "LICENSE").read_bytes()}


def record(files, own_name):
    """Sum and size of each file."""
    lines = []
    for path, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).decode().rstrip("=")
        lines.append(f"{path},sha256={digest},{len(content)}")
    return "\n".join([*lines, f"{own_name},,", ""]).encode()
