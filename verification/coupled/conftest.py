# SPDX-License-Identifier: Apache-2.0
import pytest


@pytest.fixture(autouse=True)
def in_work(work):
    """Each test runs in an empty folder of its own."""
