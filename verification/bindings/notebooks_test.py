# SPDX-License-Identifier: Apache-2.0
"""The notebooks run, and a run shows itself in one."""
import copy
import os
import pathlib
import unittest
from unittest import mock

try:
    import ipykernel  # noqa: F401
    import nbclient
    import nbformat
except ImportError:
    nbclient = None

FOLDER = pathlib.Path(os.environ["GASJET_SOURCE_DIR"], "bindings", "python", "notebooks")


@unittest.skipUnless(nbclient, "nbclient or ipykernel is not installed (packages python3-nbclient, python3-ipykernel)")
class Notebooks(unittest.TestCase):
    def test_each_runs(self):
        """In one kernel, which takes the longest to start; it forgets all names before the next notebook."""
        names = sorted(file.name for file in FOLDER.glob("*.ipynb"))
        books = [nbformat.read(FOLDER / name, as_version=4) for name in names]
        cells = [[cell for cell in book.cells if cell.cell_type == "code"] for book in books]
        for cell in (cell for some in cells for cell in some):  # kept without results, which would go stale
            self.assertEqual((cell.outputs, cell.execution_count), ([], None))
        forget = {"cell_type": "code", "execution_count": None, "metadata": {}, "outputs": [], "source": "%reset -f"}
        whole = nbformat.from_dict({**books[0], "cells": [cell for some in cells for cell in (copy.deepcopy(forget), *some)]})
        with mock.patch.dict(os.environ, {"PYDEVD_DISABLE_FILE_VALIDATION": "1"}):  # else the kernel talks about debuggers
            nbclient.NotebookClient(whole, timeout=60, resources={"metadata": {"path": str(FOLDER)}}).execute()
        shown = {}
        for cell in whole.cells:
            if cell.source == forget["source"]:
                shown[names[len(shown)]] = given = []
            given += [output.get("data", {}) for output in cell.outputs]
        pages = [data["text/html"] for data in shown["run_of_a_bag.ipynb"] if "text/html" in data]
        self.assertEqual([page.count("<svg") for page in pages], [3, 3])
        self.assertEqual([len(shown[name]) for name in names], [3, 4, 5])
        readme = (FOLDER / "README.md").read_text()
        self.assertTrue(all(f"({name})" in readme for name in names))


if __name__ == "__main__":
    unittest.main()
