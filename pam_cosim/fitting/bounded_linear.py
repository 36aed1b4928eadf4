"""Linear least squares within bounds, exactly.

Primal-dual active sets: which bounds hold is guessed, the others are solved for, and the solution shows which bounds to
hold next, those that it is beyond, and which to release, those that the slope leads away from. Hintermüller, Ito and
Kunisch (2003), SIAM J. Optim. 13, 865-888. A few rounds come to the minimum as a rule; where they go in a circle,
``scipy.optimize.lsq_linear`` goes there one bound at a time.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_triangular
from scipy.optimize import lsq_linear

from pam_cosim.arrays import Array

Moved = NDArray[np.bool_]
Bounds = tuple[Array, Array]

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

    def solve(is_free: Moved, x: Array, size: Array, bounds: Bounds) -> Array:
        remaining_right = right - matrix[:, ~is_free] @ x[~is_free]
        return _of_rows(*_triangle(matrix[:, is_free] / size, remaining_right), *bounds)

    return _in_scale(np.linalg.norm(matrix, axis=0), low, high, solve)


def bounded_minimum(square: Array, along: Array, low: Array, high: Array, ridge: float) -> Array:
    """The x within bounds that minimises ``x' square x - 2 along' x``; what moves nothing is nearest to zero.

    Args:
        square: (n, n). along: (n,).
        low: (n,) the bounds, ``low <= high``; they may be infinite.
        high: (n,) likewise, the upper ones.
        ridge: what is added to a diagonal of ones, to which ``square`` is scaled, so that it is positive definite.

    Returns:
        (n,).
    """

    def solve(is_free: Moved, x: Array, size: Array, bounds: Bounds) -> Array:
        remaining_gradient = along[is_free] - square[np.ix_(is_free, ~is_free)] @ x[~is_free]
        scaled = square[np.ix_(is_free, is_free)] / np.outer(size, size)
        return _of_square(scaled + ridge * np.eye(len(size)), remaining_gradient / size, *bounds)

    return _in_scale(np.sqrt(np.maximum(np.diag(square), 0.0)), low, high, solve)


def _in_scale(
    size: Array, low: Array, high: Array, solve: Callable[[Moved, Array, Array, Bounds], Array]
) -> Array:
    """The solution where every column has length one, of those that something moves, in the scale of the problem."""
    x: Array = np.clip(np.zeros(len(size)), low, high)
    is_free = (size > 0) & (low < high)
    if is_free.any():
        free_size = size[is_free]
        scaled = solve(is_free, x, free_size, (low[is_free] * free_size, high[is_free] * free_size))
        x[is_free] = np.clip(scaled / free_size, low[is_free], high[is_free])
    return x


def _triangle(rows: Array, right: Array) -> tuple[Array, Array]:
    """The same problem in no more rows than unknowns."""
    n = rows.shape[1]
    if len(rows) <= n:
        return rows, right
    triangle: Array = np.asarray(np.linalg.qr(np.column_stack([rows, right]), mode="r"))
    return triangle[:n, :n], triangle[:n, n]


def _of_rows(rows: Array, right: Array, low: Array, high: Array) -> Array:
    """The solution for columns of length one."""

    def solve_free(x: Array, free: NDArray[np.bool_]) -> Array:
        return np.asarray(np.linalg.lstsq(rows[:, free], right - rows @ x, rcond=None)[0])

    x = _active_sets(
        solve_free, lambda x: rows.T @ (rows @ x - right), low, high, float(np.linalg.norm(right))
    )
    return _one_bound_at_a_time(rows, right, low, high) if x is None else x


def _of_square(square: Array, along: Array, low: Array, high: Array) -> Array:
    """The same for a quadratic form, positive definite."""

    def solve_free(x: Array, free: NDArray[np.bool_]) -> Array:
        return np.asarray(np.linalg.solve(square[np.ix_(free, free)], (along - square @ x)[free]))

    x = _active_sets(
        solve_free, lambda x: square @ x - along, low, high, float(np.linalg.norm(along))
    )
    if x is None:
        lower: Array = np.asarray(np.linalg.cholesky(square), dtype=float)
        right = solve_triangular(lower, along, lower=True, check_finite=False)
        return _one_bound_at_a_time(lower.T, right, low, high)
    return x


def _active_sets(
    solve_free: Callable[[Array, NDArray[np.bool_]], Array],
    slope_at: Callable[[Array], Array],
    low: Array,
    high: Array,
    size: float,
) -> Array | None:
    """The minimum within bounds; None: the guesses go in a circle.

    A side is -1 at the lower bound, 1 at the upper one, 0 between them. ``solve_free`` solves for the
    free ones, given the others.
    """
    side = np.zeros(len(low), dtype=int)
    for _ in range(_ROUNDS):
        x: Array = np.where(side < 0, low, np.where(side > 0, high, 0.0))
        free = side == 0
        if free.any():
            x[free] = solve_free(x, free)
        slope = slope_at(x)
        slope[free] = 0.0
        if _is_minimum(x, slope, side, low, high, size):
            return x
        target = x - slope
        side = np.where(target < low, -1, np.where(target > high, 1, 0))
    return None


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
