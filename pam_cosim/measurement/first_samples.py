"""Where a signal lies when a run begins, and how fast it changes there: a line through its first samples."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA


@dataclass(frozen=True)
class FirstSamples:
    """A signal at the first instant of a run.

    Attributes:
        value: [unit]; ``sd``: its standard deviation [unit].
        slope: [unit/s]; ``slope_sd``: its standard deviation, infinite where one sample alone tells.
    """

    value: float
    sd: float
    slope: float = 0.0
    slope_sd: float = float("inf")

    @property
    def moves(self) -> bool:
        """Whether the samples show that the signal changes."""
        return abs(self.slope) > CRITERIA.starts.moving * self.slope_sd


def first_samples(time: Array, values: Array, sigma: float, start: float) -> FirstSamples | None:
    """The signal at time ``start``; None where there is no sample.

    Args:
        time: (n,) [s].
        values: (n,) [unit], NaN where a sample is missing.
        sigma: standard deviation of the noise [unit].
        start: [s].
    """
    there: NDArray[np.intp] = np.flatnonzero(np.isfinite(values))[: CRITERIA.starts.most_samples]
    if not there.size:
        return None
    t, y = time[there] - start, values[there]
    best = FirstSamples(float(y[0]), sigma)
    for count in range(3, len(there) + 1):
        if t[count - 1] == t[0]:
            continue
        line, left = _line(t[:count], y[:count], sigma)
        freedom = count - 2
        if left > freedom + CRITERIA.starts.bent * np.sqrt(2.0 * freedom):
            break
        best = line
    return best


def _line(t: Array, y: Array, sigma: float) -> tuple[FirstSamples, float]:
    """The straight line at t = 0, and the squares that it leaves in variances of the noise."""
    matrix = np.column_stack([np.ones_like(t), t])
    inverse = np.linalg.inv(matrix.T @ matrix)
    value, slope = inverse @ matrix.T @ y
    spread = sigma * np.sqrt(np.diag(inverse))
    left = y - matrix @ np.array([value, slope])
    squares = float(left @ left) / sigma**2 if sigma else 0.0
    return FirstSamples(float(value), float(spread[0]), float(slope), float(spread[1])), squares
