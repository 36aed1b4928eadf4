"""``[parameters]`` and ``[fit]`` against the parameters of the bench."""

from __future__ import annotations

from collections.abc import Mapping
from math import inf

from pam_cosim.errors import InputError
from pam_cosim.measurement.experiment_tables import FreeTable
from pam_cosim.measurement.free_parameter import FreeParameter, Prior
from pam_cosim.measurement.place import Place, Stated
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.model.settings import value_of
from pam_cosim.wording import shown


def known_values(interface: Interface, values: Mapping[str, Stated]) -> dict[str, float]:
    """Values in the model's units: parameters, and inputs that are constant.

    Raises:
        InputError: an unknown name, a unit that does not fit, a value outside the model's range.
    """
    variables = {**interface.parameters, **interface.inputs}
    role = "parameter or input"
    return {
        name: _value(_variable(interface, variables, name, role, stated.place), stated)
        for name, stated in values.items()
    }


def free_parameter(
    interface: Interface,
    name: str,
    table: FreeTable,
    stated_values: Mapping[str, Stated],
    run: str = "",
) -> FreeParameter:
    """One entry of ``[fit]`` or ``[runs.fit]``; a value under ``[parameters]`` (``known``) is its start value.

    Raises:
        InputError: as ``known_values``; bounds reversed, start value given twice or outside the bounds, a logarithm
            of what may be zero, a prior without spread.
    """
    if name in interface.inputs:
        message = (
            f"{shown(name)} is an input of {interface.model}, and only parameters can be fitted"
        )
        raise table.error(f"{message}; state its value under [parameters]")
    parameter = _variable(interface, interface.parameters, name, "parameter", table.at())
    if parameter.kind != "Real":
        message = f"{name} is of type {parameter.kind}, and only Real parameters can be fitted"
        raise table.error(f"{message}; state its value under [parameters]")
    low, high = _value(parameter, table.min), _value(parameter, table.max)
    bounds = f"min = {shown(table.min.value)} and max = {shown(table.max.value)}"
    if not low < high:
        raise table.error(f"{name}: the bounds are reversed or equal, {bounds}")
    if table.transform == "log" and not low > 0.0:
        raise table.error(f"{name}: a logarithm needs bounds above zero, not {bounds}", "transform")
    if table.start is not None and name in stated_values and not run:
        message = f"{name} has a start value here and a value under [parameters]; keep one of them"
        raise table.error(message, "start")
    stated = table.start or stated_values.get(name)
    start = None if stated is None else _value(parameter, stated)
    if stated is not None and start is not None and not low <= start <= high:
        raise stated.place.error(f"{name}: the start value lies outside the bounds, {bounds}")
    prior = None
    if table.prior is not None:
        mean, subject = _value(parameter, table.prior.mean), f"sd of the prior of {name}"
        prior = Prior(mean, table.prior.sd.above_zero(parameter.unit, subject, difference=True))
        start = min(max(mean, low), high) if start is None else start
    full_name = f"{name}@{run}" if run else name
    return FreeParameter(full_name, low, high, start, parameter.unit, table.transform, prior, run)


def _variable(
    interface: Interface, variables: Mapping[str, Variable], name: str, role: str, place: Place
) -> Variable:
    if name not in variables:
        raise place.error(interface.unknown(name, role, variables))
    return variables[name]


def _value(parameter: Variable, stated: Stated) -> float:
    if parameter.kind != "Real":
        try:
            return value_of(stated.value, parameter)
        except InputError as error:
            raise stated.place.error(error.message) from None
    number = stated.quantity(parameter.unit, parameter.name)
    low = -inf if parameter.min is None else parameter.min
    high = inf if parameter.max is None else parameter.max
    if not low <= number <= high:
        unit = "" if parameter.unit == "1" else parameter.unit
        span = f"{low:g} to {high:g} {unit}".rstrip()
        message = f"{parameter.name}: {shown(stated.value)} is outside the model's range, {span}"
        raise stated.place.error(message)
    return number
