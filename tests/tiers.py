"""Which parameters of a test are of the quick tier, and which names are of the one that is run."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import Any

import pytest


def quick(names: Iterable[str], *chosen: str) -> list[Any]:
    """All names as parameters of a test; those that are not among the chosen ones are of the full tier."""
    every = list(names)
    assert set(chosen) <= set(every), sorted(set(chosen) - set(every))
    return [pytest.param(n, marks=[pytest.mark.full] * (n not in chosen)) for n in every]


def quick_but(names: Iterable[str], slow: Collection[str]) -> list[Any]:
    """All names as parameters of a test; the slow ones are of the full tier."""
    every = list(names)
    return quick(every, *(n for n in every if n not in slow))


def of_this_tier(names: Iterable[str], slow: Collection[str], config: pytest.Config) -> list[str]:
    """The names that are run now: without ``--full``, those that are not slow."""
    return [n for n in names if n not in slow or config.getoption("--full")]
