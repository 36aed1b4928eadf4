"""Two recordings of one run on clocks of their own: the offset estimated, and both on one time."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import sqrt

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement.recording import Recording, locked
from pam_cosim.measurement.white_noise import estimate_noise
from pam_cosim.simulation.inputs import Interpolation

_COARSE = 2000  # Points of the longer recording by which offsets are looked for.
_SLOPE = 3.0  # Samples to each side, by which a slope is estimated.
_STEPS, _SHARE = (
    60,
    0.5,
)  # Of Newton's method, which lines between noisy samples would else make swing.
_CLOSE = 0.01  # Of its standard deviation, to which an offset is iterated.
_LEAST = 0.5  # Of the shorter recording, which an offset must leave in common.


class ClockError(ValueError):
    """The offset cannot be estimated; the caller adds the place."""


@dataclass(frozen=True)
class Offset:
    """What is added to the times of the second recording [s], and its standard deviation [s]; 0: stated."""

    value: float
    sd: float = 0.0


def estimate_offset(reference: tuple[Array, Array], shifted: tuple[Array, Array]) -> Offset:
    """The offset by which the second signal is most like the first, up to a gain and a zero.

    Args:
        first: times (n,) [s] and values of a signal, NaN where one is missing.
        second: of the same quantity by the other clock.

    Returns:
        The offset that leaves the least squares, and its standard deviation to first order.

    Raises:
        ClockError: the signals do not change, do not agree, or agree at several offsets.
    """
    t, y = _finite_samples(*reference)
    s, z = _finite_samples(*shifted)
    if (
        min(len(t), len(s)) < CRITERIA.noise.fewest_samples
        or not np.ptp(y) > 0
        or not np.ptp(z) > 0
    ):
        raise ClockError("the signal has too few samples, or does not change")
    step = max(t[-1] - t[0], s[-1] - s[0]) / _COARSE
    offset = _offset_on_grid(t, y, s, z, step)
    reach = max(_SLOPE * float(np.median(np.diff(t))), float(np.median(np.diff(s))))
    noise = float(np.nan_to_num(estimate_noise(t, y)))
    for _ in range(_STEPS):
        change, sd = _newton_step(t, y, s + offset, z, reach, noise)
        offset += _SHARE * change
        if abs(change) < _CLOSE * sd:
            return Offset(offset, sd)
    raise ClockError("the signals do not agree at one offset")


def _newton_step(
    t: Array, y: Array, s: Array, z: Array, reach: float, noise: float
) -> tuple[float, float]:
    """Change of the offset by linear least squares, and its standard deviation.

    Slopes are differences over samples apart from the one itself, whose noise they do not share; what the noise of
    the first signal adds to their squares is taken off.
    """
    inside = (s >= t[0] + reach) & (s <= t[-1] - reach)
    at, value = s[inside], z[inside]
    if len(at) < CRITERIA.noise.fewest_samples:
        raise ClockError("the two files have too little time in common")
    model = np.interp(at, t, y)
    slope = (np.interp(at + reach, t, y) - np.interp(at - reach, t, y)) / (2.0 * reach)
    model, slope, value = model - model.mean(), slope - slope.mean(), value - value.mean()
    gain = float(model @ value) / float(model @ model)
    residual = value - gain * model
    information = float(slope @ slope) - len(at) * noise**2 / (2.0 * reach**2)
    if information <= 0.0 or gain == 0.0:
        raise ClockError("the signal changes too little compared with its noise")
    spread = sqrt(float(residual @ residual) / (len(at) - 3) / information) / abs(gain)
    return float(slope @ residual) / (gain * information), spread


def merged(
    main: Recording, added: Recording, offset: float, interpolation: Interpolation
) -> Recording:
    """One recording with all rows of two, on the clock of the first, within the times at which all inputs are known.

    Columns of both files are taken from the first.

    Args:
        main: the first recording.
        added: the second recording.
        offset: is added to the times of the second [s].
        interpolation: of the inputs.

    Raises:
        ClockError: the two have no time in common.
    """
    added_time = added.time + offset
    low, high = main.time[0], main.time[-1]
    if added.inputs:
        low, high = max(low, added_time[0]), min(high, added_time[-1])
    if not low < high:
        raise ClockError("the two files have no time in common")
    rows = np.flatnonzero((main.time >= low) & (main.time <= high))
    further_rows = np.flatnonzero((added_time >= low) & (added_time <= high))
    if not len(further_rows):
        raise ClockError("the two files have no time in common")
    time = main.time[rows]
    place, ahead = _places_in(time, added_time[further_rows])
    new, shared = further_rows[place < 0], further_rows[place >= 0]
    place = place[place >= 0]
    times = np.concatenate([time, added_time[new]])
    order = np.lexsort((np.concatenate([np.ones(len(time)), ~ahead]), times))

    def joined(values: Array, added_values: Array) -> Array:
        return locked(np.concatenate([values, added_values])[order])

    def of_second(values: Array, at_rows: Array) -> Array:
        at_rows[place] = values[shared]
        return joined(at_rows, values[new])

    inputs = {
        name: joined(v[rows], _interpolated(main.time, v, added_time[new], interpolation))
        for name, v in main.inputs.items()
    }
    inputs |= {
        name: of_second(v, _interpolated(added_time, v, time, interpolation))
        for name, v in added.inputs.items()
        if name not in inputs
    }
    missing = np.full(len(new), np.nan)
    measured = {name: joined(v[rows], missing) for name, v in main.measurements.items()}
    measured |= {
        name: of_second(v, np.full(len(time), np.nan))
        for name, v in added.measurements.items()
        if name not in measured
    }
    notes = (*main.notes, *added.notes)
    return replace(
        main, time=locked(times[order]), inputs=inputs, measurements=measured, notes=notes
    )


def _places_in(time: Array, times: Array) -> tuple[NDArray[np.intp], NDArray[np.bool_]]:
    """Which of the times (n,) each of the others (m,) is, -1 for a new one; which of the new ones come ahead of theirs.

    A step is two rows at one time. Where only the others have one, its first row is new.
    """
    place = np.searchsorted(time, times, side="right") - 1
    is_present = (place >= 0) & (time[np.maximum(place, 0)] == times)
    begins_step = is_present & np.append(times[1:] == times[:-1], False)
    is_second_row = begins_step & (place > 0) & (time[np.maximum(place - 1, 0)] == times)
    is_new_time = ~is_present | (begins_step & ~is_second_row)
    return np.where(is_new_time, -1, place - is_second_row), begins_step[is_new_time]


def _interpolated(time: Array, values: Array, at: Array, interpolation: Interpolation) -> Array:
    if interpolation == "linear":
        return np.asarray(np.interp(at, time, values), dtype=float)
    return values[np.maximum(np.searchsorted(time, at, side="right") - 1, 0)]


def _finite_samples(time: Array, values: Array) -> tuple[Array, Array]:
    is_finite = np.isfinite(values)
    return time[is_finite], values[is_finite]


def _offset_on_grid(t: Array, y: Array, s: Array, z: Array, step: float) -> float:
    """The best offset on a grid; every other good one must be near it."""
    a, b = (np.interp(np.arange(u[0], u[-1], step), u, v) for u, v in ((t, y), (s, z)))
    least = max(3, int(_LEAST * min(len(a), len(b))))
    lags = np.arange(least - len(b), len(a) - least + 1)
    like = np.array(
        [_correlation(a[max(0, k) : k + len(b)], b[max(0, -k) : len(a) - k]) for k in lags]
    )
    best = int(np.argmax(like))
    unexplained = np.maximum(1.0 - like**2, 1e-12)
    peaks = np.flatnonzero((like[1:-1] >= like[:-2]) & (like[1:-1] >= like[2:])) + 1
    rivals = [int(k) for k in peaks if abs(k - best) > 2 and like[k] > 0]
    worse = [min(len(s), len(t)) * np.log(unexplained[k] / unexplained[best]) for k in rivals]
    at = [t[0] - s[0] + step * float(lags[k]) for k in (best, *rivals)]
    if worse and min(worse) < CRITERIA.noise.outlier_far**2:
        other = at[1 + int(np.argmin(worse))]
        raise ClockError(f"the signals agree about as well at {at[0]:.4g} s as at {other:.4g} s")
    if not like[best] > 0.0:
        raise ClockError("the signals do not agree at any offset")
    return float(at[0])


def _correlation(a: Array, b: Array) -> float:
    """Coefficient of correlation."""
    a, b = a - a.mean(), b - b.mean()
    size = sqrt(float(a @ a) * float(b @ b))
    return float(a @ b) / size if size > 0.0 else 0.0
