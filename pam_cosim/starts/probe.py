"""The model at the very start of a run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import SimulationFailure
from pam_cosim.measurement import DataSet, Run
from pam_cosim.simulation import AnySimulator, Settle, Trajectory
from pam_cosim.starts.run_start import (
    FirstSamples,
    InitialState,
    first_of_run,
    measured_signals,
    start_time,
)

STEP = 1e-5  # of its size, by which a state is moved to see on which readings and rates it acts
_ELSEWHERE = 0.1  # of its size, by which states are moved off the own start to see the same
_CORRECTIONS = (
    4  # times that a first reading is brought into agreement with the state that it shows
)


class ObservedState(NamedTuple):
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


class StartProbe:
    """Signals, rates and states of the model at the very start of a run, by start values of its states.

    Args:
        simulator: the model.
        data: the data set the run belongs to.
        run: the run.
        parameters: of the run [SI]; start values of states among them are ignored.
    """

    def __init__(
        self, simulator: AnySimulator, data: DataSet, run: Run, parameters: Mapping[str, float]
    ) -> None:
        self.simulator, self.data, self.run, self.parameters = simulator, data, run, parameters
        self.states, self.rates = simulator.interface.states, simulator.interface.rates
        signals = measured_signals(run, data)
        samples = {n: first_of_run(run, n, data.signals[n].sigma) for n in signals}
        self.first: dict[str, FirstSamples] = {n: sample for n, sample in samples.items() if sample}
        self.signals = list(self.first)

    def changed(self, parameters: Mapping[str, float]) -> StartProbe:
        """The same with other values of some parameters [SI]."""
        return StartProbe(self.simulator, self.data, self.run, {**self.parameters, **parameters})

    def at(self, values: Mapping[str, float], settle: Settle = "none") -> tuple[Array, Array]:
        """Signals and rates, and the states, right at the start.

        As if nothing were recorded early: what such a record shows first, the model comes to after its start.
        """
        names = [*self.signals, *self.rates, *self.states]
        in_time = dict.fromkeys(self.simulator.interface.record_delays, 0.0)
        start = InitialState({**values, **in_time}, settle)
        trajectory = self._simulated(start, [start_time(self.run)], names)
        row = np.array([trajectory[name][0] for name in names])
        count = len(names) - len(self.states)
        return row[:count], row[count:]

    def trajectory(self, times: ArrayLike) -> Trajectory:
        """The signals at some times as the model begins by itself."""
        return self._simulated(InitialState(), times, self.signals)

    def _simulated(self, start: InitialState, times: ArrayLike, names: Sequence[str]) -> Trajectory:
        model_parameters = {n: v for n, v in self.parameters.items() if n not in self.states}
        return start.trajectory(self.simulator, self.run, model_parameters, times, names)

    def signals_of_one_state(self) -> list[str]:
        """The signals that depend on one state alone."""
        if not self.states:
            return []
        count = np.count_nonzero(self.dependences({})[: len(self.signals)], axis=1)
        return [name for name, n in zip(self.signals, count, strict=True) if n == 1]

    def dependences(self, values: Mapping[str, float]) -> Array:
        """(signals + states, states): slopes of signals and rates by states, about a state.

        By central differences, which are exactly zero where there is no dependence.
        """
        state = self.state(values)
        columns = []
        for name in self.states:
            step = STEP * self._size(name, state[name])
            above, below = (
                self.at({**state, name: state[name] + sign * step})[0] for sign in (1.0, -1.0)
            )
            columns.append((above - below) / (2.0 * step))
        return np.column_stack(columns)

    def state(self, values: Mapping[str, float]) -> dict[str, float]:
        """Where each state begins, with some start values given [SI]."""
        return dict(zip(self.states, self.at(values)[1].tolist(), strict=True))

    def nearby_state(self) -> dict[str, float]:
        """A state near the model's own start at which nothing vanishes by chance, as a force does without pressure."""
        state = self.state({})
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
        observed_states: Mapping[str, ObservedState],
        dependences: Array,
        values: Mapping[str, float],
    ) -> dict[str, float]:
        """Start values of the observed states at which the signals that determine them are as measured [SI].

        Args:
            observed_states: by state, the signal or rate that determines it.
            dependences: (signals + states, states) as of ``dependences``.
            values: initial guesses by state [SI].
        """
        begin = self.state({})
        starts = {name: values.get(name, begin[name]) for name in observed_states}
        rows = [observed.row for observed in observed_states.values()]
        aims = np.array([observed.aim for observed in observed_states.values()])
        slopes = dependences[np.ix_(rows, [self.states.index(name) for name in observed_states])]
        for _ in range(_CORRECTIONS if starts else 0):
            miss = aims - self.at(starts)[0][rows]
            step = np.linalg.lstsq(slopes, miss, rcond=None)[0]
            starts = {name: float(starts[name] + s) for name, s in zip(starts, step, strict=True)}
            sizes = np.array([self._size(n, v) for n, v in starts.items()])
            if np.all(np.abs(step) <= STEP * sizes):
                break
        return starts

    def unmatched_signals(
        self, observed_states: Mapping[str, ObservedState], values: Mapping[str, float]
    ) -> set[str]:
        """The signals that are not as they were measured, wherever the states that they show begin."""
        outputs, _ = self.at(values)
        return {
            observed.signal
            for observed in observed_states.values()
            if observed.spread
            and abs(outputs[observed.row] - observed.aim) > CRITERIA.starts.away * observed.spread
        }

    def settle_others(self, values: Mapping[str, float]) -> Settle:
        """Whether the other states come to rest with these: "others"; "none" where they find no rest."""
        try:
            if self.simulator.settles:
                self.at(values, "others")
                return "others"
        except SimulationFailure:
            pass
        return "none"
