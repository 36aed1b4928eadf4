"""Where a signal lies when a run begins, and how fast it changes there: a line through its first samples."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA

_LEAST = 3  # samples, through which no line has to go


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
    """The signal at time ``start``; None where there is no sample, or the first comes after a pause.

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
    if len(t) > 1 and t[0] > CRITERIA.recognition.pause * float(np.median(np.diff(t))):
        return None  # a line through such samples says what the signal did then, not where it was
    first = FirstSamples(float(y[0]), sigma)
    if len(there) < _LEAST or not sigma:
        return first
    lines = _lines(t, y - y[0])
    freedom = np.arange(_LEAST, len(there) + 1) - 2.0
    left = lines.left[_LEAST - 1 :] / sigma**2
    bent = np.flatnonzero(left > freedom + CRITERIA.starts.bent * np.sqrt(2.0 * freedom))
    count = (int(bent[0]) if bent.size else len(freedom)) + _LEAST - 1
    if count < _LEAST or lines.spread[count - 1] <= 0.0:
        return first
    n, mean, spread = float(count), lines.mean[count - 1], lines.spread[count - 1]
    slope = lines.slope[count - 1]
    return FirstSamples(
        float(y[0] + lines.level[count - 1] - slope * mean),
        float(sigma * np.sqrt(1.0 / n + mean**2 / spread)),
        float(slope),
        float(sigma / np.sqrt(spread)),
    )


@dataclass(frozen=True)
class _Lines:
    """Straight lines through the first one, two, ... n samples: (n,) each.

    Attributes:
        mean, level: of time and of the signal.
        spread: sum of squared distances from the mean in time.
        slope: of the line. left: squares that it leaves.
    """

    mean: Array
    level: Array
    spread: Array
    slope: Array
    left: Array


def _lines(t: Array, y: Array) -> _Lines:
    n = np.arange(1.0, len(t) + 1.0)
    mean, level = np.cumsum(t) / n, np.cumsum(y) / n
    spread = np.cumsum(t**2) - n * mean**2
    both = np.cumsum(t * y) - n * mean * level
    slope = np.divide(both, spread, out=np.zeros(len(t)), where=spread > 0.0)
    left = np.maximum(np.cumsum(y**2) - n * level**2 - slope * both, 0.0)
    return _Lines(mean, level, spread, slope, left)
