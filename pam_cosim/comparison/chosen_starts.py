"""How runs begin that do not say it: as the model does by itself, where their first samples agree with that."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from pam_cosim.comparison.beginning import Probe, measured
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import SimulationFailure
from pam_cosim.measurement import DataSet, FirstSamples, Run, Start, first_samples
from pam_cosim.simulation import AnySimulator
from pam_cosim.units import format_quantity


@dataclass(frozen=True)
class _First:
    """A signal at its first sample, and what the model gives there."""

    name: str
    unit: str
    sample: FirstSamples
    model: float
    away: bool

    def said(self, model: bool = False) -> str:
        return format_quantity(self.model if model else self.sample.value, self.unit, 3)


def with_starts(simulator: AnySimulator, data: DataSet, parameters: Mapping[str, float] | None = None) -> DataSet:
    """The same where every run says how it begins.

    Args:
        simulator: the model.
        data: the measurement with its noise.
        parameters: values to simulate with [SI].

    Raises:
        InputError: a parameter that the model does not have.
    """
    if all(run.is_static or run.start.mode is not None for run in data.runs):
        return data
    runs = tuple(
        run if run.is_static or run.start.mode is not None else _with_start(simulator, data, run, parameters or {})
        for run in data.runs
    )
    return replace(data, runs=runs)


def _with_start(simulator: AnySimulator, data: DataSet, run: Run, parameters: Mapping[str, float]) -> Run:
    own = data.parameters_of(run, parameters)
    try:
        first = _first(simulator, data, run, own)
        away = [one for one in first if one.away]
        if not away or _is_fitted(simulator, data, run, own):
            return replace(run, start=Start("rest"))
        shown = measured(simulator, data, run, own).shown
    except SimulationFailure:  # who simulates the run says why it cannot be
        return replace(run, start=Start("rest"))
    moving = any(one.sample.moves for one in first)
    begins = f"{run.name} begins at {', '.join(one.said() for one in first)}, {'moving' if moving else 'at rest'}"
    if not shown:
        where = ", ".join(f"{one.name} = {one.said(model=True)}" for one in away)
        return replace(run, start=Start("rest", f"{begins}: the model begins at {where}, and cannot begin elsewhere"))
    return replace(run, start=Start("estimated", f"{begins}: estimated"))


def _first(simulator: AnySimulator, data: DataSet, run: Run, own: Mapping[str, float]) -> list[_First]:
    """Signals that show a state, or all that are fitted where none does, beside the model that begins by itself."""
    probe = Probe(simulator, data, run, own)
    when = {name: float(run.time[np.isfinite(run.measurements[name])][0]) for name in probe.signals}
    times = np.unique(list(when.values()))
    if not times.size:
        return []
    course = probe.course(times, probe.signals)
    first = [_beside(data, run, n, when[n], float(course[n][np.searchsorted(times, when[n])])) for n in probe.signals]
    shows = probe.showing()
    return [one for one in first if one.name in shows] or first


def _beside(data: DataSet, run: Run, name: str, time: float, model: float) -> _First:
    signal = data.signals[name]
    sigma = signal.sigma or 0.0
    sample = first_samples(run.time, run.measurements[name], sigma, time)
    assert sample is not None
    values = np.concatenate([[model], *(r.measurements[name] for r in data.runs if name in r.measurements)])
    span = float(np.nanmax(values) - np.nanmin(values))
    tolerance = max(CRITERIA.starts.away * sigma, CRITERIA.recognition.offset * span)
    return _First(name, signal.unit, sample, model, abs(sample.value - model) > tolerance)


def _is_fitted(simulator: AnySimulator, data: DataSet, run: Run, own: Mapping[str, float]) -> bool:
    """Whether a free parameter says where the run begins."""
    for free in data.fit.values():
        if free.run and free.run != run.name:
            continue
        low, high = (
            Probe(simulator, data, run, {**own, free.parameter: value}).at({})[1] for value in (free.min, free.max)
        )
        size = np.maximum(np.maximum(np.abs(low), np.abs(high)), 1.0)
        if float(np.max(np.abs(high - low) / size, initial=0.0)) > CRITERIA.starts.own_parameter:
            return True
    return False


__all__ = ["with_starts"]
