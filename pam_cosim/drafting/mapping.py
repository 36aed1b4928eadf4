"""From columns of the files to names and units of the bench: entries of ``[columns]``, and the numbers they give."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from math import sqrt

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.bench_choice import BenchChoice, meaning_of
from pam_cosim.drafting.columns import Found
from pam_cosim.drafting.direction import words_of
from pam_cosim.drafting.requests import ReadRecordings
from pam_cosim.drafting.rest import Rest, correlation, noise_of, rests, span
from pam_cosim.drafting.sources import RecordingSource
from pam_cosim.drafting.vocabulary import fits
from pam_cosim.errors import InputError
from pam_cosim.measurement.experiment import RecordingTable
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.units import convert, format_quantity, parse_quantity

_C = CRITERIA.recognition
_REFERABLE = re.compile(r"[^'\\\n]+")
_GRAVITY = "9.80665 m/s2"


@dataclass(frozen=True)
class ColumnEntry:
    """One key of ``[columns]``: ``column``, ``unit``, ``formula`` as stated; ``zero`` in seconds by recording.

    Attributes:
        words: of a direction, up, down or none by the words of the column.
        held: one value for each recording [SI], of which the name of its file tells: no column has it.
        why: what was guessed, in sentences.
    """

    name: str
    column: str | None = None
    unit: str | None = None
    formula: str | None = None
    zero: dict[int, tuple[float, float]] = field(default_factory=dict)
    why: tuple[str, ...] = ()
    words: dict[str, str] = field(default_factory=dict)
    held: dict[int, float] = field(default_factory=dict)


@dataclass(frozen=True)
class MappedRecording:
    """One recording under the bench's names.

    Attributes:
        time: (n,) [s].
        inputs, outputs: (n,) each, in the bench's units.
        rest: where nothing moves, first to last.
    """

    time: Array
    inputs: dict[str, Array]
    outputs: dict[str, Array]
    rest: tuple[Rest, ...]

    @property
    def every(self) -> dict[str, Array]:
        """All of them."""
        return {**self.inputs, **self.outputs}

    @property
    def first_rest(self) -> Rest | None:
        """The rest that it begins with, where it does."""
        return self.rest[0] if self.rest and self.rest[0].start == 0 else None


@dataclass(frozen=True)
class Mapped:
    """Entries by the bench's names, and the recordings under them."""

    entries: dict[str, ColumnEntry]
    courses: tuple[MappedRecording, ...]


def map_columns(choice: BenchChoice, interface: Interface, known: ReadRecordings) -> Mapped:
    """Entries for what is named, signed, scaled or zeroed otherwise than the bench has it."""
    variables = {**interface.inputs, **interface.outputs}
    time = known.time
    entries = {} if time is None else {"time": ColumnEntry("time", time.name, _unit(time), None, {}, time.why)}
    arrays: dict[str, dict[int, Array]] = {}
    for name, column in choice.fed.items():
        entries[name], arrays[name] = _named(name, column, variables[name], interface, known.stated)
        if column.in_names:
            held = {i: float(values[0]) for i, values in arrays[name].items()}
            entries[name] = ColumnEntry(name, why=entries[name].why, held=held)
    for name, formula in known.formulas.items():
        entries[name] = ColumnEntry(name, formula=formula)
    times = {i: _time(i, source, time, known.recording) for i, source in enumerate(known.sources)}
    pressure = _pressure(interface, arrays)
    for name in arrays:
        entries[name], arrays[name] = _signed(entries[name], arrays[name], choice, variables[name], pressure)
    if known.points:
        return Mapped(entries, _courses(interface, times, arrays, moving=False))
    courses = _courses(interface, times, arrays)
    for name in arrays:
        entries[name] = _zeroed(entries[name], name, choice, interface, courses, pressure)
    return Mapped(entries, _courses(interface, times, _less_zero(arrays, entries, times)))


def _unit(column: Found) -> str | None:
    return None if column.stated else column.unit or None


def _named(
    name: str, column: Found, variable: Variable, interface: Interface, stated: Mapping[str, str]
) -> tuple[ColumnEntry, dict[int, Array]]:
    """The entry that renames a column or makes it what the bench calls so, and its numbers."""
    kind = column.meaning.kind if column.meaning else ""
    if kind == "direction":
        return _direction(name, column)
    wanted = meaning_of(variable)
    if wanted and wanted.kind == "contraction" and kind in ("length", "ratio"):
        return _contraction(name, column, interface, stated)
    if kind == "force" and fits(column.unit, "mass"):
        formula = f'{_term(column)} * "{_GRAVITY}"'
        numbers = {
            i: convert(v, column.unit, "kg") * parse_quantity(_GRAVITY, "m/s2") for i, v in column.values.items()
        }
        return ColumnEntry(
            name, formula=formula, why=(*column.why, f"a force in {column.unit}, times gravity")
        ), numbers
    numbers = {i: convert(v, column.unit, variable.unit) for i, v in column.values.items()}
    if column.absolute and kind == "pressure" and _REFERABLE.fullmatch(column.name):
        ambient = f"{_C.ambient / 1e3:g} kPa"
        why = f"its heading says absolute; the ambient is taken as {ambient}"
        formula = f'{_term(column)} - "{ambient}"'
        return ColumnEntry(name, formula=formula, why=(*column.why, why)), {
            i: v - _C.ambient for i, v in numbers.items()
        }
    return ColumnEntry(name, column.name, _unit(column), None, {}, column.why), numbers


def _direction(name: str, column: Found) -> tuple[ColumnEntry, dict[int, Array]]:
    """Words for directions, or a formula that gives 1 and -1."""
    values = {i: np.array([float(column.senses.get(v, 0)) for v in own.tolist()]) for i, own in column.values.items()}
    if column.words:
        return ColumnEntry(name, column.name, None, None, {}, column.why, words_of(column)), values
    if all(number == sense for number, sense in column.senses.items()):
        return ColumnEntry(name, column.name, None, None, {}, column.why), values
    up, down = (next((n for n, s in column.senses.items() if s == sense), None) for sense in (1, -1))
    if up is None or down is None or len(column.senses) > 2:
        hint = f"leave it out: --recording ignore={column.name}"
        raise InputError(f"the values of {column.name} are no directions; {hint}")
    scale, offset = 2.0 / (up - down), -(up + down) / (up - down)
    return ColumnEntry(name, formula=f"{scale:g} * {_term(column)} + ({offset:g})", why=column.why), values


def _contraction(
    name: str, column: Found, interface: Interface, stated: Mapping[str, str]
) -> tuple[ColumnEntry, dict[int, Array]]:
    """A contraction made of a length or of a ratio."""
    rest = _length_at_rest(interface, stated)
    if column.meaning and column.meaning.kind == "ratio":
        value, why = rest or ("1 m", "")
        numbers = {i: convert(v, column.unit, "1") * parse_quantity(value, "m") for i, v in column.values.items()}
        why = f"it is a ratio, times the length at rest, {value}: {why}"
        return ColumnEntry(name, formula=f'{_term(column)} * "{value}"', why=(*column.why, why)), numbers
    lengths = {i: convert(v, column.unit, "m") for i, v in column.values.items()}
    longest = max(float(np.nanmax(v)) for v in lengths.values())
    if rest is not None and rest[1] == "stated":
        value, why = rest
    else:
        value, why = f"{longest:.6g} m", "the longest in any recording"
    full = parse_quantity(value, "m")
    why = f"it is a length: the contraction is what is missing to {value}, {why}"
    return ColumnEntry(name, formula=f'"{value}" - {_term(column)}', why=(*column.why, why)), {
        i: full - v for i, v in lengths.items()
    }


def _length_at_rest(interface: Interface, stated: Mapping[str, str]) -> tuple[str, str] | None:
    """The value of the parameter that is a muscle's length at rest, and where it comes from."""
    name = length_parameter(interface)
    if name is None:
        return None
    if name in stated:
        return stated[name], "stated"
    return f"{interface.parameters[name].start:g} m", f"the bench's default of {name}, state yours and change it here"


def length_parameter(interface: Interface) -> str | None:
    """The parameter that is a muscle's length at rest, by what is said of it."""
    for name, variable in interface.parameters.items():
        said = variable.description.casefold()
        if variable.unit == "m" and "length" in said and any(word in said for word in ("rest", "initial")):
            return name
    return None


def longest_of(choice: BenchChoice) -> float | None:
    """The longest length [m] in any recording of a column that is one; None: there is none."""
    lengths = [c for c in choice.fed.values() if c.of("length") and not c.in_names]
    return max((float(np.nanmax(convert(c.every, c.unit, "m"))) for c in lengths), default=None)


def _term(column: Found) -> str:
    """The column in a formula."""
    name = f"'{column.name}'" if _REFERABLE.fullmatch(column.name) else "value"
    return name if column.stated or not column.unit else f'{name} * "1 {column.unit}"'


def _time(i: int, source: RecordingSource, time: Found | None, recording: RecordingTable) -> Array:
    """(n,) [s]; of points at rest, their numbers."""
    if time is not None:
        return convert(time.values[i], time.unit, "s")
    count = len(next(iter(source.table.columns.values())).values)
    step = 1.0 if recording.interval is None else parse_quantity(recording.interval, "s")
    return np.arange(count, dtype=np.float64) * step


def _pressure(interface: Interface, arrays: Mapping[str, dict[int, Array]]) -> dict[int, Array] | None:
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
    if meaning is None or entry.formula is not None or entry.column is None or not _REFERABLE.fullmatch(entry.column):
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
    return float(np.nanmean(values)) < 0.0 and abs(float(np.nanmin(values))) > abs(float(np.nanmax(values)))


def _courses(
    interface: Interface, times: Mapping[int, Array], arrays: Mapping[str, Mapping[int, Array]], moving: bool = True
) -> tuple[MappedRecording, ...]:
    made = []
    for i, time in times.items():
        inputs = {n: v[i] for n, v in arrays.items() if n in interface.inputs and i in v}
        outputs = {n: v[i] for n, v in arrays.items() if n in interface.outputs and i in v}
        slow = [v for n, v in outputs.items() if not fits(interface.outputs[n].unit, "temperature")]
        made.append(
            MappedRecording(time, inputs, outputs, tuple(rests(time, [*inputs.values(), *slow])) if moving else ())
        )
    return tuple(made)


def _zeroed(
    entry: ColumnEntry,
    name: str,
    choice: BenchChoice,
    interface: Interface,
    courses: Sequence[MappedRecording],
    pressure: dict[int, Array] | None,
) -> ColumnEntry:
    """The entry with a zero from the rest that every recording begins with, where it is away from zero there."""
    variable = {**interface.inputs, **interface.outputs}[name]
    meaning = meaning_of(variable)
    having = [i for i, course in enumerate(courses) if name in course.every]
    if meaning is None or any(courses[i].first_rest is None for i in having):
        return entry
    begin = _begin(name, [courses[i] for i in having])
    reading = format_quantity(begin.reading, variable.unit)
    why = ""
    if meaning.kind == "pressure" and not meaning.roles:
        if begin.absolute:
            why = f"it begins with {reading}, as a gauge of absolute pressure does"
        elif begin.far and begin.slight:
            why = f"it begins at rest with {reading}"
    elif name in choice.outputs and begin.far and _unloaded(courses, pressure, having):
        small = abs(begin.reading) <= _C.offset * begin.largest
        if meaning.kind == "contraction" or (meaning.kind == "force" and small):
            why = f"it begins at rest, without pressure, with {reading}"
    if not why:
        return entry
    zero = _common({i: _times(courses[i]) for i in having}, courses)
    return ColumnEntry(entry.name, entry.column, entry.unit, entry.formula, zero, (*entry.why, f"{why}: its zero"))


@dataclass(frozen=True)
class _Begin:
    """What a signal reads while recordings rest at their beginning.

    Attributes:
        reading: the one farthest from zero.
        far: it is away from zero by more than its error, in some recording.
        slight: by a small part of what the signal moves, in all.
        absolute: it is that of the atmosphere in all, and the signal moves.
        largest: magnitude in any row.
    """

    reading: float
    far: bool
    slight: bool
    absolute: bool
    largest: float


def _begin(name: str, courses: Sequence[MappedRecording]) -> _Begin:
    at_rest = [_at_rest(course, course.every[name]) for course in courses]
    moved = max((span(course.every[name]) for course in courses), default=0.0)
    low, high = _C.atmosphere
    return _Begin(
        reading=max(at_rest, key=abs),
        far=any(abs(one) > _C.away * _error(course, name) for one, course in zip(at_rest, courses, strict=True)),
        slight=all(abs(one) <= _C.offset * moved for one in at_rest),
        absolute=moved > 0.0 and all(low <= one <= high for one in at_rest),
        largest=max((float(np.nanmax(np.abs(course.every[name]))) for course in courses), default=0.0),
    )


def _at_rest(course: MappedRecording, values: Array) -> float:
    assert course.first_rest is not None
    part = values[course.first_rest.start : course.first_rest.stop]
    return float(np.nanmean(part)) if np.isfinite(part).any() else 0.0


def _error(course: MappedRecording, name: str) -> float:
    """Of a mean at rest [unit]; at least what is not seen."""
    values = course.every[name]
    assert course.first_rest is not None
    return max(noise_of(course.time, values) / sqrt(course.first_rest.count), _C.still * span(values) / _C.away)


def _unloaded(courses: Sequence[MappedRecording], pressure: dict[int, Array] | None, having: Sequence[int]) -> bool:
    """Whether there is no pressure at the start of any of them, but for an offset."""
    if pressure is None:
        return False
    largest = max(span(pressure[i]) for i in having if i in pressure) if any(i in pressure for i in having) else 0.0
    low = [_at_rest(courses[i], pressure[i] - np.nanmin(pressure[i])) for i in having if i in pressure]
    return bool(low) and largest > 0.0 and all(value <= _C.unloaded * largest for value in low)


def _times(course: MappedRecording) -> tuple[float, float]:
    rest = course.first_rest
    assert rest is not None
    return float(course.time[rest.start]), float(course.time[rest.stop - 1])


def _common(each: dict[int, tuple[float, float]], courses: Sequence[MappedRecording]) -> dict[int, tuple[float, float]]:
    """One interval for all recordings, where their rests have enough samples in common."""
    start, stop = max(one for one, _ in each.values()), min(one for _, one in each.values())
    inside = [int(np.sum((courses[i].time >= start) & (courses[i].time <= stop))) for i in each]
    return dict.fromkeys(each, (start, stop)) if min(inside) >= CRITERIA.noise.fewest_samples else each


def _less_zero(
    arrays: Mapping[str, dict[int, Array]], entries: Mapping[str, ColumnEntry], times: Mapping[int, Array]
) -> dict[str, dict[int, Array]]:
    made = {}
    for name, values in arrays.items():
        zero = entries[name].zero
        made[name] = {i: v - _mean_between(times[i], v, *zero[i]) if i in zero else v for i, v in values.items()}
    return made


def _mean_between(time: Array, values: Array, start: float, stop: float) -> float:
    inside = values[(time >= start) & (time <= stop)]
    inside = inside[np.isfinite(inside)]
    return float(np.mean(inside)) if inside.size else 0.0
