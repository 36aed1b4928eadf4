"""Integration over pieces between which the right-hand side jumps."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import LSODA, solve_ivp

from rig.schedule import Course, Joint, Schedule

Array = NDArray[np.float64]
Rates = Callable[[Sequence[float], Any], list[float]]
"""States and what the rig is told (currents, and further inputs behind them) -> time derivatives."""

PATIENCE = 20_000
"""Evaluations in one piece, some seconds of work; most pieces take a thousand."""
_MORE = 5  # times as many for BDF
_SAME = 1e-9  # s, between instants that are one


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
    Raises RuntimeError when the integrator gives up, or leaves the numbers that an equation of the rig is made for.

    SciPy 1.17's LSODA hangs now and then within one step, without an evaluation, in runs of many short pieces; the same
    run goes through when it is repeated. Where that was seen BDF is the method, which takes about twice the time.
    """
    edges = _edges(schedule.starts, float(times[0]), float(times[-1]))
    states = np.empty((len(start), len(times)))
    states[:, 0] = start
    y = np.array(start, dtype=float)
    for left, right in zip(edges[:-1], edges[1:], strict=True):
        told = schedule.within(left)
        wanted = np.flatnonzero((times > left + 1e-12) & (times <= right + 1e-12))
        grid = np.append(np.minimum(times[wanted], right), right)
        options: dict[str, Any] = {"t_eval": np.unique(grid), "rtol": rtol, "atol": atol}
        function = partial(_flat, rates, told)
        with within_the_numbers(left, right):
            if patience is None or method != "LSODA":
                solution = solve_ivp(function, (left, right), y, method=method, **options)
            else:
                solution = solve_ivp(
                    function, (left, right), y, method=_PatientLSODA, patience=patience, **options
                )
                if not solution.success:
                    solution = _by_bdf(function, (left, right), y, options, _MORE * patience)
        if not solution.success:
            raise RuntimeError(
                f"integration stopped between {left} s and {right} s: {solution.message}"
            )
        states[:, wanted] = solution.y[:, : len(wanted)]
        y = solution.y[:, -1]
    return states


def _edges(switches: Sequence[float], begin: float, end: float) -> list[float]:
    """Begin, switches and end in order; of two instants that rounding parts, one: LSODA hangs in between."""
    edges = [begin]
    for t in sorted(t for t in switches if begin < t < end - _SAME):
        if t > edges[-1] + _SAME:
            edges.append(t)
    return [*edges, end]


@contextmanager
def within_the_numbers(left: float, right: float) -> Iterator[None]:
    """What an equation or the integrator's algebra cannot compute becomes a RuntimeError, as its other failures are.

    ValueError is what `math` raises beyond a function's domain, and what SciPy's algebra raises of what is not finite;
    LinAlgError is one of them.
    """
    try:
        yield
    except (ArithmeticError, ValueError) as error:
        raise RuntimeError(
            f"integration between {left} s and {right} s left the numbers: {error}"
        ) from error


def _by_bdf(
    function: Callable[[float, Array], list[float]], piece: tuple[float, float], y: Array, options: dict[str, Any],
    most: int,
) -> Any:  # fmt: skip
    """What LSODA did not do. Raises RuntimeError where this is too slow as well."""
    try:
        return solve_ivp(_counted(function, most), piece, y, method="BDF", **options)
    except _Slow:
        raise RuntimeError(
            f"integration between {piece[0]} s and {piece[1]} s takes too many steps"
        ) from None


class _PatientLSODA(LSODA):  # type: ignore[misc]
    """Gives up between two steps: an exception within one would leave the Fortran of the next call in disorder."""

    def __init__(self, *arguments: Any, patience: int, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self.patience = patience

    def _step_impl(self) -> tuple[bool, str | None]:
        if self.nfev > self.patience:
            return False, "too many evaluations"
        success, message = super()._step_impl()
        return bool(success), message


class _Slow(Exception):
    """More evaluations than allowed."""


def _counted(
    function: Callable[[float, Array], list[float]], most: int
) -> Callable[[float, Array], list[float]]:
    count = 0

    def counted(t: float, y: Array) -> list[float]:
        nonlocal count
        count += 1
        if count > most:
            raise _Slow
        return function(t, y)

    return counted


def _flat(
    rates: Rates, told: Callable[[float], tuple[float, ...]], t: float, y: Array
) -> list[float]:
    return rates(y.tolist(), told(t))
