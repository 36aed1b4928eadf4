"""From columns of the files to names and units of the bench: entries of ``[columns]``, and the numbers they give."""

from __future__ import annotations

import re
from collections.abc import Mapping

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.bench_choice import BenchChoice, meaning_of
from pam_cosim.drafting.direction import words_of
from pam_cosim.drafting.mapped import ColumnEntry, Mapped, MappedRecording
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.requests import ReadRecordings
from pam_cosim.drafting.rest import correlation, rests
from pam_cosim.drafting.sources import RecordingSource
from pam_cosim.drafting.vocabulary import fits
from pam_cosim.drafting.zeros import with_zero, without_offsets
from pam_cosim.errors import InputError
from pam_cosim.measurement.experiment_tables import RecordingTable
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.units import convert, parse_quantity

_C = CRITERIA.recognition
_REFERABLE = re.compile(r"[^'\\\n]+")
_GRAVITY = "9.80665 m/s2"


def map_columns(choice: BenchChoice, interface: Interface, known: ReadRecordings) -> Mapped:
    """Entries for what is named, signed, scaled or zeroed otherwise than the bench has it."""
    variables = {**interface.inputs, **interface.outputs}
    entries: dict[str, ColumnEntry] = {}
    if known.time is not None:
        entries["time"] = ColumnEntry(
            "time", known.time.name, _unit(known.time), why=known.time.why
        )
    arrays: dict[str, dict[int, Array]] = {}
    for name, column in choice.fed.items():
        entries[name], arrays[name] = _named(name, column, variables[name], interface, known.stated)
        if column.in_names:
            held = {i: float(values[0]) for i, values in arrays[name].items()}
            entries[name] = ColumnEntry(name, why=entries[name].why, held=held)
    for name, formula in known.formulas.items():
        entries[name] = ColumnEntry(name, formula=formula)
    times = {
        i: _time(i, source, known.time, known.recording) for i, source in enumerate(known.sources)
    }
    pressure = _pressure(interface, arrays)
    for name in arrays:
        entries[name], arrays[name] = _signed(
            entries[name], arrays[name], choice, variables[name], pressure
        )
    courses = _courses(interface, times, arrays, moving=not known.points)
    if known.points:
        return Mapped(entries, courses)
    for name in arrays:
        entries[name] = with_zero(entries[name], name, choice, interface, courses, pressure)
    return Mapped(entries, _courses(interface, times, without_offsets(arrays, entries, times)))


def _unit(column: RecordedColumn) -> str | None:
    return None if column.stated else column.unit or None


def _named(
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
    if column.absolute and kind == "pressure" and _REFERABLE.fullmatch(column.name):
        return _gauge_pressure(name, column, numbers)
    return ColumnEntry(name, column.name, _unit(column), why=column.why), numbers


def _weight(name: str, column: RecordedColumn) -> tuple[ColumnEntry, dict[int, Array]]:
    """A force that was recorded as a mass."""
    gravity = parse_quantity(_GRAVITY, "m/s2")
    numbers = {i: convert(v, column.unit, "kg") * gravity for i, v in column.values.items()}
    why = (*column.why, f"a force in {column.unit}, times gravity")
    return ColumnEntry(name, formula=f'{_term(column)} * "{_GRAVITY}"', why=why), numbers


def _gauge_pressure(
    name: str, column: RecordedColumn, numbers: dict[int, Array]
) -> tuple[ColumnEntry, dict[int, Array]]:
    """A gauge pressure that was recorded as an absolute one [Pa]."""
    ambient = f"{_C.ambient / 1e3:g} kPa"
    why = (*column.why, f"its heading says absolute; the ambient is taken as {ambient}")
    entry = ColumnEntry(name, formula=f'{_term(column)} - "{ambient}"', why=why)
    return entry, {i: v - _C.ambient for i, v in numbers.items()}


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
    up, down = (
        next((n for n, s in column.senses.items() if s == sense), None) for sense in (1, -1)
    )
    if up is None or down is None or len(column.senses) > 2:
        hint = f"leave it out: --recording ignore={column.name}"
        raise InputError(f"the values of {column.name} are no directions; {hint}")
    scale, offset = 2.0 / (up - down), -(up + down) / (up - down)
    return ColumnEntry(
        name, formula=f"{scale:g} * {_term(column)} + ({offset:g})", why=column.why
    ), values


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
        return ColumnEntry(
            name, formula=f'{_term(column)} * "{value}"', why=(*column.why, why)
        ), numbers
    lengths = {i: convert(v, column.unit, "m") for i, v in column.values.items()}
    longest = max(float(np.nanmax(v)) for v in lengths.values())
    value, source = f"{longest:.6g} m", "the longest in any recording"
    if at_rest is not None and at_rest[1] == "stated":
        value, source = at_rest
    length = parse_quantity(value, "m")
    why = f"it is a length: the contraction is what is missing to {value}, {source}"
    entry = ColumnEntry(name, formula=f'"{value}" - {_term(column)}', why=(*column.why, why))
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
        if (
            variable.unit == "m"
            and "length" in said
            and any(word in said for word in ("rest", "initial"))
        ):
            return name
    return None


def longest_of(choice: BenchChoice) -> float | None:
    """The longest length [m] in any recording of a column that is one; None: there is none."""
    lengths = [c for c in choice.fed.values() if c.of("length") and not c.in_names]
    return max((float(np.nanmax(convert(c.every, c.unit, "m"))) for c in lengths), default=None)


def _term(column: RecordedColumn) -> str:
    """The column in a formula."""
    name = f"'{column.name}'" if _REFERABLE.fullmatch(column.name) else "value"
    return name if column.stated or not column.unit else f'{name} * "1 {column.unit}"'


def _time(
    i: int, source: RecordingSource, time: RecordedColumn | None, recording: RecordingTable
) -> Array:
    """(n,) [s]; of points at rest, their numbers."""
    if time is not None:
        return convert(time.values[i], time.unit, "s")
    count = len(next(iter(source.table.columns.values())).values)
    step = 1.0 if recording.interval is None else parse_quantity(recording.interval, "s")
    return np.arange(count, dtype=np.float64) * step


def _pressure(
    interface: Interface, arrays: Mapping[str, dict[int, Array]]
) -> dict[int, Array] | None:
    """The pressure in the muscle, or the one it is told."""
    variables = {**interface.inputs, **interface.outputs}
    for roles in (frozenset[str](), frozenset({"set"})):
        for name in arrays:
            meaning = meaning_of(variables[name])
            if meaning is not None and (meaning.kind, meaning.roles) == ("pressure", roles):
                return arrays[name]
    return None


def _signed(
    entry: ColumnEntry,
    values: dict[int, Array],
    choice: BenchChoice,
    variable: Variable,
    pressure: dict[int, Array] | None,
) -> tuple[ColumnEntry, dict[int, Array]]:
    """A contraction that falls while the pressure rises counts the other way, as does a pull below zero."""
    meaning = meaning_of(variable)
    if (
        meaning is None
        or entry.formula is not None
        or entry.column is None
        or not _REFERABLE.fullmatch(entry.column)
    ):
        return entry, values
    why = ""
    if meaning.kind == "contraction" and variable.name in choice.outputs and pressure is not None:
        if correlation(pressure, values) < -_C.follows:
            why = "it falls where the pressure rises: its sign is turned round"
    elif meaning.kind == "force" and _mostly_negative(np.concatenate(list(values.values()))):
        why = "it is below zero: its sign is turned round, so that a pull is positive"
    if not why:
        return entry, values
    scale = f' * "1 {entry.unit}"' if entry.unit else ""
    turned = ColumnEntry(entry.name, formula=f"-'{entry.column}'{scale}", why=(*entry.why, why))
    return turned, {i: -v for i, v in values.items()}


def _mostly_negative(values: Array) -> bool:
    """Whether values are below zero on average, and farther below than above."""
    return float(np.nanmean(values)) < 0.0 and abs(float(np.nanmin(values))) > abs(
        float(np.nanmax(values))
    )


def _courses(
    interface: Interface,
    times: Mapping[int, Array],
    arrays: Mapping[str, Mapping[int, Array]],
    moving: bool = True,
) -> tuple[MappedRecording, ...]:
    """The recordings; ``moving``: over time, so that they may rest."""
    made = []
    for i, time in times.items():
        inputs = {n: v[i] for n, v in arrays.items() if n in interface.inputs and i in v}
        outputs = {n: v[i] for n, v in arrays.items() if n in interface.outputs and i in v}
        quick = [
            v for n, v in outputs.items() if not fits(interface.outputs[n].unit, "temperature")
        ]
        at_rest = rests(time, [*inputs.values(), *quick]) if moving else []
        made.append(MappedRecording(time, inputs, outputs, tuple(at_rest)))
    return tuple(made)
