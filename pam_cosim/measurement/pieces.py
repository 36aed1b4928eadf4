"""Recordings with gaps: a logger that paused, a clock that restarted.

``gaps = "split"``: each piece is a run of its own, with a start of its own. ``gaps = "through"``: the model runs
through the gaps, with the inputs as they are recorded before and after; time that goes back goes on one interval later.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import InputError
from pam_cosim.measurement.data_set import Run
from pam_cosim.measurement.table import TIME, Table

_PLACES_LISTED = 3  # at which time goes back

Gaps = Literal["split", "through"]
PAUSES = "it pauses"
"""How a note on pauses of a recording begins."""


def with_time_going_on(table: Table, gaps: Gaps | None) -> Table:
    """The table with time that never goes back, where it is stated what that means; else as it is."""
    if gaps is None or TIME not in table.columns:
        return table
    column = table.columns[TIME]
    back = np.flatnonzero(np.diff(column.values) < 0.0)
    if not back.size or not np.isfinite(column.values).all():
        return table
    time = going_on(column.values, gaps)
    places = ", ".join(f"{column.values[i]:g}" for i in back[:_PLACES_LISTED])
    treatment = (
        "a piece of its own begins there" if gaps == "split" else "it goes on one interval later"
    )
    note = f"time goes back {_times(back.size)}, after {places} {column.unit or 's'}: {treatment}"
    return replace(
        table,
        columns={**table.columns, TIME: replace(column, values=time)},
        notes=(*table.notes, note),
    )


def going_on(time: Array, gaps: Gaps) -> Array:
    """(n,) the time, which where it goes back goes on a pause later (``split``), or one usual step."""
    steps = np.diff(time)
    usual = usual_step(steps) or 1.0
    pause = usual * (2.0 * CRITERIA.starts.pause if gaps == "split" else 1.0)
    return np.asarray(
        time[0] + np.concatenate([[0.0], np.cumsum(np.where(steps < 0.0, pause, steps))])
    )


def _times(count: int) -> str:
    return "once" if count == 1 else f"{count} times"


def usual_step(steps: Array) -> float:
    """The median of those in which time goes on [s]; 0 where it never does."""
    forward = steps[steps > 0.0]
    return float(np.median(forward)) if forward.size else 0.0


def pauses(time: Array) -> NDArray[np.intp]:
    """Rows (k,) of times (n,) [s] after which a recording pauses: the step is much longer than usual."""
    steps = np.diff(time)
    usual = usual_step(steps)
    return np.flatnonzero(steps > CRITERIA.starts.pause * usual) if usual else np.zeros(0, np.intp)


def pieces_of(run: Run, gaps: Gaps | None) -> list[Run]:
    """The pieces of a run, or the run with a note on its pauses.

    Raises:
        InputError: a piece of one row.
    """
    after = pauses(run.time)
    if not after.size:
        return [run]
    if gaps == "through":
        return [run]
    if gaps is None:
        return [replace(run, notes=(*run.notes, _note(run.time, after)))]
    ends = [0, *(after + 1).tolist(), len(run.time)]
    return [
        _piece(run, a, b, k) for k, (a, b) in enumerate(zip(ends[:-1], ends[1:], strict=True), 1)
    ]


def _note(time: Array, after: Sequence[int] | NDArray[np.intp]) -> str:
    longest = int(max(after, key=lambda i: time[i + 1] - time[i]))
    pause = time[longest + 1] - time[longest]
    return (
        f"{PAUSES} {_times(len(after))}, for {pause:.3g} s after {time[longest]:g} s: the model runs through that "
        'with the inputs as they were before and after; gaps = "split" gives each piece a start of its own'
    )


def first_rows(run: Run, count: int) -> Run:
    """So many of the first rows of a run."""
    return run.rows(slice(0, count))


def _piece(run: Run, begin: int, end: int, number: int) -> Run:
    if end - begin < 2:
        raise InputError(
            f"the piece at {run.time[begin]:g} s has one row; it cannot be a run", run.file
        )
    return replace(
        run.rows(slice(begin, end)),
        name=f"{run.name} piece {number}",
        notes=run.notes if number == 1 else (),
    )
