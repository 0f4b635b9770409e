# SPDX-License-Identifier: Apache-2.0
"""The Debian packages of the build that GASJET_BUILD names, but for the documentation's, extracted and used from outside: the main case
and every other, the reference set, man pages, completion; all C++ packages in one project, with the default compiler and with clang++
where there is one, and programs in C, Fortran and Python."""

import os
import pathlib
import re
import shutil
import subprocess

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
OUTSIDE = ROOT / "verification/rules/outside"


def output(*command, **options):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
    assert done.returncode == 0, done.stdout
    return done.stdout


@pytest.fixture(scope="module")
def packages(tmp_path_factory):
    """The folder of the .deb files; what they install is in its folder root."""
    scratch, build = tmp_path_factory.mktemp("packages"), pathlib.Path(os.environ["GASJET_BUILD"])
    components = re.search(r'^set\(CPACK_COMPONENTS_ALL "(.*)"\)$', (build / "CPackConfig.cmake").read_text(), re.M)[1].replace(";docs", "")
    output("cpack", "-G", "DEB", "-B", scratch, "-D", f"CPACK_COMPONENTS_ALL={components}", "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip", cwd=build, umask=0o077)
    for package in scratch.glob("*.deb"):
        output("dpkg-deb", "-x", package, scratch / "root")
    return scratch


@pytest.fixture(scope="module")
def prefix(packages):
    return packages / "root/usr"


@pytest.fixture(scope="module")
def gasjet(prefix):
    return lambda *arguments: output(prefix / "bin/gasjet", *arguments)


def test_files(packages, prefix):
    assert os.listdir(packages / "root") == ["usr"]
    assert {folder.stat().st_mode & 0o777 for folder in (packages / "root/usr").glob("**")} == {0o755}  # whatever the umask
    for package in packages.glob("*.deb"):
        name = output("dpkg-deb", "-f", package, "Package").strip()
        assert (prefix / f"share/doc/{name}/copyright").stat().st_size
    if shutil.which("dpkg-shlibdeps"):
        assert "libtbb" in output("dpkg-deb", "-f", *packages.glob("gasjet_*.deb"), "Depends")


def test_cases(prefix, gasjet, tmp_path):
    cases = prefix / "share/gasjet/cases"
    gasjet("run", cases / "passenger_pendulum.toml", "--set", "scene.end_time=1e-3", "--out", tmp_path / "run", "--quiet")
    assert '"status": "done"' in (tmp_path / "run/summary.json").read_text()
    for case in [*cases.glob("*.toml"), *cases.glob("reference/*.toml")]:
        gasjet("check", case)
    output("sha256sum", "--quiet", "--strict", "-c", "SHA256SUMS", cwd=cases / "reference")


def test_judging_a_program(prefix, tmp_path):
    """As a stranger has it: no tree, no GASJET, another folder, `gasjet` found beside the script."""
    data, program = prefix / "share/gasjet", tmp_path / "program"
    program.write_text(f'#!/bin/bash\ncp "{data}/cases/reference/$(basename "$1" .json).csv" "$2"\n')
    program.chmod(0o755)
    output(data / "run_external.py", "--scenes", "tank_fill,plate_jet", "--out", "judged", "./program", cwd=tmp_path, env={"PATH": "/usr/bin:/bin"})
    assert '"verdict": "inside",' in (tmp_path / "judged/report.json").read_text()
    assert all((data / f"schemas/{schema}.schema.json").stat().st_size for schema in ("scene", "report"))


def test_manual_and_completion(prefix, gasjet):
    def completed(*words):
        script = 'source "$1" && COMP_WORDS=("${@:2}") COMP_CWORD=$(($# - 2)) && _gasjet && echo "${COMPREPLY[*]}"'
        return output("bash", "-c", script, "bash", prefix / "share/bash-completion/completions/gasjet", *words).strip()

    commands = re.findall(r"^  ([a-z]+) ", re.search(r"^Subcommands:.*?^Exit", gasjet("--help"), re.M | re.S)[0], re.M)
    assert len(commands) > 8
    for command in [[], *([name] for name in commands)]:
        page = prefix / f"share/man/man1/{'-'.join(['gasjet', *command])}.1"
        if shutil.which("man"):
            assert output("bash", "-c", 'man --warnings -l "$1" 2>&1 >/dev/null', "bash", page) == ""
        for option in re.findall(r"^ +(?:-[a-z],)?(--[a-z-]+)", gasjet(*command, "--help"), re.M):
            assert re.search(rf"^.fB{option}.fR", page.read_text().replace("\\-", "-"), re.M), (page, option)
            assert option in completed("gasjet", *command, option)
    assert completed("gasjet", "ch") == "check"
    assert completed("gasjet", "mesh", "dri") == "driver"
    assert completed("gasjet", "check", "--format", "") == "text json keys"
    assert completed("gasjet", "run", "--out", "") + completed("gasjet", "run", "") == ""  # files are left to bash
    assert re.search("Exit.codes: 0 done", (prefix / "share/man/man1/gasjet-run.1").read_text())


def test_programs(prefix):
    used = output(OUTSIDE / "use.sh", prefix)
    for package, language in (("libgasjet-exact", "C"), ("libgasjet-fortran", "Fortran"), ("python3-gasjet-exact", "Python")):
        assert not (prefix / f"share/doc/{package}").exists() or re.search(f"^{language}: .*holds", used, re.M), used


def test_other_compiler(prefix):
    clang = shutil.which("clang++") or shutil.which("clang++-14")
    if not clang:
        pytest.skip("no clang++")
    output(OUTSIDE / "use.sh", prefix, clang)


def test_without_closed_forms(prefix):
    """What is not under the GPL works without what is. After the tests that need both."""
    modules = list(prefix.rglob("_exact.*.so"))
    if not modules:
        pytest.skip("no Python package")
    assert "libgasjet_exact" in output("ldd", *modules)
    modules[0].unlink()
    assert not re.search("gsl|gasjet_exact|not found", output("ldd", *prefix.rglob("_gasjet.*.so")))
    output("/usr/bin/python3", "-B", OUTSIDE / "consumer.py", "--without-exact", env={**os.environ, "PYTHONPATH": str(modules[0].parent.parent)})


def test_container():
    """README's first command is all that the container's image runs; what it builds is there by its name."""
    command = re.search(r"^```sh\n(\S+)", (ROOT / "README.md").read_text(), re.M)[1]
    container = dict(re.findall(r"^(RUN|WORKDIR|ENV) (.*)", (ROOT / "Dockerfile").read_text(), re.M))
    folder = re.search("^([a-z/]+)/gasjet run ", (ROOT / command).read_text(), re.M)[1]
    assert container["RUN"] == command and container["ENV"].startswith(f"PATH={container['WORKDIR']}/{folder}:")
