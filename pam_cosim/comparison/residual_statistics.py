"""Is what a model leaves noise, or is there structure in it?"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.fft import irfft, next_fast_len, rfft
from scipy.optimize import nnls

from pam_cosim.arrays import Array
from pam_cosim.comparison.residuals import RunComparison
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement import Signal


@dataclass(frozen=True)
class ResidualStatistics:
    """Statistics of weighted residuals, all signals and runs together.

    Attributes:
        chi2: sum of squares; ``samples`` their number.
        white_variance: mean square that neighbouring samples do not share (von Neumann): the white part.
        whiteness_score: of "the residuals are white", in standard deviations (``lag_one``).
        correlation_time: how many samples make one independent one, at least 1.
        noise_floor: mean square that noise explains, white or not: the stated one, or an estimate.
    """

    chi2: float
    samples: int
    white_variance: float
    whiteness_score: float
    correlation_time: float
    noise_floor: float = 1.0

    @property
    def chi2_reduced(self) -> float:
        """Mean square of the weighted residuals."""
        return self.chi2 / self.samples if self.samples else float("nan")

    @property
    def excess(self) -> float:
        """Mean square beyond the noise, in noise variances."""
        return max(self.chi2_reduced - self.noise_floor, 0.0)


def series_of(runs: Sequence[RunComparison], sigma: dict[str, float]) -> list[Array]:
    """Weighted residuals as separate series, one for each run and signal, missing samples left out."""
    series = []
    for r in runs:
        for name, s in sigma.items():
            if r.run.sample_count(name):
                residual = r.residual(name)
                series.append(residual[np.isfinite(residual)] / s)
    return series


def stated_of(runs: Sequence[RunComparison], signals: Mapping[str, Signal]) -> list[bool]:
    """For each series of ``series_of``, whether the noise level of its signal was stated."""
    return [not s.estimated for r in runs for n, s in signals.items() if s.fitted and s.sigma and r.run.sample_count(n)]


def residual_statistics(series: Sequence[Array], stated: Sequence[bool] | None = None) -> ResidualStatistics:
    """Statistics of ``series``, weighted residuals in time order.

    Args:
        series: one for each run and signal.
        stated: for each, whether its noise level was stated by the experimenter. Stated noise may have any colour
            up to that level; None: noise is white.
    """
    chi2 = float(sum(np.sum(e**2) for e in series))
    samples = sum(len(e) for e in series)
    steps = float(sum(np.sum(np.diff(e) ** 2) for e in series))
    pairs = sum(max(len(e) - 1, 0) for e in series)
    white_variance = steps / (2 * pairs) if pairs else float("nan")
    _, whiteness_score = lag_one(series)
    noise_floor = white_variance if stated is None else _noise_floor(series, stated)
    return ResidualStatistics(chi2, samples, white_variance, whiteness_score, _correlation_time(series), noise_floor)


def _noise_floor(series: Sequence[Array], stated: Sequence[bool]) -> float:
    """Mean square that noise explains: of stated noise at least its own variance, else the estimate for red noise."""
    total, samples = 0.0, 0
    for known in (True, False):
        chosen = [e for e, s in zip(series, stated, strict=True) if s is known and len(e) > CRITERIA.residuals.lags]
        count = sum(len(e) for e in chosen)
        if count:
            total += count * (max(1.0, _steps(chosen, 1)) if known else red_noise(chosen))
            samples += count
    return total / samples if samples else 1.0


def _steps(series: Sequence[Array], lag: int) -> float:
    """Half the mean square difference of samples at a distance."""
    squares = sum(float(np.sum((e[lag:] - e[:-lag]) ** 2)) for e in series)
    return squares / (2 * sum(len(e) - lag for e in series))


def lag_one(series: Sequence[Array]) -> tuple[float, float]:
    """Correlation of neighbours about zero over all series, and how many standard deviations of white noise that is.

    Args:
        series: residuals in time order, missing samples left out; each series has a scale of its own.
    """
    weighted, pairs = 0.0, 0
    for e in series:
        power = float(np.sum(e**2))
        if len(e) > 2 and power > 0:
            n = len(e) - 1
            weighted += n * float(np.sum(e[1:] * e[:-1])) / power
            pairs += n
    return (weighted / pairs, weighted / float(np.sqrt(pairs))) if pairs else (0.0, 0.0)


def red_noise(series: Sequence[Array]) -> float:
    """Variance of first-order autoregressive noise under a slow course.

    Samples at a distance l differ by noise, half mean square v (1 - r^l), and by what the slow course gains, a l^2.
    v, a >= 0 and the correlation r of neighbours are fitted to the first few distances.

    Args:
        series: weighted residuals in time order, each longer than those distances.
    """
    lags = np.arange(1, CRITERIA.residuals.lags + 1)
    variogram = np.array([_steps(series, int(lag)) for lag in lags])
    best, variance = np.inf, variogram[0]
    for r in np.linspace(0.0, CRITERIA.residuals.reddest, CRITERIA.residuals.colours):
        columns = np.column_stack([1 - r**lags, lags**2]) / variogram[:, None].clip(1e-300)
        weights, miss = nnls(columns, np.ones(CRITERIA.residuals.lags))
        if miss < best:
            best, variance = miss, float(weights[0])
    return max(float(variance), 0.0)


def _correlation_time(series: Sequence[Array]) -> float:
    """1 + 2 sum of the autocorrelation up to where it first falls below zero, averaged by power."""
    total, power = 0.0, 0.0
    for e in series:
        own = float(np.sum(e**2))
        if len(e) < 3 or own <= 0:
            continue
        most = max(2, int(CRITERIA.residuals.longest_memory * len(e)))
        r = _autocorrelation(e, most)[1:]
        gone = np.flatnonzero(r <= CRITERIA.residuals.memory_gone / np.sqrt(len(e)))
        time = 1 + 2 * float(np.sum(r[: gone[0]] if len(gone) else r))
        total += own * time
        power += own
    return max(1.0, total / power) if power else 1.0


def _autocorrelation(e: Array, lags: int) -> Array:
    """(lags,) about zero, over the sum of squares."""
    size = next_fast_len(len(e) + lags, real=True)
    products: Array = np.asarray(irfft(np.abs(rfft(e, size)) ** 2, size)[:lags])
    correlation: Array = products / products[0]
    return correlation
