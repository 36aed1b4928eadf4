"""Which column of the recordings is the time, and in which unit; tables without one may hold points at rest."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.clock_columns import difference
from pam_cosim.drafting.column_statistics import span
from pam_cosim.drafting.further_clocks import SeveralClocks
from pam_cosim.drafting.recorded_column import RecordedColumn, with_usual_unit
from pam_cosim.drafting.sources import RecordingSource
from pam_cosim.drafting.vocabulary import Meaning, fits, says_time
from pam_cosim.drafting.words import (
    DAYS,
    SHORTEST_RECORDING,
    SHORTEST_STEP,
    USUAL_EPOCHS,
    USUAL_STEPS,
)
from pam_cosim.errors import InputError
from pam_cosim.measurement.cell_kinds import EXAMPLE
from pam_cosim.measurement.experiment_tables import RecordingTable
from pam_cosim.measurement.wrapped_clocks import LONGEST_STEP
from pam_cosim.units import seconds
from pam_cosim.wording import did_you_mean, listed, shown

_MOST_POINTS = 2000  # rows of a static table, which limits the run time

NO_UNIT = "no unit is written"
_LABVIEW = re.compile(r"x[ _]?values?([ _.]?\d+)?", re.IGNORECASE)


def with_time(
    columns: list[RecordedColumn], asked: str | None, sources: Sequence[RecordingSource]
) -> list[RecordedColumn]:
    """The columns with one of time at most, and its unit.

    Raises:
        InputError: the column that is asked for is in no file; a second clock that runs differently.
    """
    wanted, why = _likely_time(columns) if asked is None else _asked_time(columns, asked)
    if wanted is None:
        return columns
    unit, more = _known_unit_of_time(wanted)
    made = replace(wanted, meaning=Meaning("time"), unit=unit, why=(*why, *more))
    clocks = [c.name for c in columns if c.name == wanted.name or (_is_clock(c) and _rises(c))]
    return [
        made
        if c.name == wanted.name
        else _beside(made, c, sources, columns, clocks)
        if _is_clock(c)
        else c
        for c in columns
    ]


def _is_clock(column: RecordedColumn) -> bool:
    return column.of("time") or bool(_LABVIEW.fullmatch(column.name) and _runs(column))


def _known_unit_of_time(column: RecordedColumn) -> tuple[str, tuple[str, ...]]:
    """The unit of a column of time, and why; none, where one is written that nobody knows."""
    if column.unknown:
        return "", column.why
    is_known = column.unit and fits(column.unit, "time")
    return (column.unit, _why_known(column)) if is_known else _unit_of_time(column)


def _beside(
    time: RecordedColumn,
    column: RecordedColumn,
    sources: Sequence[RecordingSource],
    columns: Sequence[RecordedColumn],
    clocks: Sequence[str],
) -> RecordedColumn:
    """A clock beside the one that is the time.

    Raises:
        SeveralClocks: it runs differently, so that columns may belong to either.
    """
    if not _rises(column) or time.values.keys().isdisjoint(column.values):
        return _no_time(column)
    unit = _known_unit_of_time(column)[0]
    late = difference(time.values, time.unit, column.values, unit)
    if late is None:
        source = sources[min(column.values)]
        keep = f"leave it out, --recording 'ignore={column.name}', where all columns belong to the first"
        apart = (
            f"name the file once more under [[runs.loggers]], with what belongs to it; or {keep}"
        )
        message = f"it runs otherwise than {shown(time.name)}: two clocks in one file; {apart}"
        other = replace(column, unit=unit)
        line = source.table.header_line
        raise SeveralClocks(message, source.file, line, time, other, columns, clocks)
    away = ""
    if late and not (column.since or time.since):
        away = f", {abs(late):.4g} s {'later' if late > 0.0 else 'earlier'}"
    return replace(column, meaning=None, why=(f"it runs with {shown(time.name)}, the time{away}",))


def _why_known(column: RecordedColumn) -> tuple[str, ...]:
    """Why a column whose unit is known is the time."""
    if not column.since:
        return column.why
    return (f"it holds dates, which count in seconds from the first, {column.since}",)


def _asked_time(
    columns: Sequence[RecordedColumn], asked: str
) -> tuple[RecordedColumn, tuple[str, ...]]:
    """The column that the user names.

    Raises:
        InputError: there is none of that name.
    """
    wanted = next((c for c in columns if c.name == asked), None)
    if wanted is None:
        raise InputError(
            f"no file has a column {shown(asked)}; {did_you_mean(asked, [c.name for c in columns])}"
        )
    return wanted, ()


def _likely_time(
    columns: Sequence[RecordedColumn],
) -> tuple[RecordedColumn | None, tuple[str, ...]]:
    """The column that is called time and rises; one that runs as a clock does; one that is called so all the same."""
    called = [c for c in columns if c.of("time")]
    rising = [c for c in called if _rises(c)]
    if rising:  # a date may be written no finer than in seconds
        return max(rising, key=lambda c: (not c.since, c.known)), ()
    labview = next((c for c in columns if _LABVIEW.fullmatch(c.name) and _runs(c)), None)
    if labview is not None and not any(one.unit.strip() for one in labview.places.values()):
        return labview, ("LabVIEW calls the time so, and its numbers rise from row to row",)
    running = next(
        (
            c
            for c in columns
            if c.meaning is None and _runs(c) and (not c.unit or fits(c.unit, "time"))
        ),
        None,
    )
    if running is not None:
        return running, ("its numbers rise from row to row",)
    return (called[0] if called else None), ()  # Its fault is told when it is read.


def _no_time(column: RecordedColumn) -> RecordedColumn:
    """Beside a column of time, a capital T is a temperature."""
    if column.name.strip() != "T" or column.unit:
        return replace(column, meaning=None, why=("another column is the time",))
    return with_usual_unit(
        replace(column, meaning=Meaning("temperature"), why=("another column is the time",))
    )


def _rises(column: RecordedColumn) -> bool:
    recordings = list(column.values.values())
    return bool(recordings) and all(map(_grows, recordings))


def _grows(values: Array) -> bool:
    """Whether no value is less than one before it; a column that is shorter than others has empty cells."""
    known = values[np.isfinite(values)]
    return known.size > 1 and bool((np.diff(known) >= 0).all()) and bool(known[-1] > known[0])


def _runs(column: RecordedColumn) -> bool:
    """Whether numbers of which nobody knows what they are rise in every row, and about evenly: as a clock does."""
    steps = [np.diff(one) for one in column.values.values() if len(one) > 1]
    return bool(steps) and all(
        bool((one > 0.0).all()) and float(one.max()) <= LONGEST_STEP * float(np.median(one))
        for one in steps
    )


def _unit_of_time(column: RecordedColumn) -> tuple[str, tuple[str, ...]]:
    """``ms`` to ``ns`` of a long recording whose numbers are whole, days of a spreadsheet, else ``s``; and why."""
    steps = np.concatenate([np.diff(one) for one in column.values.values()] or [np.empty(0)])
    known = steps[np.isfinite(steps)]
    step = float(np.median(known)) if known.size else 0.0
    whole = bool((column.every == np.round(column.every)).all())
    longest = max((len(one) for one in column.values.values()), default=0)
    first = float(column.every[0]) if column.every.size else 0.0
    unit = "s"
    if whole and longest >= CRITERIA.noise.fewest_samples:
        unit = _first_above(abs(first), USUAL_EPOCHS) or _first_above(step, USUAL_STEPS)
    elif 0.0 < step < SHORTEST_STEP and (DAYS[0] <= first <= DAYS[1] or _is_too_short(column)):
        unit = "d"
    return unit, (f"{NO_UNIT}; steps of {step:.4g} are taken as {unit}",)


def _is_too_short(column: RecordedColumn) -> bool:
    """Whether numbers are parts of a day that last no time, if they were seconds."""
    within = all(one[0] >= 0.0 and one[-1] < 1.0 for one in column.values.values())
    return within and max(map(span, column.values.values())) < SHORTEST_RECORDING


def _first_above(number: float, table: Sequence[tuple[float, str]]) -> str:
    return next((unit for most, unit in table if number < most), "")


def check_time(
    columns: Sequence[RecordedColumn], sources: Sequence[RecordingSource], recording: RecordingTable
) -> RecordedColumn | None:
    """The column of time; None where an interval is stated instead, or the files are tables of points at rest.

    Raises:
        InputError: there is neither.
    """
    time = next((c for c in columns if c.of("time")), None)
    if recording.interval is not None:
        seconds(recording.interval.value)
        return None
    if time is None and may_be_points(columns, sources):
        _check_no_clock(sources)
        _check_no_empty_time(columns, sources)
        return None
    for i, source in enumerate(sources):
        if time is None:
            raise InputError(_no_time_among(source), source.file, source.table.header_line)
        if i not in time.values:
            first = sources[min(time.values)]
            raise InputError(
                _other_columns(first, source, time), source.file, source.table.header_line
            )
    return time


def _check_no_clock(sources: Sequence[RecordingSource]) -> None:
    """Raises InputError where rows have times of day that are not read: they may be no points at rest.

    Where time is known, or the user leaves them out, nothing hangs on them.
    """
    for source in sources:
        if source.clocks:
            name = source.clocks[0]
            read = f"a time of day is read beside its date, as {shown(EXAMPLE)}; write it so"
            raise InputError(
                f"this text says when each row was taken, and no other column is the time; {read}, {_otherwise(name)}",
                source.file,
                source.table.header_line,
                name,
            )


def _check_no_empty_time(
    columns: Sequence[RecordedColumn], sources: Sequence[RecordingSource]
) -> None:
    """Raises InputError where a column is called time and is empty: its rows may be no points at rest."""
    for column in columns:
        if not column.values and column.places and _is_called_time(column.name):
            source = sources[min(column.places)]
            raise InputError(
                f"it is called as the time is, and has no value in any row; {_otherwise(column.name)}",
                source.file,
                source.table.header_line,
                column.name,
            )


def _otherwise(name: str) -> str:
    """What to say where a column of that name is not read as the time."""
    even = "say --recording interval='1 ms' where rows are evenly apart"
    return f"{even}, or --recording 'ignore={name}' where each row is a point at rest"


def _is_called_time(name: str) -> bool:
    """Whether a heading can only be that of the time; a T may be a temperature."""
    return (name != "T" and says_time(name)) or bool(_LABVIEW.fullmatch(name))


def _no_time_among(source: RecordingSource) -> str:
    """What to say of a file in which nothing is the time."""
    hint = "say which by --column time=NAME, or --recording interval='1 ms' where rows are evenly apart"
    dates = (
        f"; {shown(source.clocks[0])} is text: dates are read as {EXAMPLE}" if source.clocks else ""
    )
    return f"there is no column of time among {listed(source.table.columns)}{dates}; {hint}"


def _other_columns(first: RecordingSource, source: RecordingSource, time: RecordedColumn) -> str:
    """What to say of a file that lacks the column that is the time in another one."""
    if time.name in source.table.columns:
        return f"the column {shown(time.name)} of time has no value"
    here, there = listed(source.table.columns), listed(first.table.columns)
    hint = "files with the same columns are drafted together, others into a data set of their own"
    return (
        f"it has no column {shown(time.name)}, which is the time in {first.file.name}: its columns are {here}, "
        f"those of {first.file.name} {there}; {hint}"
    )


def may_be_points(columns: Sequence[RecordedColumn], sources: Sequence[RecordingSource]) -> bool:
    """Whether tables without time are of points at rest: so few rows that somebody waited for each, and no valve."""
    kinds = {c.meaning.kind for c in columns if c.meaning is not None}
    is_driven = bool(kinds & {"command", "current"})
    has_pressure = any(c.of("pressure") or c.of("pressure", "set") for c in columns)
    rows = max(len(next(iter(s.table.columns.values())).values) for s in sources)
    return has_pressure and not is_driven and rows <= _MOST_POINTS
