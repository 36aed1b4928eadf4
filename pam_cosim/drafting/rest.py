"""Where a recording is at rest, and what it looks like otherwise: held, stepping, a switch."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import isfinite, sqrt

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.column_statistics import (
    NOISE_SPAN,
    PIECE,
    PIECES,
    REST_BAND,
    noise_of,
    span,
)
from pam_cosim.measurement.noise import record_step
from pam_cosim.measurement.white_noise import estimate_noise

_WINDOW = 0.01  # of the samples: length of the means that distinguish rest from motion
_MOST_IN_WINDOW = 30  # samples; a longer mean misses short rests
_FEWEST_IN_WINDOW = 5  # samples of such a mean
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
    window = max(_FEWEST_IN_WINDOW, min(round(_WINDOW * count), _MOST_IN_WINDOW))
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
    """The intervals in which no column moves, of enough samples to tell noise by."""
    still = np.ones(len(time), dtype=bool)
    for values in columns:
        still &= ~moving(time, values)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], still, [False]]).astype(int)))
    ends = [Rest(int(a), int(b)) for a, b in zip(edges[::2], edges[1::2], strict=True)]
    known = [
        (_from_lowest(values), noise_of(time, values), REST_BAND * span(values))
        for values in columns
    ]
    return [level for one in ends for level in _levels(one, known)]


def _from_lowest(values: Array) -> Array:
    """Less the lowest of them: means of many like numbers differ in the last digit, means of noughts do not."""
    return values - np.nanmin(values) if np.isfinite(values).any() else values


def begins_still(time: Array, columns: Sequence[Array]) -> bool:
    """Whether nothing moves in the first samples, be they too few to tell noise by."""
    return all(
        span(values[:_FEWEST_IN_WINDOW])
        <= max(REST_BAND * span(values), NOISE_SPAN * noise_of(time, values))
        for values in columns
    )


def _levels(rest: Rest, columns: Sequence[tuple[Array, float, float]]) -> list[Rest]:
    """The interval, cut into halves as long as these differ: a slow drift is no rest."""
    if rest.count < CRITERIA.noise.fewest_samples:
        return []
    middle = (rest.start + rest.stop) // 2
    halves = Rest(rest.start, middle), Rest(middle, rest.stop)
    band = _NOISE_BAND * 2.0 / sqrt(rest.count)
    for values, noise, least in columns:
        one, other = (values[half.start : half.stop] for half in halves)
        if not (np.isfinite(one).any() and np.isfinite(other).any()):
            continue
        if abs(float(np.nanmean(other)) - float(np.nanmean(one))) > max(band * noise, least):
            return [level for half in halves for level in _levels(half, columns)]
    return [rest]


def noise_at_rest(time: Array, values: Array, rest: Rest) -> tuple[float, float]:
    """Standard deviation at rest and the step of the record (0: none); 0 where the samples show neither."""
    most = PIECE * PIECES
    inside = slice(rest.start, min(rest.stop, rest.start + most))
    step = record_step(values[:most])
    sigma = estimate_noise(time[inside], values[inside])
    if not isfinite(sigma):
        steps = np.diff(values[inside])
        sigma = sqrt(float(np.nanmean(steps**2)) / 2.0) if np.isfinite(steps).any() else 0.0
    sigma = max(sigma, step / sqrt(12.0))
    return (sigma, step) if sigma > _COMPUTED_SCATTER * span(values) else (0.0, 0.0)


def _filled(values: Array) -> Array:
    present = np.isfinite(values)
    if present.all():
        return values
    places = np.arange(len(values))
    return np.asarray(np.interp(places, places[present], values[present]))
