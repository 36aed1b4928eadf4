"""Which column of the recordings is the time, and in which unit; further clocks; tables without one hold points."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from math import inf

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.columns import NO_UNIT, UNNAMED, RecordedColumn, with_usual_unit
from pam_cosim.drafting.headings import PRESSURE, SET_PRESSURE, UNKNOWN, Headings, alike, meant
from pam_cosim.drafting.recordings import Source
from pam_cosim.drafting.shapes import is_held, span
from pam_cosim.errors import InputError
from pam_cosim.measurement.cell_kinds import EXAMPLE
from pam_cosim.measurement.experiment_tables import RecordingTable
from pam_cosim.measurement.pieces import usual_step
from pam_cosim.measurement.table import Column, Table
from pam_cosim.measurement.wrapped_clocks import LONGEST_STEP
from pam_cosim.units import convert, seconds
from pam_cosim.wording import did_you_mean, listed, shown

_MOST_POINTS = 2000  # rows of a static table, which limits the run time
_LABVIEW = re.compile(r"x[ _]?values?([ _.]?\d+)?", re.IGNORECASE)
# Unit of whole numbers of time, by what they begin with, since 1970, or else by the step from row to row: a recording
# of a muscle has several rows a second.
_EPOCHS = ((1e11, ""), (1e14, "ms"), (1e17, "us"), (inf, "ns"))
_STEPS = ((1e3, "ms"), (1e6, "us"), (inf, "ns"))
_DAYS = (30e3, 80e3)  # since 1900, as spreadsheets count them, of recordings since 1982
_SHORTEST_STEP = 1e-5  # [s] of such numbers, if they were seconds
_SHORTEST_RECORDING = 0.1  # [s] of shares of a day, if they were seconds


class SeveralClocks(Exception):  # noqa: N818 -- it requests other rows
    """Columns of time run differently: the one that was taken, and the names and units of all of them."""

    def __init__(self, time: RecordedColumn, units: Mapping[str, str]) -> None:
        super().__init__(time.name)
        self.time, self.units = time, units


def with_time(
    columns: Sequence[RecordedColumn], requested: str | None, headings: Headings
) -> tuple[list[RecordedColumn], RecordedColumn | None]:
    """The columns with one of time at most, and that.

    Raises:
        InputError: the column that is requested is in no file.
        SeveralClocks: a second clock runs differently.
    """
    if requested is None:
        wanted, why = _likely_time(columns)
    else:
        wanted, why = next((c for c in columns if c.name == requested), None), ()
        if wanted is None:
            hint = did_you_mean(requested, [c.name for c in columns])
            raise InputError(f"no file has a column {shown(requested)}; {hint}")
    if wanted is None:
        return list(columns), None
    unit, more = _unit_of(wanted, headings)
    time = replace(wanted, meaning=meant("time"), unit=unit, why=(*why, *more))
    clocks = [c for c in columns if c.name != time.name and _is_clock(c)]
    units = {
        c.name: _unit_of(c, headings)[0]
        for c in columns
        if c is wanted or (c in clocks and _rises(c))
    }
    others = {c.name: _second_clock(time, c, units, headings) for c in clocks}
    return [time if c is wanted else others.get(c.name, c) for c in columns], time


def _is_clock(column: RecordedColumn) -> bool:
    return column.of("time") or (_is_of_labview(column) and _runs(column))


def _is_of_labview(column: RecordedColumn) -> bool:
    return bool(_LABVIEW.fullmatch(column.name))


def _likely_time(
    columns: Sequence[RecordedColumn],
) -> tuple[RecordedColumn | None, tuple[str, ...]]:
    """The column that is called time and rises; one that runs as a clock does; one that is called so all the same."""
    called = [c for c in columns if c.of("time")]
    rising = [c for c in called if _rises(c)]
    if rising:  # a date may be written no finer than in seconds
        return max(rising, key=lambda c: (not c.since, c.known_share)), ()
    labview = next((c for c in columns if _is_of_labview(c) and _runs(c)), None)
    if labview is not None and not labview.written_unit:
        return labview, ("LabVIEW calls the time so, and its numbers rise from row to row",)
    for c in columns:
        if (
            not c.meaning
            and not UNNAMED.fullmatch(c.name)
            and alike(c.unit or "s", "s")
            and _runs(c)
        ):
            return c, ("its numbers rise from row to row",)
    return (called[0] if called else None), ()  # Its fault is reported when it is read.


def _second_clock(
    time: RecordedColumn, column: RecordedColumn, units: Mapping[str, str], headings: Headings
) -> RecordedColumn:
    """A second clock, in addition to the column that is the time."""
    if not _rises(column) or time.values.keys().isdisjoint(column.values):
        why = ("another column is the time",)
        if column.name.strip() != "T" or column.unit:
            return replace(column, meaning=UNKNOWN, why=why)
        return with_usual_unit(replace(column, meaning=meant("temperature"), why=why), headings)
    late = _difference(time.values, time.unit, column.values, units[column.name])
    if late is None:
        raise SeveralClocks(time, units)
    away = f", {abs(late):.4g} s {'later' if late > 0.0 else 'earlier'}"
    if not late or column.since or time.since:
        away = ""
    why = (f"it runs with {shown(time.name)}, the time{away}",)
    return replace(column, meaning=UNKNOWN, why=why)


def _rises(column: RecordedColumn) -> bool:
    """Whether no value is less than one before it; a column that is shorter than others has empty cells."""
    finite = [values[np.isfinite(values)] for values in column.values.values()]
    return bool(finite) and all(
        v.size > 1 and bool((np.diff(v) >= 0).all()) and bool(v[-1] > v[0]) for v in finite
    )


def _runs(column: RecordedColumn) -> bool:
    """Whether numbers of unknown meaning rise in every row, and about evenly: as a clock does."""
    steps = [np.diff(v) for v in column.values.values() if len(v) > 1]
    return bool(steps) and all(
        bool((step > 0.0).all()) and float(step.max()) <= LONGEST_STEP * float(np.median(step))
        for step in steps
    )


def _unit_of(column: RecordedColumn, headings: Headings) -> tuple[str, tuple[str, ...]]:
    """The unit of a column of time, and why; none, where an unknown unit is written."""
    if column.unknown:
        return "", column.why
    if column.unit and headings.fits(column.unit, "time"):
        dates = f"it holds dates, which count in seconds from the first, {column.since}"
        return column.unit, (dates,) if column.since else column.why
    return _guessed_unit(column)


def _guessed_unit(column: RecordedColumn) -> tuple[str, tuple[str, ...]]:
    """``ms`` to ``ns`` of a long recording whose numbers are whole, days of a spreadsheet, else ``s``; and why."""
    steps = np.concatenate([np.diff(v) for v in column.values.values()] or [np.empty(0)])
    finite = steps[np.isfinite(steps)]
    step = float(np.median(finite)) if finite.size else 0.0
    is_integer = bool((column.samples == np.round(column.samples)).all())
    longest = max(map(len, column.values.values()), default=0)
    first = float(column.samples[0]) if column.samples.size else 0.0
    unit = "s"
    if is_integer and longest >= CRITERIA.noise.fewest_samples:
        unit = _first_above(abs(first), _EPOCHS) or _first_above(step, _STEPS)
    elif 0.0 < step < _SHORTEST_STEP:
        within = all(v[0] >= 0.0 and v[-1] < 1.0 for v in column.values.values())
        short = max(map(span, column.values.values())) < _SHORTEST_RECORDING
        unit = "d" if _DAYS[0] <= first <= _DAYS[1] or (within and short) else "s"
    return unit, (f"{NO_UNIT}; steps of {step:.4g} are taken as {unit}",)


def _first_above(number: float, table: Sequence[tuple[float, str]]) -> str:
    return next((unit for most, unit in table if number < most), "")


# ---- is there a time, and are the rows points at rest? ---------------------------------------------------------------


def check_time(
    time: RecordedColumn | None,
    columns: Sequence[RecordedColumn],
    sources: Sequence[Source],
    recording: RecordingTable,
    headings: Headings,
) -> None:
    """Checks that each recording has a time, or an interval is stated, or the files are tables of points at rest.

    Raises:
        InputError: there is none of these.
    """
    if recording.interval is not None:
        seconds(recording.interval.value)
        return
    if time is None and _may_be_points(columns, sources):
        _check_no_clock(columns, sources, headings)
        return
    for i, source in enumerate(sources):
        if time is None or i not in time.values:
            message = _no_time_in(source, sources, time)
            raise InputError(message, source.file, source.table.header_line)


def _may_be_points(columns: Sequence[RecordedColumn], sources: Sequence[Source]) -> bool:
    """Whether tables without time are of points at rest: so few rows that each may be an equilibrium, and no valve."""
    is_driven = any(c.kind in ("command", "current") for c in columns)
    has_pressure = any(c.meaning in (PRESSURE, SET_PRESSURE) for c in columns)
    return has_pressure and not is_driven and max(s.count for s in sources) <= _MOST_POINTS


def _check_no_clock(
    columns: Sequence[RecordedColumn], sources: Sequence[Source], headings: Headings
) -> None:
    """Raises InputError where a column is called time and is text, or empty: its rows may be no points at rest."""
    dates = (
        "this text states when each row was recorded, and no other column is the time; a time of day is read together "
        f"with its date, as {shown(EXAMPLE)}; write it so,"
    )
    empty = "it is called as the time is, and has no value in any row;"
    faults = [(source, source.clocks[0], dates) for source in sources if source.clocks]
    faults += [
        (sources[min(c.places)], c.name, empty)
        for c in columns
        if not c.values and (_is_of_labview(c) or (c.name != "T" and headings.says_time(c.name)))
    ]  # a T may be a temperature
    for source, name, why in faults:
        say = f"state --recording interval='1 ms' where rows are evenly apart, or --recording 'ignore={name}'"
        message = f"{why} {say} where each row is a point at rest"
        raise InputError(message, source.file, source.table.header_line, name)


def _no_time_in(source: Source, sources: Sequence[Source], time: RecordedColumn | None) -> str:
    """The message on a file without a column of time, or without that of the other files."""
    here = listed(source.table.columns)
    if time is None:
        hint = "state which by --column time=NAME, or --recording interval='1 ms' where rows are evenly apart"
        text = (
            f"; {shown(source.clocks[0])} is text: dates are read as {EXAMPLE}"
            if source.clocks
            else ""
        )
        return f"there is no column of time among {here}{text}; {hint}"
    if time.name in source.table.columns:
        return f"the column {shown(time.name)} of time has no value"
    first = sources[min(time.values)]
    hint = "files with the same columns are drafted together, others into a data set of their own"
    return (
        f"it has no column {shown(time.name)}, which is the time in {first.file.name}: its columns are {here}, "
        f"those of {first.file.name} {listed(first.table.columns)}; {hint}"
    )


# ---- clocks that are too coarse for their rows, and files with several clocks ----------------------------------------


def even_interval(times: Sequence[Array]) -> str | None:
    """How far rows are apart, where most share their time with a neighbour and all may be evenly apart; else None.

    Args:
        times: (n,) [s] of each recording.
    """
    if not times or not all(map(_is_coarse, times)):
        return None
    first, steps = times[0], [usual_step(np.diff(time)) for time in times]
    slope = float(np.polyfit(np.arange(len(first)), first, 1)[0])
    # as few digits as put the last row off by less than half a step of the clock
    short = (float(f"{slope:.{digits}g}") for digits in range(1, 9))
    interval = next((s for s in short if abs(s - slope) * len(first) < steps[0] / 2.0), slope)
    even = all(
        np.ptp(time - interval * np.arange(len(time))) <= 1.5 * step
        for time, step in zip(times, steps, strict=True)
    )
    return f"{1e3 * interval:g} ms" if even else None


def _is_coarse(time: Array) -> bool:
    """Whether most rows share their time [s] with a neighbour."""
    _, count = np.unique(time, return_counts=True)
    goes_on = not (np.diff(time) < 0.0).any()
    return goes_on and len(count) > 1 and float(np.median(count)) >= 2.0


def _difference(
    first: Mapping[int, Array], first_unit: str, other: Mapping[int, Array], other_unit: str
) -> float | None:
    """By how much [s] one clock is late against another in the rows of both; None: they run differently.

    The zeros may differ; what is returned is of the first recording that has both. A clock that ends before the other
    one has rows of its own.
    """
    late = []
    for i in first.keys() & other.keys():
        first_time, other_time = (
            convert(v[i], u, "s") for v, u in ((first, first_unit), (other, other_unit))
        )
        apart = other_time - first_time
        step = max(usual_step(np.diff(first_time)), usual_step(np.diff(other_time)))
        if not np.isfinite(apart).all() or float(np.ptp(apart)) > step:
            return None
        late.append(float(np.median(apart)))
    return late[0]


def with_one_clock(
    sources: Sequence[Source],
    columns: Sequence[RecordedColumn],
    clocks: SeveralClocks,
    headings: Headings,
) -> list[Source]:
    """The recordings with a row for each time of any clock, on that of the first; they are written to new files.

    A reading stands in the rows of its own clock. What is imposed has a value in every row: a command the last one or
    one between its neighbours; where nothing is known to be a command, so do the columns of the first clock.
    """
    commands = {
        c.name
        for c in columns
        if c.kind in ("command", "current", "voltage") or "set" in c.meaning.roles
    }
    return [_merged(source, commands, clocks, headings) for source in sources]


def _merged(
    source: Source, commands: Collection[str], clocks: SeveralClocks, headings: Headings
) -> Source:
    recorded, first = source.table.columns, clocks.time.name
    units = {n: unit or "s" for n, unit in clocks.units.items() if n in recorded}
    if len(units) < 2 or first not in units:
        return replace(source, is_merged=True)
    times = {n: convert(recorded[n].values, unit, "s") for n, unit in units.items()}
    clock_of = dict.fromkeys(recorded, first)
    for clock in reversed(times):
        clock_of |= dict.fromkeys(_headed(clock, source.table, times, headings), clock)
    samples = {}
    for n in (n for n in recorded if n not in times):
        time, values = times[clock_of[n]], recorded[n].values
        present = np.isfinite(time) & np.isfinite(values)
        samples[n] = time[present], values[present]
    imposed = [
        n
        for n, (at, _) in samples.items()
        if at.size and (n in commands if commands else clock_of[n] == first)
    ]
    rows = np.unique(np.concatenate([t[np.isfinite(t)] for t in times.values()]))
    for n in imposed:  # nothing is known of it before and after
        rows = rows[(rows >= samples[n][0][0]) & (rows <= samples[n][0][-1])]
    table = {first: Column(first, units[first], convert(rows, "s", units[first]))}
    for n, (at, values) in samples.items():
        if n in imposed and not is_held(values):
            filled = np.interp(rows, at, values)
        else:
            last = np.clip(np.searchsorted(at, rows, side="right") - 1, 0, None)
            filled = np.append(values, np.nan)[last]
            filled[~np.isin(rows, at if n not in imposed else rows)] = np.nan
        table[n] = replace(recorded[n], values=filled)
    return replace(source, table=replace(source.table, columns=table, lines=None), is_merged=True)


def _headed(
    clock: str, table: Table, clocks: Collection[str], headings: Headings
) -> tuple[str, ...]:
    """The column of which a clock has the times by its name, or those between it and the next clock."""
    names = [name for name in table.columns if name not in clocks]
    named = {c: headings.time_of(c, names) for c in clocks}
    if all(named.values()):
        return (named[clock],)
    in_order = list(table.columns)
    behind = in_order[in_order.index(clock) + 1 :]
    end = next((i for i, name in enumerate(behind) if name in clocks), len(behind))
    return tuple(behind[:end])
