"""The state in which the simulation of a run begins, so that it agrees with the first samples.

A signal that depends on one state alone shows it: a pressure reading the pressure, a ruler the position. Where the rate
of such a state depends on one further state alone, the slope of the samples shows that: the speed, or what lies behind
the lag of an instrument. The others follow: they are at rest beside these, under the first inputs.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import SimulationFailure
from pam_cosim.measurement import DataSet, FirstSamples, Run, first_samples
from pam_cosim.simulation import AnySimulator, Inputs, Settle, Trajectory


@dataclass(frozen=True)
class InitialState:
    """How a simulation begins.

    Attributes:
        values: start values of states by name [SI].
        settle: which states come to rest first, as ``Simulator.run`` has it.
        shown: the signal that shows each of the states; of one that a rate shows, the signal of that.
    """

    values: dict[str, float] = field(default_factory=dict)
    settle: Settle = "none"
    shown: dict[str, str] = field(default_factory=dict)


def start_time(run: Run) -> float:
    """When the simulation of a run begins [s].

    A run that records inputs begins with its first row, or as long before as something is known of them. A run without
    inputs is a free course from the state at time zero, which the first sample may come after.
    """
    first = float(run.time[0])
    if run.start.periodic:
        return first - run.start.periods * _period(run)
    if run.start.seconds:
        return first - run.start.seconds
    return first if run.inputs or run.start.is_found else min(0.0, first)


def _period(run: Run) -> float:
    """Of a run that is one: the row that would follow the last is the first again."""
    return float(run.time[-1] - run.time[0] + np.median(np.diff(run.time)))


def inputs_of_run(run: Run) -> Inputs | None:
    """What drives the model, from the start of the simulation on."""
    start, time, values = run.start, run.time, run.inputs
    if start.seconds and values:
        # a step at the first row: what was before, and what the row says
        time = np.concatenate([[time[0] - start.seconds, time[0]], time])
        values = {
            n: np.concatenate([np.full(2, start.before.get(n, v[0])), v]) for n, v in values.items()
        }
    elif start.periodic and values:
        shifts = _period(run) * np.arange(-start.periods, 1)
        time = (shifts[:, None] + time).ravel()
        values = {n: np.tile(v, len(shifts)) for n, v in values.items()}
    return Inputs(time, values, run.interpolation) if values else None


def initial_state(
    simulator: AnySimulator, data: DataSet, run: Run, parameters: Mapping[str, float]
) -> InitialState:
    """How the simulation of a run begins.

    Args:
        simulator: the model.
        data: the data set the run belongs to.
        run: says in which state it begins.
        parameters: what it is simulated with [SI], start values among them.
    """
    if run.start.seconds:
        return InitialState(settle="all")
    given = [name for name in simulator.interface.states if name in parameters]
    if run.is_static or (run.start.mode in (None, "rest") and not run.start.periodic):
        return InitialState()
    if given:
        return InitialState(
            settle="none" if len(given) == len(simulator.interface.states) else "others"
        )
    found = measured_initial_state(simulator, data, run, parameters)
    return InitialState(found.values, "all", found.shown) if run.start.mode == "steady" else found


def measured_initial_state(
    simulator: AnySimulator, data: DataSet, run: Run, parameters: Mapping[str, float]
) -> InitialState:
    """The initial state at which the model gives the first samples; arguments as for ``initial_state``."""
    probe = StartProbe(simulator, data, run, parameters)
    first = probe.first_samples()
    if not simulator.interface.states or not first:
        return InitialState()
    dependences = probe.dependences({}).joined(probe.dependences(probe.nearby_state()))
    shown, values = _consistent_start(probe, dependences, first)
    unmatched = probe.unmatched_signals(
        shown, values
    )  # such as a reading at the end of its range, which shows nothing
    if unmatched:
        others = {signal: one for signal, one in first.items() if signal not in unmatched}
        shown, values = _consistent_start(probe, dependences, others)
    signals = {state: one.signal for state, one in shown.items()}
    settle: Settle = "others" if probe.finds_rest(values) else "none"
    return InitialState(values, settle, signals)


def _consistent_start(
    probe: StartProbe, dependences: _Dependences, first: Mapping[str, FirstSamples]
) -> tuple[dict[str, _ObservedState], dict[str, float]]:
    """What shows which states, and their start values, at which the model agrees with that."""
    shown: dict[str, _ObservedState] = {}
    values: dict[str, float] = {}
    for _ in range(2):  # what acts on what may not show where the model begins by itself
        shown = _observed_states(dependences, first, probe.signals, probe.states)
        values = probe.corrected(shown, dependences, values)
        dependences = dependences.joined(probe.dependences(values))
    return shown, values


@dataclass(frozen=True)
class _ObservedState:
    """What shows a state: row ``row`` of what is computed shall have a value; its slope there by the state."""

    row: int
    aim: float
    spread: float
    signal: str
    rate: float


@dataclass(frozen=True)
class _Dependences:
    """(signals + states, states): slopes of signals and rates by states, one after the other; 0: none at all."""

    matrix: Array

    def joined(self, other: _Dependences) -> _Dependences:
        """The later slopes, and the earlier ones where those have vanished."""
        return _Dependences(np.where(other.matrix != 0.0, other.matrix, self.matrix))


def _observed_states(
    dependences: _Dependences,
    first: Mapping[str, FirstSamples],
    signals: list[str],
    states: tuple[str, ...],
) -> dict[str, _ObservedState]:
    """By name of the state. Of two signals that show the same state, the one that shows it better."""
    matrix, shown = dependences.matrix, dict[str, _ObservedState]()
    better: dict[str, float] = {}
    for row, signal in enumerate(signals):
        dependent = np.flatnonzero(matrix[row])
        if len(dependent) != 1 or signal not in first:
            continue
        slope, sample = matrix[row, dependent[0]], first[signal]
        state, spread = states[dependent[0]], sample.sd / abs(slope)
        if state not in shown or spread < better[state]:
            better[state] = spread
            rate = sample.slope / slope if sample.moves else 0.0
            shown[state] = _ObservedState(row, sample.value, sample.sd, signal, rate)
    waiting = list(shown)
    while waiting:
        by = waiting.pop(0)
        i, known = states.index(by), shown[by]
        row = len(signals) + i
        others = [int(j) for j in np.flatnonzero(matrix[row]) if j != i]
        if len(others) == 1 and states[others[0]] not in shown:
            follows = -matrix[row, i] / matrix[row, others[0]]
            state = states[others[0]]
            shown[state] = _ObservedState(row, known.rate, 0.0, known.signal, known.rate * follows)
            waiting.append(state)
    return shown


def first_of_run(run: Run, signal: str, sigma: float) -> FirstSamples | None:
    """A signal at the first row of a run; None where it has no sample, or the first comes after a pause.

    Args:
        run: what was recorded.
        signal: its name.
        sigma: standard deviation of the noise [SI].
    """
    time, values = run.time, run.measurements[signal]
    if signal in run.start.leading:
        early, recorded = run.start.leading[signal]
        later = time >= run.time[0] + run.start.lead
        time, values = np.append(early, time[later]), np.append(recorded, values[later])
    return first_samples(time, values, sigma, float(run.time[0]))


class StartProbe:
    """What the model gives at the very start of a run, for start values of its states."""

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

    def first_samples(self) -> dict[str, FirstSamples]:
        """Of the signals that are fitted."""
        known = {
            name: first_of_run(self.run, name, self.data.signals[name].sigma)
            for name in self.signals
        }
        return {name: one for name, one in known.items() if one is not None}

    def at(self, values: Mapping[str, float], settle: Settle = "none") -> tuple[Array, Array]:
        """Signals and rates, and the states, right at the start."""
        names = [*self.signals, *self.rates, *self.states]
        trajectory = self.simulator.run(
            np.array([self._start]),
            parameters={**self._parameters, **values},
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
        count = (
            np.count_nonzero(self.dependences({}).matrix[: len(self.signals)], axis=1)
            if self.states
            else ()
        )
        return [name for name, n in zip(self.signals, count, strict=False) if n == 1]

    def dependences(self, values: Mapping[str, float]) -> _Dependences:
        """About a state; by central differences, which are exactly zero where there is no dependence."""
        _, state = self.at(values)
        here = dict(zip(self.states, state.tolist(), strict=True))
        columns = []
        for name in self.states:
            step = CRITERIA.starts.step * self._size(name, here[name])
            above, below = (
                self.at({**here, name: here[name] + sign * step})[0] for sign in (1.0, -1.0)
            )
            columns.append((above - below) / (2.0 * step))
        return _Dependences(np.column_stack(columns))

    def nearby_state(self) -> dict[str, float]:
        """A state near the model's own start at which nothing vanishes by chance, as a force does without pressure."""
        state = dict(zip(self.states, self.at({})[1].tolist(), strict=True))
        shifted = {n: v + CRITERIA.starts.elsewhere * self._size(n, v) for n, v in state.items()}
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
        shown: Mapping[str, _ObservedState],
        dependences: _Dependences,
        values: Mapping[str, float],
    ) -> dict[str, float]:
        """Start values of the states that are shown, at which what shows them is as it was measured."""
        _, state = self.at({})
        starts = {name: values.get(name, state[self.states.index(name)]) for name in shown}
        rows = [one.row for one in shown.values()]
        aims = np.array([one.aim for one in shown.values()])
        slopes = dependences.matrix[np.ix_(rows, [self.states.index(name) for name in shown])]
        for _ in range(CRITERIA.starts.corrections if starts else 0):
            miss = aims - self.at(starts)[0][rows]
            step = np.linalg.lstsq(slopes, miss, rcond=None)[0]
            starts = {name: float(starts[name] + s) for name, s in zip(starts, step, strict=True)}
            if np.all(
                np.abs(step)
                <= CRITERIA.starts.step * np.array([self._size(n, v) for n, v in starts.items()])
            ):
                break
        return starts

    def unmatched_signals(
        self, shown: Mapping[str, _ObservedState], values: Mapping[str, float]
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


__all__ = [
    "InitialState",
    "StartProbe",
    "first_of_run",
    "initial_state",
    "inputs_of_run",
    "measured_initial_state",
    "start_time",
]
