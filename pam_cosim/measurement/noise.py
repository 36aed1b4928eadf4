"""The standard deviation of an instrument's noise, from the recording alone.

Differences of order m over m + 1 neighbouring samples remove every polynomial below degree m, so that what is left
of a well-sampled smooth signal is noise (Gasser, Sroka and Jennen-Steinmetz, Biometrika 73, 1986; general order:
Hall, Kay and Titterington, Biometrika 77, 1990). A median makes the estimate indifferent to steps.

Limits: noise is taken as white. A sensor that filters or repeats its samples looks less noisy than it is. A signal
that bends within a few samples during most of the recording cannot be told from noise, and gives NaN. Noise below
a third of the quantum comes out up to a fifth too small. The spread of the estimate itself is about 16 % with 50
samples, 7 % with 200, 5 % with 500 and 2.5 % with 2000.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import erf, exp, hypot, inf, nan, pi, sqrt

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import ArrayLike

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement.data_set import Run, Signal, StatedSignal
from pam_cosim.measurement.repeatability import with_repeatability

_CLIP = CRITERIA.noise.clip
_CLIPPED_VARIANCE = 1.0 - 2.0 * _CLIP * exp(-(_CLIP**2) / 2.0) / sqrt(2.0 * pi) / erf(_CLIP / sqrt(2.0))


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
    quantum = _quantum(samples)
    if len(samples) < CRITERIA.noise.fewest_samples or quantum == 0.0:
        return nan
    rounding = quantum**2 / 12.0
    # Dither makes the distribution continuous, so that its median means something; its variance is known.
    dither = np.random.default_rng(0).uniform(-quantum / 2.0, quantum / 2.0, len(samples))
    variance = _white_level(times, samples + dither) ** 2 - rounding
    return nan if np.isnan(variance) else sqrt(max(variance, rounding))


def complete_noise(stated: Mapping[str, StatedSignal], runs: Sequence[Run]) -> dict[str, Signal]:
    """Signals with their noise: stated levels are kept, the others estimated from the samples.

    Where the samples show none, 1 % of their range is assumed: sparse ones, such as points read off a printed figure.
    Where runs of the same test differ more than that, or more is stated, their repeatability takes its place.

    A record in steps has their noise of step/sqrt(12) besides a stated one, which is that of the sensor (B. Widrow,
    I. Kollar, Quantization Noise, 2008); an estimated one holds it already. (What rounding does to a residual,
    ``comparison.rounding`` says.)

    Args:
        stated: the measured outputs by name.
        runs: their samples.
    """
    return with_repeatability({name: _complete(one, runs) for name, one in stated.items()}, runs)


def _complete(stated: StatedSignal, runs: Sequence[Run]) -> Signal:
    """A signal with the noise of one run, stated, estimated or assumed."""
    samples = [run.measurements[stated.name] for run in runs if stated.name in run.measurements]
    known = stated.sigma or _typical(runs, stated.name)
    signal = Signal(
        stated.name,
        stated.unit,
        known or _assumed(samples),
        estimated=stated.sigma is None,
        fitted=stated.fitted,
        step=stated.step,
        repeatability=stated.repeatability,
        assumed=not known,
        stated=stated.sigma,
    )
    if not (signal.assumed or signal.step):
        signal = _with_steps(signal, samples)
    return _growing(signal, stated.sigma_of_reading, samples) if stated.sigma_of_reading else signal


def _growing(signal: Signal, growth: float, samples: Sequence[Array]) -> Signal:
    """The signal with noise that grows with the reading; steps count as noise beside it, white and the same everywhere.

    What an instrument of a class of accuracy is off by at every reading alike is no noise: that is an effect.
    """
    readings = np.concatenate(samples)
    typical = growth * sqrt(float(np.nanmean(readings**2)))
    at_zero = signal.sigma
    return replace(signal, sigma=hypot(at_zero, typical), sigma_of_reading=growth, sigma_at_zero=at_zero, step=0.0)


def _assumed(samples: Sequence[Array]) -> float:
    """A share of the range of samples that show no noise; of what stands still, next to nothing of its value."""
    values = np.concatenate([np.empty(0), *samples])
    values = values[np.isfinite(values)]
    if not values.size:
        values = np.zeros(1)
    return CRITERIA.noise.assumed_share * float(np.ptp(values)) or max(abs(float(np.mean(values))), 1.0) * 1e-6


def record_step(values: ArrayLike) -> float:
    """The step of a record of which every sample is a multiple of it, but for a constant; 0 where there is none.

    Args:
        values: (n,) samples, NaN where one is missing; fewer than some 30 show none.
    """
    samples: Array = np.asarray(values, dtype=float)
    levels = np.unique(samples[np.isfinite(samples)])
    quantum = _quantum(levels)
    if np.isfinite(samples).sum() < CRITERIA.noise.fewest_samples or quantum == 0.0:
        return 0.0
    # From level to level, so that digits which round a step themselves do not add up; then the step that suits all.
    places = np.concatenate([[0.0], np.cumsum(np.round(np.diff(levels) / quantum))])
    step, first = (float(c) for c in np.polyfit(places, levels, 1))
    off = np.abs(levels - first - step * places)
    return step if bool((off < CRITERIA.noise.off_step * step).all()) else 0.0


def _with_steps(signal: Signal, samples: Sequence[Array]) -> Signal:
    """The signal with the step of its record, where that adds to its noise; its noise with that of the steps.

    A stated noise is that of the sensor; an estimated one holds the steps. What is less than a part of a step is no
    estimate: so small a noise is seen only where a signal rests near the edge of a step.
    """
    steps = [record_step(values) for values in samples if _quantum(values[np.isfinite(values)])]
    step = float(np.median(steps)) if steps else 0.0
    noise, rounding = signal.sigma, step**2 / 12.0
    if rounding < CRITERIA.residuals.slight_excess * noise**2:
        return signal
    if signal.estimated:
        noise = sqrt(max(noise**2 - rounding, 0.0))
    noise = max(noise, CRITERIA.noise.least_of_step * step)
    return replace(signal, step=step, sigma=sqrt(noise**2 + rounding))


def _typical(all_runs: Sequence[Run], signal: str) -> float:
    """Median over the runs: a run in which the signal shakes says nothing about the instrument. 0: none shows it."""
    runs = [run for run in all_runs if signal in run.measurements]
    estimates = [estimate_noise(run.time, run.measurements[signal]) for run in runs if not run.is_static]
    estimates.append(_along_curves([(run.time, run.measurements[signal]) for run in runs if run.is_static]))
    finite = [sigma for sigma in estimates if np.isfinite(sigma)]
    return float(np.median(finite)) if finite else 0.0


def _along_curves(curves: Sequence[tuple[Array, Array]]) -> float:
    """Noise of points along curves at uneven distances, repeated ones among them; NaN where they are too few.

    What a sample differs by from the line through its neighbours, by the variance of that, all curves together (Gasser,
    Sroka and Jennen-Steinmetz 1986); of curves that bend between two points, the same from a cubic.
    """
    scales = []
    for around in ((-1, 1), (-2, -1, 1, 2)):
        parts = [_misses(at[np.isfinite(y)], y[np.isfinite(y)], around) for at, y in curves]
        misses = np.concatenate([np.empty(0), *parts])
        if misses.size >= CRITERIA.noise.fewest_samples:
            scales.append(_scale(misses))
    return min(scales, default=nan)


def _misses(at: Array, values: Array, around: Sequence[int]) -> Array:
    """What each sample is off the polynomial through those ``around`` it, in its own standard deviation per sigma.

    Where neighbours stand at one place, the mean of all is what a sample is off.
    """
    reach = max(around)
    middle = np.arange(reach, len(values) - reach)
    if not middle.size:
        return np.empty(0)
    nodes = at[middle[:, None] + np.array(around)]
    distance = nodes[:, :, None] - nodes[:, None, :]
    own = np.arange(len(around))
    distance[:, own, own] = 1.0
    factors = np.repeat((at[middle, None] - nodes)[:, None, :], len(around), axis=1)
    factors[:, own, own] = 1.0
    with np.errstate(divide="ignore", invalid="ignore"):
        weights = (factors / distance).prod(axis=2)
    same = ~np.isfinite(weights).all(axis=1) | (np.abs(weights).max(axis=1) > 1.0 + 1e-9)
    flat = same & (np.ptp(nodes, axis=1) == 0.0)
    weights[flat] = 1.0 / len(around)
    kept = flat | ~same if reach == 1 else np.isfinite(weights).all(axis=1)
    off = values[middle] - np.sum(weights * values[middle[:, None] + np.array(around)], axis=1)
    return np.asarray((off / np.sqrt(1.0 + np.sum(weights**2, axis=1)))[kept])


def _quantum(values: Array) -> float:
    """Smallest distance of different values, rounding errors of the conversion aside; 0 when all are equal."""
    distinct = np.unique(values)
    if distinct.size < 2:
        return 0.0
    gaps = np.diff(distinct)
    return float(gaps[gaps > 1e-9 * np.abs(distinct).max()].min(initial=distinct[-1] - distinct[0]))


def _white_level(time: Array, values: Array) -> float:
    """The estimate of the lowest order that higher orders do not lower; NaN when every order lowers it."""
    tolerance = 1.0 + max(CRITERIA.noise.level_tolerance, CRITERIA.noise.level_spread / sqrt(len(values)))
    previous = inf
    for order in CRITERIA.noise.orders:
        sigma = _scale(_differences(time, values, order))
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


def _scale(differences: Array) -> float:
    """Robust standard deviation: from the median, then sharpened by the root mean square of what is not outlying."""
    if differences.size == 0:
        return nan
    rough = CRITERIA.noise.median_to_sigma * float(np.median(np.abs(differences)))
    inner = differences[np.abs(differences) <= _CLIP * rough]
    return sqrt(float(np.mean(inner**2)) / _CLIPPED_VARIANCE)
