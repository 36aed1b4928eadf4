"""Which parameters of a test are of the quick tier."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import pytest


def quick(names: Iterable[str], *chosen: str) -> list[Any]:
    """All names as parameters of a test; those that are not among the chosen ones are of the full tier."""
    every = list(names)
    assert set(chosen) <= set(every), sorted(set(chosen) - set(every))
    return [pytest.param(n, marks=[pytest.mark.full] * (n not in chosen)) for n in every]
