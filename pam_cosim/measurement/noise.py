"""The noise of each signal: stated, estimated from the samples or assumed, with the steps of its record."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import hypot, nan, sqrt

import numpy as np
from numpy.typing import ArrayLike

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement.data_set import Run
from pam_cosim.measurement.repeatability import with_repeatability
from pam_cosim.measurement.signal import Signal, StatedSignal
from pam_cosim.measurement.white_noise import estimate_noise, quantum_of, robust_scale


def complete_noise(stated: Mapping[str, StatedSignal], runs: Sequence[Run]) -> dict[str, Signal]:
    """Signals with their noise: stated levels are kept, the others estimated from the samples.

    Where the samples show none, 1 % of their range is assumed: sparse ones, such as points read off a printed figure.
    Where runs of the same test differ more than that, or more is stated, their repeatability takes its place.

    A record in steps has their noise of step/sqrt(12) in addition to a stated one, which is that of the sensor (B.
    Widrow, I. Kollar, Quantization Noise, 2008); an estimated one holds it already. (What rounding does to a residual,
    ``comparison.rounding`` says.)

    Args:
        stated: the measured outputs by name.
        runs: their samples.
    """
    return with_repeatability(
        {name: _complete(signal, runs) for name, signal in stated.items()}, runs
    )


def _complete(stated: StatedSignal, runs: Sequence[Run]) -> Signal:
    """A signal with the noise of one run, stated, estimated or assumed."""
    samples = [run.measurements[stated.name] for run in runs if stated.name in run.measurements]
    known_sigma = stated.sigma or _typical(runs, stated.name)
    signal = Signal(
        stated.name,
        stated.unit,
        known_sigma or _assumed(samples),
        estimated=stated.sigma is None,
        fitted=stated.fitted,
        step=stated.step,
        repeatability=stated.repeatability,
        assumed=not known_sigma,
        stated=stated.sigma,
    )
    if not (signal.assumed or signal.step):
        signal = _with_steps(signal, samples)
    return _growing(signal, stated.sigma_of_reading, samples) if stated.sigma_of_reading else signal


def _growing(signal: Signal, growth: float, samples: Sequence[Array]) -> Signal:
    """The signal with noise that grows with the reading; steps count as additional white noise.

    What an instrument of a class of accuracy is off by at every reading alike is no noise: that is an effect.
    """
    readings = np.concatenate(samples)
    typical = growth * sqrt(float(np.nanmean(readings**2)))
    at_zero = signal.sigma
    return replace(
        signal,
        sigma=hypot(at_zero, typical),
        sigma_of_reading=growth,
        sigma_at_zero=at_zero,
        step=0.0,
    )


def _assumed(samples: Sequence[Array]) -> float:
    """A share of the range of samples that show no noise; of what stands still, next to nothing of its value."""
    values = np.concatenate([np.empty(0), *samples])
    values = values[np.isfinite(values)]
    if not values.size:
        values = np.zeros(1)
    return (
        CRITERIA.noise.assumed_share * float(np.ptp(values))
        or max(abs(float(np.mean(values))), 1.0) * 1e-6
    )


def record_step(values: ArrayLike) -> float:
    """The step of a record of which every sample is a multiple of it, but for a constant; 0 where there is none.

    Args:
        values: (n,) samples, NaN where one is missing; fewer than some 30 show none.
    """
    samples: Array = np.asarray(values, dtype=float)
    levels = np.unique(samples[np.isfinite(samples)])
    quantum = quantum_of(levels)
    if np.isfinite(samples).sum() < CRITERIA.noise.fewest_samples or quantum == 0.0:
        return 0.0
    # From level to level, so that digits which round a step themselves do not add up; then the step that suits all.
    places = np.concatenate([[0.0], np.cumsum(np.round(np.diff(levels) / quantum))])
    step, offset = (float(c) for c in np.polyfit(places, levels, 1))
    off = np.abs(levels - offset - step * places)
    return step if bool((off < CRITERIA.noise.off_step * step).all()) else 0.0


def _with_steps(signal: Signal, samples: Sequence[Array]) -> Signal:
    """The signal with the step of its record, where that adds to its noise; its noise with that of the steps.

    A stated noise is that of the sensor; an estimated one holds the steps. What is less than a part of a step is no
    estimate: so small a noise is seen only where a signal rests near the edge of a step.
    """
    steps = [record_step(values) for values in samples if quantum_of(values[np.isfinite(values)])]
    step = float(np.median(steps)) if steps else 0.0
    noise, rounding = signal.sigma, step**2 / 12.0
    if rounding < CRITERIA.noise.slight_rounding * noise**2:
        return signal
    if signal.estimated:
        noise = sqrt(max(noise**2 - rounding, 0.0))
    noise = max(noise, CRITERIA.noise.least_of_step * step)
    return replace(signal, step=step, sigma=sqrt(noise**2 + rounding))


def _typical(all_runs: Sequence[Run], signal: str) -> float:
    """Median over the runs: a vibrating signal does not show the instrument's noise. 0: no run shows it."""
    runs = [run for run in all_runs if signal in run.measurements]
    estimates = [
        estimate_noise(run.time, run.measurements[signal]) for run in runs if not run.is_static
    ]
    estimates.append(
        _along_curves([(run.time, run.measurements[signal]) for run in runs if run.is_static])
    )
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
            scales.append(robust_scale(misses))
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
    places = np.arange(len(around))
    distance[:, places, places] = 1.0
    factors = np.repeat((at[middle, None] - nodes)[:, None, :], len(around), axis=1)
    factors[:, places, places] = 1.0
    with np.errstate(all="ignore"):  # two nodes at one place, or nearly so, have no weights
        weights = (factors / distance).prod(axis=2)
        has_weights = np.isfinite(np.sum(weights**2, axis=1))
    is_repeated = ~has_weights | (np.abs(weights).max(axis=1) > 1.0 + 1e-9)
    flat = is_repeated & (np.ptp(nodes, axis=1) == 0.0)
    weights[flat] = 1.0 / len(around)
    is_usable = flat | ~is_repeated if reach == 1 else flat | has_weights
    weights, middle = weights[is_usable], middle[is_usable]
    off = values[middle] - np.sum(weights * values[middle[:, None] + np.array(around)], axis=1)
    return np.asarray(off / np.sqrt(1.0 + np.sum(weights**2, axis=1)))
