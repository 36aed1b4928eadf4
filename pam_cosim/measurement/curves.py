"""Points at rest have no time and their rows no order: they are put into curves by their values alone.

Inputs that take few values, such as the pressures of a map or the loads of a rig, divide the rows into curves. The one
that varies most within them is what the rows are sorted by. Only the direction of a branch may follow from their order.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array

_LEVEL = 0.02  # of the range: nearer values are one level
ROWS_PER_LEVEL = 2.0  # on average, at least; other values vary continuously
CONSTANT_RANGE = 1e-6  # of its size: an input that varies less is constant
_TURN_RANGE = 0.05  # of the range: a smaller reversal of a pressure is noise
ROWS_PER_CURVE = 3  # on average, at least; fewer rows are scattered points

Indices = NDArray[np.int64]
_NOTHING: Mapping[str, Array] = {}


@dataclass(frozen=True)
class Curve:
    """Rows of a file that belong together.

    Attributes:
        rows: their numbers in the file, sorted along the curve.
        along: name of the input that varies.
        at: values of the inputs that do not, where the file has several of them.
    """

    rows: Indices
    along: str
    at: dict[str, float]


def levels(values: Array) -> Indices | None:
    """(n,) number of the level that each value lies on; None: they take no few values but vary continuously."""
    order = np.argsort(values, kind="stable")
    ordered = values[order]
    span = float(ordered[-1] - ordered[0])
    if span <= CONSTANT_RANGE * float(np.abs(ordered).max(initial=0.0)):
        return np.zeros(len(values), dtype=np.int64)
    apart = np.diff(ordered) > _LEVEL * span
    number = np.concatenate([[0], np.cumsum(apart)])
    if number[-1] and len(values) < ROWS_PER_LEVEL * (number[-1] + 1):
        return None
    wide = any(np.ptp(ordered[number == k]) > 2 * _LEVEL * span for k in range(int(number[-1]) + 1))
    if wide:
        return None
    level_of = np.empty(len(values), dtype=np.int64)
    level_of[order] = number
    return level_of


def curves(
    inputs: Mapping[str, Array], measured: Mapping[str, Array], apart: Sequence[Array] = ()
) -> list[Curve]:
    """The rows as curves, sorted by what they are at.

    Args:
        inputs: (n,) each, imposed.
        measured: (n,) each; they decide where the inputs leave open what is along what, or what comes first.
        apart: (n,) each; rows of unlike values are never of one curve, such as those of two branches.
    """
    level_of = {name: levels(values) for name, values in inputs.items()}
    along = _along(inputs, level_of, measured)
    constant_inputs = {name: values for name, values in inputs.items() if name != along}
    dividing = _dividing(level_of, constant_inputs)
    count = len(inputs[along])
    key = np.column_stack([np.zeros(count), *apart, *dividing.values()])
    rows = [np.flatnonzero((key == level).all(axis=1)) for level in np.unique(key, axis=0)]
    if count < ROWS_PER_CURVE * len(rows) and dividing:  # points that stand alone are no curves
        return curves(
            {along: inputs[along]}, {**measured, **{name: inputs[name] for name in dividing}}, apart
        )
    ties = [np.nan_to_num(values) for values in (*measured.values(), *constant_inputs.values())]
    found_curves = []
    for chosen in rows:
        position = inputs[along][chosen]
        order = _mixed(
            np.lexsort([*(values[chosen] for values in reversed(ties)), position]), position
        )
        at = {name: _level(inputs[name], chosen) for name in dividing}
        found_curves.append(Curve(chosen[order], along, at))
    return found_curves


def _dividing(level_of: Mapping[str, Indices | None], names: Iterable[str]) -> dict[str, Indices]:
    """The levels of those inputs that lie on a few of them, and on more than one."""
    levels_by_name = {name: level_of[name] for name in names}
    return {
        name: level
        for name, level in levels_by_name.items()
        if level is not None and level.max(initial=0) > 0
    }


def _level(values: Array, chosen: Indices) -> float:
    """The value of some rows, no finer than levels are distinguished."""
    step = 10.0 ** np.floor(np.log10(_LEVEL * float(np.ptp(values)) / 2))
    return float(np.round(np.median(values[chosen]) / step) * step)


def _mixed(order: Indices, values: Array) -> Indices:
    """The order with points at one place mixed, always alike: sorted by their readings they would be no noise."""
    places = np.unique(values[order], return_inverse=True)[1]
    chance = np.random.default_rng(0).random(len(order))
    return np.asarray(order[np.lexsort([chance, places])])


def _along(
    inputs: Mapping[str, Array], on: Mapping[str, Indices | None], measured: Mapping[str, Array]
) -> str:
    """The input that takes most values; of several that vary continuously, the one that most is read by."""
    free = [name for name, k in on.items() if k is None]
    if len(free) == 1:
        return free[0]
    if not free:
        return max(on, key=lambda name: int(on[name].max(initial=0)))  # type: ignore[union-attr]
    reading = next(iter(measured.values()), np.zeros(len(inputs[free[0]])))
    is_finite = np.isfinite(reading)
    return max(free, key=lambda name: _strength(inputs[name][is_finite], reading[is_finite]))


def _strength(values: Array, reference: Array) -> float:
    if len(values) < 3 or np.ptp(values) == 0.0 or np.ptp(reference) == 0.0:
        return 0.0
    from scipy.stats import spearmanr  # half a second, which few need

    return abs(float(spearmanr(values, reference).statistic))


def directions(
    inputs: Mapping[str, Array], first: Sequence[str], measured: Mapping[str, Array] = _NOTHING
) -> tuple[Array, str]:
    """(n,) 1 or -1 for each row of an unfolded list: whether what the curves run along rises or falls to it.

    Args:
        inputs: (n,) each, in the order in which they were taken.
        first: names of inputs that a muscle contracts by; of those that take as many values the first counts.
        measured: (n,) each; they decide where several vary continuously.

    Returns:
        The directions, zero where nothing varies; and the name of the input that they are of, "" for none.
    """
    on = {name: levels(values) for name, values in inputs.items()}
    moving = {n: inputs[n] for n in first if on[n] is None or on[n].max(initial=0) > 0}  # type: ignore[union-attr]
    count = len(next(iter(inputs.values())))
    if not moving:
        return np.zeros(count), ""
    along = _along(moving, {n: on[n] for n in moving}, measured)
    other_inputs = [k for n, k in on.items() if n != along and k is not None]
    key = np.column_stack([np.zeros(count), *other_inputs])
    cuts = [0, *(np.flatnonzero(np.any(np.diff(key, axis=0) != 0, axis=1)) + 1), count]
    values = inputs[along]
    least = _TURN_RANGE * float(np.ptp(values))
    ways = [_ways(values[a:b], least) for a, b in zip(cuts[:-1], cuts[1:], strict=True)]
    return np.concatenate(ways), along


def _ways(values: Array, least: float) -> Array:
    """1 or -1 by the way in which the values go, which turns where they go back by more than ``least``."""
    turns, way, extreme = [0], 0, 0
    for i, value in enumerate(values):
        if way >= 0 and value > values[extreme]:
            extreme, way = i, way or (1 if value - values[0] > least else 0)
        elif way <= 0 and value < values[extreme]:
            extreme, way = i, way or (-1 if values[0] - value > least else 0)
        elif way and abs(value - values[extreme]) > least:
            turns.append(extreme)
            extreme, way = i, -way
    if way == 0:
        return np.zeros(len(values))
    ways = np.empty(len(values))
    sign = way * (-1) ** (len(turns) - 1)
    for begin, end in zip(turns, [*turns[1:], len(values) - 1], strict=True):
        ways[begin + (begin > 0) : end + 1] = sign
        sign = -sign
    return ways
