"""The standard deviation of an instrument's noise, from the recording alone.

Differences of order m over m + 1 neighbouring samples remove every polynomial below degree m, so that what is left
of a well-sampled smooth signal is noise (Gasser, Sroka and Jennen-Steinmetz, Biometrika 73, 1986; general order:
Hall, Kay and Titterington, Biometrika 77, 1990). A median makes the estimate indifferent to steps.

A sensor that is slower than its logger shows each reading for several rows: one of them counts.

Limits: noise is taken as white. A sensor that filters its samples looks less noisy than it is. A signal
that bends within a few samples during most of the recording cannot be distinguished from noise, and gives NaN. Noise
below a third of the quantum comes out up to a fifth too small. The spread of the estimate itself is about 16 % with 50
samples, 7 % with 200, 5 % with 500 and 2.5 % with 2000.
"""

from __future__ import annotations

from math import erf, exp, inf, nan, pi, sqrt

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import ArrayLike

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA

# standard deviation over the median deviation, of a normal distribution
MEDIAN_TO_SIGMA = 1.4826022185056018
_CLIP = CRITERIA.noise.clip
_CLIPPED_VARIANCE = 1.0 - 2.0 * _CLIP * exp(-(_CLIP**2) / 2.0) / sqrt(2.0 * pi) / erf(
    _CLIP / sqrt(2.0)
)


def estimate_noise(time: ArrayLike, values: ArrayLike) -> float:
    """Standard deviation of white noise on a smooth signal with steps, in the unit of ``values``.

    At least the error of rounding, when the values are multiples of a quantum.

    Args:
        time: (n,) not decreasing.
        values: (n,), NaN where a sample is missing.

    Returns:
        NaN for a constant signal, fewer than some 30 samples at even distances, or a signal that the samples do
        not resolve.
    """
    present = np.isfinite(np.asarray(values, dtype=float))
    times: Array = np.asarray(time, dtype=float)[present]
    samples: Array = np.asarray(values, dtype=float)[present]
    times, samples = _without_held(*_without_repeats(times, samples))
    quantum = quantum_of(samples)
    if len(samples) < CRITERIA.noise.fewest_samples or quantum == 0.0:
        return nan
    rounding = quantum**2 / 12.0
    # Dither makes the distribution continuous, so that its median means something; its variance is known.
    dither = np.random.default_rng(0).uniform(-quantum / 2.0, quantum / 2.0, len(samples))
    variance = _white_level(times, samples + dither) ** 2 - rounding
    return nan if np.isnan(variance) else sqrt(max(variance, rounding))


def _without_repeats(time: Array, values: Array) -> tuple[Array, Array]:
    """Rows of which most stand at the time of the one before: repeated ones are left out, others spread evenly.

    A logger that writes each row twice has no more information than one that does not; one whose clock is coarse
    continues in between.
    """
    steps = np.diff(time)
    if not steps.size or float(np.median(steps)) > 0.0 or time[-1] == time[0]:
        return time, values
    new = np.concatenate([[True], (steps > 0.0) | (np.diff(values) != 0.0)])
    time, values = time[new], values[new]
    is_first = np.concatenate([[True], np.diff(time) > 0.0])
    rows = np.arange(len(time))
    return np.interp(rows, rows[is_first], time[is_first]), values


def _without_held(time: Array, values: Array) -> tuple[Array, Array]:
    """Rows at which the value changes, of a sensor that shows each reading for several rows of its logger."""
    new = np.flatnonzero(np.concatenate([[True], np.diff(values) != 0.0]))
    rows = np.diff(new)[1:]  # the first reading may be older than the recording
    if len(rows) < CRITERIA.noise.fewest_samples or float(np.median(rows)) < 2.0:
        return time, values
    alike = float(np.mean(np.abs(rows - np.median(rows)) <= 1))  # or one row more, or less
    return (time[new], values[new]) if alike >= CRITERIA.noise.stepwise else (time, values)


def quantum_of(values: Array) -> float:
    """Smallest distance of different values, rounding errors of the conversion aside; 0 when all are equal."""
    distinct = np.unique(values)
    if distinct.size < 2:
        return 0.0
    gaps = np.diff(distinct)
    return float(gaps[gaps > 1e-9 * np.abs(distinct).max()].min(initial=distinct[-1] - distinct[0]))


def _white_level(time: Array, values: Array) -> float:
    """The estimate of the lowest order that higher orders do not lower; NaN when every order lowers it."""
    tolerance = 1.0 + max(
        CRITERIA.noise.level_tolerance, CRITERIA.noise.level_spread / sqrt(len(values))
    )
    previous = inf
    for order in CRITERIA.noise.orders:
        sigma = robust_scale(_differences(time, values, order))
        if previous <= tolerance * sigma:
            return previous
        previous = sigma
    return nan


def _differences(time: Array, values: Array, order: int) -> Array:
    """Divided differences of evenly spaced neighbours, scaled to the variance of one sample; maybe none."""
    steps = np.diff(time)
    typical = float(np.median(steps))
    if len(values) <= order or typical <= 0.0:
        return np.empty(0)
    even = (steps >= 0.5 * typical) & (steps <= 2.0 * typical)
    usable = sliding_window_view(even, order).all(axis=1)
    if usable.sum() < max(CRITERIA.noise.fewest_samples - order, len(values) / 2):
        return np.empty(0)
    nodes = sliding_window_view(time, order + 1)[usable] / typical
    weights = _divided_difference_weights(nodes)
    sums = np.sum(weights * sliding_window_view(values, order + 1)[usable], axis=1)
    return np.asarray(sums / np.sqrt(np.sum(weights**2, axis=1)))


def _divided_difference_weights(nodes: Array) -> Array:
    """(k, m + 1) weights of the m-th divided difference at each row of nodes."""
    distance = nodes[:, :, None] - nodes[:, None, :]
    diagonal = np.arange(nodes.shape[1])
    distance[:, diagonal, diagonal] = 1.0
    return np.asarray(1.0 / distance.prod(axis=2))


def robust_scale(differences: Array) -> float:
    """Robust standard deviation: from the median, then sharpened by the root mean square of what is not outlying."""
    if differences.size == 0:
        return nan
    rough = MEDIAN_TO_SIGMA * float(np.median(np.abs(differences)))
    inner = differences[np.abs(differences) <= _CLIP * rough]
    return sqrt(float(np.mean(inner**2)) / _CLIPPED_VARIANCE)
