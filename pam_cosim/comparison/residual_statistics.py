"""Is what a model leaves noise, or is there structure in it?"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.fft import irfft, next_fast_len, rfft
from scipy.optimize import nnls

from pam_cosim.arrays import Array
from pam_cosim.comparison.residuals import RunComparison
from pam_cosim.comparison.rounding import expected_squares, standardized_residuals
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement import Signal


@dataclass(frozen=True)
class ResidualStatistics:
    """Statistics of weighted residuals, all signals and runs together.

    Attributes:
        chi2: sum of squares; ``samples`` how many samples these count for: what noise alone gives on average.
        white_variance: mean square that neighbouring samples do not share (von Neumann): the white part.
        whiteness_score: of "the residuals are white", in standard deviations (``lag_one``).
        correlation_time: how many samples make one independent one, at least 1.
        noise_floor: mean square that noise explains, white or not: the stated one, or an estimate.
        level_score: of "they are as large as the stated noise", in standard deviations; 0 where none is stated.
    """

    chi2: float
    samples: float
    white_variance: float
    whiteness_score: float
    correlation_time: float
    noise_floor: float = 1.0
    level_score: float = 0.0

    @property
    def chi2_reduced(self) -> float:
        """Mean square of the weighted residuals."""
        return self.chi2 / self.samples if self.samples else float("nan")

    @property
    def excess(self) -> float:
        """Mean square beyond the noise, in noise variances."""
        return max(self.chi2_reduced - self.noise_floor, 0.0)

    def exceeds(self, share: float) -> bool:
        """Whether the mean square beyond the noise is more than a share of the noise, of the stated level at least."""
        return self.excess > share * max(1.0, self.noise_floor)


@dataclass(frozen=True)
class Series:
    """Weighted residuals of one signal in one run, in time order.

    Attributes:
        values: (n,).
        expected: (n,) mean squares that the noise gives; one each, but for readings in coarse steps (``rounding``).
        stated: whether the level of the noise is known, not estimated; known noise may have any colour up to it.
        signal: its name.
    """

    values: Array
    expected: Array
    stated: bool = True
    signal: str = ""

    @classmethod
    def plain(cls, values: Array, stated: bool = True, signal: str = "") -> Series:
        """Residuals in standard deviations of the noise."""
        return cls(values, np.ones(len(values)), stated, signal)

    @property
    def samples(self) -> float:
        """How many samples these count for."""
        return float(np.sum(self.expected))

    @property
    def pairs(self) -> float:
        """How many pairs of neighbours these count for: what white noise of these squares may be correlated by."""
        earlier, later = self.expected[:-1], self.expected[1:]
        shared = float(earlier @ later)
        return float(np.sum(earlier)) * float(np.sum(later)) / shared if shared > 0 else 0.0

    def differences(self, lag: int) -> tuple[float, float]:
        """Half the squared differences of samples at a distance, and how much of that is expected of white noise."""
        v, expected = self.values, self.expected
        return float(np.sum((v[lag:] - v[:-lag]) ** 2)) / 2, float(
            np.sum(expected[lag:] + expected[:-lag])
        ) / 2


def series_of(
    runs: Sequence[RunComparison],
    signals: Mapping[str, Signal],
    shifts: Mapping[tuple[str, str], Array] | None = None,
) -> list[Series]:
    """Weighted residuals, one series for each run and fitted signal, missing samples left out.

    Args:
        runs: of a model.
        signals: by name; those that are fitted count.
        shifts: (n,) what is added to the weighted residuals, by run and signal.
    """
    series = []
    for r in runs:
        for name, signal in signals.items():
            if signal.fitted and r.run.sample_count(name):
                error = r.residual(name)
                is_measured = np.isfinite(error)
                values = standardized_residuals(
                    error[is_measured], signal, r.run.measurements[name][is_measured]
                )
                if shifts and (r.run.name, name) in shifts:
                    values = values + shifts[r.run.name, name][is_measured]
                # Steps are what they are, also where the noise is not known.
                noise_is_known = not signal.estimated or signal.is_coarse
                series.append(
                    Series(
                        values, expected_squares(error[is_measured], signal), noise_is_known, name
                    )
                )
    return series


def residual_statistics(series: Sequence[Series]) -> ResidualStatistics:
    """Statistics of weighted residuals, one series for each run and signal."""
    chi2, samples = _sums(series)
    _, whiteness_score = lag_one(series)
    return ResidualStatistics(
        chi2,
        samples,
        _white_part(series, 1),
        whiteness_score,
        _correlation_time(series),
        _noise_floor(series),
        _level_score([e for e in series if e.stated]),
    )


def _sums(series: Sequence[Series]) -> tuple[float, float]:
    """Sum of squares, and how many samples they count for."""
    return float(sum(np.sum(e.values**2) for e in series)), float(sum(e.samples for e in series))


def _level_score(series: Sequence[Series]) -> float:
    """What residuals exceed a known noise by, over what chance would (chi-square distribution)."""
    chi2, samples = _sums(series)
    return (chi2 - samples) / float(np.sqrt(2 * samples)) if samples else 0.0


def _noise_floor(series: Sequence[Series]) -> float:
    """Mean square that noise explains: of known noise at least its own variance, else the estimate for red noise."""
    total, samples = 0.0, 0.0
    for is_known in (True, False):
        chosen = [
            e for e in series if e.stated is is_known and len(e.values) > CRITERIA.residuals.lags
        ]
        count = sum(e.samples for e in chosen)
        if count:
            total += count * (max(1.0, _white_part(chosen, 1)) if is_known else red_noise(chosen))
            samples += count
    return total / samples if samples else 1.0


def _white_part(series: Sequence[Series], lag: int) -> float:
    """Half the mean square difference of samples at a distance; NaN without any."""
    parts = [e.differences(lag) for e in series]
    expected = sum(part[1] for part in parts)
    return sum(part[0] for part in parts) / expected if expected > 0 else float("nan")


def lag_one(series: Sequence[Series]) -> tuple[float, float]:
    """Correlation of neighbours about zero over all series, and how many standard deviations of white noise that is.

    Args:
        series: each has a scale of its own.
    """
    correlated, pairs = 0.0, 0.0
    for e in series:
        power, n = float(np.sum(e.values**2)), e.pairs
        if len(e.values) > 2 and power > 0 and n > 0:
            correlated += n * float(np.sum(e.values[1:] * e.values[:-1])) / power
            pairs += n
    return (correlated / pairs, correlated / float(np.sqrt(pairs))) if pairs else (0.0, 0.0)


def red_noise(series: Sequence[Series]) -> float:
    """Variance of first-order autoregressive noise under a slow drift.

    Samples at a distance l differ by noise, half mean square v (1 - r^l), and by what the slow drift gains, a l^2.
    v, a >= 0 and the correlation r of neighbours are fitted to the first few distances.

    Args:
        series: each longer than those distances.
    """
    lags = np.arange(1, CRITERIA.residuals.lags + 1)
    variogram = np.array([_white_part(series, int(lag)) for lag in lags])
    best, variance = np.inf, variogram[0]
    for r in np.linspace(0.0, CRITERIA.residuals.reddest, CRITERIA.residuals.colours):
        columns = np.column_stack([1 - r**lags, lags**2]) / variogram[:, None].clip(1e-300)
        weights, miss = nnls(columns, np.ones(CRITERIA.residuals.lags))
        if miss < best:
            best, variance = miss, float(weights[0])
    return max(float(variance), 0.0)


def _correlation_time(series: Sequence[Series]) -> float:
    """1 + 2 sum of the autocorrelation up to where it first falls below zero, averaged by power."""
    total, power = 0.0, 0.0
    for e in (part.values for part in series):
        power_of_part = float(np.sum(e**2))
        if len(e) < 3 or power_of_part <= 0:
            continue
        most = max(2, int(CRITERIA.residuals.longest_memory * len(e)))
        r = autocorrelation(e, most)[1:]
        insignificant = np.flatnonzero(r <= CRITERIA.residuals.memory_gone / np.sqrt(len(e)))
        time = 1 + 2 * float(np.sum(r[: insignificant[0]] if len(insignificant) else r))
        total += power_of_part * time
        power += power_of_part
    return max(1.0, total / power) if power else 1.0


def autocorrelation(e: Array, lags: int) -> Array:
    """(lags,) autocorrelation of a series about zero, from lag 0 on; 1 at lag 0."""
    size = next_fast_len(len(e) + lags, real=True)
    products: Array = np.asarray(irfft(np.abs(rfft(e, size)) ** 2, size)[:lags])
    correlation: Array = products / products[0]
    return correlation
