"""Numbers with units to numbers in the model's unit."""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pam_cosim.units.grammar import (
    UnitError,
    is_dimensionless,
    read_unit,
    registry,
    registry_errors,
)
from pam_cosim.wording import shown

LARGEST = 1e100  # [SI] of what anybody measures or states: its square is a number too
_EXAMPLES = {
    "Pa": "kPa, bar or psi",
    "m": "mm",
    "K": "degC",
    "A": "mA",
    "N": "kN",
    "kg": "g",
    "m3": "l",
    "s": "ms",
}
_QUANTITY = re.compile(r"([+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?)(.*)", re.DOTALL)


def examples(unit: str) -> str:
    """Units a person might have meant where the model uses ``unit``."""
    return f"{unit}, {_EXAMPLES[unit]}" if unit in _EXAMPLES else unit


def convert(
    values: ArrayLike, unit: str, target: str, *, difference: bool = False
) -> NDArray[np.float64]:
    """Numbers in ``unit`` as numbers in ``target``; a hertz is a turn a second where the other unit has an angle.

    Args:
        values: any shape; NaN stays NaN.
        unit: as a person writes it; "", "1" and "-" are dimensionless.
        target: the model's unit.
        difference: the values are differences (0.5 degC is 0.5 K, not 273.65 K).

    Raises:
        UnitError: a unit is unknown, or the dimensions differ.
    """
    source, goal = read_unit(unit, difference), read_unit(target, difference)
    if source.dimensionality != goal.dimensionality:
        if is_dimensionless(target):
            raise UnitError(
                f"unit {shown(unit)} does not fit a number without dimension; leave it out"
            )
        if is_dimensionless(unit):
            raise UnitError(f"a unit is missing; use one of {examples(target)}")
        message = (
            f"unit {shown(unit)} cannot be converted to '{target}'; use one of {examples(target)}"
        )
        raise UnitError(message)
    numbers = np.array(values, dtype=float)
    try:
        with np.errstate(over="ignore", invalid="ignore"):
            converted = registry().Quantity(numbers, source).to(goal).magnitude
            return np.asarray(converted, dtype=float) * _turns(source, goal)
    except registry_errors(ValueError, OverflowError):
        raise UnitError(f"unit {shown(unit)} cannot be converted to '{target}'") from None


def _turns(source: Any, goal: Any) -> float:
    """2 pi between a frequency in hertz and an angular speed: pint takes a radian for the number 1."""
    angles = _power("radian", registry().get_root_units(goal)[1])
    angles -= _power("radian", registry().get_root_units(source)[1])
    frequencies = _power("hertz", source) - _power("hertz", goal)
    return math.tau**angles if angles == frequencies else 1.0


def _power(name: str, unit: Any) -> float:
    """Of a unit of that name, with any prefix, in a product of units."""
    return float(sum(power for symbol, power in unit._units.items() if symbol.endswith(name)))


def parse_quantity(value: str | float, target: str, *, difference: bool = False) -> float:
    """One value such as ``"2.27 kg"``, in ``target``; a bare number only where ``target`` has no dimension.

    Raises:
        UnitError: no number, not finite, no unit where one is needed, or a unit that does not fit.
    """
    number, unit = _split_quantity(value, target) if isinstance(value, str) else (float(value), "")
    if not math.isfinite(number):
        raise UnitError(f"{shown(value)} is not a finite number")
    if is_dimensionless(unit) and not is_dimensionless(target):
        raise UnitError(f'{shown(value)} needs a unit; write for example "{number:g} {target}"')
    result = float(convert(number, unit, target, difference=difference))
    if not abs(result) <= LARGEST:
        raise UnitError(f"{shown(value)} is too large")
    return result


def _split_quantity(text: str, target: str) -> tuple[float, str]:
    parts = number_and_unit(text)
    if parts is None:
        example = "0.7" if is_dimensionless(target) else f"0.7 {target}"
        raise UnitError(f'{shown(text)} is not a number with a unit; write for example "{example}"')
    return parts


def number_and_unit(text: str) -> tuple[float, str] | None:
    """The parts of a text such as "2.27 kg"; None where it does not begin with a number.

    Raises:
        UnitError: a decimal comma.
    """
    match = _QUANTITY.fullmatch(text.strip())
    if match is None:
        return None
    unit = match.group(2).strip()
    if unit.startswith(","):
        raise UnitError(f"{shown(text)} has a decimal comma; write a decimal point")
    return float(match.group(1)), unit


_SECONDS = {"s": 1.0, "ms": 1e-3}  # for these the registry of all units need not be loaded


def seconds(value: float | str) -> float:
    """A number [s], or a text such as "10 ms".

    Raises:
        UnitError: not a finite time.
    """
    try:
        number = float(value)
    except TypeError:
        raise UnitError(f"{shown(value)} is not a time; write for example '10 ms'") from None
    except ValueError:
        parts = number_and_unit(str(value))
        if parts and parts[1] in _SECONDS and abs(parts[0]) <= LARGEST:
            return parts[0] * _SECONDS[parts[1]]
        return parse_quantity(value, "s")
    if not math.isfinite(number):
        raise UnitError(f"{shown(value)} is not a finite time")
    return number
