"""The state in which the simulation of a run begins: stated, measured, estimated or eliminated.

The first samples show some of the states (``observed_states``). The others follow: they are at rest beside these, under
the first inputs.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from pam_cosim.arrays import Array
from pam_cosim.measurement import DataSet, Run
from pam_cosim.simulation import AnySimulator
from pam_cosim.starts.observed_states import observed_states
from pam_cosim.starts.probe import ObservedState, StartProbe
from pam_cosim.starts.run_start import InitialState, start_time


def initial_state(
    simulator: AnySimulator, data: DataSet, run: Run, parameters: Mapping[str, float]
) -> InitialState:
    """How the simulation of a run begins.

    Args:
        simulator: the model.
        data: the data set the run belongs to.
        run: says in which state it begins.
        parameters: what it is simulated with [SI]; start values among them were stated, estimated or eliminated.
    """
    start = run.start
    if start.seconds:
        return InitialState(settle="all")
    if run.is_static or (start.mode in (None, "rest") and not start.periodic):
        return InitialState()
    states = simulator.interface.states
    if given := sum(name in parameters for name in states):
        return InitialState(settle="none" if given == len(states) else "others")
    measured = measured_initial_state(StartProbe(simulator, data, run, parameters))
    return replace(measured, settle="all") if start.mode == "steady" else measured


def measured_initial_state(
    probe: StartProbe, given: Mapping[str, float] | None = None
) -> InitialState:
    """The initial state at which the model gives the first samples.

    Args:
        probe: of the run.
        given: values of some states [SI], which take the place of the first samples.
    """
    given = given or {}
    if not probe.states or not (probe.first or given):
        return InitialState()
    if len(given) == len(probe.states):
        return InitialState(dict(given))
    shown, values = _shown_by_first_samples(probe) if probe.first else ({}, {})
    values |= given
    signals = {state: one.signal for state, one in shown.items()}
    return InitialState(values, probe.settle_beside(values), signals)


def _shown_by_first_samples(
    probe: StartProbe,
) -> tuple[dict[str, ObservedState], dict[str, float]]:
    """What shows which states, and their start values."""
    dependences = _joined(probe.dependences({}), probe.dependences(probe.nearby_state()))
    shown, values = _consistent_start(probe, dependences)
    # such as a reading at the end of its range, which shows nothing
    unmatched = probe.unmatched_signals(shown, values)
    return _consistent_start(probe, dependences, unmatched) if unmatched else (shown, values)


def _joined(earlier: Array, later: Array) -> Array:
    """The later slopes, and the earlier ones where those have vanished."""
    return np.where(later != 0.0, later, earlier)


def _consistent_start(
    probe: StartProbe, dependences: Array, ignored: set[str] | frozenset[str] = frozenset()
) -> tuple[dict[str, ObservedState], dict[str, float]]:
    """What shows which states, and their start values, at which the model agrees with that."""
    shown = observed_states(probe, dependences, ignored)
    values = probe.corrected(shown, dependences, {})
    # what acts on what may not show where the model begins by itself
    dependences = _joined(dependences, probe.dependences(values))
    shown = observed_states(probe, dependences, ignored)
    return shown, probe.corrected(shown, dependences, values)


def state_course(
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
    own = data.parameters_of(run, parameters)
    begin = start_time(run)
    times = np.append(begin, np.maximum(run.time if times is None else times, begin))
    start = initial_state(simulator, data, run, own)
    return dict(start.trajectory(simulator, run, own, times, simulator.interface.states).values)
