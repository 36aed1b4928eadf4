"""Integration over pieces between which the right-hand side jumps."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from rig.schedule import Course, Joint, Schedule

Array = NDArray[np.float64]
Rates = Callable[[Sequence[float], Any], list[float]]
"""States and what the rig is told (currents, and further inputs behind them) -> time derivatives."""


def integrate(
    rates: Rates,
    start: Sequence[float],
    schedule: Schedule | Course | Joint,
    times: Array,
    atol: Sequence[float],
    rtol: float = 1e-8,
    method: str = "LSODA",
) -> Array:
    """States at the given increasing times [s], shape (states, times); restarted at every switch.

    Raises RuntimeError when the integrator gives up.
    """
    t_end = float(times[-1])
    edges = sorted({float(times[0]), t_end, *(t for t in schedule.starts if times[0] < t < t_end)})
    states = np.empty((len(start), len(times)))
    states[:, 0] = start
    y = np.array(start, dtype=float)
    for left, right in zip(edges[:-1], edges[1:], strict=True):
        told = schedule.within(left)
        wanted = np.flatnonzero((times > left + 1e-12) & (times <= right + 1e-12))
        grid = np.append(np.minimum(times[wanted], right), right)
        function = partial(_flat, rates, told)
        solution = solve_ivp(function, (left, right), y, method=method, t_eval=np.unique(grid), rtol=rtol, atol=atol)
        if not solution.success:
            raise RuntimeError(f"integration stopped between {left} s and {right} s: {solution.message}")
        states[:, wanted] = solution.y[:, : len(wanted)]
        y = solution.y[:, -1]
    return states


def _flat(rates: Rates, told: Callable[[float], tuple[float, ...]], t: float, y: Array) -> list[float]:
    return rates(y.tolist(), told(t))
