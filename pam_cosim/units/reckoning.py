"""Numbers that carry their unit while they are reckoned with: pint's quantities in SI base units."""

from __future__ import annotations

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
    """Numbers and unit of what was reckoned."""
    if not hasattr(value, "magnitude"):
        return np.asarray(value, dtype=float), ""
    base = value.to_base_units()
    unit = f"{base.units:~C}"
    return np.asarray(base.magnitude, dtype=float), "" if unit == "dimensionless" else unit
