"""FMUs of the benches, built once (the cache keeps them), and how many processes a diagnosis may use here."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from pam_cosim import study


@pytest.fixture(scope="session")
def bench() -> Callable[[str], Path]:
    """The FMU of a bench by its name."""
    return study.build


@pytest.fixture(scope="session")
def workers() -> int | None:
    """One process for each diagnosis where the tests themselves run side by side."""
    return 1 if "PYTEST_XDIST_WORKER" in os.environ else None
