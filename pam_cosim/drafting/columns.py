"""The columns of all recordings, and what each is: by its words, its unit, and what its numbers look like."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.column_statistics import span
from pam_cosim.drafting.logged_on_change import with_values_kept
from pam_cosim.drafting.recorded_column import RecordedColumn, with_usual_unit
from pam_cosim.drafting.sources import RecordingSource
from pam_cosim.drafting.time_column import with_time
from pam_cosim.drafting.vocabulary import (
    Heading,
    Meaning,
    contradiction,
    fits,
    is_count,
    known_unit,
    read_heading,
    scaled_unit,
)
from pam_cosim.errors import InputError
from pam_cosim.measurement.table import Column
from pam_cosim.wording import shown

_SUPPLY_RANGE = 0.3  # of its mean, by which a supply pressure varies at most


_SHARES = ("command", "ratio")  # need no unit: what is written there, such as on/off, is none
_SCALES = {
    "contraction": ("x", "0.02 mm"),
    "force": ("F", "0.1 N"),
    "pressure": ("p", "0.1 kPa"),
}
"""By kind, how a column in counts may be scaled: a name and the size of a count."""
_MOST = 400  # columns; each is held against each
_NAME = re.compile(r"'([^']*)'|([A-Za-z_]\w*)", re.ASCII)


def find_columns(
    sources: Sequence[RecordingSource], asked: Mapping[str, str]
) -> list[RecordedColumn]:
    """Every column of numbers and what it is; ``asked`` are columns by the names that the user gave them.

    Raises:
        InputError: a column that is asked for is in no file; there are too many.
    """
    names = dict.fromkeys(name for source in sources for name in source.table.columns)
    if len(names) > _MOST:
        raise InputError(
            f"{len(names)} columns are too many to recognise; leave out those that are not needed, down to {_MOST}",
            sources[-1].file,
        )
    columns = [_found(name, sources) for name in names]
    columns = with_time(_valves(_supply(columns)), asked.get("time"), sources)
    columns = with_values_kept(columns)
    _check_alike(columns, sources)
    return columns


def with_known_units(
    columns: Sequence[RecordedColumn],
    formulas: Iterable[str],
    sources: Sequence[RecordingSource],
    asked: Iterable[str] = (),
) -> list[RecordedColumn]:
    """The columns, of which those whose unit nobody knows, or is of another quantity, serve formulas alone.

    Raises:
        InputError: a unit is written that nobody knows, or that is of another quantity than the name says, and neither
            a formula holds the column nor is it ``asked`` for: no other one is guessed.
    """
    in_formulas = {name for formula in formulas for name in names_in(formula)}
    said = {*in_formulas, *asked}
    for one in columns:
        wrong = _unknown(one) if _lacks_unit(one) and one.name not in in_formulas else ""
        if not wrong and one.name not in said:
            wrong = _contradicts(one)
        if wrong:
            source = sources[min(one.places)]
            raise InputError(wrong, source.file, source.table.header_line, one.name)
    wrong_in_formulas = {c.name for c in columns if c.name in in_formulas and _contradicts(c)}
    return [
        replace(c, meaning=None) if _lacks_unit(c) or c.name in wrong_in_formulas else c
        for c in columns
    ]


def names_in(formula: str) -> set[str]:
    """The columns that a formula reads: quantities stand in double quotes, names bare or in single ones."""
    return {quoted or bare for quoted, bare in _NAME.findall(re.sub(r'"[^"]*"', "", formula))}


def _lacks_unit(one: RecordedColumn) -> bool:
    """Whether the unit that is written is none, and its numbers need one: a command that is on or off needs none."""
    if not one.unknown or one.unit or one.meaning is None:
        return False
    kind = one.meaning.kind
    shares = is_count(one.unknown) if kind in _SHARES else True
    return shares and kind not in ("count", "direction")


def _unknown(one: RecordedColumn) -> str:
    assert one.meaning is not None
    left_out = f"or leave it out: --recording 'ignore={one.name}'"
    signal, step = _SCALES.get(one.meaning.kind, _SCALES["contraction"])
    scaled = f"scale it, as in --column {_scaling(signal, one.name, step)}"
    if is_count(one.unknown):
        return f"how large its {one.unknown} are is not said; {scaled}, {left_out}"
    correct = "correct it in the file"
    if scaled_unit(one.name) != one.unknown:
        return f"unit {shown(one.unknown)} is unknown; {correct}, {left_out}"
    more = "" if one.meaning.kind == "time" else f"{scaled}, "
    return f"its unit {shown(one.unknown)} has a factor, which is not read; {correct}, {more}{left_out}"


def _scaling(signal: str, name: str, step: str, less: str = "") -> str:
    """A formula that scales a column, as a word of a command."""
    term = name if name.isidentifier() else f"'{name}'"
    formula = f'{signal}={f"({term}{less})" if less else term} * "{step}"'
    if term == name:
        return f"'{formula}'"
    return '"' + formula.replace('"', '\\"') + '"'


def _contradicts(one: RecordedColumn) -> str:
    """What to say of a column whose unit is of another quantity than its name says; "" where they agree."""
    written = next((column.unit for column in one.places.values()), "")
    unit = known_unit(written)
    said = contradiction(one.name, unit) if unit and one.values else ""
    if not said:
        return ""
    scaled = _scaling("p", one.name, "0.5 bar/mA", ' - "4 mA"')
    scale = f"scale the signal, as in --column {scaled}, " if fits(unit, "current") else ""
    hint = f"--recording 'ignore={one.name}', or say what it is: --column NAME={shown(one.name)}"
    return f"{said}; correct the heading, {scale}leave it out: {hint}"


def _check_alike(columns: Sequence[RecordedColumn], sources: Sequence[RecordingSource]) -> None:
    """Raises InputError where recordings call the same quantity by different names: one would be lost."""
    for one in columns:
        for other in columns:
            if (
                one.meaning is not None
                and one.meaning == other.meaning
                and not one.values.keys() & other.values.keys()
            ):
                there, here = sources[min(one.values)].file.name, sources[min(other.values)].file
                message = f"{there} calls the {one.meaning} {shown(one.name)}; files of one kind are drafted together"
                raise InputError(message, here, None, other.name)


def _found(name: str, sources: Sequence[RecordingSource]) -> RecordedColumn:
    places = {i: s.table.columns[name] for i, s in enumerate(sources) if name in s.table.columns}
    first = next(iter(places.values()))
    if any(column.unit != first.unit for column in places.values()):
        raise _two_units(name, places, sources)
    reading = _reading(name, first.unit, [column.values for column in places.values()])
    one = RecordedColumn(
        name,
        reading.unit,
        reading.written,
        reading.meaning,
        {i: column.values for i, column in places.items() if np.isfinite(column.values).any()},
        unknown=reading.unknown,
        absolute=reading.absolute,
        known=reading.known,
        places=places,
    )
    if not one.values:
        rows = sum(len(column.values) for column in places.values())
        return replace(one, meaning=None, why=(f"it has no value in any of {rows} rows",))
    words = _words_in(sources, name, first.heading)
    if words:
        return replace(one, meaning=Meaning("direction"), words=words, unit="", stated=True)
    meaning = one.meaning
    if meaning is None:
        return one
    if reading.known == 0.0:
        one = replace(one, why=(f"its unit is {reading.unit}",))
    if one.unknown and meaning.kind not in _SHARES:
        return one
    if not reading.unit:
        return with_usual_unit(one)
    if not one.stated:
        one = replace(one, why=(*one.why, f"unit {reading.unit} by its name"))
    return one


def _reading(name: str, unit: str, recorded: Sequence[Array]) -> Heading:
    """What a heading says; a pressure that moves is none of the atmosphere: ``p_atm`` is one in that unit."""
    bare = re.sub(r"[\W_]+atm$", "", name, flags=re.IGNORECASE)
    if bare != name and not all(map(_varies_little, recorded)):
        in_atmospheres = read_heading(bare, unit or "atm")
        if in_atmospheres.meaning is not None and in_atmospheres.meaning.kind == "pressure":
            return replace(in_atmospheres, written=in_atmospheres.written and bool(unit.strip()))
    return read_heading(name, unit)


def _words_in(sources: Sequence[RecordingSource], name: str, heading: str) -> tuple[str, ...]:
    """The words that stand in a column for directions; none where it holds numbers."""
    for source in sources:
        words = source.words.get(name) or source.words.get(heading)
        if words:
            return words
    return ()


def _two_units(
    name: str, places: Mapping[int, Column], sources: Sequence[RecordingSource]
) -> InputError:
    first = min(places)
    other = next(i for i, column in places.items() if column.unit != places[first].unit)
    there, here = (shown(places[i].unit) for i in (first, other))
    message = f"its unit is {there} in {sources[first].file.name} and {here} here; draft data sets of their own"
    return InputError(message, sources[other].file, None, name)


def _supply(columns: list[RecordedColumn]) -> list[RecordedColumn]:
    """Of two pressures of which none is called so, the one that stays above the other is the supply's."""
    plain = [c for c in columns if c.of("pressure") and c.unit]
    if (
        len(plain) != 2
        or any(c.of("pressure", "supply") for c in columns)
        or plain[0].values.keys() != plain[1].values.keys()
    ):
        return columns
    for one, other in (plain, plain[::-1]):
        if one.unit == other.unit and _feeds(one.every, other.every):
            meaning = Meaning("pressure", frozenset({"supply"}))
            made = replace(
                one,
                meaning=meaning,
                why=(*one.why, f"it stays above '{other.name}' and varies little"),
            )
            return [made if c is one else c for c in columns]
    return columns


def _feeds(one: Array, other: Array) -> bool:
    """Whether one pressure stays above another and varies little."""
    steady = float(np.nanmin(one)) > 0.0 and _varies_little(one)
    return (
        steady
        and float(np.mean(one >= other)) > CRITERIA.noise.stepwise
        and span(other) > span(one)
    )


def _varies_little(values: Array) -> bool:
    """Whether values span a small part of their mean; those of an empty column do."""
    present = values[np.isfinite(values)]
    return not present.size or span(present) < _SUPPLY_RANGE * float(np.mean(present))


def _valves(columns: list[RecordedColumn]) -> list[RecordedColumn]:
    """Of two signals of valves that do not say which, the first is the inlet's; one alone is too."""
    for kind in ("current", "command"):
        of_kind = {
            c.name: c.meaning for c in columns if c.meaning is not None and c.meaning.kind == kind
        }
        if len(of_kind) > 2:
            continue
        taken = {role for meaning in of_kind.values() for role in meaning.roles}
        left = [role for role in ("inlet", "exhaust") if role not in taken]
        plain = [name for name, meaning in of_kind.items() if not meaning.roles]
        roles = dict(zip(plain, left, strict=False))
        alone = len(of_kind) == 1
        columns = [
            _with_role(c, kind, roles[c.name], alone) if c.name in roles else c for c in columns
        ]
    return columns


def _with_role(column: RecordedColumn, kind: str, role: str, alone: bool) -> RecordedColumn:
    why = (*column.why, _why_valve(role, alone))
    return replace(column, meaning=Meaning(kind, frozenset({role})), why=why)


def _why_valve(role: str, alone: bool) -> str:
    if alone:
        return "the only one: the inlet valve's"
    return f"the {role} valve's, " + (
        "as the first of two" if role == "inlet" else "as the other one is not"
    )
