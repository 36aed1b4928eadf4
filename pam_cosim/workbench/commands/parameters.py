"""Values set by hand."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from pam_cosim.errors import InputError
from pam_cosim.fitting import Free
from pam_cosim.model.settings import value_of
from pam_cosim.units import readable_factor
from pam_cosim.wording import shown
from pam_cosim.workbench.checks import is_number, names_of, one_of
from pam_cosim.workbench.job_queue import StudyWithJobs
from pam_cosim.workbench.steps import Step


def set_values(study: StudyWithJobs, values: Mapping[str, Any]) -> None:
    """Sets parameters and start values, numbers in their shown units."""
    study.check_free()
    states = study.opened.simulator.interface.start_values
    set_by_hand, starts = dict[str, float](), dict[str, float]()
    for name, number in values.items():
        state = states.get(name.rpartition("@")[0])
        if state is None or name in study.opened.parameters:
            set_by_hand[name] = _number(study, _parameter(study, name), number)
        else:
            starts[name] = value_of(_plain(name, number) / readable_factor(state.unit), state)
    if set_by_hand:
        _move(study, Step("set", {"values": set_by_hand}))
    if starts:  # the other states of these runs begin where they did
        begins = dict[str, float]()
        for run in dict.fromkeys(name.rpartition("@")[2] for name in starts):
            begins |= study.start_values_of(run)
        _move(study, Step("start", {"values": begins | starts, "moved": list(starts)}))


def reset(study: StudyWithJobs, names: Sequence[str] | None = None) -> None:
    """Sets parameters to where they began; all, or those named."""
    study.check_free()
    chosen = study.opened.parameters if names is None else names_of(names, "reset")
    _move(study, Step("set", {"values": {n: _parameter(study, n).start for n in chosen}}))


def _move(study: StudyWithJobs, step: Step) -> None:
    values = {**study.state.values, **step.arguments["values"]}
    study.enter(study.state.after(step, values=values, milestone=""), moved=True)


def _parameter(study: StudyWithJobs, name: str) -> Free:
    parameters = study.opened.parameters
    return parameters[one_of(name, parameters, "parameter", " to set")]


def _number(study: StudyWithJobs, free: Free, value: Any) -> float:
    number = _plain(free.name, value) / readable_factor(free.unit)
    variable = study.opened.simulator.interface.settable.get(free.parameter)
    if variable is not None and free.name != f"{variable.name}/stated":
        number = value_of(number, variable)
    if not free.low <= number <= free.high:
        raise InputError(
            f"{shown(f'{free.name}={value}')}: a slider goes from its lowest to its highest value"
        )
    return number


def _plain(name: str, value: Any) -> float:
    if not is_number(value):
        raise InputError(f"{shown(f'{name}={value}')}: the value must be a number")
    try:
        return float(value)
    except OverflowError:
        return float("inf")
