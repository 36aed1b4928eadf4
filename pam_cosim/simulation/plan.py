"""Communication points: the times of the outputs and those at which an input really changes its slope or value."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.simulation.inputs import Inputs, Interpolation, Pieces, pieces

Indices = NDArray[np.int64]

# Points closer than this part of the time scale are one.
_SAME_TIME = 1e-12
_ON_GRID = 1e-6  # of a step: a time so close to the end of one is there
_JUMP = 0.05  # of the range of an input, above which it is a step and not noise
_KEPT = 64  # plans: a fit runs the same few experiments over and over


class CommunicationPlan(NamedTuple):
    """What the driver does at each communication point.

    Attributes:
        times: (m,) [s], increasing; the first is the start time.
        knots: (m,) row of ``values`` and ``slopes`` to set at the point, or -1.
        values, slopes: (k, inputs) [SI, SI/s] from a knot on.
        rows_before, rows_after: (m,) row of outputs read before and after the inputs are set, or -1.
        rows: (n,) row of each time requested.
        row_count: number of rows.
        means: (m,) row of ``values`` to set at the point after reading, or -1; None: none.
        grid: of an FMU with equal steps, where the times requested are among them; None: they are points.
    """

    times: Array
    knots: Indices
    values: Array
    slopes: Array
    rows_before: Indices
    rows_after: Indices
    rows: Indices
    row_count: int
    means: Indices | None = None
    grid: EqualSteps | None = None

    def table(self, values: Array, held: NDArray[np.bool_]) -> Array:
        """(n, k) values at the requested times, from those of the rows; (k,) ``held`` are not interpolated."""
        return values[self.rows] if self.grid is None else self.grid.table(values, held)


class EqualSteps(NamedTuple):
    """Times among the ends of equal steps, between which outputs are interpolated.

    Attributes:
        place: (n,) of each time, in steps from the start.
        ends: (m,) numbers of the points between which the outputs are smooth: at the others an input jumps.
    """

    place: Array
    ends: Indices

    def table(self, values: Array, held: NDArray[np.bool_]) -> Array:
        """(n, k) of (rows, k): a row for every point, and for each of the ``ends`` but the first one from before it."""
        from scipy.interpolate import Akima1DInterpolator

        count, last = int(self.ends[-1]), np.floor(self.place).astype(np.int64)
        rows, before = values[last], values[count + 1 :]
        is_first = np.append(self.place[1:] == self.place[:-1], False)
        for a, b, end in zip(self.ends[:-1], self.ends[1:], before, strict=True):
            points, piece = np.arange(a, b + 1), np.concatenate((values[a:b], end[None]))
            inside = (self.place > a) & (self.place < b)
            if not inside.any():
                pass
            elif b - a == 1 or not np.isfinite(piece).all():
                share = (self.place[inside] - a)[:, None]
                rows[inside] = piece[0] + share * (piece[1] - piece[0])
            else:
                rows[inside] = Akima1DInterpolator(points, piece, method="makima")(
                    self.place[inside]
                )
            rows[is_first & (self.place == b)] = end
        rows[:, held] = values[last][:, held]
        return rows


class Steps(NamedTuple):
    """What an FMU needs of communication points.

    Attributes:
        ramps: distance [s] of the points at which inputs that change over time are set, where it takes no slopes.
        fixed: length of each of its steps [s]; None: steps of any length.
    """

    ramps: float | None = None
    fixed: float | None = None


_ANY_STEPS = Steps()


def plan(
    times: Array,
    start: float,
    inputs: Inputs | None,
    steps: Steps = _ANY_STEPS,
    held: Collection[str] = (),
) -> CommunicationPlan:
    """Lays out a run.

    An output at the time of a step in an input is read after the step; where a time is requested twice, the
    first is read before it.

    Args:
        times: (n,) [s] of the outputs, never decreasing.
        start: of the run [s].
        inputs: or None: start values.
        steps: what the FMU needs.
        held: inputs that change at samples alone, whatever the interpolation: those that are no continuous numbers.

    Raises:
        InputError: times that decrease or come before the start.
    """
    _check(times, start)
    if inputs is None:
        return _laid_out(times.tobytes(), start, b"", (), (), "linear", steps)
    columns = tuple(values.tobytes() for values in inputs.values.values())
    discrete = tuple(name in held for name in inputs.values)
    time = inputs.time.tobytes()
    return _laid_out(times.tobytes(), start, time, columns, discrete, inputs.interpolation, steps)


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
    discrete: tuple[bool, ...],
    interpolation: Interpolation,
    steps: Steps,
) -> CommunicationPlan:
    """The plan, of the bytes of the arrays."""
    times, changing = np.frombuffer(time), np.frombuffer(input_time)
    lines = [
        pieces(changing, np.frombuffer(values), "previous" if is_held else interpolation)
        for values, is_held in zip(columns_of_inputs, discrete, strict=True)
    ]
    if steps.fixed is not None:
        return _on_grid(times, start, lines, discrete, steps.fixed)
    end = float(times[-1])
    changes = _changes(lines, start, end)
    ramps = steps.ramps is not None and any(line.slope.any() for line in lines)
    if ramps:
        grid = np.arange(start, end, steps.ramps)
        changes = _inside(np.concatenate((changes, changing, grid, times)), start, end)
    points, evaluated, point_of_time = _merge(times, start, changes)
    is_knot = ~np.isnan(evaluated) if lines else np.zeros(points.size, dtype=bool)
    at = evaluated[is_knot]
    columns = [line.at(at) for line in lines]
    values, slopes = _stacked(columns, 0, at.size), _stacked(columns, 1, at.size)
    knots = np.where(is_knot, np.cumsum(is_knot) - 1, -1).astype(np.int64)
    means = None
    if ramps:  # every point is a knot, and the inputs are straight up to the next one
        halves = np.append(np.diff(points), 0.0)[:, None] / 2.0
        means = np.where(np.arange(points.size) < points.size - 1, knots + len(values), -1)
        values = np.concatenate((values, values + halves * slopes))
        slopes = np.zeros_like(values)
    return CommunicationPlan(
        points, knots, values, slopes, *_rows(point_of_time, points.size), means
    )


def _on_grid(
    times: Array, start: float, lines: Sequence[Pieces], discrete: Sequence[bool], length: float
) -> CommunicationPlan:
    """Equal steps past the last time: inputs are means over each, those that are discrete the values in the middle."""
    count = max(1, math.ceil((times[-1] - start) / length - _ON_GRID))
    numbers = np.arange(count + 1, dtype=np.int64)
    points = start + length * numbers
    exact = [line.at(points)[0] for line in lines]
    means = [
        line.at(points[:-1] + length / 2)[0] if is_discrete else line.means(points)
        for line, is_discrete in zip(lines, discrete, strict=True)
    ]
    values = np.concatenate((np.stack(exact, 1), np.stack(means, 1))) if lines else np.zeros((0, 0))
    ends = _smooth_ends(lines, points)
    before = np.full(count + 1, -1, dtype=np.int64)
    before[ends[1:]] = count + 1 + np.arange(len(ends) - 1)
    place = (times - start) / length
    place = np.where(np.abs(place - np.round(place)) < _ON_GRID, np.round(place), place)
    none = np.full(count + 1, -1, dtype=np.int64)
    return CommunicationPlan(
        points,
        numbers if lines else none,
        values,
        np.zeros_like(values),
        before,
        numbers,
        np.floor(place).astype(np.int64),
        count + len(ends),
        np.where(numbers < count, numbers + count + 1, -1) if lines else none,
        EqualSteps(place, ends),
    )


def _smooth_ends(lines: Sequence[Pieces], points: Array) -> Indices:
    """(m,) numbers of the first and the last point, and of those at or around jumps of inputs."""
    ends = [np.array([0, len(points) - 1])]
    for line in lines:
        before = line.value[:-1] + line.slope[:-1] * np.append(0.0, np.diff(line.time[1:]))
        jumps = np.abs(line.value[1:] - before) > _JUMP * np.ptp(line.value)
        place = (line.time[1:][jumps] - points[0]) / (points[1] - points[0])
        index = np.round(place)
        index = np.where(np.abs(place - index) < _ON_GRID, index, place)
        ends += [np.floor(index).astype(int), np.ceil(index).astype(int)]
    indices = np.unique(np.concatenate(ends))
    return indices[(indices >= 0) & (indices < len(points))].astype(np.int64)


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
    all_times = np.concatenate(([start], times, changes))
    order = np.argsort(all_times, kind="stable")
    ordered = all_times[order]
    tolerance = _SAME_TIME * max(abs(start), abs(float(times[-1])))
    group_of_ordered = np.concatenate(([0], np.cumsum(np.diff(ordered) > tolerance)))
    group = np.empty_like(group_of_ordered)
    group[order] = group_of_ordered
    points = np.empty(int(group_of_ordered[-1]) + 1)
    points[group[::-1]] = all_times[
        ::-1
    ]  # start first, then outputs, then changes name a group's time
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
