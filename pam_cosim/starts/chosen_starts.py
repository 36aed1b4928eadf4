"""The start of runs that state none: the model's own, where first samples agree with it, else an estimated one."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from math import log

import numpy as np

from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import SimulationFailure
from pam_cosim.measurement import DataSet, FreeParameter, Run, StartMode
from pam_cosim.simulation import AnySimulator
from pam_cosim.starts.initial_state import initial_state, measured_initial_state
from pam_cosim.starts.probe import STEP, StartProbe
from pam_cosim.starts.run_start import (
    FirstSamples,
    InitialState,
    first_of_run,
    measured_signals,
    start_time,
)
from pam_cosim.units import format_quantity

_SAME_SLOPE = 1e-6  # difference of slopes, up to which a state is what a parameter sets
_SHARE_OF_RANGE = 1e-3  # by which a free parameter is moved to see what depends on it


@dataclass(frozen=True)
class FirstOffset:
    """A signal at its first sample, compared with the model that begins by itself.

    Attributes:
        name: of the signal.
        unit: of all numbers.
        sample: the first sample, with its noise.
        later: the first instant by the samples after it; None: there are none.
        model: the model's value there.
        noise: the largest offset that noise makes.
        span: range of the signal over all runs and the model's first value.
    """

    name: str
    unit: str
    sample: FirstSamples
    later: FirstSamples | None
    model: float
    noise: float
    span: float

    @property
    def offset(self) -> float:
        """The first sample less the model's value."""
        return self.sample.value - self.model

    @property
    def exceeds_noise(self) -> bool:
        """Whether the offset is more than noise makes, and more than one slip: the samples after it show it too."""
        also = self.later is None or abs(self.later.value - self.model) > self.noise
        return also and abs(self.offset) > self.noise

    def exceeds_instrument(self, common: float | None) -> bool:
        """Whether neither noise nor an instrument's offset explains it, which is small and the same in all runs.

        Args:
            common: the offset of most runs; None where too few are known.
        """
        if not self.exceeds_noise:
            return False
        is_large = abs(self.offset) > CRITERIA.starts.offset * self.span
        return is_large or (common is not None and abs(self.offset - common) > self.noise)

    def text(self, value: float) -> str:
        """A value of the signal with its unit."""
        return format_quantity(value, self.unit, 3)


def first_offsets(probe: StartProbe) -> list[FirstOffset]:
    """Offsets of the signals that depend on one state alone; without such a signal, of all fitted signals.

    Raises:
        SimulationFailure: the run cannot be simulated.
    """
    if not probe.signals:
        return []
    when = {name: _first_time(probe.run, name) for name in probe.signals}
    times = np.unique(list(when.values()))
    simulated = probe.trajectory(times)
    offsets = [
        _offset(probe, name, float(simulated[name][np.searchsorted(times, time)]))
        for name, time in when.items()
    ]
    showing = probe.signals_of_one_state()
    return [offset for offset in offsets if offset.name in showing] or offsets


def _first_time(run: Run, name: str) -> float:
    times, values = run.start.leading.get(name, (run.time[:0], run.time[:0]))
    all_values = np.append(values, run.measurements[name])
    return float(np.append(times, run.time)[np.isfinite(all_values)][0])


def _offset(probe: StartProbe, name: str, model: float) -> FirstOffset:
    signal = probe.data.signals[name]
    runs = (r.measurements[name] for r in probe.data.runs if name in r.measurements)
    values = np.concatenate([[model], *runs])
    return FirstOffset(
        name,
        signal.unit,
        probe.first[name],
        first_of_run(probe.run, name, signal.sigma, skipped=1),
        model,
        CRITERIA.starts.away * signal.sigma,
        float(np.nanmax(values) - np.nanmin(values)),
    )


def starts_are_open(data: DataSet) -> bool:
    """Whether it is to be chosen how some run begins."""
    return any(map(_is_open, data.runs))


def _is_open(run: Run) -> bool:
    if run.is_static:
        return False
    return not run.start.periods if run.start.periodic else run.start.mode is None


def _begun(run: Run, mode: StartMode, reason: str = "") -> Run:
    return replace(run, start=replace(run.start, mode=mode, reason=reason, chosen=True))


class StartChoice:
    """Chooses the starts of the runs of one data set, by one model with its parameters.

    Args:
        simulator: the model.
        data: the measurement with its noise.
        parameters: values to simulate with [SI].
        estimate_pays: whether estimated starts of some runs explain much of the residuals, which an offset of each
            instrument does not.

    Raises:
        InputError: a parameter that the model does not have.
    """

    def __init__(
        self,
        simulator: AnySimulator,
        data: DataSet,
        parameters: Mapping[str, float],
        estimate_pays: Callable[[Sequence[Run]], bool],
    ) -> None:
        self._data, self._estimate_pays = data, estimate_pays
        self._probes = {
            run.name: StartProbe(simulator, data, run, data.parameters_of(run, parameters))
            for run in data.runs
            if not run.is_static
        }
        self._offsets = {run.name: self._first_offsets(run) for run in data.runs}
        self._common = self._common_offsets()

    def completed(self) -> DataSet:
        """The data set where every run states how it begins."""
        runs = [self._by_itself(run) if _is_open(run) else run for run in self._data.runs]
        undecided = [run for run in runs if _is_open(run)]
        if any(run.start.mode == "estimated" for run in runs):
            runs = [self._as_others(run) for run in runs]
        elif undecided and self._estimate_pays(undecided):
            much_less = partial(self._estimated, reason="which leaves much less")
            runs = [much_less(run) if _is_open(run) else run for run in runs]
        runs = [_begun(run, "rest") if _is_open(run) else run for run in runs]
        return replace(self._data, runs=tuple(runs))

    def _first_offsets(self, run: Run) -> list[FirstOffset] | None:
        """None where the run cannot be simulated, and the next simulation reports the reason."""
        if run.is_static or run.start.periodic:
            return []
        try:
            return first_offsets(self._probes[run.name])
        except SimulationFailure:
            return None

    def _common_offsets(self) -> dict[str, float]:
        """By signal: how far first samples are off the model's start in most runs, as by an instrument's offset."""
        offsets: dict[str, list[float]] = {}
        chosen = [run.name for run in self._data.runs if not run.start.seconds]
        for first_offset in (
            first_offset for name in chosen for first_offset in self._offsets[name] or []
        ):
            offsets.setdefault(first_offset.name, []).append(first_offset.offset)
        fewest = CRITERIA.starts.runs
        return {name: float(np.median(v)) for name, v in offsets.items() if len(v) >= fewest}

    def _by_itself(self, run: Run) -> Run:
        """The run with its start; unchanged where its first samples alone do not decide it."""
        try:
            if run.start.periodic:
                return _with_periods(self._probes[run.name])
            return self._by_first_samples(run)
        except SimulationFailure:
            return _begun(run, "rest")

    def _by_first_samples(self, run: Run) -> Run:
        offsets, probe = self._offsets[run.name] or [], self._probes[run.name]
        differing = [offset for offset in offsets if offset.exceeds_noise]
        if not differing or _start_is_fitted(probe):
            return _begun(run, "rest")
        start = measured_initial_state(probe)
        is_elsewhere = any(
            offset.exceeds_instrument(self._common.get(offset.name)) for offset in offsets
        )
        if start.shown and not is_elsewhere:
            return run
        if start.shown and not _explains(probe, start):
            return _begun(run, "rest")
        moving = any(offset.sample.moves for offset in offsets)
        begins = f"{_first_samples_text(run, offsets)}, {'moving' if moving else 'at rest'}"
        if start.shown:
            return _begun(run, "estimated", f"{begins}: estimated")
        differences = ", ".join(
            f"{offset.name} = {offset.text(offset.model)}" for offset in differing
        )
        hint = "no start value of a state can be set: free a parameter that moves it"
        reason = f"{begins}: the model begins at {differences}, and {hint}"
        return _begun(run, "rest", reason)

    def _as_others(self, run: Run) -> Run:
        """A run of a recording that begins in the middle: one that agrees with rest may move all the same."""
        agrees = run.start.chosen and run.start.mode == "rest" and not run.start.reason
        if run.is_static or run.start.periodic or not (agrees or _is_open(run)):
            return run
        return self._estimated(run, "as others are", unless_stated=agrees)

    def _estimated(self, run: Run, reason: str, unless_stated: bool = False) -> Run:
        """The run with an estimated start, where it can have one."""
        offsets, probe = self._offsets[run.name], self._probes[run.name]
        if offsets is None:
            return run
        try:
            observed_states = measured_initial_state(probe).shown
            if not observed_states or (unless_stated and _start_is_stated(probe, observed_states)):
                return run
            if _start_is_fitted(probe):
                return run
        except SimulationFailure:
            return run
        return _begun(run, "estimated", f"{_first_samples_text(run, offsets)}: estimated, {reason}")


def _explains(probe: StartProbe, start: InitialState) -> bool:
    """Whether the signals are much nearer to their first samples from there: a missing force would remain.

    By their orders of magnitude: a temperature that the model cannot meet anyway does not outweigh a pressure.
    """
    aims = np.array([sample.value for sample in probe.first.values()])
    noise = np.array([probe.data.signals[name].sigma for name in probe.signals])

    def misfit(begin: InitialState) -> float:
        signals = probe.at(begin.values, begin.settle)[0][: len(aims)]
        return float(np.sum(np.log1p(((signals - aims) / noise) ** 2)))

    return misfit(InitialState()) - misfit(start) > log(CRITERIA.starts.worth)


def _first_samples_text(run: Run, offsets: Sequence[FirstOffset]) -> str:
    return (
        f"{run.name} begins at {', '.join(offset.text(offset.sample.value) for offset in offsets)}"
    )


def _start_is_stated(probe: StartProbe, observed_states: Collection[str]) -> bool:
    """Whether parameters of the run are the start values of all these states, as ``tank.p_start``.

    Such a parameter has the unit of its state, which begins higher by as much as the parameter is raised.

    Raises:
        SimulationFailure: the model breaks down at the start.
    """
    interface = probe.simulator.interface
    states, missing = probe.at({})[1], set(observed_states)
    for name in probe.run.parameters.keys() & interface.parameters.keys():
        parameter, value = interface.parameters[name], probe.parameters[name]
        step = STEP * max(abs(value), abs(parameter.nominal or 0.0), 1.0)
        slopes = (probe.changed({name: value + step}).at({})[1] - states) / step
        follows = np.abs(slopes - 1.0) < _SAME_SLOPE
        following = {interface.states[i] for i in np.flatnonzero(follows)}
        missing -= {s for s in following if interface.start_values[s].unit == parameter.unit}
    return not missing


def _start_is_fitted(probe: StartProbe) -> bool:
    """Whether one of the free parameters of the data set is where the run begins.

    Raises:
        SimulationFailure: the model breaks down at the start.
    """
    free = [
        parameter for parameter in probe.data.fit.values() if parameter.run in ("", probe.run.name)
    ]
    return any(_sets_start(probe, parameter) for parameter in free)


def _sets_start(probe: StartProbe, free: FreeParameter) -> bool:
    """Whether a parameter moves the start, and is a start value: by its name, or since nothing else depends on it.

    A load moves the start too, of a model that begins at rest under it, but a recording begins where it does.
    Without states that could be set, whatever moves the first values does so in place of a start.
    """
    name, step = free.parameter, _SHARE_OF_RANGE * (free.max - free.min)
    declared = probe.simulator.interface.parameters.get(name)
    if declared is None:  # as the fit reports
        return False
    value = probe.parameters.get(name, declared.start or 0.0)
    changed_probe = probe.changed(
        {name: value + step if value + step <= free.max else value - step}
    )
    has_states = bool(probe.states)
    if np.array_equal(probe.at({})[has_states], changed_probe.at({})[has_states]):
        return False
    if not has_states or name.endswith((".start", "_start")):
        return True
    nearby = probe.nearby_state()
    return np.array_equal(probe.at(nearby)[0], changed_probe.at(nearby)[0])


def _with_periods(probe: StartProbe) -> Run:
    """A periodic run with so many periods before it that one more would change no measured signal.

    Raises:
        SimulationFailure: the run does not reach its end.
    """
    run, data, most = probe.run, probe.data, CRITERIA.starts.periods
    signals = measured_signals(run, data)
    longest = replace(run, start=replace(run.start, periods=most))
    begin = initial_state(probe.simulator, data, longest, probe.parameters)
    begin_of_longest = start_time(longest)
    period = (float(run.time[0]) - begin_of_longest) / most
    times = begin_of_longest + period * np.arange(most + 1)
    simulated = begin.trajectory(probe.simulator, longest, probe.parameters, times, signals)
    from_last = [np.abs(simulated[n] - simulated[n][-1]) / data.signals[n].sigma for n in signals]
    differing = np.flatnonzero(np.max(from_last, axis=0, initial=0.0) > CRITERIA.starts.round)
    count = max(int(differing[-1]) + 1 if differing.size else 0, 1)
    length = format_quantity(period, "s", 4)
    reason = f"{run.name} is periodic: {count} periods of {length} are simulated before it"
    if count >= most:
        reason += ", and it is not periodic by then"
    return replace(run, start=replace(run.start, periods=count, reason=reason, chosen=True))
