"""What drives a model: sampled inputs, and the pieces of straight line between them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.wording import Printed

Interpolation = Literal["linear", "previous"]

# Two samples closer than this part of the time scale are a step.
_SAME_TIME = 1e-12
# A sample within this part of the input's size lies on the line of its neighbours.
_ON_LINE = 1e-12


@dataclass(frozen=True)
class Inputs(Printed):
    """Inputs over time, held before the first and after the last sample.

    Attributes:
        time: (n,) [s], never decreasing; a time that stands twice makes a step.
        values: name to (n,) [SI].
        interpolation: "linear" between samples, or "previous": held until the next sample.
    """

    time: Array
    values: Mapping[str, Array]
    interpolation: Interpolation = "linear"

    def __str__(self) -> str:
        span = f"{self.time[0]:g} s to {self.time[-1]:g} s"
        return f"{', '.join(self.values) or 'no input'} at {len(self.time)} times, {span}"

    def __post_init__(self) -> None:
        time = np.asarray(self.time, dtype=float)
        object.__setattr__(self, "time", time)
        object.__setattr__(
            self, "values", {k: np.asarray(v, dtype=float) for k, v in self.values.items()}
        )
        if time.ndim != 1 or time.size == 0 or not np.isfinite(time).all():
            raise InputError("the times of the inputs must be a non-empty list of finite numbers")
        if (np.diff(time) < 0.0).any():
            raise InputError(f"the times of the inputs decrease after {_first_decrease(time):g} s")
        for name, values in self.values.items():
            if values.shape != time.shape:
                raise InputError(f"input '{name}' has {values.size} values for {time.size} times")
            if not np.isfinite(values).all():
                raise InputError(f"input '{name}' has a value that is not a finite number")
        if self.interpolation not in ("linear", "previous"):
            raise InputError(
                f"interpolation must be 'linear' or 'previous', not '{self.interpolation}'"
            )


def with_held(inputs: Inputs | None, held: Mapping[str, float], start: float) -> Inputs | None:
    """``inputs`` and those that are ``held`` constant [SI] from ``start`` [s] on.

    Raises:
        InputError: an input is given both ways.
    """
    if not held:
        return inputs
    given = inputs or Inputs(np.array([start]), {})
    for name in held:
        if name in given.values:
            raise InputError(
                f"the input '{name}' is given over time and as a constant; keep one of them"
            )
    constant = {name: np.full(given.time.shape, value) for name, value in held.items()}
    return Inputs(given.time, {**given.values, **constant}, given.interpolation)


def _first_decrease(time: Array) -> float:
    return float(time[np.argmax(np.diff(time) < 0.0)])


class Pieces(NamedTuple):
    """An input as straight lines: from ``time[i]`` on, ``value[i] + slope[i] (t - time[i])``.

    All (k,); the first piece begins at minus infinity and is constant.
    """

    time: Array
    value: Array
    slope: Array

    def at(self, t: Array) -> tuple[Array, Array]:
        """Values and slopes just after the times ``t``."""
        i = np.searchsorted(self.time, t, side="right") - 1
        since = np.where(self.slope[i] == 0.0, 0.0, t - np.where(i == 0, 0.0, self.time[i]))
        return self.value[i] + self.slope[i] * since, self.slope[i]

    def means(self, points: Array) -> Array:
        """(n - 1,) means between times that increase, (n,)."""
        corners = np.unique(np.concatenate((points, self.time[self.time > points[0]])))
        corners = corners[corners <= points[-1]]
        lengths = np.diff(corners)
        middle = self.at(corners[:-1] + lengths / 2)[0]
        integral = np.concatenate(([0.0], np.cumsum(middle * lengths)))
        return np.diff(np.interp(points, corners, integral)) / np.diff(points)


def pieces(time: Array, values: Array, interpolation: Interpolation) -> Pieces:
    """The fewest straight lines through all samples."""
    if interpolation == "previous":
        return _held(time, values)
    step = np.diff(time)
    real = step > _SAME_TIME * np.maximum(np.abs(time[1:]), 1.0)
    begin = np.flatnonzero(real)
    starts, ends = values[begin], values[begin + 1]
    lengths = step[begin]
    kept = _kept(starts, ends, lengths)
    last = np.append(kept[1:], begin.size) - 1 if kept.size else kept
    merged = (ends[last] - starts[kept]) / (time[begin[last] + 1] - time[begin[kept]])
    if not _fits(time[begin], starts, kept, merged):
        kept, merged = np.arange(begin.size), (ends - starts) / lengths
    return Pieces(
        np.concatenate(([-np.inf], time[begin[kept]], time[-1:])),
        np.concatenate((values[:1], starts[kept], values[-1:])),
        np.concatenate(([0.0], merged, [0.0])),
    )


def _held(time: Array, values: Array) -> Pieces:
    last_of_time = np.append(np.diff(time) > 0.0, True)
    time, values = time[last_of_time], values[last_of_time]
    new = np.append(True, np.diff(values) != 0.0)
    time, values = np.append(-np.inf, time[new][1:]), values[new]
    return Pieces(time, values, np.zeros_like(values))


def _kept(starts: Array, ends: Array, lengths: Array) -> NDArray[np.intp]:
    """Indices of the pieces that do not merely continue the one before."""
    if starts.size == 0:
        return np.zeros(0, dtype=np.intp)
    slopes = (ends - starts) / lengths
    size = _ON_LINE * float(np.max(np.abs(np.append(starts, ends))))
    bend = np.abs(np.diff(slopes)) * np.minimum(lengths[1:], lengths[:-1]) > size
    jump = starts[1:] != ends[:-1]
    return np.flatnonzero(np.append(True, bend | jump))


def _fits(time: Array, starts: Array, kept: NDArray[np.intp], slopes: Array) -> bool:
    """Whether every sample lies on its merged line: many small bends may add up to a curve."""
    if starts.size == 0:
        return True
    owner = np.searchsorted(kept, np.arange(starts.size), side="right") - 1
    line = starts[kept[owner]] + slopes[owner] * (time - time[kept[owner]])
    return bool(np.max(np.abs(line - starts)) <= 1e3 * _ON_LINE * np.max(np.abs(starts)))
