"""Tests run side by side: those of a file in one process, with what they keep in memory."""

from __future__ import annotations

import pytest


def test_tests_of_a_file_share_a_process(request: pytest.FixtureRequest) -> None:
    """xdist finds the group of a test at the end of its name; where the two do not fit together it has none."""
    if not getattr(request.config.option, "loadgroup", False):  # as xdist tells its processes
        pytest.skip("tests are not kept together by their groups")
    assert request.node.nodeid.endswith("@tests/test_processes.py")
