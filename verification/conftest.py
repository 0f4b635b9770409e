# SPDX-License-Identifier: Apache-2.0
"""The folder that tests of the command run in, and how tests that are skipped tell ctest."""
import os
import tempfile

import pytest
from command import ROOT


@pytest.fixture
def work(monkeypatch):
    """An empty folder, in which `cases` are those of the tree."""
    with tempfile.TemporaryDirectory() as folder:
        os.chmod(folder, 0o755)  # some tests run the command as another user
        os.symlink(ROOT / "cases", folder + "/cases")
        monkeypatch.chdir(folder)
        yield folder


def pytest_terminal_summary(terminalreporter):
    kinds = terminalreporter.stats.keys()
    if "skipped" in kinds and not kinds & {"passed", "failed", "error"}:
        terminalreporter._session.exitstatus = 77  # ctest's code of a skipped test
