"""Values set by hand."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from pam_cosim.errors import InputError
from pam_cosim.fitting import Free
from pam_cosim.settings import value_of
from pam_cosim.units import readable_factor
from pam_cosim.wording import did_you_mean, shown
from pam_cosim.workbench.doing.words import names_of
from pam_cosim.workbench.steps import SET, Step

if TYPE_CHECKING:
    from pam_cosim.workbench.session import Session


def set_values(session: Session, values: Mapping[str, Any]) -> None:
    """Sets parameters, numbers in their shown units."""
    session.work.check_free()
    si = {name: _number(session, _parameter(session, name), number) for name, number in values.items()}
    _move(session, si)


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
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise InputError(f"{shown(f'{free.name}={value}')}: the value must be a number")
    try:
        number = float(value) / readable_factor(free.unit)
    except OverflowError:
        number = float("inf")
    variable = session.opened.simulator.interface.settable.get(free.parameter)
    if variable is not None and free.name != f"{variable.name}/stated":
        number = value_of(number, variable)
    if not free.low <= number <= free.high:
        raise InputError(f"{shown(f'{free.name}={value}')}: a slider goes from its lowest to its highest value")
    return number
