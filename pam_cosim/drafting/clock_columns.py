"""Clocks of a logger that are no plain time: too coarse for its rows, or a second one beside the first."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.measurement.pieces import usual_step
from pam_cosim.units import convert


def even_interval(times: Sequence[Array]) -> str | None:
    """How far rows are apart, where most share their time with a neighbour and all may be evenly apart; else None.

    Args:
        times: (n,) [s] of each recording.
    """
    found = [_interval(one) for one in times]
    known = [one for one in found if one is not None]
    if not known or len(known) < len(found):
        return None
    steps = [usual_step(np.diff(one)) for one in times]
    interval = _rounded(known[0], len(times[0]), steps[0])
    fits = zip(times, steps, strict=True)
    return f"{1e3 * interval:g} ms" if all(_is_even(t, interval, s) for t, s in fits) else None


def _interval(time: Array) -> float | None:
    """[s], the slope of a straight line through the times over the rows."""
    _, count = np.unique(time, return_counts=True)
    if len(count) < 2 or float(np.median(count)) < 2.0 or (np.diff(time) < 0.0).any():
        return None
    return float(np.polyfit(np.arange(len(time)), time, 1)[0])


def _rounded(interval: float, rows: int, step: float) -> float:
    """The interval with as few digits as put the last row off by less than half a step of the clock."""
    for digits in range(1, 9):
        short = float(f"{interval:.{digits}g}")
        if abs(short - interval) * rows < step / 2.0:
            return short
    return interval


def _is_even(time: Array, interval: float, step: float) -> bool:
    """Whether no time is farther from that of its row than a step of the clock."""
    off = time - time[0] - interval * np.arange(len(time))
    return bool(np.ptp(off) <= 1.5 * step)


def difference(
    first: Mapping[int, Array], first_unit: str, other: Mapping[int, Array], other_unit: str
) -> float | None:
    """By how much [s] one clock is late against another in the rows of both; None: they run differently.

    The zeros may differ; what is returned is of the first recording that has both, of which there is one at least. A
    clock that ends before the other one has rows of its own.
    """
    late = []
    for i in first.keys() & other.keys():
        one, another = (
            convert(v[i], u, "s") for v, u in ((first, first_unit), (other, other_unit))
        )
        apart = another - one
        step = max(usual_step(np.diff(one)), usual_step(np.diff(another)))
        if not np.isfinite(apart).all() or float(np.ptp(apart)) > step:
            return None
        late.append(float(np.median(apart)))
    return late[0]
