"""The state in which the simulation of a run begins, so that it agrees with the first samples.

A signal that depends on one state alone shows it: a pressure reading the pressure, a ruler the position. Where the rate
of such a state depends on one further state alone, the slope of the samples shows that: the speed, or what lies behind
the lag of an instrument. Of an instrument it may depend on others that are shown: behind a thermometer lies the mass of
a gas whose pressure is known. What is left follows: it is at rest beside these, under the first inputs.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison.run_start import first_of_run, inputs_of_run, start_time
from pam_cosim.comparison.start_probe import Dependences, ObservedState, StartProbe
from pam_cosim.measurement import DataSet, FirstSamples, Run
from pam_cosim.simulation import AnySimulator, Settle


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
    return InitialState(values, _settling(probe, values), signals)


def initial_state_about(
    simulator: AnySimulator,
    data: DataSet,
    run: Run,
    parameters: Mapping[str, float],
    values: Mapping[str, float],
) -> InitialState:
    """The initial state with these values of some states [SI], of the others as the first samples show it.

    The other arguments are as for ``initial_state``.
    """
    if len(values) == len(simulator.interface.states):
        return InitialState(dict(values))
    found = measured_initial_state(simulator, data, run, parameters).values
    probe = StartProbe(simulator, data, run, parameters)
    known = {**found, **values}
    return InitialState(known, _settling(probe, known))


def _settling(probe: StartProbe, values: Mapping[str, float]) -> Settle:
    """The states without a value come to rest beside the others, where they find one."""
    return "others" if probe.finds_rest(values) else "none"


def _consistent_start(
    probe: StartProbe, dependences: Dependences, first: Mapping[str, FirstSamples]
) -> tuple[dict[str, ObservedState], dict[str, float]]:
    """What shows which states, and their start values, at which the model agrees with that."""
    shown: dict[str, ObservedState] = {}
    values: dict[str, float] = {}
    for _ in range(2):  # what acts on what may not show where the model begins by itself
        shown = _observed_states(dependences, first, probe.signals, probe.states)
        values = probe.corrected(shown, dependences, values)
        dependences = dependences.joined(probe.dependences(values))
    return shown, values


def _observed_states(
    dependences: Dependences,
    first: Mapping[str, FirstSamples],
    signals: list[str],
    states: tuple[str, ...],
) -> dict[str, ObservedState]:
    """By name of the state. Of two signals that show the same state, the one that shows it better."""
    matrix, shown = dependences.matrix, dict[str, ObservedState]()
    rates = matrix[len(signals) :]
    instruments = _states_of_instruments(rates)
    better: dict[str, float] = {}

    def unknown(state: str) -> list[int]:
        """The states on which the rate of one depends, and that nothing shows so far."""
        return [
            int(j) for j in np.flatnonzero(rates[states.index(state)]) if states[j] not in shown
        ]

    def shows(state: str) -> bool:
        """Whether the rate of a state shows another one: the only other one, or of an instrument the only unknown."""
        i = states.index(state)
        alone = i in instruments or np.count_nonzero(np.delete(rates[i], i)) == 1
        return alone and len(unknown(state)) == 1

    for row, signal in enumerate(signals):
        dependent = np.flatnonzero(matrix[row])
        if len(dependent) != 1 or signal not in first:
            continue
        slope, sample = matrix[row, dependent[0]], first[signal]
        state, spread = states[dependent[0]], sample.sd / abs(slope)
        if state not in shown or spread < better[state]:
            better[state] = spread
            rate = sample.slope / slope if sample.moves else 0.0
            shown[state] = ObservedState(row, sample.value, sample.sd, signal, rate)
    waiting = list(shown)
    while (by := next((name for name in waiting if shows(name)), None)) is not None:
        waiting.remove(by)
        row, known = len(signals) + states.index(by), shown[by]
        state = states[unknown(by)[0]]
        moved = sum(matrix[row, states.index(name)] * one.rate for name, one in shown.items())
        rate = -float(moved) / float(matrix[row, states.index(state)])
        shown[state] = ObservedState(row, known.rate, 0.0, known.signal, rate)
        waiting.append(state)
    return shown


def _states_of_instruments(rates: Array) -> set[int]:
    """States that act on nothing but readings, as that of a thermometer does: on no rate but their own, and on those
    of such states.

    Args:
        rates: (states, states) slopes of the rates by the states.
    """
    found = set[int]()
    acting = [{int(i) for i in np.flatnonzero(column)} for column in rates.T]
    while more := {i for i, on in enumerate(acting) if i not in found and on <= {i, *found}}:
        found |= more
    return found


__all__ = [
    "InitialState",
    "StartProbe",
    "first_of_run",
    "initial_state",
    "initial_state_about",
    "inputs_of_run",
    "measured_initial_state",
    "start_time",
]
