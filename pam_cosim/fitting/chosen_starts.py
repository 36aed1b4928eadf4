"""How runs begin that do not say it: as the model does by itself, where their first samples agree with that."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pam_cosim.comparison.initial_state import (
    InitialState,
    StartProbe,
    first_of_run,
    initial_state,
    inputs_of_run,
    measured_initial_state,
    start_time,
)
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting.objective import Objective
from pam_cosim.measurement import DataSet, FirstSamples, Run, StartMode
from pam_cosim.simulation import AnySimulator
from pam_cosim.units import format_quantity

_MODES: tuple[StartMode, ...] = ("rest", "estimated")
_LEAST = 3  # runs, of which one may differ from the others
_SAME = 1e-6  # by which a start value may move otherwise than the parameter that it is


@dataclass(frozen=True)
class _First:
    """A signal at its first sample, and what the model gives there.

    Attributes:
        off: it is not what noise makes of the model's value. away: nor what an offset of an instrument does, which is
            small, and the same in all runs.
    """

    name: str
    unit: str
    sample: FirstSamples
    model: float
    off: bool
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
    if not starts_are_open(data):
        return data
    values = parameters or {}
    common = _common_offsets(simulator, data, values)
    runs = [_with_start(simulator, data, r, values, common) if _is_open(r) else r for r in data.runs]
    undecided = [run for run in runs if _is_open(run)]
    if any(run.start.mode == "estimated" for run in runs):
        runs = [_as_others(simulator, data, run, values) for run in runs]
    elif undecided and _takes_away(simulator, data, undecided, values):
        runs = [_estimated(simulator, data, r, values, "which leaves much less") if _is_open(r) else r for r in runs]
    return replace(data, runs=tuple(_begun(run, "rest") if _is_open(run) else run for run in runs))


def starts_are_open(data: DataSet) -> bool:
    """Whether it is to be chosen how some run begins."""
    return any(map(_is_open, data.runs))


def _is_open(run: Run) -> bool:
    return not run.is_static and (not run.start.periods if run.start.periodic else run.start.mode is None)


def _common_offsets(simulator: AnySimulator, data: DataSet, parameters: Mapping[str, float]) -> dict[str, float]:
    """By signal: how far first samples are off the model's own start in most runs, as by an instrument's offset."""
    offsets: dict[str, list[float]] = {}
    for run in data.runs:
        if run.is_static or run.start.periodic or run.start.seconds:
            continue
        try:
            first = _first(simulator, data, run, data.parameters_of(run, parameters), {}, every=True)
        except SimulationFailure:  # who simulates the run says why it cannot be
            continue
        for one in first:
            offsets.setdefault(one.name, []).append(one.sample.value - one.model)
    return {name: float(np.median(values)) for name, values in offsets.items() if len(values) >= _LEAST}


def _begun(run: Run, mode: StartMode, reason: str = "") -> Run:
    return replace(run, start=replace(run.start, mode=mode, reason=reason, chosen=True))


def _with_start(
    simulator: AnySimulator, data: DataSet, run: Run, parameters: Mapping[str, float], common: Mapping[str, float]
) -> Run:
    """The run with its start; unchanged where its first samples alone do not tell it."""
    own = data.parameters_of(run, parameters)
    try:
        if run.start.periodic:
            return _repeated(simulator, data, run, own)
        first = _first(simulator, data, run, own, common)
        off = [one for one in first if one.off]
        if not off or _is_fitted(simulator, data, run, own):
            return _begun(run, "rest")
        begins = measured_initial_state(simulator, data, run, own)
        shown = begins.shown
        if shown and not any(one.away for one in first):
            return run
        if shown and not _explains(simulator, data, run, own, begins):
            return _begun(run, "rest")
    except SimulationFailure:  # who simulates the run says why it cannot be
        return _begun(run, "rest")
    moving = any(one.sample.moves for one in first)
    said = f"{run.name} begins at {', '.join(one.said() for one in first)}, {'moving' if moving else 'at rest'}"
    if not shown:
        where = ", ".join(f"{one.name} = {one.said(model=True)}" for one in off)
        return _begun(run, "rest", f"{said}: the model begins at {where}, and cannot begin elsewhere")
    return _begun(run, "estimated", f"{said}: estimated")


def _explains(simulator: AnySimulator, data: DataSet, run: Run, own: Mapping[str, float], begins: InitialState) -> bool:
    """Whether all signals are much nearer to their first samples from there: a force that is missing stays away."""
    probe = StartProbe(simulator, data, run, own)
    samples = probe.first_samples()
    aims = np.array([samples[name].value for name in probe.signals])
    noise = np.array([data.signals[name].sigma for name in probe.signals])

    def squares(start: InitialState) -> float:
        there = probe.at(start.values, start.settle)[0][: len(aims)]
        return float(np.sum(((there - aims) / noise) ** 2))

    return squares(InitialState()) > CRITERIA.starts.worth * squares(begins)


def _as_others(simulator: AnySimulator, data: DataSet, run: Run, parameters: Mapping[str, float]) -> Run:
    """A run of a recording that begins in the middle; one whose first samples agree with rest may move all the same."""
    agrees = run.start.chosen and run.start.mode == "rest" and not run.start.reason
    if run.is_static or run.start.periodic or not (agrees or _is_open(run)):
        return run
    if agrees and _is_stated(simulator, data, run, parameters):
        return run
    return _estimated(simulator, data, run, parameters, "as others are")


def _estimated(simulator: AnySimulator, data: DataSet, run: Run, parameters: Mapping[str, float], reason: str) -> Run:
    """The run with a start of its own, where it can have one."""
    own = data.parameters_of(run, parameters)
    try:
        if _is_fitted(simulator, data, run, own) or not measured_initial_state(simulator, data, run, own).shown:
            return run
        first = _first(simulator, data, run, own, {}, every=True)
    except SimulationFailure:
        return run
    begins = f"{run.name} begins at {', '.join(one.said() for one in first)}"
    return _begun(run, "estimated", f"{begins}: estimated, {reason}")


def _takes_away(simulator: AnySimulator, data: DataSet, runs: Sequence[Run], parameters: Mapping[str, float]) -> bool:
    """Whether starts of their own take much of what the model leaves: an offset of an instrument stays."""
    left = []
    for mode in _MODES:
        tried = [replace(run, start=replace(run.start, mode=mode)) for run in runs]
        try:
            left.append(Objective(simulator, data, tried, (), parameters).squares(np.zeros(0)))
        except SimulationFailure:
            return False
    return left[0] > CRITERIA.starts.worth * left[1]


def _repeated(simulator: AnySimulator, data: DataSet, run: Run, own: Mapping[str, float]) -> Run:
    """The run with so many periods before it that one more would change nothing that is measured."""
    most = CRITERIA.starts.periods
    signals = {n: s.sigma for n, s in data.signals.items() if s.fitted and run.sample_count(n)}
    tried = replace(run, start=replace(run.start, periods=most))
    begins = initial_state(simulator, data, tried, own)
    period = (float(run.time[0]) - start_time(tried)) / most
    times = start_time(tried) + period * np.arange(most + 1)
    course = simulator.run(
        times, parameters={**own, **begins.values}, inputs=inputs_of_run(tried), outputs=list(signals),
        start_time=start_time(tried), settle=begins.settle,
    )  # fmt: skip
    off = np.max([np.abs(course[n] - course[n][-1]) / sigma for n, sigma in signals.items()], axis=0)
    there = np.flatnonzero(off > CRITERIA.starts.round)
    count = max(int(there[-1]) + 1 if there.size else 0, 1)
    said = f"{run.name} is periodic: {count} periods of {format_quantity(period, 's', 4)} are simulated before it"
    reason = f"{said}, and it has not come round by then" if count >= most else said
    return replace(run, start=replace(run.start, periods=count, reason=reason, chosen=True))


def _first(
    simulator: AnySimulator,
    data: DataSet,
    run: Run,
    own: Mapping[str, float],
    common: Mapping[str, float],
    every: bool = False,
) -> list[_First]:
    """Signals that show a state, or all that are fitted where none does, beside the model that begins by itself.

    None where all agree with it, unless ``every`` is wanted; ``common`` are the offsets of most runs.
    """
    probe = StartProbe(simulator, data, run, own)
    when = {name: _first_time(run, name) for name in probe.signals}
    times = np.unique(list(when.values()))
    if not times.size:
        return []
    course = probe.course(times, probe.signals)
    own_start = {n: float(course[n][np.searchsorted(times, when[n])]) for n in probe.signals}
    first = [_beside(data, run, n, model, common.get(n)) for n, model in own_start.items()]
    if not every and not any(one.off for one in first):
        return []
    shows = probe.showing()
    return [one for one in first if one.name in shows] or first


def _first_time(run: Run, name: str) -> float:
    times, values = run.start.leading.get(name, (run.time[:0], run.time[:0]))
    both = np.append(values, run.measurements[name])
    return float(np.append(times, run.time)[np.isfinite(both)][0])


def _beside(data: DataSet, run: Run, name: str, model: float, common: float | None) -> _First:
    signal = data.signals[name]
    noise = CRITERIA.starts.away * signal.sigma
    sample = first_of_run(run, name, signal.sigma)
    assert sample is not None
    values = np.concatenate([[model], *(r.measurements[name] for r in data.runs if name in r.measurements)])
    span = float(np.nanmax(values) - np.nanmin(values))
    offset = sample.value - model
    off = abs(offset) > noise
    is_large = abs(offset) > CRITERIA.recognition.offset * span
    differs = common is not None and abs(offset - common) > noise
    return _First(name, signal.unit, sample, model, off, off and (is_large or differs))


def _is_stated(simulator: AnySimulator, data: DataSet, run: Run, parameters: Mapping[str, float]) -> bool:
    """Whether parameters of the run are the start values of all states that its signals show, such as ``tank.p_start``.

    Such a parameter has the unit of its state, which begins higher by as much as the parameter is raised.
    """
    own = data.parameters_of(run, parameters)
    interface, states = simulator.interface, simulator.interface.states
    try:
        shown = set(measured_initial_state(simulator, data, run, own).shown)
        here = StartProbe(simulator, data, run, own).at({})[1]
        for name in run.parameters.keys() & interface.parameters.keys():
            step = CRITERIA.starts.step * max(abs(own[name]), abs(interface.parameters[name].nominal or 0.0), 1.0)
            there = StartProbe(simulator, data, run, {**own, name: own[name] + step}).at({})[1]
            moved = dict(zip(states, ((there - here) / step).tolist(), strict=True))
            unit = interface.parameters[name].unit
            shown -= {n for n in shown if interface.start_values[n].unit == unit and abs(moved[n] - 1.0) < _SAME}
    except SimulationFailure:
        return False
    return not shown


def _is_fitted(simulator: AnySimulator, data: DataSet, run: Run, own: Mapping[str, float]) -> bool:
    """Whether a free parameter says where the run begins."""
    for free in data.fit.values():
        if free.run and free.run != run.name:
            continue
        low, high = (
            StartProbe(simulator, data, run, {**own, free.parameter: value}).at({})[1] for value in (free.min, free.max)
        )
        size = np.maximum(np.maximum(np.abs(low), np.abs(high)), 1.0)
        if float(np.max(np.abs(high - low) / size, initial=0.0)) > CRITERIA.starts.own_parameter:
            return True
    return False


__all__ = ["starts_are_open", "with_starts"]
