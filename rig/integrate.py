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

PATIENCE = 20_000
"""Evaluations in one piece, some seconds of work; most pieces take a thousand."""


def integrate(
    rates: Rates,
    start: Sequence[float],
    schedule: Schedule | Course | Joint,
    times: Array,
    atol: Sequence[float],
    rtol: float = 1e-8,
    method: str = "LSODA",
    patience: int | None = None,
) -> Array:
    """States at the given increasing times [s], shape (states, times); restarted at every switch.

    patience: evaluations in one piece after which BDF does it instead: LSODA now and then misses that it must switch
    to stiff steps, as where both sides of an open valve have the same pressure. None: never.
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
        options: dict[str, Any] = {"t_eval": np.unique(grid), "rtol": rtol, "atol": atol}
        function = partial(_flat, rates, told)
        try:
            patient = function if patience is None else _counted(function, patience)
            solution = solve_ivp(patient, (left, right), y, method=method, **options)
        except _Slow:
            solution = solve_ivp(function, (left, right), y, method="BDF", **options)
        if not solution.success:
            raise RuntimeError(f"integration stopped between {left} s and {right} s: {solution.message}")
        states[:, wanted] = solution.y[:, : len(wanted)]
        y = solution.y[:, -1]
    return states


class _Slow(Exception):
    """More evaluations than allowed."""


def _counted(function: Callable[[float, Array], list[float]], most: int) -> Callable[[float, Array], list[float]]:
    count = 0

    def counted(t: float, y: Array) -> list[float]:
        nonlocal count
        count += 1
        if count > most:
            raise _Slow
        return function(t, y)

    return counted


def _flat(rates: Rates, told: Callable[[float], tuple[float, ...]], t: float, y: Array) -> list[float]:
    return rates(y.tolist(), told(t))
