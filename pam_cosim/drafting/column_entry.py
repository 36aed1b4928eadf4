"""The entry of one column: named, scaled and signed as the bench has it, and the numbers that it gives."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.column_statistics import correlation
from pam_cosim.drafting.direction import words_of
from pam_cosim.drafting.feeding import BenchChoice, meaning_of
from pam_cosim.drafting.mapped import ColumnEntry
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.vocabulary import fits
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.units import convert, parse_quantity

_C = CRITERIA.recognition
_GRAVITY = "9.80665 m/s2"


def unit_to_state(column: RecordedColumn) -> str | None:
    """The unit that the entry of a column states; None where its heading does."""
    return None if column.stated else column.unit or None


def named_entry(
    name: str,
    column: RecordedColumn,
    variable: Variable,
    interface: Interface,
    stated: Mapping[str, str],
) -> tuple[ColumnEntry, dict[int, Array]]:
    """The entry that renames a column or makes it what the bench calls so, and its numbers."""
    kind = column.meaning.kind if column.meaning else ""
    if kind == "direction":
        return _direction(name, column)
    wanted = meaning_of(variable)
    if wanted and wanted.kind == "contraction" and kind in ("length", "ratio"):
        return _contraction(name, column, interface, stated)
    if kind == "force" and fits(column.unit, "mass"):
        return _weight(name, column)
    numbers = {i: convert(v, column.unit, variable.unit) for i, v in column.values.items()}
    if column.absolute and kind == "pressure":
        return _gauge_pressure(name, column, numbers)
    return ColumnEntry(name, column.name, unit_to_state(column), why=column.why), numbers


def _weight(name: str, column: RecordedColumn) -> tuple[ColumnEntry, dict[int, Array]]:
    """A force that was recorded as a mass."""
    gravity = parse_quantity(_GRAVITY, "m/s2")
    numbers = {i: convert(v, column.unit, "kg") * gravity for i, v in column.values.items()}
    why = (*column.why, f"a force in {column.unit}, times gravity")
    return _scaled(name, column, _GRAVITY, None, why), numbers


def _gauge_pressure(
    name: str, column: RecordedColumn, numbers: dict[int, Array]
) -> tuple[ColumnEntry, dict[int, Array]]:
    """A gauge pressure that was recorded as an absolute one [Pa]."""
    ambient = f"{_C.ambient / 1e3:g} kPa"
    why = (*column.why, f"its heading says absolute; the ambient is taken as {ambient}")
    return _scaled(name, column, None, f"-{ambient}", why), {
        i: v - _C.ambient for i, v in numbers.items()
    }


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


def _contraction(
    name: str, column: RecordedColumn, interface: Interface, stated: Mapping[str, str]
) -> tuple[ColumnEntry, dict[int, Array]]:
    """A contraction made of a length or of a ratio."""
    at_rest = _length_at_rest(interface, stated)
    if column.meaning and column.meaning.kind == "ratio":
        value, source = at_rest or ("1 m", "")
        length = parse_quantity(value, "m")
        numbers = {i: convert(v, column.unit, "1") * length for i, v in column.values.items()}
        why = f"it is a ratio, times the length at rest, {value}: {source}"
        return _scaled(name, column, value, None, (*column.why, why)), numbers
    lengths = {i: convert(v, column.unit, "m") for i, v in column.values.items()}
    longest = max(float(np.nanmax(v)) for v in lengths.values())
    value, source = f"{longest:.6g} m", "the longest in any recording"
    if at_rest is not None and at_rest[1] == "stated":
        value, source = at_rest
    length = parse_quantity(value, "m")
    why = f"it is a length: the contraction is what is missing to {value}, {source}"
    return _scaled(name, column, "-1", value, (*column.why, why)), {
        i: length - v for i, v in lengths.items()
    }


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


def _scaled(
    name: str, column: RecordedColumn, gain: str | None, offset: str | None, why: tuple[str, ...]
) -> ColumnEntry:
    """The entry of a column times a gain, plus an offset: as a formula, where one can hold the column."""
    if not column.readable:
        return ColumnEntry(name, column.name, column.unit, gain=gain or "1", offset=offset, why=why)
    term = f"'{column.name}'"
    if not column.stated and column.unit:
        term += f' * "1 {column.unit}"'
    if gain == "-1":
        formula = f'"{offset}" - {term}' if offset else f"-{term}"
    else:
        formula = term + (f' * "{gain}"' if gain else "")
        formula += f' - "{offset.removeprefix("-")}"' if offset else ""
    return ColumnEntry(name, formula=formula, why=why)


def signed_entry(
    entry: ColumnEntry,
    values: dict[int, Array],
    choice: BenchChoice,
    variable: Variable,
    pressure: dict[int, Array] | None,
) -> tuple[ColumnEntry, dict[int, Array]]:
    """A contraction that falls while the pressure rises counts the other way, as does a pull below zero."""
    meaning = meaning_of(variable)
    if meaning is None or entry.formula is not None or entry.gain is not None:
        return entry, values
    why = ""
    if meaning.kind == "contraction" and variable.name in choice.outputs and pressure is not None:
        if correlation(pressure, values) < -_C.follows:
            why = "it falls where the pressure rises: its sign is turned round"
    elif meaning.kind == "force" and _mostly_negative(np.concatenate(list(values.values()))):
        why = "it is below zero: its sign is turned round, so that a pull is positive"
    if not why:
        return entry, values
    turned = _scaled(entry.name, choice.fed[entry.name], "-1", None, (*entry.why, why))
    return turned, {i: -v for i, v in values.items()}


def _mostly_negative(values: Array) -> bool:
    """Whether values are below zero on average, and farther below than above."""
    lowest, highest = float(np.nanmin(values)), float(np.nanmax(values))
    return float(np.nanmean(values)) < 0.0 and abs(lowest) > abs(highest)
