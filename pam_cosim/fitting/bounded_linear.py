"""Linear least squares within bounds, exactly.

Primal-dual active sets: which bounds hold is guessed, the others are solved for, and the solution shows which bounds to
hold next, those that it is beyond, and which to release, those that the slope leads away from. Hintermüller, Ito and
Kunisch (2003), SIAM J. Optim. 13, 865-888. A few rounds come to the minimum as a rule; where they go in a circle,
``scipy.optimize.lsq_linear`` goes there one bound at a time.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import lsq_linear

from pam_cosim.arrays import Array

_ROUNDS = 20  # of guesses; five are many
_EXACT = 1e-12  # of the right side and of the largest coordinate: rounding
_STEEPEST = 1e-14  # relative change at which the net ends


def bounded_least_squares(matrix: Array, right: Array, low: Array, high: Array) -> Array:
    """The x within bounds that minimises ``|matrix x - right|``; a column of zeros has the x nearest to zero.

    Args:
        matrix: (m, n). right: (m,).
        low: (n,) the bounds, ``low <= high``; they may be infinite.
        high: (n,) likewise, the upper ones.

    Returns:
        (n,).
    """
    size = np.linalg.norm(matrix, axis=0)
    x: Array = np.clip(np.zeros(len(size)), low, high)
    free = (size > 0) & (low < high)
    if free.any():
        right = right - matrix[:, ~free] @ x[~free]
        rows, right = _triangle(matrix[:, free] / size[free], right)
        scaled = _of_rows(rows, right, low[free] * size[free], high[free] * size[free])
        x[free] = np.clip(scaled / size[free], low[free], high[free])
    return x


def _triangle(rows: Array, right: Array) -> tuple[Array, Array]:
    """The same problem in no more rows than unknowns."""
    n = rows.shape[1]
    if len(rows) <= n:
        return rows, right
    triangle: Array = np.asarray(np.linalg.qr(np.column_stack([rows, right]), mode="r"))
    return triangle[:n, :n], triangle[:n, n]


def _of_rows(rows: Array, right: Array, low: Array, high: Array) -> Array:
    """The solution for columns of length one; a side is -1 at the lower bound, 1 at the upper one, 0 between them."""
    side, size = np.zeros(len(low), dtype=int), float(np.linalg.norm(right))
    for _ in range(_ROUNDS):
        x: Array = np.where(side < 0, low, np.where(side > 0, high, 0.0))
        free = side == 0
        if free.any():
            x[free] = np.linalg.lstsq(rows[:, free], right - rows @ x, rcond=None)[0]
        slope = rows.T @ (rows @ x - right)
        slope[free] = 0.0
        if _is_minimum(x, slope, side, low, high, size):
            return x
        target = x - slope
        side = np.where(target < low, -1, np.where(target > high, 1, 0))
    return _one_bound_at_a_time(rows, right, low, high)


def _one_bound_at_a_time(rows: Array, right: Array, low: Array, high: Array) -> Array:
    net: Array = lsq_linear(
        rows, right, (low, high), method="bvls", tol=_STEEPEST, max_iter=100 * len(low)
    ).x
    return net


def _is_minimum(
    x: Array, slope: Array, side: NDArray[np.int_], low: Array, high: Array, size: float
) -> bool:
    """Whether nothing is beyond its bounds, and at a bound the slope leads out of the box."""
    beyond = np.maximum(low - x, x - high)
    inwards = slope * side
    return bool(beyond.max() <= _EXACT * np.abs(x).max() and inwards.max() <= _EXACT * size)
