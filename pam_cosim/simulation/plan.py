"""Communication points: the times of the outputs and those at which an input really changes its course."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.simulation.inputs import Inputs, Interpolation, Pieces, pieces

Indices = NDArray[np.int64]

# Points closer than this part of the time scale are one.
_SAME_TIME = 1e-12
_KEPT = 64  # plans: a fit runs the same few experiments over and over


@dataclass(frozen=True)
class CommunicationPlan:
    """What the driver does at each communication point.

    Attributes:
        times: (m,) [s], increasing; the first is the start time.
        knots: (m,) row of ``values`` and ``slopes`` to set at the point, or -1.
        values, slopes: (k, inputs) [SI, SI/s] from a knot on.
        rows_before, rows_after: (m,) row of outputs read before and after the inputs are set, or -1.
        rows: (n,) row of each time asked for.
        row_count: number of rows.
    """

    times: Array
    knots: Indices
    values: Array
    slopes: Array
    rows_before: Indices
    rows_after: Indices
    rows: Indices
    row_count: int


def plan(
    times: Array, start: float, inputs: Inputs | None, sample_ramps: float | None = None
) -> CommunicationPlan:
    """Lays out a run.

    An output at the time of a step in an input is read after the step; where a time is asked for twice, the
    first is read before it.

    Args:
        times: (n,) [s] of the outputs, never decreasing.
        start: of the run [s].
        inputs: or None: start values.
        sample_ramps: for FMUs that do not understand slopes: distance [s] of the points that approximate ramps.

    Raises:
        InputError: times that decrease or come before the start.
    """
    _check(times, start)
    if inputs is None:
        return _laid_out(times.tobytes(), start, b"", (), "linear", sample_ramps)
    columns = tuple(values.tobytes() for values in inputs.values.values())
    return _laid_out(
        times.tobytes(), start, inputs.time.tobytes(), columns, inputs.interpolation, sample_ramps
    )


def points(values: Mapping[str, Array], count: int) -> CommunicationPlan:
    """One point for each of ``count`` rows of inputs [SI], which have no time; they are numbered."""
    numbers, width = np.arange(count, dtype=np.int64), len(values)
    table = (
        np.ascontiguousarray(np.stack(list(values.values()), axis=1))
        if values
        else np.zeros((count, 0))
    )
    none = np.full(count, -1, dtype=np.int64)
    knots = numbers if width else none
    return CommunicationPlan(
        numbers.astype(float), knots, table, np.zeros((count, width)), none, numbers, numbers, count
    )


@lru_cache(_KEPT)
def _laid_out(
    time: bytes,
    start: float,
    input_time: bytes,
    columns_of_inputs: tuple[bytes, ...],
    interpolation: Interpolation,
    sample_ramps: float | None,
) -> CommunicationPlan:
    """The plan, of the bytes of the arrays."""
    times, changing = np.frombuffer(time), np.frombuffer(input_time)
    lines = [pieces(changing, np.frombuffer(values), interpolation) for values in columns_of_inputs]
    end = float(times[-1])
    changes = _changes(lines, start, end)
    if sample_ramps is not None and any(line.slope.any() for line in lines):
        grid = np.arange(start, end, sample_ramps)
        changes = _inside(np.concatenate((changes, changing, grid, times)), start, end)
    points, evaluated, point_of_time = _merge(times, start, changes)
    known = ~np.isnan(evaluated) if lines else np.zeros(points.size, dtype=bool)
    at = evaluated[known]
    columns = [line.at(at) for line in lines]
    values, slopes = _stacked(columns, 0, at.size), _stacked(columns, 1, at.size)
    return CommunicationPlan(
        points,
        np.where(known, np.cumsum(known) - 1, -1).astype(np.int64),
        values,
        slopes,
        *_rows(point_of_time, points.size),
    )


def _stacked(columns: Sequence[tuple[Array, Array]], place: int, count: int) -> Array:
    """The arrays at one place of each pair, as columns of a matrix of so many rows."""
    if not columns:
        return np.zeros((count, 0))
    return np.ascontiguousarray(np.stack([pair[place] for pair in columns], axis=1))


def _check(times: Array, start: float) -> None:
    if times.ndim != 1 or times.size == 0 or not np.isfinite(times).all():
        raise InputError("the times of a run must be a non-empty list of finite numbers")
    if (np.diff(times) < 0.0).any():
        raise InputError("the times of a run must not decrease")
    if not np.isfinite(start) or start > times[0]:
        raise InputError(
            f"the run cannot start at {start:g} s, after its first output at {times[0]:g} s"
        )


def _inside(times: Array, start: float, end: float) -> Array:
    return times[(times > start) & (times <= end)]


def _changes(lines: list[Pieces], start: float, end: float) -> Array:
    """Times inside the run at which some input jumps or bends."""
    changes = [_inside(line.time, start, end) for line in lines]
    return np.concatenate(changes) if changes else np.zeros(0)


def _merge(times: Array, start: float, changes: Array) -> tuple[Array, Array, Indices]:
    """Distinct points; per point the time at which to evaluate the inputs (NaN: leave them); point of each time.

    A change that differs from an output's time by rounding alone takes place at the output's time.
    """
    every = np.concatenate(([start], times, changes))
    order = np.argsort(every, kind="stable")
    ordered = every[order]
    near = _SAME_TIME * max(abs(start), abs(float(times[-1])))
    group_of_ordered = np.concatenate(([0], np.cumsum(np.diff(ordered) > near)))
    group = np.empty_like(group_of_ordered)
    group[order] = group_of_ordered
    points = np.empty(int(group_of_ordered[-1]) + 1)
    points[group[::-1]] = every[::-1]  # start first, then outputs, then changes name a group's time
    evaluated = np.full(points.size, np.nan)
    evaluated[0] = start
    np.fmax.at(evaluated, group[1 + times.size :], changes)
    return points, evaluated, group[1 : 1 + times.size].astype(np.int64)


def _rows(point_of_time: Indices, count: int) -> tuple[Indices, Indices, Indices, int]:
    """Rows before and after the inputs change, per point; row of each time; number of rows."""
    distinct, first, size = np.unique(point_of_time, return_index=True, return_counts=True)
    before, after = np.full(count, -1, dtype=np.int64), np.full(count, -1, dtype=np.int64)
    after[distinct] = np.arange(distinct.size)
    twice = distinct[size > 1]
    before[twice] = distinct.size + np.arange(twice.size)
    rows = after[point_of_time]
    rows[first[size > 1]] = before[twice]
    return before, after, rows, int(distinct.size + twice.size)
