"""Tests run side by side: those of a file in one process, with what they keep in memory."""

from __future__ import annotations

import os

import pytest


@pytest.mark.skipif("PYTEST_XDIST_WORKER" not in os.environ, reason="they run in one process")
def test_tests_of_a_file_share_a_process(request: pytest.FixtureRequest) -> None:
    """xdist finds the group of a test at the end of its name; where the two do not fit together it has none."""
    assert request.node.nodeid.endswith("@tests/test_processes.py")
