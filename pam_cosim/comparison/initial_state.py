"""The state in which the simulation of a run begins, so that it agrees with the first samples.

These show some of the states (``observed_states``). The others follow: they are at rest beside these, under the first
inputs.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from pam_cosim.comparison.observed_states import observed_states
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
    shown, values = _shown_by_first_samples(probe)
    if not probe.states or not probe.first_samples():
        return InitialState()
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
    probe = StartProbe(simulator, data, run, parameters)
    known = {**_shown_by_first_samples(probe)[1], **values}
    return InitialState(known, _settling(probe, known))


def _shown_by_first_samples(
    probe: StartProbe,
) -> tuple[dict[str, ObservedState], dict[str, float]]:
    """What shows which states, and their start values; nothing where the model has no states, or no sample comes."""
    first = probe.first_samples()
    if not probe.states or not first:
        return {}, {}
    dependences = probe.dependences({}).joined(probe.dependences(probe.nearby_state()))
    shown, values = _consistent_start(probe, dependences, first)
    unmatched = probe.unmatched_signals(
        shown, values
    )  # such as a reading at the end of its range, which shows nothing
    if not unmatched:
        return shown, values
    others = {signal: one for signal, one in first.items() if signal not in unmatched}
    return _consistent_start(probe, dependences, others)


def _settling(probe: StartProbe, values: Mapping[str, float]) -> Settle:
    """The states without a value come to rest beside the others, where they find one."""
    return "others" if probe.finds_rest(values) else "none"


def _consistent_start(
    probe: StartProbe, dependences: Dependences, first: Mapping[str, FirstSamples]
) -> tuple[dict[str, ObservedState], dict[str, float]]:
    """What shows which states, and their start values, at which the model agrees with that."""
    shown = observed_states(dependences, first, probe.signals, probe.states)
    values = probe.corrected(shown, dependences, {})
    # what acts on what may not show where the model begins by itself
    dependences = dependences.joined(probe.dependences(values))
    shown = observed_states(dependences, first, probe.signals, probe.states)
    return shown, probe.corrected(shown, dependences, values)


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
