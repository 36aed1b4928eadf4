"""A contraction made of a length or of a ratio that was recorded."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.drafting.mapped import ColumnEntry
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.scaling import scaled_entry
from pam_cosim.model.interface import Interface
from pam_cosim.units import convert, parse_quantity

LONGEST = "the longest in any recording"
"""Where a length at rest comes from that nobody states."""


def contraction_entry(
    name: str, column: RecordedColumn, interface: Interface, stated: Mapping[str, str]
) -> tuple[ColumnEntry, dict[int, Array]]:
    """A contraction made of a length or of a ratio."""
    at_rest = _length_at_rest(interface, stated)
    if column.meaning and column.meaning.kind == "ratio":
        value, source = at_rest or ("1 m", "")
        length = parse_quantity(value, "m")
        numbers = {i: convert(v, column.unit, "1") * length for i, v in column.values.items()}
        why = f"it is a ratio, times the length at rest, {value}: {source}"
        return scaled_entry(name, column, value, None, (*column.why, why)), numbers
    lengths = {i: convert(v, column.unit, "m") for i, v in column.values.items()}
    longest = max(float(np.nanmax(v)) for v in lengths.values())
    value, source = f"{longest:.6g} m", LONGEST
    if at_rest is not None and at_rest[1] == "stated":
        value, source = at_rest
    length = parse_quantity(value, "m")
    why = f"it is a length: the contraction is what is missing to {value}, {source}"
    entry = scaled_entry(name, column, "-1", value, (*column.why, why))
    return entry, {i: length - v for i, v in lengths.items()}


def _length_at_rest(interface: Interface, stated: Mapping[str, str]) -> tuple[str, str] | None:
    """The value of the parameter that is a muscle's length at rest, and where it comes from."""
    name = length_parameter(interface)
    if name is None:
        return None
    if name in stated:
        return stated[name], "stated"
    return (
        f"{interface.parameters[name].start:g} m",
        f"the bench's default of {name}, state yours and change it here",
    )


def length_parameter(interface: Interface) -> str | None:
    """The parameter that is a muscle's length at rest, by what is said of it."""
    for name, variable in interface.parameters.items():
        said = variable.description.casefold()
        is_length = variable.unit == "m" and "length" in said
        if is_length and ("rest" in said or "initial" in said):
            return name
    return None
