"""Where the error sits, as rules a person can read."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.comparison.residuals import RunComparison
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement import Signal
from pam_cosim.model.domain import Domain
from pam_cosim.model.interface import Variable
from pam_cosim.model.references import BRANCH
from pam_cosim.units import readable_factor, readable_unit

Mask = NDArray[np.bool_]


@dataclass(frozen=True)
class Rule:
    """A part of the measurement that holds more than its share of the error.

    Attributes:
        signal: whose error.
        rule: the conditions, in words.
        error_share: share of the squared error beyond the noise.
        time_share: share of the samples.
    """

    signal: str
    rule: str
    error_share: float
    time_share: float


@dataclass(frozen=True)
class _Samples:
    excess: Array
    conditions: list[list[tuple[str, Mask]]]


def where(
    runs: Sequence[RunComparison],
    signals: Mapping[str, Signal],
    outputs: Mapping[str, Variable],
    domain: Domain,
    inputs: Mapping[str, Variable] | None = None,
) -> list[Rule]:
    """Finds for each signal the few rules that hold most of its error in the least time.

    Conditions are the phase, bands of the modelled outputs, whether one that moves grows, rests or shrinks and how
    fast, early, middle or late in the run, the run, and what differs between runs, such as the load; a rule joins a
    phase with one more. What divides a run into phases, and what moves, the ``domain`` says. Points at rest have bands
    of what is imposed, by ``inputs``, and of the outputs.
    """
    rules: list[Rule] = []
    for name, signal in signals.items():
        samples = _collect(runs, signal, outputs, domain, inputs or {})
        if samples is not None:
            rules += _rules(name, samples)
    return sorted(rules, key=lambda r: -r.error_share * (r.error_share - r.time_share))


def _collect(
    runs: Sequence[RunComparison],
    signal: Signal,
    outputs: Mapping[str, Variable],
    domain: Domain,
    inputs: Mapping[str, Variable],
) -> _Samples | None:
    parts = [r for r in runs if r.run.sample_count(signal.name)]
    if not parts:
        return None
    present = _Present(parts, [r.residual(signal.name) for r in parts])
    noise = signal.sigma_at(present.of([r.run.measurements[signal.name] for r in parts]))
    excess = np.maximum(present.of(present.residuals) ** 2 - noise**2, 0.0)
    if excess.sum() <= 0:
        return None
    conditions = []
    for name, variable in outputs.items():
        conditions += _bands(name, variable, present.of([r.model[name] for r in parts]))
    if all(r.run.is_static for r in parts):
        return _Samples(excess, [[], _by_imposed(present, inputs) + conditions + _by_run(present)])
    for name, variable in outputs.items():
        if variable.unit in domain.moving:
            conditions += _moving(name, present.of([_speed(r, name) for r in parts]))
    conditions += _times(present) + _by_run(present)
    return _Samples(excess, [_phases(present, outputs, domain), conditions])


class _Present:
    """The samples of a signal that are there, of all runs one after the other."""

    def __init__(self, parts: Sequence[RunComparison], residuals: Sequence[Array]) -> None:
        self.parts, self.residuals = parts, residuals
        self.kept = [np.isfinite(error) for error in residuals]

    def of(self, values: Sequence[Array]) -> Array:
        """What belongs to these samples, of what is given for each row of each run."""
        return np.concatenate([v[k] for v, k in zip(values, self.kept, strict=True)])

    @property
    def run_numbers(self) -> Array:
        """Of which run each is."""
        return np.concatenate([np.full(int(k.sum()), i) for i, k in enumerate(self.kept)])


def _phases(
    present: _Present, outputs: Mapping[str, Variable], domain: Domain
) -> list[tuple[str, Mask]]:
    """The phases that the field divides a run into, by the slope of the output that has the unit for it."""
    dividing = next(
        ((n, row) for row in domain.phases for n, v in outputs.items() if v.unit == row[0]), None
    )
    if dividing is None:
        return []
    output, (_, rising, resting, falling) = dividing
    slope = present.of([_slope(r.run.time, r.model[output]) for r in present.parts])
    limit = CRITERIA.where.still * float(np.max(np.abs(slope), initial=0.0))
    return [(rising, slope > limit), (resting, np.abs(slope) <= limit), (falling, slope < -limit)]


def _times(present: _Present) -> list[tuple[str, Mask]]:
    """Thirds of each run."""
    late = present.of([_relative_time(r.run.time) for r in present.parts])
    return [
        ("early", late < 1 / 3),
        ("middle", (late >= 1 / 3) & (late < 2 / 3)),
        ("late", late >= 2 / 3),
    ]


def _by_run(present: _Present) -> list[tuple[str, Mask]]:
    """Each run, where there are several, and runs that have a parameter's value in common."""
    numbers, parts = present.run_numbers, present.parts
    single = (
        [(f"in {r.run.name}", numbers == i) for i, r in enumerate(parts)] if len(parts) > 1 else []
    )
    return single + _by_parameter(parts, numbers)


def _by_imposed(present: _Present, inputs: Mapping[str, Variable]) -> list[tuple[str, Mask]]:
    """Bands of the inputs that all runs at rest have."""
    parts = present.parts
    names = [
        n for n in parts[0].run.inputs if n in inputs and all(n in r.run.inputs for r in parts)
    ]
    return [
        band
        for n in names
        for band in _given(n, inputs[n], present.of([r.run.inputs[n] for r in parts]))
    ]


def _speed(r: RunComparison, output: str) -> Array:
    return _slope(r.run.time, r.model[output])


def _moving(name: str, speed: Array) -> list[tuple[str, Mask]]:
    """Direction, and fast or slow by the typical speed of what moves."""
    limit = CRITERIA.where.still * float(np.max(np.abs(speed), initial=0.0))
    if not limit > 0:
        return []
    fast = float(np.median(np.abs(speed[np.abs(speed) > limit])))
    return [
        (f"{name} grows fast", speed > fast),
        (f"{name} grows slowly", (speed > limit) & (speed <= fast)),
        (f"{name} rests", np.abs(speed) <= limit),
        (f"{name} shrinks slowly", (speed < -limit) & (speed >= -fast)),
        (f"{name} shrinks fast", speed < -fast),
    ]


def _by_parameter(parts: Sequence[RunComparison], names: Array) -> list[tuple[str, Mask]]:
    """One condition for each value of a parameter that several runs share and others do not."""
    masks: list[tuple[str, Mask]] = []
    for parameter in parts[0].run.parameters:
        values = np.array([r.run.parameters.get(parameter, np.nan) for r in parts])
        for value in np.unique(values):
            members = np.flatnonzero(values == value)
            if 1 < len(members) < len(parts):
                masks.append((f"{parameter} = {value:.4g}", np.isin(names, members)))
    return masks


def _slope(time: Array, values: Array) -> Array:
    slope = np.zeros_like(values)
    step = np.diff(time)
    good = step > 0
    slope[1:][good] = np.diff(values)[good] / step[good]
    return slope


def _relative_time(time: Array) -> Array:
    span = float(time[-1] - time[0])
    return (time - time[0]) / span if span else np.zeros_like(time)


def _given(name: str, variable: Variable, values: Array) -> list[tuple[str, Mask]]:
    """Bands of an input; of the branch that points at rest lie on, its direction."""
    if name != BRANCH:
        return _bands(name, variable, values)
    return [("inflating", values > 0), ("deflating", values < 0)] if np.ptp(values) > 0 else []


def _bands(name: str, variable: Variable, values: Array) -> list[tuple[str, Mask]]:
    low, high = float(values.min()), float(values.max())
    if not high > low:
        return []
    edges = np.linspace(low, high, CRITERIA.where.bands + 1)
    factor, unit = readable_factor(variable.unit), readable_unit(variable.unit)
    bands: list[tuple[str, Mask]] = []
    for i in range(CRITERIA.where.bands):
        inside = (values >= edges[i]) & ((values < edges[i + 1]) | (i == CRITERIA.where.bands - 1))
        first, last = (
            0.0 if abs(e) < CRITERIA.where.edge_at_zero * (high - low) else e
            for e in (edges[i], edges[i + 1])
        )
        text = f"{first * factor:.3g} {unit} < {name} < {last * factor:.3g} {unit}"
        bands.append((text.replace("  ", " "), inside))
    return bands


def _candidates(samples: _Samples) -> list[tuple[str, Mask]]:
    """What a rule can say: each condition, and each phase with another condition."""
    phases, others = samples.conditions
    return [*phases, *others, *((f"{a}, {b}", m & n) for a, m in phases for b, n in others)]


def _rules(signal: str, samples: _Samples) -> list[Rule]:
    candidates = _candidates(samples)
    left = samples.excess.copy()
    total, count = float(left.sum()), len(left)
    rules: list[Rule] = []
    for _ in range(CRITERIA.where.rules_per_signal):
        best: tuple[float, str, Mask] | None = None
        for text, mask in candidates:
            time_share = float(mask.sum()) / count
            if time_share < min(CRITERIA.where.least_time_share, 2 / count):
                continue
            gain = float(left[mask].sum()) / total
            value = gain * (gain - time_share)
            if gain > time_share and (best is None or value > best[0]):
                best = (value, text, mask)
        if best is None or best[0] < CRITERIA.where.least_value:
            break
        _, text, mask = best
        rules.append(
            Rule(signal, text, float(samples.excess[mask].sum()) / total, float(mask.sum()) / count)
        )
        left = np.where(mask, 0.0, left)
    return rules


def samples_in(
    rule: Rule,
    runs: Sequence[RunComparison],
    signals: Mapping[str, Signal],
    outputs: Mapping[str, Variable],
    domain: Domain,
    inputs: Mapping[str, Variable] | None = None,
) -> dict[str, list[tuple[float, float]]]:
    """Where a rule of ``where`` holds, which was called with the same: ranges of the time [s] of each run by name.

    Of points at rest, ranges of what they are drawn over.
    """
    samples = _collect(runs, signals[rule.signal], outputs, domain, inputs or {})
    mask = (
        None
        if samples is None
        else next((m for text, m in _candidates(samples) if text == rule.rule), None)
    )
    ranges: dict[str, list[tuple[float, float]]] = {}
    if mask is None:
        return ranges
    at = 0
    for r in runs:
        if not r.run.sample_count(rule.signal):
            continue
        time = r.run.time[np.isfinite(r.residual(rule.signal))]
        edges = np.flatnonzero(np.diff(mask[at : at + len(time)].astype(int), prepend=0, append=0))
        at += len(time)
        if len(edges):
            pairs = edges.reshape(-1, 2)
            ranges[r.run.name] = [
                (float(time[first]), float(time[end - 1])) for first, end in pairs
            ]
    return ranges
