"""What numbers show: their span and noise, where nothing moves, whether they are held, switched or follow others."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import isfinite, sqrt

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement.noise import record_step
from pam_cosim.measurement.white_noise import estimate_noise

REST_BAND = 0.005  # of the range: means at rest differ by less, where the noise is smaller
PIECE = 4000  # samples of each piece of a long recording that its noise is estimated from
PIECES = 5  # of a long recording, at even distances
LEAST_CORRELATION = 0.5  # absolute correlation above which one column follows another
NOISE_SPAN = 10.0  # sd: span of a column that is noise alone


def span(values: Array) -> float:
    """Largest less smallest value."""
    present = values[np.isfinite(values)]
    return float(np.ptp(present)) if present.size else 0.0


def noise_of(time: Array, values: Array) -> float:
    """Standard deviation as ``estimate_noise`` has it, of pieces of a long recording; 0: not known."""
    count = len(values)
    starts = [0] if count <= PIECE * PIECES else np.linspace(0, count - PIECE, PIECES).astype(int)
    size = count if len(starts) == 1 else PIECE
    estimates = [estimate_noise(time[s : s + size], values[s : s + size]) for s in starts]
    finite = list(filter(isfinite, estimates))
    return float(np.median(finite)) if finite else 0.0


def correlation(first: Mapping[int, Array], second: Mapping[int, Array]) -> float:
    """Between two signals of several recordings, each less its mean in the recording; 0 where one is constant."""
    shared = [i for i in second if i in first]
    a, b = (
        np.concatenate([np.zeros(0), *(signal[i] - np.nanmean(signal[i]) for i in shared)])
        for signal in (first, second)
    )
    are_finite = np.isfinite(a) & np.isfinite(b)
    norm = sqrt(float(np.sum(a[are_finite] ** 2) * np.sum(b[are_finite] ** 2)))
    return float(np.sum(a[are_finite] * b[are_finite])) / norm if norm else 0.0


def is_constant(values: Array) -> bool:
    """Whether a column is noise about one value."""
    count = np.arange(len(values), dtype=float)
    return span(values) <= NOISE_SPAN * noise_of(count, values)


def is_switch(values: Array) -> bool:
    """Whether a column has two values only."""
    present = values[np.isfinite(values)]
    if not present.size or span(values) == 0.0:
        return False
    sample = present[:: max(1, len(present) // 100_000)]
    return len(np.unique(sample)) <= 2


def is_repeated(values: Array) -> bool:
    """Whether most numbers are those before them, without any noise."""
    return float(np.mean(np.diff(values[np.isfinite(values)]) == 0.0)) >= CRITERIA.noise.stepwise


def is_held(values: Array) -> bool:
    """Whether a column keeps its value between steps, and takes some, each within one sample."""
    if span(values) == 0.0:
        return False
    changed = np.abs(np.diff(values[np.isfinite(values)])) > REST_BAND * span(values)
    count = int(changed.sum())
    in_a_row = int((changed[1:] & changed[:-1]).sum())
    mostly_within_one_sample = 2 * (count - in_a_row) > count
    return (
        count > 0
        and float(np.mean(~changed)) >= CRITERIA.noise.stepwise
        and mostly_within_one_sample
    )


_WINDOW = 0.01  # of the samples: length of the means that distinguish rest from motion
_MOST_IN_WINDOW = 30  # samples; a longer mean misses short rests
FEWEST_IN_WINDOW = 5  # samples of such a mean
_NOISE_BAND = 4.0  # sd of the difference of two means, below which it is noise
_COMPUTED_SCATTER = 1e-5  # of the range: smaller scatter is that of computed numbers


@dataclass(frozen=True)
class Rest:
    """Samples ``start`` to ``stop`` of a run, in which nothing moves."""

    start: int
    stop: int

    @property
    def count(self) -> int:
        """How many samples."""
        return self.stop - self.start


def moving(time: Array, values: Array) -> np.ndarray:
    """(n,) whether a signal moves there: means over neighbouring windows differ by more than noise lets them."""
    count = len(values)
    window = max(FEWEST_IN_WINDOW, min(round(_WINDOW * count), _MOST_IN_WINDOW))
    moves = np.zeros(count, dtype=bool)
    if count < 2 * window or span(values) == 0.0:
        return moves
    filled = _filled(values)
    sums = np.concatenate([[0.0], np.cumsum(filled - filled[0])])
    means = (sums[window:] - sums[:-window]) / window
    change = np.abs(means[window:] - means[:-window])
    band = max(_NOISE_BAND * noise_of(time, filled) * sqrt(2.0 / window), REST_BAND * span(filled))
    edges = np.zeros(count + 1)
    at = np.flatnonzero(change > band)
    half = (
        window // 2
    )  # The motion lies about the border of the two windows; at the ends, anywhere in them.
    np.add.at(edges, np.where(at == 0, 0, at + half), 1.0)
    np.add.at(edges, np.where(at == len(change) - 1, count, at + 2 * window - half), -1.0)
    return np.asarray(np.cumsum(edges[:-1]) > 0.0)


def rests(time: Array, columns: Sequence[Array]) -> list[Rest]:
    """The intervals in which no column moves, with enough samples to estimate noise."""
    still = np.ones(len(time), dtype=bool)
    for values in columns:
        still &= ~moving(time, values)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], still, [False]]).astype(int)))
    ends = [Rest(int(a), int(b)) for a, b in zip(edges[::2], edges[1::2], strict=True)]
    described = [
        (_from_lowest(values), noise_of(time, values), REST_BAND * span(values))
        for values in columns
    ]
    return [level for interval in ends for level in _levels(interval, described)]


def _from_lowest(values: Array) -> Array:
    """The values less the lowest: means of equal numbers differ in the last digit, means of zeros do not."""
    return values - np.nanmin(values) if np.isfinite(values).any() else values


def begins_still(time: Array, columns: Sequence[Array]) -> bool:
    """Whether nothing moves in the first samples, even if they are too few to estimate noise."""
    return all(
        span(values[:FEWEST_IN_WINDOW])
        <= max(REST_BAND * span(values), NOISE_SPAN * noise_of(time, values))
        for values in columns
    )


def _levels(interval: Rest, columns: Sequence[tuple[Array, float, float]]) -> list[Rest]:
    """The interval, cut into halves as long as these differ: a slow drift is no rest."""
    if interval.count < CRITERIA.noise.fewest_samples:
        return []
    middle = (interval.start + interval.stop) // 2
    halves = Rest(interval.start, middle), Rest(middle, interval.stop)
    band = _NOISE_BAND * 2.0 / sqrt(interval.count)
    for values, noise, least in columns:
        first, second = (values[half.start : half.stop] for half in halves)
        if not (np.isfinite(first).any() and np.isfinite(second).any()):
            continue
        if abs(float(np.nanmean(second)) - float(np.nanmean(first))) > max(band * noise, least):
            return [level for half in halves for level in _levels(half, columns)]
    return [interval]


def noise_at_rest(time: Array, values: Array, interval: Rest) -> tuple[float, float]:
    """Standard deviation at rest and the step of the record (0: none); 0 where the samples show neither."""
    most = PIECE * PIECES
    inside = values[interval.start : min(interval.stop, interval.start + most)]
    step = record_step(values[:most])
    sigma = estimate_noise(time[interval.start :][: len(inside)], inside)
    if not isfinite(sigma):
        steps = np.diff(inside)
        sigma = sqrt(float(np.nanmean(steps**2)) / 2.0) if np.isfinite(steps).any() else 0.0
    sigma = max(sigma, step / sqrt(12.0))
    return (sigma, step) if sigma > _COMPUTED_SCATTER * span(values) else (0.0, 0.0)


def _filled(values: Array) -> Array:
    present = np.isfinite(values)
    if present.all():
        return values
    places = np.arange(len(values))
    return np.asarray(np.interp(places, places[present], values[present]))
