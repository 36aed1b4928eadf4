"""Is what a model leaves noise, or is there structure in it?"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pam_cosim.comparison import RunComparison

Array = NDArray[np.float64]

_LONGEST = 0.2  # autocorrelation is summed over at most this share of a series


@dataclass(frozen=True)
class Structure:
    """Statistics of weighted residuals, all signals and runs together.

    Attributes:
        chi2: sum of squares; ``samples`` their number.
        noise: mean square that neighbouring samples do not share (von Neumann): the white part.
        score: standard score of "the residuals are white"; above 4 they are not.
        correlation_time: how many samples make one independent one, at least 1.
    """

    chi2: float
    samples: int
    noise: float
    score: float
    correlation_time: float

    @property
    def chi2_reduced(self) -> float:
        """Mean square of the weighted residuals."""
        return self.chi2 / self.samples if self.samples else float("nan")

    @property
    def excess(self) -> float:
        """Mean square of what is not white, in noise variances."""
        return max(self.chi2_reduced - self.noise, 0.0)


def series_of(runs: Sequence[RunComparison], sigma: dict[str, float]) -> list[Array]:
    """Weighted residuals as separate series, one for each run and signal, missing samples left out."""
    found = []
    for r in runs:
        for name, s in sigma.items():
            if r.run.sample_count(name):
                residual = r.residual(name)
                found.append(residual[np.isfinite(residual)] / s)
    return found


def structure(series: Sequence[Array]) -> Structure:
    """Statistics of ``series``, weighted residuals in time order."""
    chi2 = float(sum(np.sum(e**2) for e in series))
    samples = sum(len(e) for e in series)
    steps = float(sum(np.sum(np.diff(e) ** 2) for e in series))
    pairs = sum(max(len(e) - 1, 0) for e in series)
    noise = steps / (2 * pairs) if pairs else float("nan")
    score = _whiteness(series)
    return Structure(chi2, samples, noise, score, _correlation_time(series))


def _whiteness(series: Sequence[Array]) -> float:
    """Sum over series of the lag-one correlation about zero, in standard deviations of white noise."""
    weighted, variance = 0.0, 0.0
    for e in series:
        power = float(np.sum(e**2))
        if len(e) > 2 and power > 0:
            n = len(e) - 1
            weighted += n * float(np.sum(e[1:] * e[:-1])) / power
            variance += n
    return weighted / np.sqrt(variance) if variance else 0.0


def _correlation_time(series: Sequence[Array]) -> float:
    """1 + 2 sum of the autocorrelation up to where it first falls below zero, averaged by power."""
    total, power = 0.0, 0.0
    for e in series:
        own = float(np.sum(e**2))
        if len(e) < 3 or own <= 0:
            continue
        time = 1.0
        for lag in range(1, max(2, int(_LONGEST * len(e)))):
            r = float(np.sum(e[lag:] * e[:-lag])) / own
            if r <= 2 / np.sqrt(len(e)):
                break
            time += 2 * r
        total += own * time
        power += own
    return max(1.0, total / power) if power else 1.0
