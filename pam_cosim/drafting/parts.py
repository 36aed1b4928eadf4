"""Files in which the time begins anew: the experiments that a logger appended to one another."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.drafting.recorded_column import RecordedColumn
from pam_cosim.drafting.sources import Part, RecordingSource
from pam_cosim.measurement.pieces import going_on, usual_step
from pam_cosim.measurement.table import Table
from pam_cosim.units import convert


def in_parts(sources: Sequence[RecordingSource], time: RecordedColumn) -> list[RecordingSource]:
    """The recordings, of which those that hold several experiments are one for each."""
    return [
        part
        for i, source in enumerate(sources)
        for part in (_parts_of(source, time, time.values[i]) if i in time.values else [source])
    ]


def _parts_of(
    source: RecordingSource, time: RecordedColumn, values: Array
) -> list[RecordingSource]:
    first = _first_rows(values)
    if len(first) < 2:
        return [source]
    goes_on = going_on(values, "split")
    ends = [*first[1:], len(values)]
    borders = [
        None,
        *(float(convert(goes_on[k - 1 : k + 1].mean(), time.unit, "s")) for k in first[1:]),
        None,
    ]
    table = source.table
    column = replace(table.columns[time.name], values=goes_on)
    table = replace(table, columns={**table.columns, time.name: column})
    return [
        replace(
            source,
            table=_rows(table, slice(begin, end)),
            part=Part(k + 1, borders[k], borders[k + 1]),
        )
        for k, (begin, end) in enumerate(zip(first, ends, strict=True))
    ]


def _first_rows(time: Array) -> list[int]:
    """Where each experiment begins: the time goes back to its beginning, and on; elsewhere a cell is wrong."""
    steps = np.diff(time)
    first = [0, *(np.flatnonzero(steps < 0.0) + 1).tolist()]
    lengths = np.diff([*first, len(time)])
    begins = time[first] <= time[0] + usual_step(steps)
    enough = lengths >= CRITERIA.noise.fewest_samples
    return first if bool(np.all(begins) and np.all(enough)) else [0]


def _rows(table: Table, rows: slice) -> Table:
    columns = {n: replace(c, values=c.values[rows]) for n, c in table.columns.items()}
    lines = None if table.lines is None else table.lines[rows]
    return replace(table, columns=columns, lines=lines)
