"""How the runs of a study begin, as the page shows it: the mode, and the start value of each state."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting import Estimate
from pam_cosim.measurement import START_MODES, Run
from pam_cosim.model.interface import Variable
from pam_cosim.reporting.account import unit_text
from pam_cosim.starts import state_trajectory
from pam_cosim.units import format_quantity, readable_factor
from pam_cosim.workbench.opened_model import Opened
from pam_cosim.workbench.protocol import Json, event
from pam_cosim.workbench.state import State
from pam_cosim.workbench.state_events import interval

_ROOM = 0.5  # of what a state goes through in its run, that a slider goes beyond that on both sides

BY_HAND = "by hand"


@dataclass
class StartsShown:
    """Makes the event; keeps how far sliders go, so that they stand still while they are dragged."""

    _reach: dict[str, tuple[float, float]] = field(default_factory=dict)

    def forget(self) -> None:
        """After which sliders may go elsewhere: the model, or the data, are others."""
        self._reach.clear()

    def event(
        self, state: State, opened: Opened, begun: Mapping[str, Estimate], version: int
    ) -> Json:
        """How each recording begins.

        Args:
            state: of the study.
            opened: its model.
            begun: starts that were estimated, by "state@run".
            version: of what is drawn.
        """
        runs = [run for run in state.data.runs if not run.is_static]
        run_entries = [self._run(run, state, opened, begun) for run in runs]
        return event("starts", version=version, runs=run_entries)

    def _run(self, run: Run, state: State, opened: Opened, begun: Mapping[str, Estimate]) -> Json:
        interface = opened.simulator.interface
        by_hand = any(
            name.endswith(f"@{run.name}") for name in opened.start_values_in(state.values)
        )
        mode = (
            BY_HAND if by_hand else "periodic" if run.start.periodic else run.start.mode or "rest"
        )
        entry = {"run": run.name, "mode": mode, "modes": _modes(opened)}
        try:
            reach_is_set = all(f"{name}@{run.name}" in self._reach for name in interface.states)
            trajectories = courses(run, state, opened, begun, only_start=reach_is_set)
        except SimulationFailure as failure:
            return entry | {"text": f"{run.name}: {failure}", "warning": True, "values": []}
        return entry | {
            "text": _text(run, mode),
            "warning": run.start.mode == "rest" and bool(run.start.reason) and not by_hand,
            "values": [
                self._value(run, interface.start_values[name], states, begun)
                for name, states in trajectories.items()
            ],
        }

    def _value(
        self, run: Run, variable: Variable, trajectory: Array, begun: Mapping[str, Estimate]
    ) -> Json:
        name, factor = f"{variable.name}@{run.name}", readable_factor(variable.unit)
        value = float(trajectory[0])
        low, high = self._reach.setdefault(name, _reach(variable, trajectory))
        low, high = self._reach[name] = min(low, value), max(high, value)
        return {
            **interval(begun.get(name), variable.unit),
            "name": name,
            "label": variable.name,
            "unit": unit_text(variable.unit),
            "value": value * factor,
            "low": low * factor,
            "high": high * factor,
            "description": variable.description,
        }


def courses(
    run: Run,
    state: State,
    opened: Opened,
    begun: Mapping[str, Estimate],
    *,
    only_start: bool = False,
) -> dict[str, Array]:
    """The states along a run [SI], the first value where it begins; none where start values cannot be set.

    Args:
        run: a recording over time.
        state: of the study.
        opened: its model.
        begun: starts that were estimated, by "state@run".
        only_start: that alone is wanted, which costs next to nothing.

    Raises:
        SimulationFailure: the run did not reach its end.
    """
    if run.start.seconds or run.start.periodic or not opened.simulator.interface.states:
        return {}
    values = {**state.values, **{name: estimate.value for name, estimate in begun.items()}}
    return state_trajectory(opened.simulator, state.data, run, values, () if only_start else None)


def _reach(variable: Variable, trajectory: Array) -> tuple[float, float]:
    """Between which values a slider moves a start value [SI]."""
    low, high = float(np.min(trajectory)), float(np.max(trajectory))
    room = _ROOM * (high - low) or 0.1 * max(abs(high), abs(variable.nominal or 0.0)) or 1.0
    low, high = low - room, high + room
    low = low if variable.min is None else max(low, variable.min)
    return low, high if variable.max is None else min(high, variable.max)


def _modes(opened: Opened) -> tuple[str, ...]:
    if not opened.simulator.interface.states:
        return ("rest",)
    return tuple(mode for mode in START_MODES if mode != "steady" or opened.simulator.settles)


def _text(run: Run, mode: str) -> str:
    if mode == BY_HAND:
        return f"{run.name} begins where it was set by hand"
    if run.start.reason:
        return run.start.reason
    if run.start.seconds:
        return f"{run.name} begins {mode}, {format_quantity(run.start.seconds, 's')} before its first sample"
    first = (
        "its first samples agree with the model's own start" if run.start.chosen else "as stated"
    )
    return f"{run.name} begins {mode}: {first}"
