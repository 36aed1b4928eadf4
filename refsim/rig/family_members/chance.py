"""How random members are drawn."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from rig.effect import Effect

Chance = np.random.Generator
Place = Callable[[Chance], Effect]
"""Draws a member whose cause acts at one place."""


def some(rng: Chance, low: float, high: float) -> float:
    """Uniform between the bounds."""
    return float(rng.uniform(low, high))


def order(rng: Chance, low: float, high: float) -> float:
    """Uniform by order of magnitude between positive bounds."""
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))
