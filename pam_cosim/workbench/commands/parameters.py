"""Values set by hand."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from pam_cosim.errors import InputError
from pam_cosim.fitting import Free
from pam_cosim.model.interface import Variable
from pam_cosim.model.settings import value_of
from pam_cosim.units import readable_factor
from pam_cosim.wording import did_you_mean, shown
from pam_cosim.workbench.commands.checks import names_of
from pam_cosim.workbench.steps import SET, START, Step

if TYPE_CHECKING:
    from pam_cosim.workbench.session import Session


def set_values(session: Session, values: Mapping[str, Any]) -> None:
    """Sets parameters, numbers in their shown units."""
    session.work.check_free()
    states = session.opened.simulator.interface.start_values
    starts = {
        name: states[name.rpartition("@")[0]]
        for name in values
        if name.rpartition("@")[0] in states
    }
    starts = {
        name: variable for name, variable in starts.items() if name not in session.opened.parameters
    }
    others = {name: number for name, number in values.items() if name not in starts}
    si = {
        name: _number(session, _parameter(session, name), number) for name, number in others.items()
    }
    moved = {name: _start_value(name, variable, values[name]) for name, variable in starts.items()}
    if si:
        _move(session, si)
    if moved:
        _move_starts(session, moved)


def _start_value(name: str, variable: Variable, value: Any) -> float:
    return value_of(_plain(name, value) / readable_factor(variable.unit), variable)


def _move_starts(session: Session, moved: dict[str, float]) -> None:
    """Sets where runs begin: the other states of these runs begin where they did."""
    state, begins = session.state, dict[str, float]()
    for run in dict.fromkeys(name.rpartition("@")[2] for name in moved):
        begins |= session.start_values_of(run)
    values = begins | moved
    step = Step(START, {"values": values, "moved": list(moved)})
    session.move(state.after(step, values={**state.values, **values}, milestone=""))


def reset(session: Session, names: Sequence[str] | None = None) -> None:
    """Sets parameters to where they began; all, or those named."""
    session.work.check_free()
    chosen = list(session.opened.parameters) if names is None else names_of(names, "reset")
    _move(session, {name: _parameter(session, name).start for name in chosen})


def _move(session: Session, values: dict[str, float]) -> None:
    state = session.state
    step = Step(SET, {"values": values})
    session.move(state.after(step, values={**state.values, **values}, milestone=""))


def _parameter(session: Session, name: str) -> Free:
    known = session.opened.parameters
    if name not in known:
        raise InputError(f"there is no parameter {shown(name)} to set; {did_you_mean(name, known)}")
    return known[name]


def _number(session: Session, free: Free, value: Any) -> float:
    number = _plain(free.name, value) / readable_factor(free.unit)
    variable = session.opened.simulator.interface.settable.get(free.parameter)
    if variable is not None and free.name != f"{variable.name}/stated":
        number = value_of(number, variable)
    if not free.low <= number <= free.high:
        raise InputError(
            f"{shown(f'{free.name}={value}')}: a slider goes from its lowest to its highest value"
        )
    return number


def _plain(name: str, value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise InputError(f"{shown(f'{name}={value}')}: the value must be a number")
    try:
        return float(value)
    except OverflowError:
        return float("inf")
