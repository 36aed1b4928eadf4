"""When commands stepped that stand between two samples, as the measured signals tell beside a model.

A model to which each step comes at another time within its interval moves the signals, to first order, by the slopes of
its outputs with respect to these times. The times and the free parameters that leave least are a bounded linear least
squares problem; with the times put into the data the model is fitted again.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.catalogue import Composition
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.search.trial import every_parameter
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.fitting import Fit, FitOptions, Free, bounded_least_squares, fit
from pam_cosim.fitting.objective import DIFFERENCE_TOLERANCE, Objective
from pam_cosim.fmu import build_source
from pam_cosim.measurement import DataSet, Run, between_samples, with_step_times
from pam_cosim.model.references import parameter_of
from pam_cosim.simulation import Simulator

_ROUNDS = 2  # the second from where the first one ended
_INSIDE = 1e-3  # of an interval, that a step keeps from the samples at its ends


@dataclass(frozen=True)
class Retiming:
    """A fitted model beside which the steps are to find their times.

    Attributes:
        effects: that the model has. composition: its text.
        data: the measurement, with noise levels.
        fit: of the model.
        files: further Modelica files. library: ``compiler.library_hash()``.
    """

    effects: tuple[str, ...]
    composition: Composition
    data: DataSet
    fit: Fit
    files: tuple[Path, ...] = ()
    library: str = ""


@dataclass(frozen=True)
class Retimed:
    """What came of it.

    Attributes:
        effects: that the model has.
        steps: how many steps found a time.
        data: the measurement with the times. fit: of the model to these.
    """

    effects: tuple[str, ...]
    steps: int
    data: DataSet
    fit: Fit


def steps_between(data: DataSet) -> int:
    """How many commands step between two samples, all runs together."""
    return sum(len(between_samples(run)) for run in data.runs)


def nothing_found(task: Retiming) -> Retimed | None:
    """The result where a model cannot be simulated."""
    return None


def run_retiming(task: Retiming) -> Retimed | None:
    """Finds the times beside the model, fits it with them, and both once more.

    None where they do less, in the first run, than a further effect has to, or the model cannot be simulated.
    """
    names = tuple(
        dict.fromkeys([*map(parameter_of, task.fit.parameters), *task.data.differentiated])
    )
    text, name = task.composition.text, task.composition.name
    try:
        source = build_source(
            name, text, task.files, sensitivities=names, library=task.library, lean=True
        )
        with Simulator(source) as simulator:
            return _retimed(task, simulator)
    except (SimulationFailure, InputError):
        return nothing_found(task)


def _retimed(task: Retiming, simulator: Simulator) -> Retimed | None:
    numbers, best = CRITERIA.search, task.fit
    free = every_parameter(task.data, task.composition, simulator.interface)
    step_times = _StepTimes(simulator, task.data, best.values)
    start = _starting_at_fit(free, best)
    if not step_times.explains_enough(start):
        return None
    options = FitOptions(
        evaluations=numbers.screening_evaluations,
        screened_starts=0,
        precision=numbers.precision,
        rules=False,
        holdout_uncertainty=True,
    )
    for _ in range(_ROUNDS):
        start = step_times.updated(start)
        best = fit(simulator, step_times.data, start, options=options)
        start = _starting_at_fit(free, best)
    return Retimed(task.effects, step_times.steps, step_times.data, best)


def _starting_at_fit(free: Sequence[Free], fit: Fit) -> list[Free]:
    return [f.starting_at(fit.values.get(f.name, f.start)) for f in free]


class _StepTimes:
    """A data set whose steps come at times that can be moved within their intervals."""

    def __init__(self, simulator: Simulator, data: DataSet, values: Mapping[str, float]) -> None:
        self._simulator, self._values, self._recorded = simulator, values, data
        self._rows = [between_samples(run) for run in data.runs]
        self._low = [run.time[rows] for run, rows in zip(data.runs, self._rows, strict=True)]
        self._high = [run.time[rows + 1] for run, rows in zip(data.runs, self._rows, strict=True)]
        self._times = [(low + high) / 2 for low, high in zip(self._low, self._high, strict=True)]
        self.steps = sum(map(len, self._rows))
        self.data = self._with(self._times)
        self._slopes: dict[int, Array] = {}

    def _with(self, times: Sequence[Array]) -> DataSet:
        moved = zip(self._recorded.runs, self._rows, times, strict=True)
        return replace(
            self._recorded, runs=tuple(with_step_times(run, rows, t) for run, rows, t in moved)
        )

    def _slopes_of(self, i: int) -> Array:
        """(samples, steps) of a run's samples by the times of its steps, in noise standard deviations a second.

        About the middles of the intervals and the values that all began with.
        """
        if i not in self._slopes:
            times = (self._low[i] + self._high[i]) / 2
            before = self._residual(i, times)
            columns = [np.zeros((len(before), 0))]
            for k, shift in enumerate((self._high[i] - times) / 2):
                moved = times.copy()
                moved[k] += shift
                columns.append(((before - self._residual(i, moved)) / shift)[:, None])
            self._slopes[i] = np.column_stack(columns)
        return self._slopes[i]

    def _residual(self, i: int, times: Array) -> Array:
        """Samples minus model of a run that steps at these times, in noise standard deviations."""
        run = with_step_times(self._recorded.runs[i], self._rows[i], times)
        objective = self._objective([run], (), self._values)
        return _finite(objective, objective.plain_residuals(np.zeros(0)))[: objective.size]

    def _objective(
        self, runs: Sequence[Run], free: Sequence[Free], fixed: Mapping[str, float] | None = None
    ) -> Objective:
        return Objective(self._simulator, self.data, runs, free, fixed, DIFFERENCE_TOLERANCE)

    @staticmethod
    def _about(objective: Objective) -> tuple[Array, Array, tuple[Array, Array]]:
        """Samples minus model, the model's slopes by the parameters where they start, and how far these can go."""
        z = np.array([f.to_z(f.start) for f in objective.free])
        residual = _finite(objective, objective.residuals(z))
        low, high = objective.bounds
        slopes = -objective.jacobian(z, residual)
        return residual[: objective.size], slopes[: objective.size], (low - z, high - z)

    def explains_enough(self, free: Sequence[Free]) -> bool:
        """Whether times of its steps take from the first fitted run that has any as much as an effect has to."""
        fitted = (
            i for i, run in enumerate(self.data.runs) if run.role == "fit" and len(self._rows[i])
        )
        first = next(fitted, None)
        if first is None:
            return False
        residual, slopes, room = self._about(self._objective([self.data.runs[first]], free))
        change, times = self._solve([first], [slopes], [residual], room)
        left = (
            residual
            - slopes @ change
            - self._slopes_of(first) @ (times[first] - self._times[first])
        )
        excess = float(residual @ residual) - len(residual)
        return float(left @ left) - len(left) < CRITERIA.search.step * excess

    def updated(self, free: Sequence[Free]) -> list[Free]:
        """Moves the steps to where they and the free parameters leave least of the samples, to first order.

        Returns the parameters, to start from where they are then.
        """
        objective = self._objective(self.data.runs, free)
        residual, slopes, room = self._about(objective)
        parts = [slice(a, b) for a, b in itertools.pairwise(objective.ends)]
        fitted = [i for i, run in enumerate(self.data.runs) if run.role == "fit"]
        rows, residuals = [slopes[parts[i]] for i in fitted], [residual[parts[i]] for i in fitted]
        change, times = self._solve(fitted, rows, residuals, room)
        nothing = np.zeros(0)
        for i, part in enumerate(parts):
            if i not in times and len(
                self._rows[i]
            ):  # a held-out run finds its own times beside these parameters
                left = residual[part] - slopes[part] @ change
                _, of_run = self._solve([i], [slopes[part][:, :0]], [left], (nothing, nothing))
                times |= of_run
        self._times = [times.get(i, t) for i, t in enumerate(self._times)]
        self.data = self._with(self._times)
        return [
            f.starting_at(f.to_value(f.to_z(f.start) + float(c)))
            for f, c in zip(free, change, strict=True)
        ]

    def _solve(
        self,
        runs: Sequence[int],
        rows: Sequence[Array],
        left: Sequence[Array],
        room: tuple[Array, Array],
    ) -> tuple[Array, dict[int, Array]]:
        """The change of the parameters and the times of the steps of some runs that leave least, all within bounds."""
        parameters = rows[0].shape[1]
        first_time = parameters + np.cumsum([0, *(len(self._rows[i]) for i in runs)])
        matrix = np.zeros((sum(map(len, left)), first_time[-1]))
        ends = np.cumsum([0, *map(len, left)])
        for n, i in enumerate(runs):
            of_run = slice(ends[n], ends[n + 1])
            matrix[of_run, :parameters] = rows[n]
            matrix[of_run, first_time[n] : first_time[n + 1]] = self._slopes_of(i)
        earliest, latest = self._limits_of_times(runs)
        now = np.concatenate([np.zeros(0), *(self._times[i] for i in runs)])
        low = np.minimum(np.concatenate([room[0], earliest - now]), 0.0)
        high = np.maximum(np.concatenate([room[1], latest - now]), 0.0)
        step = bounded_least_squares(matrix, np.concatenate(left), low, high)
        times = step[parameters:] + now
        parts = np.split(times, first_time[1:-1] - parameters)
        return step[:parameters], dict(zip(runs, parts, strict=True))

    def _limits_of_times(self, runs: Sequence[int]) -> tuple[Array, Array]:
        """Between which each step of some runs can come [s]: inside its interval, off the samples at its ends."""
        low = np.concatenate([self._low[i] for i in runs])
        high = np.concatenate([self._high[i] for i in runs])
        margin = _INSIDE * (high - low)
        return low + margin, high - margin


def _finite(objective: Objective, residual: Array) -> Array:
    if not np.all(np.isfinite(residual)):
        raise SimulationFailure(objective.first_failure)
    return residual
