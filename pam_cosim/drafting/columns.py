"""The columns of all recordings, and what each is: by its words, its unit, and what its numbers look like."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.rest import is_constant, is_held, is_switch, span
from pam_cosim.drafting.sources import RecordingSource
from pam_cosim.drafting.vocabulary import Meaning, fits, read_heading, usual_unit
from pam_cosim.errors import InputError
from pam_cosim.measurement.curves import levels
from pam_cosim.measurement.experiment import RecordingTable
from pam_cosim.measurement.table import Column
from pam_cosim.units import seconds
from pam_cosim.wording import did_you_mean, listed, shown

_C = CRITERIA.recognition

_MOST = 400  # columns; each is held against each


@dataclass(frozen=True)
class Found:
    """A column of that name in every recording that has it.

    Attributes:
        unit: as the registry of units has it; stated in the file, or guessed.
        stated: the file states it so that it can be read.
        meaning: None: nobody knows.
        why: what ``meaning`` and ``unit`` were guessed from, in sentences without a subject.
        known: share of its words that are known.
        values: numbers in its unit by the number of the recording.
        points: the recordings are points at rest, whose rows have no pace.
        in_names: it stands in the names of the files, one value for each.
        words: of a direction that is told in words: what its numbers are places of.
        senses: of a direction: 1 up, -1 down, 0 neither, by its numbers.
    """

    name: str
    unit: str
    stated: bool
    meaning: Meaning | None
    values: dict[int, Array]
    why: tuple[str, ...] = ()
    absolute: bool = False
    known: float = 0.0
    places: dict[int, Column] = field(default_factory=dict)
    points: bool = False
    in_names: bool = False
    words: tuple[str, ...] = ()
    senses: dict[float, int] = field(default_factory=dict)

    @property
    def every(self) -> Array:
        """All its numbers."""
        return np.concatenate([*self.values.values(), np.empty(0)])

    @cached_property
    def held(self) -> bool:
        """It hardly moves within runs beside what it does between them, or steps from one value to another.

        Of points at rest, it takes few values.
        """
        if self.points:
            return all(levels(one[np.isfinite(one)]) is not None for one in self.values.values())
        whole = span(self.every)
        own = max(span(one) for one in self.values.values())
        return (
            whole == 0.0
            or own <= _C.imposed * whole
            or all(is_held(one) or is_constant(one) for one in self.values.values())
        )

    @cached_property
    def whole(self) -> bool:
        """It lacks so few samples that it may be meant as an input."""
        return float(np.mean(np.isnan(self.every))) <= _C.gaps

    def text_of(self, value: float) -> str:
        """One of its numbers, or the word that it stands for."""
        return shown(self.words[int(value)]) if self.words else f"{value:g}"

    def of(self, kind: str, *roles: str) -> bool:
        """Whether it is of a kind, with just these roles."""
        return self.meaning == Meaning(kind, frozenset(roles))


def find_columns(sources: Sequence[RecordingSource], asked: Mapping[str, str]) -> list[Found]:
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
    columns = _time(_valves(_supply(columns)), sources, asked.get("time"))
    _check_alike(columns, sources)
    return columns


def _check_alike(columns: Sequence[Found], sources: Sequence[RecordingSource]) -> None:
    """Raises InputError where recordings call the same quantity by different names: one would be lost."""
    for one in columns:
        for other in columns:
            if one.meaning is not None and one.meaning == other.meaning and not one.values.keys() & other.values.keys():
                there, here = sources[min(one.values)].file.name, sources[min(other.values)].file
                message = f"{there} calls the {one.meaning} {shown(one.name)}; files of one kind are drafted together"
                raise InputError(message, here, None, other.name)


def _found(name: str, sources: Sequence[RecordingSource]) -> Found:
    places = {i: s.table.columns[name] for i, s in enumerate(sources) if name in s.table.columns}
    first = next(iter(places.values()))
    alike = all(column.unit == first.unit for column in places.values())
    reading = read_heading(name, first.unit)
    one = Found(
        name,
        reading.unit,
        reading.written and alike,
        reading.meaning,
        {i: column.values for i, column in places.items() if np.isfinite(column.values).any()},
        absolute=reading.absolute,
        known=reading.known,
        places=places,
    )
    if not alike:
        raise _two_units(name, places, sources)
    if not one.values:
        return replace(one, meaning=None, why=("it is empty",))
    words = next((s.words[h] for s in sources for h in (name, first.heading) if h in s.words), ())
    if words:
        return replace(one, meaning=Meaning("direction"), words=words, unit="", stated=True)
    if one.meaning is None:
        return one
    if reading.known == 0.0:
        one = replace(one, why=(f"its unit is {reading.unit}",))
    if not reading.unit:
        return _with_unit(one)
    if not one.stated:
        one = replace(one, why=(*one.why, f"unit {reading.unit} by its name"))
    return one


def _two_units(name: str, places: Mapping[int, Column], sources: Sequence[RecordingSource]) -> InputError:
    first = min(places)
    other = next(i for i, column in places.items() if column.unit != places[first].unit)
    there, here = (shown(places[i].unit) for i in (first, other))
    message = f"its unit is {there} in {sources[first].file.name} and {here} here; draft data sets of their own"
    return InputError(message, sources[other].file, None, name)


def _with_unit(one: Found) -> Found:
    """A column without a unit, which its numbers suggest."""
    assert one.meaning is not None
    kind = one.meaning.kind
    if kind == "current" and is_switch(one.every):
        one = replace(one, meaning=Meaning("command", one.meaning.roles), why=(*one.why, "it has two values"))
        kind = "command"
    if kind == "time":
        return one
    if kind == "voltage":
        return replace(one, meaning=None)
    largest = float(np.nanmax(np.abs(one.every))) if np.isfinite(one.every).any() else 0.0
    unit = usual_unit(kind, largest)
    why = f"no unit is written; numbers up to {largest:.4g} are taken as {unit}" if unit else ""
    return replace(one, unit=unit, why=(*one.why, why) if why else one.why)


def _supply(columns: list[Found]) -> list[Found]:
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
            made = replace(one, meaning=meaning, why=(*one.why, f"it stays above '{other.name}' and varies little"))
            return [made if c is one else c for c in columns]
    return columns


def _feeds(one: Array, other: Array) -> bool:
    """Whether one pressure stays above another and varies little."""
    steady = float(np.nanmin(one)) > 0.0 and span(one) < _C.steady * float(np.nanmean(one))
    return steady and float(np.mean(one >= other)) > _C.held and span(other) > span(one)


def _valves(columns: list[Found]) -> list[Found]:
    """Of two signals of valves that do not say which, the first is the inlet's; one alone is too."""
    for kind in ("current", "command"):
        of_kind = [c for c in columns if c.meaning is not None and c.meaning.kind == kind]
        if len(of_kind) > 2:
            continue
        taken = {role for c in of_kind if c.meaning for role in c.meaning.roles}
        left = [role for role in ("inlet", "exhaust") if role not in taken]
        for column, role in zip([c for c in of_kind if c.of(kind)], left, strict=False):
            made = replace(column, meaning=Meaning(kind, frozenset({role})))
            made = replace(made, why=(*column.why, _why_valve(role, alone=len(of_kind) == 1)))
            columns = [made if c is column else c for c in columns]
    return columns


def _why_valve(role: str, alone: bool) -> str:
    if alone:
        return "the only one: the inlet valve's"
    return f"the {role} valve's, " + ("as the first of two" if role == "inlet" else "as the other one is not")


def _time(columns: list[Found], sources: Sequence[RecordingSource], asked: str | None) -> list[Found]:
    """The columns with one of time at most, and its unit."""
    wanted, why = _likely_time(columns) if asked is None else _asked_time(columns, asked)
    rest = [_no_time(c) if c.of("time") else c for c in columns]
    if wanted is None:
        return rest
    unit, more = (wanted.unit, wanted.why) if wanted.unit and fits(wanted.unit, "time") else _unit_of_time(wanted)
    made = replace(wanted, meaning=Meaning("time"), unit=unit, why=(*why, *more))
    return [made if c.name == wanted.name else c for c in rest]


def _asked_time(columns: Sequence[Found], asked: str) -> tuple[Found, tuple[str, ...]]:
    """The column that the user names.

    Raises:
        InputError: there is none of that name.
    """
    wanted = next((c for c in columns if c.name == asked), None)
    if wanted is None:
        raise InputError(f"no file has a column {shown(asked)}; {did_you_mean(asked, [c.name for c in columns])}")
    return wanted, wanted.why


def _likely_time(columns: Sequence[Found]) -> tuple[Found | None, tuple[str, ...]]:
    """The column that is called time and rises; one that runs as a clock does; one that is called so all the same."""
    called = [c for c in columns if c.of("time")]
    rising = [c for c in called if _rises(c)]
    if rising:
        return max(rising, key=lambda c: c.known), ()
    running = next((c for c in columns if c.meaning is None and _runs(c) and _fits_time(c)), None)
    if running is not None:
        return running, ("its numbers rise from row to row",)
    return (called[0] if called else None), ()  # Its fault is told when it is read.


def _no_time(column: Found) -> Found:
    """Beside a column of time, a capital T is a temperature."""
    if column.name.strip() != "T" or column.unit:
        return replace(column, meaning=None, why=())
    return _with_unit(replace(column, meaning=Meaning("temperature"), why=("another column is the time",)))


def _fits_time(column: Found) -> bool:
    return not column.unit or fits(column.unit, "time")


def _rises(column: Found) -> bool:
    return bool(column.values) and all(
        len(one) > 1 and bool((np.diff(one) >= 0).all()) and one[-1] > one[0] for one in column.values.values()
    )


def _runs(column: Found) -> bool:
    """Whether numbers of which nobody knows what they are rise in every row, and about evenly: as a clock does."""
    steps = [np.diff(one) for one in column.values.values() if len(one) > 1]
    return bool(steps) and all(
        bool((one > 0.0).all()) and float(one.max()) <= _C.uneven * float(np.median(one)) for one in steps
    )


def _unit_of_time(column: Found) -> tuple[str, tuple[str, ...]]:
    steps = np.concatenate([np.diff(one) for one in column.values.values()] or [np.empty(0)])
    step = float(np.median(steps[np.isfinite(steps)])) if np.isfinite(steps).any() else 0.0
    whole = bool((column.every == np.round(column.every)).all())
    unit = (
        "ms"
        if whole and max((len(one) for one in column.values.values()), default=0) >= CRITERIA.noise.fewest_samples
        else "s"
    )
    return unit, (f"no unit is written; steps of {step:.4g} are taken as {unit}",)


def check_time(columns: Sequence[Found], sources: Sequence[RecordingSource], recording: RecordingTable) -> Found | None:
    """The column of time; None where an interval is stated instead, or the files are tables of points at rest.

    Raises:
        InputError: there is neither.
    """
    time = next((c for c in columns if c.of("time")), None)
    if recording.interval is not None:
        seconds(recording.interval)
        return None
    if time is None and may_be_points(columns, sources):
        return None
    for i, source in enumerate(sources):
        if time is None or i not in time.values:
            hint = "say which by --column time=NAME, or --recording interval='1 ms' where rows are evenly apart"
            texts = f"; {listed(map(shown, source.texts))} is text, dates are not read" if source.texts else ""
            message = f"there is no column of time among {listed(source.table.columns)}{texts}; {hint}"
            raise InputError(message, source.file, source.table.header_line)
    return time


def may_be_points(columns: Sequence[Found], sources: Sequence[RecordingSource]) -> bool:
    """Whether tables without time are of points at rest: so few rows that somebody waited for each, and no valve."""
    driven = any(c.meaning is not None and c.meaning.kind in ("command", "current") for c in columns)
    rows = max(len(next(iter(s.table.columns.values())).values) for s in sources)
    return not driven and rows <= _C.most_points and any(c.of("pressure") or c.of("pressure", "set") for c in columns)
