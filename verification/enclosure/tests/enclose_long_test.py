# SPDX-License-Identifier: Apache-2.0
"""All bounds that ship."""

import os

import tubes


def test_all_bounds_computed_anew_meet_shipped_ones():
    for name in tubes.TUBES:
        tubes.expect_shipped(os.environ["GASJET"], name)
