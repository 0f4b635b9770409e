# SPDX-License-Identifier: Apache-2.0
"""What makes the wheel refuses by name, before it compiles; and the files that come with the package."""
import os
import pathlib
import sys
import types
import unittest
from unittest import mock

import gasjet

SOURCE = os.environ["GASJET_SOURCE_DIR"]
sys.path.append(os.path.join(SOURCE, "bindings/python"))
import pip_build  # noqa: E402
import pip_libraries  # noqa: E402


class Refused(unittest.TestCase):
    def setUp(self):
        # What the machine lacks by itself is not what is tested.
        for name, answer in (("shutil.which", lambda tool: tool), ("importlib.util.find_spec", lambda name: name), ("os.path.isfile", lambda file: True)):
            patch = mock.patch(name, answer)
            patch.start()
            self.addCleanup(patch.stop)

    def refuses(self, words, name, answer, call=pip_build.require_tools):
        with mock.patch(name, answer), self.assertRaisesRegex(SystemExit, words):
            call()

    def test_a_missing_tool(self):
        for tool in ("cmake", "patchelf", "git"):
            with mock.patch("pathlib.Path.exists", lambda path: True):
                self.refuses(f"^gasjet: {tool} is missing: install Debian's package {tool} ", "shutil.which", lambda name: name != tool)
        with mock.patch("pathlib.Path.exists", lambda path: False):  # an archive of the sources needs no git
            with mock.patch("shutil.which", lambda name: name != "git"):
                pip_build.require_tools()

    def test_a_python_that_cannot(self):
        self.refuses("is pypy 3.*, allowed: CPython", "sys.implementation", types.SimpleNamespace(name="pypy"))
        self.refuses("is cpython 3.8, allowed: CPython 3.9", "sys.version_info", (3, 8, 18))
        self.refuses("has no Python.h: install its headers .*python3-dev", "os.path.isfile", lambda file: False)
        self.refuses("has no NumPy: install Debian's package python3-numpy", "importlib.util.find_spec", lambda name: None)
        self.refuses("runs on no glibc", "os.confstr", lambda name: "", pip_build.platform)

    def test_settings(self):
        for settings, words in (({"build": "1"}, "^gasjet: config-settings: build is unknown, allowed: build-dir$"),
                                ({"build-dir": "absent"}, "absent is no folder of a build")):
            with mock.patch("pathlib.Path.is_file", lambda path: False), self.assertRaisesRegex(SystemExit, words):
                pip_build.folder_of(settings)
        with self.assertRaisesRegex(SystemExit, "cmake --install failed, see above; all of absent must be built first"):
            pip_build.install("absent", "prefix")
        with self.assertRaisesRegex(SystemExit, "build-dir: has no module for .*python3"):
            pip_build.gather(pathlib.Path(SOURCE, "cmake"), pathlib.Path("absent"))

    def test_a_library_that_the_machine_lacks(self):
        said = mock.Mock(stdout="\tlibgsl.so.27 => not found\n\tlibm.so.6 => /lib/libm.so.6 (0x00007f)\n")
        with mock.patch("subprocess.run", lambda *words, **options: said), self.assertRaisesRegex(SystemExit, "program needs libgsl.so.27"):
            pip_libraries.libraries_of(pathlib.Path("program"), pathlib.Path("/"))


class Shipped(unittest.TestCase):
    def test_cases_and_references_by_name(self):
        cases, references = gasjet.cases(), gasjet.references()
        self.assertEqual(set(cases), {file.stem for pattern in ("*.toml", "reference/*.toml") for file in pathlib.Path(SOURCE, "cases").glob(pattern)})
        self.assertEqual(gasjet.compare(gasjet.run(cases["tank_blowdown"]), references["tank_blowdown"])["verdict"], "inside")

    def test_without_them(self):
        with mock.patch("os.path.isfile", lambda file: False), self.assertRaisesRegex(gasjet.InputError, "cases: are not found.*GASJET"):
            gasjet.cases()


if __name__ == "__main__":
    unittest.main()
