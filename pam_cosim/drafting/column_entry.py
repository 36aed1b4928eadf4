"""The entry of one column: named and scaled as the bench has it, and the numbers that it gives."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.drafting.contraction import contraction_entry
from pam_cosim.drafting.direction import words_of
from pam_cosim.drafting.feeding import meaning_of
from pam_cosim.drafting.mapped import ColumnEntry
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.scaling import GRAVITY, scaled_entry
from pam_cosim.drafting.vocabulary import fits
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.units import UnitError, convert, parse_quantity
from pam_cosim.units.grammar import STANDARD_ATMOSPHERE


def unit_to_state(column: RecordedColumn) -> str | None:
    """The unit that the entry of a column states; None where its heading does."""
    return None if column.stated else column.unit or None


def named_entry(
    name: str,
    column: RecordedColumn,
    variable: Variable,
    interface: Interface,
    stated: Mapping[str, str],
    ambient: RecordedColumn | None = None,
) -> tuple[ColumnEntry, dict[int, Array]]:
    """The entry that renames a column or makes it what the bench calls so, and its numbers.

    Args:
        name: of the variable.
        column: that is taken for it.
        variable: of the bench.
        interface: of the bench.
        stated: parameters as texts.
        ambient: the ambient pressure, where it was recorded.
    """
    kind = column.meaning.kind if column.meaning else ""
    if kind == "direction":
        return _direction(name, column)
    wanted = meaning_of(variable)
    if wanted and wanted.kind == "contraction" and kind in ("length", "ratio"):
        return contraction_entry(name, column, interface, stated)
    if kind == "force" and fits(column.unit, "mass"):
        return _weight(name, column)
    numbers = _converted(name, column, variable.unit)
    if column.absolute and kind == "pressure" and not variable.pressures:
        why = (*column.why, f"its heading says absolute: state an offset if {name} is gauge")
        return ColumnEntry(name, column.name, column.unit or None, why=why), numbers
    if column.absolute and kind == "pressure":
        return _gauge_pressure(name, column, numbers, ambient)
    return ColumnEntry(name, column.name, unit_to_state(column), why=column.why), numbers


def _converted(name: str, column: RecordedColumn, unit: str) -> dict[int, Array]:
    """The numbers of a column in a unit.

    Raises:
        InputError: its own is of another kind.
    """
    try:
        return {i: convert(v, column.unit, unit) for i, v in column.values.items()}
    except UnitError as problem:
        raise InputError(
            f"column '{column.name}' cannot be taken for {name}: {problem}; name another one"
        ) from None


def _weight(name: str, column: RecordedColumn) -> tuple[ColumnEntry, dict[int, Array]]:
    """A force that was recorded as a mass."""
    gravity = parse_quantity(GRAVITY, "m/s2")
    numbers = {i: v * gravity for i, v in _converted(name, column, "kg").items()}
    why = (*column.why, f"a force in {column.unit}, times gravity")
    return scaled_entry(name, column, GRAVITY, None, why), numbers


def _gauge_pressure(
    name: str, column: RecordedColumn, numbers: dict[int, Array], ambient: RecordedColumn | None
) -> tuple[ColumnEntry, dict[int, Array]]:
    """A gauge pressure that was recorded as an absolute one [Pa]."""
    outside, source = STANDARD_ATMOSPHERE, ""
    if ambient is not None:
        mean = float(np.nanmean(convert(ambient.every, ambient.unit, "Pa")))
        outside, source = mean, f", the mean of {ambient.name}"
    text = f"{outside / 1e3:.6g} kPa"
    why = (*column.why, f"its heading says absolute; the ambient is taken as {text}{source}")
    entry = scaled_entry(name, column, None, f"-{text}", why)
    return entry, {i: v - outside for i, v in numbers.items()}


def _direction(name: str, column: RecordedColumn) -> tuple[ColumnEntry, dict[int, Array]]:
    """Words for directions, or a formula that gives 1 and -1."""
    values = {
        i: np.array([float(column.senses.get(v, 0)) for v in own.tolist()])
        for i, own in column.values.items()
    }
    if column.words:
        return ColumnEntry(name, column.name, why=column.why, words=words_of(column)), values
    if all(number == sense for number, sense in column.senses.items()):
        return ColumnEntry(name, column.name, why=column.why), values
    numbers = {sense: number for number, sense in reversed(column.senses.items())}
    up, down = numbers.get(1), numbers.get(-1)
    if up is None or down is None or len(column.senses) > 2:
        hint = f"leave it out: --recording ignore={column.name}"
        raise InputError(f"the values of {column.name} are no directions; {hint}")
    scale, offset = 2.0 / (up - down), -(up + down) / (up - down)
    if not column.readable:
        turned = ColumnEntry(
            name, column.name, gain=f"{scale:g}", offset=f"{offset:g}", why=column.why
        )
        return turned, values
    formula = f"{scale:g} * '{column.name}' + ({offset:g})"
    return ColumnEntry(name, formula=formula, why=column.why), values
