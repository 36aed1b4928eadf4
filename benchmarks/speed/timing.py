"""Times that can be compared on a machine that does other things as well, and what they are at equal error."""

from __future__ import annotations

import gc
import statistics
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from benchmarks.speed.report import steps_of

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Times:
    """Processor time of one thing, over all rounds [s]."""

    median: float
    least: float


def interleaved(runs: Sequence[Callable[[], object]], rounds: int, what: str) -> list[Times]:
    """Times each run once a round; one round warms up.

    The time is the processor's, of this process: a machine that is busy with other things as well would make long
    runs look longer than short ones by the clock on the wall.
    """
    durations: list[list[float]] = [[] for _ in runs]
    for turn in steps_of(range(rounds + 1), what):
        for run, seconds in zip(runs, durations, strict=True):
            gc.disable()
            begin = time.process_time()
            run()
            end = time.process_time()
            gc.enable()
            if turn:
                seconds.append(end - begin)
    return [Times(statistics.median(s), min(s)) for s in durations]


def scaled_error(values: Array, exact: Array) -> float:
    """Largest difference at any point, of each column in parts of its range over the run; the worst column.

    A column that does not move is measured by its size.
    """
    size = np.ptp(exact, axis=0)
    size = np.where(size > 0.0, size, np.maximum(np.abs(exact).max(axis=0), 1e-300))
    return float((np.abs(values - exact).max(axis=0) / size).max())


def time_at_error(errors: Sequence[float], seconds: Sequence[float], target: float) -> float | None:
    """Time at which a solver reaches an error, between its tolerances by straight lines in logarithms.

    Only settings count that no other beats in both time and error. None: none is accurate enough. Where all are
    more accurate than asked for it is the time of the cheapest.
    """
    front: list[tuple[float, float]] = []
    for second, error in sorted(zip(seconds, errors, strict=True)):
        if not front or error < front[-1][0]:
            front.append((max(error, 1e-16), second))
    if not front or front[-1][0] > target:
        return None
    if front[0][0] <= target:
        return front[0][1]
    logs = np.log10(np.array(front[::-1]))
    return float(10.0 ** np.interp(np.log10(target), logs[:, 0], logs[:, 1]))
