"""Values set by hand."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from pam_cosim.errors import InputError
from pam_cosim.fitting import Free
from pam_cosim.model.interface import Variable
from pam_cosim.model.settings import value_of
from pam_cosim.units import readable_unit
from pam_cosim.wording import shown
from pam_cosim.workbench.checks import is_number, names_of, one_of
from pam_cosim.workbench.commands.choices import in_si, state_values
from pam_cosim.workbench.job_queue import StudyWithJobs
from pam_cosim.workbench.steps import Step


def set_values(study: StudyWithJobs, values: Mapping[str, Any], dragged: bool = False) -> None:
    """Sets parameters and start values: numbers in their shown units, or texts with a unit.

    A parameter that is not free is stated again; null: as the data set states. ``dragged``: a step with those before.
    """
    study.check_free()
    interface = study.opened.simulator.interface
    settable = {**interface.parameters, **interface.inputs}
    slider_values, stated, starts = (
        dict[str, float](),
        dict[str, float | None](),
        dict[str, float](),
    )
    for name, value in values.items():
        if name in study.opened.parameters:
            slider_values[name] = _number(study, study.opened.parameters[name], value)
            continue
        owner = name.rpartition("@")[0]
        state, held = interface.start_values.get(owner), settable.get(owner or name)
        if state is not None:
            starts[name] = value_of(in_si(name, value, state.unit), state)
        elif held is None:
            one_of(name, {**study.opened.parameters, **settable}, "parameter", " to set")
        else:
            stated[name] = None if value is None else _stated(value, held)
    hand = {"dragged": True} if dragged else {}
    if slider_values:
        _move(study, Step("set", {"values": slider_values} | hand))
    if starts:  # the other states of these runs begin where they did
        begins = dict[str, float]()
        for run in dict.fromkeys(name.rpartition("@")[2] for name in starts):
            begins |= study.start_values_of(run)
        _move(study, Step("start", {"values": begins | starts, "moved": list(starts)} | hand))
    if stated:
        study.make_room()
        state_values(study, stated)


def reset(study: StudyWithJobs, names: Sequence[str] | None = None) -> None:
    """Sets parameters to where they began; all, or those named."""
    study.check_free()
    parameters = study.opened.parameters
    chosen = parameters if names is None else names_of(names, "reset")
    starts = {n: parameters[one_of(n, parameters, "parameter", " to set")].start for n in chosen}
    _move(study, Step("set", {"values": starts}))


def _move(study: StudyWithJobs, step: Step) -> None:
    values = {**study.state.values, **step.arguments["values"]}
    study.enter(study.state.after(step, values=values, milestone=""), moved=True)


def _stated(value: Any, variable: Variable) -> float:
    """A value [SI]; a number is in the shown unit, which the message for a value out of range has too."""
    unit = readable_unit(variable.unit) if is_number(value) and variable.kind == "Real" else ""
    return value_of(f"{value} {unit}" if unit else value, variable)


def _number(study: StudyWithJobs, free: Free, value: Any) -> float:
    number = in_si(free.name, value, free.unit)
    variable = study.opened.simulator.interface.settable.get(free.parameter)
    if variable is not None and free.name != f"{variable.name}/stated":
        number = value_of(number, variable)
    if not free.low <= number <= free.high:
        raise InputError(
            f"{shown(f'{free.name}={value}')}: a slider goes from its lowest to its highest value"
        )
    return number
