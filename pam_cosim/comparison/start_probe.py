"""The model at the very start of a run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison.run_start import first_of_run, inputs_of_run, start_time
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import SimulationFailure
from pam_cosim.measurement import DataSet, FirstSamples, Run
from pam_cosim.simulation import AnySimulator, Settle, Trajectory

STEP = 1e-5  # of its size, by which a state is moved to see on which readings and rates it acts
_ELSEWHERE = 0.1  # of its size, by which states are moved off the own start to see the same
_CORRECTIONS = (
    4  # times that a first reading is brought into agreement with the state that it shows
)


@dataclass(frozen=True)
class ObservedState:
    """A state that a signal or a rate determines.

    Attributes:
        row: of the signals and rates, that determines it.
        aim: value of that row.
        spread: standard deviation of the aim; zero where it follows from another state.
        signal: that was measured.
        rate: of the state [its unit per second].
    """

    row: int
    aim: float
    spread: float
    signal: str
    rate: float


@dataclass(frozen=True)
class Dependences:
    """(signals + states, states): slopes of signals and rates by states, one after the other; 0: none at all."""

    matrix: Array

    def joined(self, other: Dependences) -> Dependences:
        """The later slopes, and the earlier ones where those have vanished."""
        return Dependences(np.where(other.matrix != 0.0, other.matrix, self.matrix))


class StartProbe:
    """Signals, rates and states of the model at the very start of a run, by start values of its states."""

    def __init__(
        self, simulator: AnySimulator, data: DataSet, run: Run, parameters: Mapping[str, float]
    ) -> None:
        self.simulator, self.data, self.run = simulator, data, run
        self.states, self.rates = simulator.interface.states, simulator.interface.rates
        fitted = [n for n, s in data.signals.items() if s.fitted and run.sample_count(n)]
        self.signals = [
            n for n in fitted if first_of_run(run, n, data.signals[n].sigma) is not None
        ]
        self._parameters = {n: v for n, v in parameters.items() if n not in self.states}
        self._start, self._inputs = start_time(run), inputs_of_run(run)

    def changed(self, parameters: Mapping[str, float]) -> StartProbe:
        """The same with other values of some parameters [SI]."""
        return StartProbe(self.simulator, self.data, self.run, {**self._parameters, **parameters})

    def first_samples(self) -> dict[str, FirstSamples]:
        """Of the signals that are fitted."""
        known = {
            name: first_of_run(self.run, name, self.data.signals[name].sigma)
            for name in self.signals
        }
        return {name: one for name, one in known.items() if one is not None}

    def at(self, values: Mapping[str, float], settle: Settle = "none") -> tuple[Array, Array]:
        """Signals and rates, and the states, right at the start.

        As if nothing were recorded early: what such a record shows first, the model comes to after its start.
        """
        names = [*self.signals, *self.rates, *self.states]
        in_time = dict.fromkeys(self.simulator.interface.record_delays, 0.0)
        trajectory = self.simulator.run(
            np.array([self._start]),
            parameters={**self._parameters, **values, **in_time},
            inputs=self._inputs,
            outputs=names,
            start_time=self._start,
            settle=settle,
        )
        row = np.array([trajectory[name][0] for name in names])
        count = len(names) - len(self.states)
        return row[:count], row[count:]

    def course(self, times: Array, names: Sequence[str]) -> Trajectory:
        """The run at some times as the model begins by itself."""
        return self.simulator.run(
            times,
            parameters=self._parameters,
            inputs=self._inputs,
            outputs=names,
            start_time=self._start,
        )

    def signals_of_one_state(self) -> list[str]:
        """The signals that depend on one state alone."""
        if not self.states:
            return []
        count = np.count_nonzero(self.dependences({}).matrix[: len(self.signals)], axis=1)
        return [name for name, n in zip(self.signals, count, strict=True) if n == 1]

    def dependences(self, values: Mapping[str, float]) -> Dependences:
        """About a state; by central differences, which are exactly zero where there is no dependence."""
        _, state = self.at(values)
        here = dict(zip(self.states, state.tolist(), strict=True))
        columns = []
        for name in self.states:
            step = STEP * self._size(name, here[name])
            above, below = (
                self.at({**here, name: here[name] + sign * step})[0] for sign in (1.0, -1.0)
            )
            columns.append((above - below) / (2.0 * step))
        return Dependences(np.column_stack(columns))

    def nearby_state(self) -> dict[str, float]:
        """A state near the model's own start at which nothing vanishes by chance, as a force does without pressure."""
        state = dict(zip(self.states, self.at({})[1].tolist(), strict=True))
        shifted = {n: v + _ELSEWHERE * self._size(n, v) for n, v in state.items()}
        try:
            self.at(shifted)
        except SimulationFailure:
            return state
        return shifted

    def _size(self, name: str, value: float) -> float:
        variable = self.simulator.interface.start_values[name]
        return max(abs(variable.nominal or 0.0), abs(value)) or 1.0

    def corrected(
        self,
        shown: Mapping[str, ObservedState],
        dependences: Dependences,
        values: Mapping[str, float],
    ) -> dict[str, float]:
        """Start values of the observed states at which the signals that determine them are as measured."""
        _, state = self.at({})
        starts = {name: values.get(name, state[self.states.index(name)]) for name in shown}
        rows = [one.row for one in shown.values()]
        aims = np.array([one.aim for one in shown.values()])
        slopes = dependences.matrix[np.ix_(rows, [self.states.index(name) for name in shown])]
        for _ in range(_CORRECTIONS if starts else 0):
            miss = aims - self.at(starts)[0][rows]
            step = np.linalg.lstsq(slopes, miss, rcond=None)[0]
            starts = {name: float(starts[name] + s) for name, s in zip(starts, step, strict=True)}
            sizes = np.array([self._size(n, v) for n, v in starts.items()])
            if np.all(np.abs(step) <= STEP * sizes):
                break
        return starts

    def unmatched_signals(
        self, shown: Mapping[str, ObservedState], values: Mapping[str, float]
    ) -> set[str]:
        """The signals that are not as they were measured, wherever the states that they show begin."""
        outputs, _ = self.at(values)
        known = [one for one in shown.values() if one.spread]
        return {
            one.signal
            for one in known
            if abs(outputs[one.row] - one.aim) > CRITERIA.starts.away * one.spread
        }

    def finds_rest(self, values: Mapping[str, float]) -> bool:
        """Whether the other states find a rest beside these."""
        if not self.simulator.settles:
            return False
        try:
            self.at(values, "others")
        except SimulationFailure:
            return False
        return True
