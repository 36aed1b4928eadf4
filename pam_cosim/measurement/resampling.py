"""A long recording as means over short intervals, so that a fit has the rows that carry information.

The mean of k samples with independent noise has the noise divided by sqrt(k), and determines a signal equally well that
bends little within the interval. An input that steps keeps the time and both values of its step: no mean goes across
it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import sqrt
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement.data_set import Run
from pam_cosim.measurement.noise import record_step
from pam_cosim.measurement.recording import Recording, locked
from pam_cosim.measurement.signal import Averaged, StatedSignal
from pam_cosim.simulation.inputs import Interpolation
from pam_cosim.units import format_quantity

_Places = NDArray[np.int64]
_SAME = 1e-6  # of the interval: two means at times no farther apart share a row


_Rows = TypeVar("_Rows", Recording, Run)


def resampled(recording: _Rows, interval: float, interpolation: Interpolation) -> _Rows:
    """Means over about ``interval`` [s]; a recording that is no denser stays as it is.

    The rows of the means are at the mean times of their samples; a signal that has fewer samples than others has rows
    of its own where those lie elsewhere. Rows of inputs alone stand at the beginning, the end
    and both sides of each step; where inputs are held (``interpolation`` "previous"), also where a mean begins. A mean
    of fewer than half as many samples as usual, between steps, is left out of the measurements.
    """
    time, count = recording.time, len(recording.time)
    mean_count = max(1, round((time[-1] - time[0]) / interval))
    if 2 * mean_count > count:
        return recording
    jumps = _jumps(recording.inputs, mean_count)
    starts = _starts(time, jumps, interval)
    sizes = np.diff(starts, append=count)
    middle = np.add.reduceat(time, starts) / sizes
    held, first_and_last = interpolation == "previous", np.array([0, count - 1])
    # Rows of inputs alone; a mean of one sample is that row already.
    rows_kept = np.concatenate([first_and_last, jumps, jumps + 1, starts if held else jumps])
    kept_rows = np.setdiff1d(rows_kept if recording.inputs else jumps[:0], starts[sizes == 1])
    mean_at = np.searchsorted(starts, kept_rows, side="right") - 1
    # About the first sample, so that the mean of what stands still is that to the last digit.
    first_values = {name: v[starts] for name, v in recording.inputs.items()}
    inputs = {
        name: v + np.add.reduceat(recording.inputs[name] - np.repeat(v, sizes), starts) / sizes
        for name, v in first_values.items()
    }
    means = {name: _mean(time, v, starts) for name, v in recording.measurements.items()}
    elsewhere = {
        name: np.flatnonzero(np.abs(mean.time - middle) > _SAME * interval)
        for name, mean in means.items()
    }
    pairs: list[Array] = [
        np.column_stack([means[name].time[at], at]) for name, at in elsewhere.items()
    ]
    extra_times, row = np.unique(
        np.concatenate([np.empty((0, 2)), *pairs]), axis=0, return_inverse=True
    )
    rows = np.split(row.ravel(), np.cumsum([len(at) for at in elsewhere.values()]))
    row_of = dict(zip(elsewhere, rows, strict=False))
    own_time, of_mean = extra_times[:, 0], extra_times[:, 1].astype(np.int64)
    times = np.concatenate([middle, time[kept_rows], own_time])
    # Stable: of rows at one time the mean before a step comes first.
    order = np.lexsort((np.concatenate([starts, kept_rows, starts[of_mean]]), times))
    order = order[~_third(times[order])]

    def of_input(name: str, values: Array) -> Array:
        recorded = recording.inputs[name]
        means = values[mean_at] if held else recorded[kept_rows]
        means_at_own_rows = values[of_mean] if held else np.interp(own_time, time, recorded)
        return locked(np.concatenate([values, means, means_at_own_rows])[order])

    def of_measurement(name: str, mean: _Mean) -> Array:
        values, means_at_own_rows = mean.values.copy(), np.full(len(own_time), np.nan)
        means_at_own_rows[row_of[name]] = values[elsewhere[name]]
        values[elsewhere[name]] = np.nan
        return locked(
            np.concatenate([values, np.full(len(kept_rows), np.nan), means_at_own_rows])[order]
        )

    means_of = f"means over {format_quantity(interval, 's')}, {len(jumps)} steps of inputs kept"
    return replace(
        recording,
        time=locked(times[order]),
        inputs={name: of_input(name, v) for name, v in inputs.items()},
        measurements={name: of_measurement(name, mean) for name, mean in means.items()},
        averaged={
            name: Averaged(mean.samples, record_step(recording.measurements[name]))
            for name, mean in means.items()
        },
        notes=(*recording.notes, f"{count} rows are {len(order)}: {means_of}"),
    )


def noise_of_mean(sigma: float, averaged: Averaged) -> float:
    """Standard deviation of a mean of samples with the noise ``sigma``, rounded to steps.

    The error of rounding is independent from sample to sample where the noise covers half a step (B. Widrow,
    I. Kollar, Quantization Noise, 2008); below that, it may be the same in all.
    """
    rounding = averaged.step**2 / 12.0
    if 2.0 * sigma >= averaged.step:
        return sqrt((sigma**2 + rounding) / averaged.samples)
    return sqrt(sigma**2 / averaged.samples + rounding)


def with_noise_of_means(
    signals: Mapping[str, StatedSignal], runs: Sequence[Run]
) -> dict[str, StatedSignal]:
    """Stated noise is that of a sample: where runs hold means of several, that of the run with the fewest counts."""
    changed = dict(signals)
    for name, signal in signals.items():
        means = [run.averaged.get(name, Averaged(1)) for run in runs if name in run.measurements]
        fewest = min(means, key=lambda a: a.samples, default=Averaged(1))
        if signal.sigma is not None and fewest.samples > 1:
            step = fewest.step if 2.0 * signal.sigma < fewest.step else 0.0
            growth = signal.sigma_of_reading / sqrt(fewest.samples)
            sigma = noise_of_mean(signal.sigma, fewest)
            changed[name] = replace(signal, sigma=sigma, step=step, sigma_of_reading=growth)
    return changed


def _starts(time: Array, jumps: _Places, interval: float) -> _Places:
    """First index of each mean: what lies between steps is divided evenly."""
    begins = np.concatenate([[0], jumps + 1])
    last = np.concatenate([jumps, [len(time) - 1]])
    span = time[last] - time[begins]
    parts = np.maximum(1, np.round(span / interval)).astype(np.int64)
    segment = np.repeat(np.arange(len(begins)), last - begins + 1)
    with np.errstate(invalid="ignore", divide="ignore"):
        share = np.nan_to_num((time - time[begins][segment]) / span[segment])
    place = np.minimum(np.floor(share * parts[segment]).astype(np.int64), parts[segment] - 1)
    number = np.concatenate([[0], np.cumsum(parts)[:-1]])[segment] + place
    return np.concatenate([[0], np.flatnonzero(np.diff(number)) + 1])


@dataclass(frozen=True)
class _Mean:
    """Means (k,) of the samples there are, NaN of too few; their mean times (k,) [s]; of how many they usually are."""

    values: Array
    time: Array
    samples: int


def _mean(time: Array, values: Array, starts: _Places) -> _Mean:
    present = np.isfinite(values)
    counts = np.add.reduceat(present.astype(np.int64), starts)
    sums = np.add.reduceat(np.where(present, values, 0.0), starts)
    usual = int(np.median(counts[counts > 0])) if counts.any() else 1
    enough = counts >= max(1.0, usual / 2)
    at = np.add.reduceat(np.where(present, time, 0.0), starts)
    divisors = np.maximum(counts, 1)
    return _Mean(
        np.where(enough, sums / divisors, np.nan), np.where(enough, at / divisors, np.nan), usual
    )


def _third(times: Array) -> NDArray[np.bool_]:
    """Which rows are between two others at the same time."""
    is_same_time = np.diff(times) == 0.0
    return (
        np.concatenate([[False], is_same_time[:-1] & is_same_time[1:], [False]])
        if len(times) > 2
        else np.zeros(len(times), bool)
    )


def _jumps(inputs: Mapping[str, Array], most: int) -> NDArray[np.int64]:
    """Rows after which an input steps: differences far beyond the others, the largest ``most`` left out of these."""
    steps = np.zeros(max((len(v) for v in inputs.values()), default=1) - 1, dtype=bool)
    for values in inputs.values():
        size = np.abs(np.diff(values))
        usual = np.partition(size, len(size) - most)[: len(size) - most]
        steps |= size > CRITERIA.noise.outlier_far * np.sqrt(float(np.mean(usual**2)))
    return np.flatnonzero(steps)
