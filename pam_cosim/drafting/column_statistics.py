"""What the numbers of a column show: their span and noise, whether they are held, switched or follow others."""

from __future__ import annotations

from collections.abc import Mapping
from math import isfinite, sqrt

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
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
    found = [estimate_noise(time[s : s + size], values[s : s + size]) for s in starts]
    known = [one for one in found if isfinite(one)]
    return float(np.median(known)) if known else 0.0


def correlation(one: Mapping[int, Array], other: Mapping[int, Array]) -> float:
    """Between two signals of several recordings, each less its mean in the recording; 0 where one is constant."""
    shared = [i for i in other if i in one]
    a, b = (
        np.concatenate([np.zeros(0), *(signal[i] - np.nanmean(signal[i]) for i in shared)])
        for signal in (one, other)
    )
    known = np.isfinite(a) & np.isfinite(b)
    norm = sqrt(float(np.sum(a[known] ** 2) * np.sum(b[known] ** 2)))
    return float(np.sum(a[known] * b[known])) / norm if norm else 0.0


def is_constant(values: Array) -> bool:
    """Whether a column is noise about one value."""
    count = np.arange(len(values), dtype=float)
    return span(values) <= NOISE_SPAN * noise_of(count, values)


def is_switch(values: Array) -> bool:
    """Whether a column has two values only."""
    present = values[np.isfinite(values)]
    if not present.size or span(values) == 0.0:
        return False
    some = present[:: max(1, len(present) // 100_000)]
    return len(np.unique(some)) <= 2


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
