"""Where the error sits, as rules a person can read."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison.residuals import RunComparison
from pam_cosim.comparison.sample_conditions import (
    Mask,
    Present,
    bands_of,
    by_imposed,
    by_run,
    imposed_speed,
    moving,
    phases,
    times,
)
from pam_cosim.measurement import Signal
from pam_cosim.model.domain import Domain
from pam_cosim.model.interface import Variable

_FEWEST_SAMPLES = 2  # of a rule: one sample may be off by chance
_LEAST_VALUE = 0.02  # share of the error times its excess over the share of time; less is chance
_MOST_RULES = 3  # of each signal, as many as are read


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
    present = Present(parts, [r.residual(signal.name) for r in parts])
    noise = signal.sigma_at(present.of([r.run.measurements[signal.name] for r in parts]))
    excess = np.maximum(present.of(present.residuals) ** 2 - noise**2, 0.0)
    if excess.sum() <= 0:
        return None
    conditions = []
    for name, variable in outputs.items():
        conditions += bands_of(name, variable, present.of([r.model[name] for r in parts]))
    if all(r.run.is_static for r in parts):
        return _Samples(excess, [[], by_imposed(present, inputs) + conditions + by_run(present)])
    for name, variable in outputs.items():
        if variable.unit in domain.moving:
            conditions += moving(name, present.of([imposed_speed(r, name) for r in parts]))
    conditions += times(present) + by_run(present)
    return _Samples(excess, [phases(present, outputs, domain), conditions])


def _candidates(samples: _Samples) -> list[tuple[str, Mask]]:
    """All possible rules: each condition, and each phase with another condition."""
    phases, further_conditions = samples.conditions
    return [
        *phases,
        *further_conditions,
        *((f"{a}, {b}", m & n) for a, m in phases for b, n in further_conditions),
    ]


def _rules(signal: str, samples: _Samples) -> list[Rule]:
    candidates = _candidates(samples)
    unexplained = samples.excess.copy()
    total, count = float(unexplained.sum()), len(unexplained)
    rules: list[Rule] = []
    for _ in range(_MOST_RULES):
        best: tuple[float, str, Mask] | None = None
        for text, mask in candidates:
            size = int(mask.sum())
            if size < _FEWEST_SAMPLES:
                continue
            time_share = size / count
            gain = float(unexplained[mask].sum()) / total
            value = gain * (gain - time_share)
            if gain > time_share and (best is None or value > best[0]):
                best = (value, text, mask)
        if best is None or best[0] < _LEAST_VALUE:
            break
        _, text, mask = best
        rules.append(
            Rule(signal, text, float(samples.excess[mask].sum()) / total, float(mask.sum()) / count)
        )
        unexplained = np.where(mask, 0.0, unexplained)
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
