"""Repeatability: what a rig's signals differ by when the same test is made again.

Its standard deviation (ISO 5725-2, section 7.4) holds the noise of the instrument and whatever of the rig does not come
again: friction that settles elsewhere, a supply that is not quite the same, a muscle that has warmed. No model explains
it, so that it takes the place of the noise where it is larger.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from math import sqrt

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement.data_set import Run
from pam_cosim.measurement.signal import Signal
from pam_cosim.measurement.white_noise import estimate_noise


def repeatability(runs: Sequence[Run], signal: str) -> float:
    """Repeatability standard deviation of a signal [its unit], from runs that repeat one another; 0: none do.

    Half the mean square difference of samples of two such runs, without what follows, in proportion, from the small
    differences of their inputs.

    Args:
        runs: the measurement.
        signal: its name.
    """
    pairs = [p for a, b in _repeated_pairs(runs) if (p := _differences(a, b, signal)) is not None]
    differences = np.concatenate([d for d, _ in pairs] or [np.empty(0)])
    if len(differences) < CRITERIA.noise.fewest_repeated:
        return 0.0
    causes = np.concatenate([u for _, u in pairs])
    varied_causes = causes[:, np.ptp(causes, axis=0) > 0]
    if varied_causes.shape[1]:
        differences = (
            differences - varied_causes @ np.linalg.lstsq(varied_causes, differences, rcond=None)[0]
        )
    return sqrt(float(np.mean(differences**2)) / 2.0)


def with_repeatability(signals: Mapping[str, Signal], runs: Sequence[Run]) -> dict[str, Signal]:
    """The signals with their repeatability, stated or estimated, as their noise where it is larger."""
    return {
        name: _with_repeatability_as_noise(_with_estimate(signal, runs))
        for name, signal in signals.items()
    }


def _with_estimate(signal: Signal, runs: Sequence[Run]) -> Signal:
    if signal.repeatability:
        return signal
    estimate = repeatability(runs, signal.name)
    if estimate**2 <= (1.0 + CRITERIA.noise.repeatability_excess) * signal.sigma**2:
        return signal
    return replace(signal, repeatability=estimate, repeats=True)


def _with_repeatability_as_noise(signal: Signal) -> Signal:
    if signal.repeatability <= signal.sigma:
        return signal
    return replace(
        signal, sigma=signal.repeatability, estimated=False, assumed=False, sigma_of_reading=0.0
    )


def _repeated_pairs(runs: Sequence[Run]) -> Iterator[tuple[Run, Run]]:
    """Pairs of runs of the same test: equal parameters, and inputs that are practically equal."""
    pairs = {
        name: [r.inputs[name] for r in runs if name in r.inputs] for a in runs for name in a.inputs
    }
    span = {name: float(np.ptp(np.concatenate(values))) for name, values in pairs.items()}
    for a, b in itertools.combinations(runs, 2):
        if _are_same_test(a, b) and all(
            _has_near_input(a, b, name, span[name]) for name in a.inputs
        ):
            yield a, b


def _are_same_test(a: Run, b: Run) -> bool:
    if (a.along, a.parameters, a.inputs.keys()) != (
        b.along,
        b.parameters,
        b.inputs.keys(),
    ) or not a.inputs:
        return False
    duration_a, duration_b = (float(np.ptp(run.time)) for run in (a, b))
    return abs(duration_a - duration_b) <= CRITERIA.noise.same_test * max(duration_a, duration_b)


def _has_near_input(a: Run, b: Run, name: str, span: float) -> bool:
    """Whether an input differs by little of what it goes through in all runs, and in these two: or by noise alone."""
    input_a, input_b = a.inputs[name], b.inputs[name][_nearest_samples(a, b)]
    square = float(np.mean((input_a - input_b) ** 2))
    size = max(float(np.abs(input_a).max()), float(np.abs(input_b).max()))
    if sqrt(square) > CRITERIA.noise.same_test * span:
        return False
    if sqrt(square) <= CRITERIA.noise.same_test * size:
        return True
    noise = estimate_noise(
        a.time, input_a - input_b
    )  # of an input that is constant while others vary, and is recorded
    return square <= (1.0 + CRITERIA.noise.repeatability_excess) * noise**2


def _nearest_samples(a: Run, b: Run) -> Array:
    """(n,) for each sample of one run, the sample of the other that is nearest, counted from their beginnings."""
    at = a.time - a.time[0] * (not a.is_static)
    times_of_other = b.time - b.time[0] * (not b.is_static)
    order = np.argsort(times_of_other, kind="stable")
    middles = (times_of_other[order][1:] + times_of_other[order][:-1]) / 2.0
    return np.asarray(order[np.searchsorted(middles, at)])


def _differences(a: Run, b: Run, signal: str) -> tuple[Array, Array] | None:
    """(n,) differences of a signal and (n, inputs) of the inputs, where both runs have samples."""
    if not (a.sample_count(signal) and b.sample_count(signal)):
        return None
    rows = _nearest_samples(a, b)
    off = a.measurements[signal] - b.measurements[signal][rows]
    causes = np.column_stack([a.inputs[name] - b.inputs[name][rows] for name in a.inputs])
    present = np.isfinite(off)
    return off[present], causes[present]
