"""Samples of a normal distribution between bounds."""

from __future__ import annotations

import numpy as np

from pam_cosim.arrays import Array

_DISCARDED_SAMPLES = 20  # first samples, which depend on the start of the chain
_MOST_REFLECTIONS = 1000  # of a sample at the bounds
_SAME_HIT = 1e-9  # quarter periods, within which two hits of a wall are one


def truncated_normal(
    mean: Array,
    precision: Array,
    bounds: tuple[Array, Array],
    start: Array,
    count: int,
    rng: np.random.Generator,
) -> Array:
    """(count, k) samples by exact Hamiltonian Monte Carlo (Pakman and Paninski, J. Comput. Graph. Stat. 23, 2014).

    A particle moves in the quadratic potential for a quarter of a period, is reflected by the walls, and is a sample
    then: no step is ever refused, however correlated the distribution is and however far its mean is out of bounds.

    Args:
        mean: (k,) of the distribution without bounds; may lie out of bounds.
        precision: (k, k) inverse of its covariance, positive definite.
        bounds: (k,) lowest and highest values.
        start: (k,) within them.
        count: of the samples.
        rng: random numbers.
    """
    factor = np.linalg.inv(
        np.linalg.cholesky(precision)
    ).T  # values are mean + factor @ w, with w standard normal
    low, high = bounds
    walls = np.vstack([factor, -factor])
    offsets = np.concatenate([mean - low, high - mean])
    inside = _SAME_HIT * (
        high - low
    )  # a particle that begins on a wall may fall through it by rounding
    w = np.asarray(
        np.linalg.solve(factor, np.clip(start, low + inside, high - inside) - mean), dtype=float
    )
    samples = []
    for _ in range(count + _DISCARDED_SAMPLES):
        w = _moved(w, rng.standard_normal(len(w)), walls, offsets)
        samples.append(mean + factor @ w)
    return np.clip(np.array(samples[_DISCARDED_SAMPLES:]).reshape(count, -1), low, high)


def _moved(w: Array, speed: Array, walls: Array, offsets: Array) -> Array:
    """Where a particle is after a quarter of a period; it stays where it may be: ``walls @ w + offsets >= 0``."""
    remaining_time, last = 0.5 * np.pi, -1
    for _ in range(_MOST_REFLECTIONS):
        times = _times_of_hits(walls @ w, walls @ speed, offsets, last)
        first = int(np.argmin(times))
        time = min(float(times[first]), remaining_time)
        w, speed = w * np.cos(time) + speed * np.sin(time), speed * np.cos(time) - w * np.sin(time)
        remaining_time -= time
        if remaining_time <= 0:
            break
        normal = walls[first]
        speed = speed - 2.0 * (normal @ speed) / (normal @ normal) * normal
        last = first
    return w


def _times_of_hits(places: Array, speeds: Array, offsets: Array, last: int) -> Array:
    """(walls,) when each wall is met, infinite where it is not; the one that was met last is met again later.

    The distance to a wall is a cosine over time, of this size and phase, plus its offset.
    """
    size, phase = np.hypot(places, speeds), np.arctan2(-speeds, places)
    times = np.full(len(places), np.inf)
    reached = size > np.abs(offsets)
    angle = np.arccos(-offsets[reached] / size[reached])
    times[reached] = np.mod(angle - phase[reached], 2 * np.pi)
    if last >= 0 and reached[last] and min(times[last], 2 * np.pi - times[last]) < _SAME_HIT:
        times[last] = np.inf
    return times
