"""Numbers that carry their unit through calculations: pint's quantities in SI base units."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pam_cosim.units.conversion import number_and_unit
from pam_cosim.units.grammar import UnitError, read_unit, registry
from pam_cosim.wording import shown


def quantity(values: ArrayLike | str, unit: str = "") -> Any:
    """Numbers in ``unit``, or a text such as "5 kPa", in SI base units; a temperature is absolute.

    Raises:
        UnitError: the text or the unit cannot be read.
    """
    if isinstance(values, str):
        parts = number_and_unit(values)
        if parts is None:
            raise UnitError(
                f"{shown(values)} is not a number with a unit; write for example '5 kPa'"
            )
        values, unit = parts
    numbers = np.asarray(values, dtype=float)
    try:
        return registry().Quantity(numbers, read_unit(unit, False)).to_base_units()
    except (OverflowError, ZeroDivisionError):
        raise UnitError(f"unit {shown(unit)} has a factor beyond what a number holds") from None


def with_unit(value: Any) -> tuple[NDArray[np.float64], str]:
    """Numbers and unit of a result: ``N`` and not the base units that it is made of."""
    if not hasattr(value, "magnitude"):
        return np.asarray(value, dtype=float), ""
    base = value.to_base_units()
    unit = f"{base.units:~C}"
    shown_as = "" if unit == "dimensionless" else _names_by_base_units().get(unit, unit)
    return np.asarray(base.magnitude, dtype=float), shown_as


@cache
def _names_by_base_units() -> dict[str, str]:
    """Units with names of their own, by the base units that they are; a torque would be no joule."""
    return {f"{quantity(1.0, name).units:~C}": name for name in ("N", "Pa", "V", "W")}
