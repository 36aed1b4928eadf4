"""The start of runs that state none: the model's own, where first samples agree with it, else an estimated one."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison.initial_state import InitialState, measured_initial_state
from pam_cosim.comparison.start_probe import StartProbe
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting.first_offsets import FirstOffset, first_offsets
from pam_cosim.fitting.free import base_parameters
from pam_cosim.fitting.linear import Linear, bounded_step, linearised, reduction_by, rows_of_series
from pam_cosim.fitting.objective import Objective
from pam_cosim.fitting.periods import with_periods
from pam_cosim.fitting.start_parameters import start_is_fitted, start_is_stated
from pam_cosim.measurement import DataSet, Run, StartMode
from pam_cosim.simulation import AnySimulator

_MODES: tuple[StartMode, ...] = ("rest", "estimated")


def with_starts(
    simulator: AnySimulator, data: DataSet, parameters: Mapping[str, float] | None = None
) -> DataSet:
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
    return _Choice(simulator, data, parameters or {}).completed()


def starts_are_open(data: DataSet) -> bool:
    """Whether it is to be chosen how some run begins."""
    return any(map(_is_open, data.runs))


def _is_open(run: Run) -> bool:
    if run.is_static:
        return False
    return not run.start.periods if run.start.periodic else run.start.mode is None


def _begun(run: Run, mode: StartMode, reason: str = "") -> Run:
    return replace(run, start=replace(run.start, mode=mode, reason=reason, chosen=True))


class _Choice:
    """Chooses the starts of the runs of one data set, by one model with its parameters."""

    def __init__(
        self, simulator: AnySimulator, data: DataSet, parameters: Mapping[str, float]
    ) -> None:
        self._simulator, self._data = simulator, data
        self._parameters = {run.name: data.parameters_of(run, parameters) for run in data.runs}
        self._stated = parameters
        self._offsets = {run.name: self._first_offsets(run) for run in data.runs}
        self._common = self._common_offsets()

    def completed(self) -> DataSet:
        """The data set where every run says how it begins."""
        runs = [self._by_itself(run) if _is_open(run) else run for run in self._data.runs]
        undecided = [run for run in runs if _is_open(run)]
        if any(run.start.mode == "estimated" for run in runs):
            runs = [self._as_others(run) for run in runs]
        elif undecided and self._leaves_less(undecided):
            runs = [
                self._estimated(run, "which leaves much less") if _is_open(run) else run
                for run in runs
            ]
        return replace(
            self._data, runs=tuple(_begun(run, "rest") if _is_open(run) else run for run in runs)
        )

    def _first_offsets(self, run: Run) -> list[FirstOffset] | None:
        """None where the run cannot be simulated, of which whoever simulates it next reports why."""
        if run.is_static or run.start.periodic:
            return []
        try:
            return first_offsets(self._simulator, self._data, run, self._parameters[run.name])
        except SimulationFailure:
            return None

    def _common_offsets(self) -> dict[str, float]:
        """By signal: how far first samples are off the model's start in most runs, as by an instrument's offset."""
        offsets: dict[str, list[float]] = {}
        for run in self._data.runs:
            if run.start.seconds:
                continue
            for first in self._offsets[run.name] or []:
                offsets.setdefault(first.name, []).append(first.offset)
        fewest = CRITERIA.starts.runs
        return {
            name: float(np.median(values))
            for name, values in offsets.items()
            if len(values) >= fewest
        }

    def _by_itself(self, run: Run) -> Run:
        """The run with its start; unchanged where its first samples alone do not decide it."""
        try:
            if run.start.periodic:
                parameters = self._parameters[run.name]
                return with_periods(self._simulator, self._data, run, parameters)
            return self._by_first_samples(run)
        except SimulationFailure:
            return _begun(run, "rest")

    def _by_first_samples(self, run: Run) -> Run:
        first = self._offsets[run.name] or []
        differing = [one for one in first if one.exceeds_noise]
        if not differing or start_is_fitted(self._probe(run), self._data.fit.values()):
            return _begun(run, "rest")
        start = self._measured(run)
        if start.shown and not any(
            one.exceeds_instrument(self._common.get(one.name)) for one in first
        ):
            return run
        if start.shown and not self._explains(run, start):
            return _begun(run, "rest")
        moving = any(one.sample.moves for one in first)
        begins = f"{_first_samples_text(run, first)}, {'moving' if moving else 'at rest'}"
        if not start.shown:
            where = ", ".join(f"{one.name} = {one.model_text()}" for one in differing)
            return _begun(
                run, "rest", f"{begins}: the model begins at {where}, and cannot begin elsewhere"
            )
        return _begun(run, "estimated", f"{begins}: estimated")

    def _measured(self, run: Run) -> InitialState:
        return measured_initial_state(self._simulator, self._data, run, self._parameters[run.name])

    def _explains(self, run: Run, start: InitialState) -> bool:
        """Whether all signals are much nearer to their first samples from there: a missing force would remain."""
        probe = self._probe(run)
        samples = probe.first_samples()
        aims = np.array([samples[name].value for name in probe.signals])
        noise = np.array([self._data.signals[name].sigma for name in probe.signals])

        def squares(begin: InitialState) -> float:
            signals = probe.at(begin.values, begin.settle)[0][: len(aims)]
            return float(np.sum(((signals - aims) / noise) ** 2))

        return squares(InitialState()) > CRITERIA.starts.worth * squares(start)

    def _probe(self, run: Run) -> StartProbe:
        return StartProbe(self._simulator, self._data, run, self._parameters[run.name])

    def _as_others(self, run: Run) -> Run:
        """A run of a recording that begins in the middle: one that agrees with rest may move all the same."""
        agrees = run.start.chosen and run.start.mode == "rest" and not run.start.reason
        if run.is_static or run.start.periodic or not (agrees or _is_open(run)):
            return run
        if agrees and self._start_is_stated(run):
            return run
        return self._estimated(run, "as others are")

    def _estimated(self, run: Run, reason: str) -> Run:
        """The run with an estimated start, where it can have one."""
        first = self._offsets[run.name]
        if first is None:
            return run
        try:
            if (
                start_is_fitted(self._probe(run), self._data.fit.values())
                or not self._measured(run).shown
            ):
                return run
        except SimulationFailure:
            return run
        return _begun(run, "estimated", f"{_first_samples_text(run, first)}: estimated, {reason}")

    def _start_is_stated(self, run: Run) -> bool:
        """Whether the run's parameters are the start values of all states that its signals show."""
        try:
            shown = self._measured(run).shown
            return start_is_stated(self._probe(run), shown, self._parameters[run.name])
        except SimulationFailure:
            return False

    def _leaves_less(self, runs: Sequence[Run]) -> bool:
        """Whether estimated starts explain much of the residuals, which an offset of each instrument does not.

        Either beside the free parameters, to first order: these have not been fitted yet.
        """
        try:
            (resting, offsets), (estimated, _) = (self._linearised(runs, mode) for mode in _MODES)
        except SimulationFailure:
            return False
        return _remaining_squares(resting, offsets) > CRITERIA.starts.worth * _remaining_squares(
            estimated
        )

    def _linearised(self, runs: Sequence[Run], mode: StartMode) -> tuple[Linear, Array]:
        """About the start values of the free parameters, and the slopes by an offset of each signal."""
        begun = [replace(run, start=replace(run.start, mode=mode)) for run in runs]
        declared = base_parameters(self._data, self._simulator.interface)
        free = [one for one in declared if one.name not in self._stated]
        objective = Objective(self._simulator, self._data, begun, free, self._stated)
        linear = linearised(
            objective, np.array([one.to_z(one.start) for one in free]), _every_row(objective)
        )
        if linear is None:
            raise SimulationFailure(objective.first_failure)
        return linear, _offset_slopes(objective)


def _remaining_squares(linear: Linear, offsets: Array | None = None) -> float:
    """What the free parameters leave within their bounds, with offsets of the signals if these are given."""
    if offsets is not None:
        free = np.full(offsets.shape[1], np.inf)
        linear = replace(
            linear,
            names=(*linear.names, *(f"offset {i}" for i in range(len(free)))),
            values=np.append(linear.values, np.zeros(len(free))),
            low=np.append(linear.low, -free),
            high=np.append(linear.high, free),
            slopes=np.column_stack([linear.slopes, offsets]),
        )
    return float(linear.residual @ linear.residual) - reduction_by(linear, bounded_step(linear))


def _every_row(objective: Objective) -> int:
    """A row for each sample, also for those that are missing."""
    return sum(map(len, objective.kept))


def _offset_slopes(objective: Objective) -> Array:
    """(m, signals) ones at the samples of each signal: an offset that is the same in all runs."""
    signals = np.array([signal for _, signal in objective.series])[
        rows_of_series(objective, _every_row(objective))
    ]
    is_present = np.concatenate(objective.kept)
    return np.asarray((signals[:, None] == np.unique(signals)) & is_present[:, None], dtype=float)


def _first_samples_text(run: Run, first: Sequence[FirstOffset]) -> str:
    return f"{run.name} begins at {', '.join(one.sample_text() for one in first)}"


__all__ = ["starts_are_open", "with_starts"]
