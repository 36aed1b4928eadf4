"""``[parameters]`` and ``[fit]`` against the parameters of the bench."""

from __future__ import annotations

from collections.abc import Mapping
from math import inf

from pam_cosim.measurement.experiment import ExperimentFile
from pam_cosim.measurement.experiment_tables import FreeTable
from pam_cosim.measurement.free_parameter import FreeParameter, Prior
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.units import UnitError, parse_quantity
from pam_cosim.wording import did_you_mean, shown


def known_values(
    document: ExperimentFile,
    interface: Interface,
    values: Mapping[str, str | float],
    *path: str | int,
) -> dict[str, float]:
    """The table at ``path`` in the model's units: parameters, and inputs that are constant.

    Raises:
        InputError: an unknown name, a unit that does not fit, a value outside the model's range.
    """
    return {
        name: _value(document, _known(document, interface, name, *path), value, *path, name)
        for name, value in values.items()
    }


def free_parameter(
    document: ExperimentFile,
    interface: Interface,
    name: str,
    table: FreeTable,
    known: Mapping[str, float],
    *path: str | int,
    run: str = "",
) -> FreeParameter:
    """One entry of ``[fit]`` or ``[runs.fit]``; a value under ``[parameters]`` (``known``) is its start value.

    Raises:
        InputError: as ``known_values``; bounds reversed, start value given twice or outside the bounds, a logarithm
            of what may be zero, a prior without spread.
    """
    parameter = _parameter(document, interface, name, *path)
    path = (*path, name)
    low = _value(document, parameter, table.min, *path, "min")
    high = _value(document, parameter, table.max, *path, "max")
    bounds = f"min = {shown(table.min)} and max = {shown(table.max)}"
    if not low < high:
        raise document.error(f"{name}: the bounds are reversed or equal, {bounds}", *path)
    if table.transform == "log" and not low > 0.0:
        raise document.error(
            f"{name}: a logarithm needs bounds above zero, not {bounds}", *path, "transform"
        )
    if table.start is not None and name in known and not run:
        message = f"{name} has a start value here and a value under [parameters]; keep one of them"
        raise document.error(message, *path, "start")
    start = known.get(name)
    if table.start is not None:
        start = _value(document, parameter, table.start, *path, "start")
    if start is not None and not low <= start <= high:
        place = ("parameters", name) if name in known and table.start is None else (*path, "start")
        raise document.error(f"{name}: the start value lies outside the bounds, {bounds}", *place)
    prior = _prior(document, parameter, table, *path)
    if start is None and prior is not None:
        start = min(max(prior.mean, low), high)
    own = f"{name}@{run}" if run else name
    return FreeParameter(own, low, high, start, parameter.unit, table.transform, prior, run)


def _prior(
    document: ExperimentFile, parameter: Variable, table: FreeTable, *path: str | int
) -> Prior | None:
    if table.prior is None:
        return None
    mean = _value(document, parameter, table.prior.mean, *path, "prior", "mean")
    try:
        sd = parse_quantity(table.prior.sd, parameter.unit, difference=True)
    except UnitError as error:
        raise document.error(
            f"sd of the prior of {parameter.name}: {error}", *path, "prior", "sd"
        ) from None
    if not 0.0 < sd < inf:
        raise document.error(
            f"sd of the prior of {parameter.name} must be greater than zero", *path, "prior", "sd"
        )
    return Prior(mean, sd)


def _known(document: ExperimentFile, interface: Interface, name: str, *path: str | int) -> Variable:
    known = {**interface.parameters, **interface.inputs}
    if name not in known:
        message = f"{interface.model} has no parameter or input {shown(name)}; {did_you_mean(name, known)}"
        raise document.error(message, *path, name)
    return known[name]


def _parameter(
    document: ExperimentFile, interface: Interface, name: str, *path: str | int
) -> Variable:
    if name in interface.inputs:
        message = (
            f"{shown(name)} is an input of {interface.model}, and only parameters can be fitted"
        )
        raise document.error(f"{message}; state its value under [parameters]", *path, name)
    known = interface.parameters
    if name not in known:
        message = f"{interface.model} has no parameter {shown(name)}; {did_you_mean(name, known)}"
        raise document.error(message, *path, name)
    return known[name]


def _value(
    document: ExperimentFile, parameter: Variable, value: str | float, *path: str | int
) -> float:
    try:
        number = parse_quantity(value, parameter.unit)
    except UnitError as error:
        raise document.error(f"{parameter.name}: {error}", *path) from None
    low = -inf if parameter.min is None else parameter.min
    high = inf if parameter.max is None else parameter.max
    if not low <= number <= high:
        unit = "" if parameter.unit == "1" else parameter.unit
        span = f"{low:g} to {high:g} {unit}".rstrip()
        message = f"{parameter.name}: {shown(value)} is outside the model's range, {span}"
        raise document.error(message, *path)
    return number
