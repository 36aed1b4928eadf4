"""The state in which the simulation of a run begins: stated, measured, estimated or eliminated.

The first samples show some of the states. The others follow: they are in equilibrium with these under the first inputs.

A signal that depends on one state alone shows it: a pressure reading the pressure, a ruler the position. An instrument
with states of its own, as a delay has, is in equilibrium with its reading. Where the rate of such a state depends on
one further state alone, the slope of the samples shows that: the speed, or what lies behind the lag of an instrument.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement import DataSet, Run
from pam_cosim.simulation import AnySimulator
from pam_cosim.starts.probe import ObservedState, StartProbe
from pam_cosim.starts.run_start import InitialState, start_time


def initial_state(
    simulator: AnySimulator, data: DataSet, run: Run, parameters: Mapping[str, float]
) -> InitialState:
    """How the simulation of a run begins.

    Args:
        simulator: the model.
        data: the data set the run belongs to.
        run: has the state in which it begins.
        parameters: what it is simulated with [SI]; start values among them were stated, estimated or eliminated.
    """
    start = run.start
    if start.seconds:
        return InitialState(settle="all")
    if run.is_static or (start.mode in (None, "rest") and not start.periodic):
        return InitialState()
    states = simulator.interface.states
    if stated_count := sum(name in parameters for name in states):
        return InitialState(settle="none" if stated_count == len(states) else "others")
    measured = measured_initial_state(StartProbe(simulator, data, run, parameters))
    return replace(measured, settle="all") if start.mode == "steady" else measured


def measured_initial_state(probe: StartProbe) -> InitialState:
    """The initial state at which the model gives the first samples of a run, by its probe."""
    if not (probe.states and probe.first):
        return InitialState()
    observed_states, values = _shown_by_first_samples(probe)
    signals = {state: observed.signal for state, observed in observed_states.items()}
    return InitialState(values, probe.settle_others(values), signals)


def _shown_by_first_samples(
    probe: StartProbe,
) -> tuple[dict[str, ObservedState], dict[str, float]]:
    """What shows which states, and their start values."""
    dependences = _joined(probe.dependences({}), probe.dependences(probe.nearby_state()))
    observed_states, values = _consistent_start(probe, dependences)
    # such as a reading at the end of its range, which shows nothing
    unmatched = probe.unmatched_signals(observed_states, values)
    return (
        _consistent_start(probe, dependences, unmatched) if unmatched else (observed_states, values)
    )


def _joined(earlier: Array, later: Array) -> Array:
    """The later slopes, and the earlier ones where those have vanished."""
    return np.where(later != 0.0, later, earlier)


def _consistent_start(
    probe: StartProbe, dependences: Array, ignored: Collection[str] = ()
) -> tuple[dict[str, ObservedState], dict[str, float]]:
    """What shows which states, and their start values, at which the model agrees with that."""
    observed_states = _observed_states(probe, dependences, ignored)
    values = probe.corrected(observed_states, dependences, {})
    # what acts on what may not show where the model begins by itself
    dependences = _joined(dependences, probe.dependences(values))
    observed_states = _observed_states(probe, dependences, ignored)
    return observed_states, probe.corrected(observed_states, dependences, values)


def state_trajectory(
    simulator: AnySimulator,
    data: DataSet,
    run: Run,
    parameters: Mapping[str, float],
    times: ArrayLike | None = None,
) -> dict[str, Array]:
    """The states along a run, (n + 1,) each [SI], by name: where the simulation begins, and at n times after that.

    Args:
        simulator: the model.
        data: the data set the run belongs to.
        run: a recording over time.
        parameters: values by name [SI], start values by "state@run" among them.
        times: (n,) [s]; default: those of the samples.

    Raises:
        SimulationFailure: the run did not reach its end.
    """
    run_parameters = data.parameters_of(run, parameters)
    begin = start_time(run)
    times = np.append(begin, np.maximum(run.time if times is None else times, begin))
    start = initial_state(simulator, data, run, run_parameters)
    return dict(
        start.trajectory(simulator, run, run_parameters, times, simulator.interface.states).values
    )


def _observed_states(
    probe: StartProbe, dependences: Array, ignored: Collection[str] = ()
) -> dict[str, ObservedState]:
    """The observed states by name. Of two signals that show the same state, the one that shows it better: a
    pressure that of a gas, not a temperature, which hardly follows its mass.

    Args:
        probe: of the run, with the first samples of its signals.
        dependences: of signals and rates on states, as ``StartProbe.dependences`` has them.
        ignored: signals that show nothing.
    """
    observed_by_index = _observed_by_signals(probe, dependences, ignored)
    _add_observed_by_rates(observed_by_index, dependences, len(probe.signals))
    return {probe.states[i]: observed for i, observed in observed_by_index.items()}


def _observed_by_signals(
    probe: StartProbe, matrix: Array, ignored: Collection[str]
) -> dict[int, ObservedState]:
    """By number of the state: what signals read, and the states of instruments, which are in equilibrium with that."""
    rates, observed_states = matrix[len(probe.signals) :], dict[int, ObservedState]()
    better: dict[int, float] = {}
    for row, (signal, sample) in enumerate(probe.first.items()):
        read = _source_of_reading({*_nonzero(matrix[row])}, rates)
        if read is None or signal in ignored:
            continue
        source, instrument = read
        slope = _slope_at_rest(matrix[row], rates, source, instrument)
        if not slope:
            continue
        # the law between a reading and a state is no more exact than that, be the reading as precise as it may
        error = CRITERIA.noise.assumed_share * abs(sample.value)
        spread = float(np.hypot(sample.sd, error)) / abs(slope)
        if spread < better.get(source, np.inf):
            better[source] = spread
            rate = sample.slope / slope if sample.moves else 0.0
            observed_states[source] = ObservedState(row, sample.value, sample.sd, signal, rate)
        for i in instrument:
            observed_states.setdefault(
                i, ObservedState(len(probe.signals) + i, 0.0, 0.0, signal, 0.0)
            )
    return observed_states


def _source_of_reading(dependent: set[int], rates: Array) -> tuple[int, set[int]] | None:
    """The one state that a reading follows, of those on which it depends, and the states of its instrument.

    The rates of these, as of a delay, depend on them and on that state alone, and they act on nothing but one another.
    None: no state is the only such one.

    Args:
        dependent: the states.
        rates: (states, states) slopes of the rates by the states.
    """
    sources = []
    for source in dependent:
        instrument_states = dependent - {source}
        while more := {j for i in instrument_states for j in _nonzero(rates[i])} - {
            source,
            *instrument_states,
        }:
            instrument_states |= more
        if {i for j in instrument_states for i in _nonzero(rates[:, j])} <= instrument_states:
            sources.append((source, instrument_states))
    return sources[0] if len(sources) == 1 else None


def _nonzero(slopes: Array) -> list[int]:
    return np.flatnonzero(slopes).tolist()


def _slope_at_rest(row: Array, rates: Array, source: int, instrument: set[int]) -> float:
    """The slope of a reading by what it reads, the states of its instrument following at rest."""
    places = sorted(instrument)
    follow = np.linalg.lstsq(rates[np.ix_(places, places)], rates[places, source], rcond=None)[0]
    return float(row[source] - row[places] @ follow)


def _add_observed_by_rates(
    observed_states: dict[int, ObservedState], matrix: Array, signals: int
) -> None:
    """Adds the states that the rates of those show which are known so far."""
    rates = matrix[signals:]

    def others(i: int) -> list[int]:
        """The states on which a rate depends besides its own."""
        return [j for j in _nonzero(rates[i]) if j != i]

    def shows(i: int) -> bool:
        """Whether a rate shows the only other state on which it depends."""
        return len(others(i)) == 1 and others(i)[0] not in observed_states

    waiting = list(observed_states)
    while (by := next((i for i in waiting if shows(i)), None)) is not None:
        waiting.remove(by)
        observed, (state,) = observed_states[by], others(by)
        predicted_rate = sum(
            rates[by, i] * shown_state.rate for i, shown_state in observed_states.items()
        )
        rate = -float(predicted_rate) / float(rates[by, state])
        observed_states[state] = ObservedState(
            signals + by, observed.rate, 0.0, observed.signal, rate
        )
        waiting.append(state)
