"""Which column of the recordings is the time, and in which unit; tables without one may hold points at rest."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.recorded_column import RecordedColumn, with_usual_unit
from pam_cosim.drafting.sources import RecordingSource
from pam_cosim.drafting.vocabulary import Meaning, fits
from pam_cosim.drafting.words import DAYS, SHORTEST_STEP, USUAL_EPOCHS, USUAL_STEPS
from pam_cosim.errors import InputError
from pam_cosim.measurement.experiment_tables import RecordingTable
from pam_cosim.units import seconds
from pam_cosim.wording import did_you_mean, listed, shown

_C = CRITERIA.recognition


def with_time(columns: list[RecordedColumn], asked: str | None) -> list[RecordedColumn]:
    """The columns with one of time at most, and its unit."""
    wanted, why = _likely_time(columns) if asked is None else _asked_time(columns, asked)
    rest = [_no_time(c) if c.of("time") else c for c in columns]
    if wanted is None:
        return rest
    unit, more = (
        (wanted.unit, wanted.why)
        if wanted.unit and fits(wanted.unit, "time")
        else _unit_of_time(wanted)
    )
    made = replace(wanted, meaning=Meaning("time"), unit=unit, why=(*why, *more))
    return [made if c.name == wanted.name else c for c in rest]


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
    return wanted, wanted.why


def _likely_time(
    columns: Sequence[RecordedColumn],
) -> tuple[RecordedColumn | None, tuple[str, ...]]:
    """The column that is called time and rises; one that runs as a clock does; one that is called so all the same."""
    called = [c for c in columns if c.of("time")]
    rising = [c for c in called if _rises(c)]
    if rising:
        return max(rising, key=lambda c: c.known), ()
    running = next((c for c in columns if c.meaning is None and _runs(c) and _fits_time(c)), None)
    if running is not None:
        return running, ("its numbers rise from row to row",)
    return (called[0] if called else None), ()  # Its fault is told when it is read.


def _no_time(column: RecordedColumn) -> RecordedColumn:
    """Beside a column of time, a capital T is a temperature."""
    if column.name.strip() != "T" or column.unit:
        return replace(column, meaning=None, why=())
    return with_usual_unit(
        replace(column, meaning=Meaning("temperature"), why=("another column is the time",))
    )


def _fits_time(column: RecordedColumn) -> bool:
    return not column.unit or fits(column.unit, "time")


def _rises(column: RecordedColumn) -> bool:
    recordings = list(column.values.values())
    return bool(recordings) and all(map(_grows, recordings))


def _grows(values: Array) -> bool:
    if len(values) < 2:
        return False
    return bool((np.diff(values) >= 0).all()) and bool(values[-1] > values[0])


def _runs(column: RecordedColumn) -> bool:
    """Whether numbers of which nobody knows what they are rise in every row, and about evenly: as a clock does."""
    steps = [np.diff(one) for one in column.values.values() if len(one) > 1]
    return bool(steps) and all(
        bool((one > 0.0).all()) and float(one.max()) <= _C.uneven * float(np.median(one))
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
    elif DAYS[0] <= first <= DAYS[1] and 0.0 < step < SHORTEST_STEP:
        unit = "d"
    return unit, (f"no unit is written; steps of {step:.4g} are taken as {unit}",)


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
        seconds(recording.interval)
        return None
    if time is None and may_be_points(columns, sources):
        return None
    for i, source in enumerate(sources):
        if time is None or i not in time.values:
            hint = "say which by --column time=NAME, or --recording interval='1 ms' where rows are evenly apart"
            texts = (
                f"; {listed(map(shown, source.texts))} is text, dates are not read"
                if source.texts
                else ""
            )
            message = (
                f"there is no column of time among {listed(source.table.columns)}{texts}; {hint}"
            )
            raise InputError(message, source.file, source.table.header_line)
    return time


def may_be_points(columns: Sequence[RecordedColumn], sources: Sequence[RecordingSource]) -> bool:
    """Whether tables without time are of points at rest: so few rows that somebody waited for each, and no valve."""
    kinds = {c.meaning.kind for c in columns if c.meaning is not None}
    is_driven = bool(kinds & {"command", "current"})
    has_pressure = any(c.of("pressure") or c.of("pressure", "set") for c in columns)
    rows = max(len(next(iter(s.table.columns.values())).values) for s in sources)
    return has_pressure and not is_driven and rows <= _C.most_points
