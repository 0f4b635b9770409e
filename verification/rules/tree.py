# SPDX-License-Identifier: Apache-2.0
"""The source tree as the rules see it: its files by name, their text, and the code in them."""

import fnmatch
import functools
import os
import re

RULES = {}  # name -> function of a Tree, which yields each violation as `file:line: what`

CPP = ("*.cpp", "*.hpp", "*.h", "*.cpp.in", "*.hpp.in")
CMAKE = ("CMakeLists.txt", "*.cmake", "CMakePresets.json")
SCRIPTS = ("*.sh", "*.py", "*.gp", "run")
PAGES = ("*.md",)


def rule(check):
    """Registers a function as the rule of its name."""
    RULES[check.__name__] = check
    return check


class Tree:
    """Without build folders, results and the rules themselves, which say what they forbid."""

    def __init__(self, root, build):
        self.root, self.build = root, build

    def path(self, name):
        return os.path.join(self.root, name)

    def exists(self, name):
        return os.path.exists(self.path(name))

    @functools.cached_property
    def all_files(self):
        found = []
        for folder, folders, names in os.walk(self.root):
            here = os.path.relpath(folder, self.root)
            folders[:] = [name for name in folders if not self._left_out(os.path.normpath(os.path.join(here, name)))]
            found += [os.path.normpath(os.path.join(here, name)) for name in names]
        return sorted(found)

    @staticmethod
    def _left_out(folder):
        return folder.startswith("build") or folder in ("results", ".git", "verification/rules") or "__pycache__" in folder

    def files(self, *patterns, under=""):
        """The files with such a name, in folders whose path the regular expression `under` matches from its start."""
        return [path for path in self.all_files if re.match(under, path) and
                any(fnmatch.fnmatch(os.path.basename(path), pattern) for pattern in patterns)]

    def named(self, name):
        """The one file of this name."""
        found = self.files(name)
        if len(found) != 1:
            raise SystemExit(f"rules.py: one file {name} is expected: {found}")
        return found[0]

    @functools.lru_cache(maxsize=None)
    def read(self, path):
        with open(self.path(path), encoding="utf-8", errors="replace") as file:
            return file.read()

    @functools.lru_cache(maxsize=None)
    def code(self, path):
        """The text without comments to the end of a line."""
        comment = r"//.*" if re.search(r"\.(cpp|hpp|h)(\.in)?$", path) else r"(^|(?<=\s))#.*"
        return re.sub(comment, "", self.read(path), flags=re.M)

    def matches(self, pattern, paths, in_code=False):
        """(file:line, match) of each match, comments included unless in_code."""
        for path in paths:
            text = self.code(path) if in_code else self.read(path)
            for found in re.finditer(pattern, text, re.M):
                yield f"{path}:{text.count(chr(10), 0, found.start()) + 1}", found

    def code_matches(self, pattern, paths):
        return self.matches(pattern, paths, in_code=True)
