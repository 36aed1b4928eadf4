"""Files with several clocks, each before the columns that it heads: all on the rows of one, to draft by.

In the data set the file stands once more below its run, as a second logger, with its own times.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.sources import RecordingSource
from pam_cosim.errors import InputError
from pam_cosim.measurement.pieces import usual_step
from pam_cosim.measurement.table import Table
from pam_cosim.units import convert

_INPUTS = ("command", "current", "voltage")
_FEWEST_ROWS = 2  # of a recording


@dataclass(frozen=True)
class FurtherClock:
    """A clock beside that of the inputs.

    Attributes:
        name: of its column.
        unit: of that; None: its heading states it.
        columns: that it heads.
    """

    name: str
    unit: str | None
    columns: tuple[str, ...]


class SeveralClocks(InputError):
    """Two columns of time run differently.

    Attributes:
        time: the one that was taken.
        other: the other one, with its unit.
        columns: all of the recordings.
        clocks: names of all columns of time.
    """

    def __init__(
        self,
        message: str,
        file: Path,
        line: int | None,
        time: RecordedColumn,
        other: RecordedColumn,
        columns: Sequence[RecordedColumn],
        clocks: Sequence[str],
    ) -> None:
        super().__init__(message, file, line, other.name)
        self.time, self.other, self.columns, self.clocks = time, other, tuple(columns), clocks


def with_one_clock(
    sources: Sequence[RecordingSource], found: SeveralClocks
) -> tuple[list[RecordingSource], FurtherClock]:
    """The recordings on the clock of the inputs, samples of the other one in the rows that are next in time."""
    groups = {name: _headed(name, sources[0].table, found.clocks) for name in found.clocks}
    first, other = found.time, found.other
    if _has_inputs(groups[other.name], found.columns) > _has_inputs(
        groups[first.name], found.columns
    ):
        first, other = other, first
    own = groups[other.name]
    made = [replace(s, table=_on_rows(s.table, first, other, own)) for s in sources]
    unit = None if other.stated else other.unit or None
    return made, FurtherClock(other.name, unit, own)


def _headed(clock: str, table: Table, clocks: Sequence[str]) -> tuple[str, ...]:
    """The columns between a clock and the next one."""
    names = list(table.columns)
    behind = names[names.index(clock) + 1 :]
    end = next((i for i, name in enumerate(behind) if name in clocks), len(behind))
    return tuple(behind[:end])


def _has_inputs(names: Sequence[str], columns: Sequence[RecordedColumn]) -> bool:
    """Whether one of these columns is what drives a rig, by its name."""
    meanings = [c.meaning for c in columns if c.name in names and c.meaning is not None]
    return any("set" in m.roles or m.kind in _INPUTS for m in meanings)


def _on_rows(
    table: Table, first: RecordedColumn, other: RecordedColumn, own: Sequence[str]
) -> Table:
    if not {first.name, other.name} <= table.columns.keys():
        return table
    time, late = (convert(table.columns[c.name].values, c.unit or "s", "s") for c in (first, other))
    rows = np.flatnonzero(np.isfinite(time))
    if len(rows) < _FEWEST_ROWS:
        return table
    place, seen = _next_rows(time[rows], late)
    columns = {}
    for name, column in table.columns.items():
        values = column.values[rows]
        if name in own:
            values = np.full(len(rows), np.nan)
            values[place] = column.values[seen]
        if name != other.name:
            columns[name] = replace(column, values=values)
    lines = None if table.lines is None else table.lines[rows]
    return replace(table, columns=columns, lines=lines)


def _next_rows(time: Array, other: Array) -> tuple[np.ndarray, np.ndarray]:
    """Rows of one time (n,), and the rows of the other (m,) that are next to each, no farther than its usual step."""
    seen = np.flatnonzero(np.isfinite(other))
    place = np.clip(np.searchsorted(time, other[seen]), 1, len(time) - 1)
    place -= (other[seen] - time[place - 1]) < (time[place] - other[seen])
    near = np.abs(time[place] - other[seen]) <= usual_step(np.diff(time))
    return place[near], seen[near]


def clock_of(columns: set[str], clocks: Sequence[FurtherClock]) -> FurtherClock | None:
    """The further clock that heads one of these columns; None: the first."""
    return next((clock for clock in clocks if columns.intersection(clock.columns)), None)
