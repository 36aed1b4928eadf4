"""A rig that cannot be simulated is drawn again, so that every number of a set gives a data set."""

from __future__ import annotations

from collections.abc import Sequence
from math import sqrt
from typing import Any

import numpy as np
import pytest

from rig.integrate import integrate
from rig.schedule import Phase, Schedule


def _root(y: Sequence[float], told: Any) -> list[float]:
    return [-sqrt(y[0]) - 1.0]


def _quotient(y: Sequence[float], told: Any) -> list[float]:
    return [1.0 / (y[0] - y[0])]


def _too_large(y: Sequence[float], told: Any) -> list[float]:
    return [10.0 ** (400.0 + y[0])]


@pytest.mark.parametrize("method", ["LSODA", "BDF"])
@pytest.mark.parametrize("rates", [_root, _quotient, _too_large])
def test_what_an_equation_cannot_compute_is_a_simulation_that_failed(
    rates: Any, method: str
) -> None:
    schedule, times = Schedule.of([Phase(1.0)]), np.linspace(0.0, 1.0, 11)
    with pytest.raises(RuntimeError, match="integration"):
        integrate(rates, [0.1], schedule, times, [1e-9], 1e-6, method)
