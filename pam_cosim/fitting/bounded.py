"""Linear least squares with bounds on the unknowns, exactly."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cholesky, solve_triangular
from scipy.optimize import lsq_linear

from pam_cosim.arrays import Array

_RIDGE = 1e-8  # of the diagonal: what directions that say nothing new are held by
_ROUNDS = 30  # active sets, before the other method is asked; two to five are the rule
_WIDTH = 1e-12  # of bounds that coincide: ``lsq_linear`` wants them distinct


def least_in_box(square: Array, along: Array, low: Array, high: Array) -> Array:
    """The x within bounds that makes least of x' A x / 2 - b' x.

    By primal-dual active sets (Bergounioux, Ito and Kunisch, SIAM J. Control Optim. 37, 1999): whatever the bounds
    hold back is released as soon as its multiplier has the other sign. Where the sets go round in a circle, by the
    bounded variable least squares of SciPy.

    Args:
        square: (n, n) A, positive semidefinite; an unknown without a diagonal element stays as near to 0 as it can.
        along: (n,) b.
        low: (n,) lower bounds; may be minus infinity.
        high: (n,) upper bounds, not below ``low``.

    Returns:
        (n,) x.
    """
    size = np.sqrt(np.maximum(np.diag(square), 0.0))
    x = np.clip(np.zeros(len(along)), low, high)
    felt = np.flatnonzero(size > 0)
    if felt.size:
        scale = size[felt]
        matrix = square[np.ix_(felt, felt)] / np.outer(scale, scale) + _RIDGE * np.eye(len(felt))
        scaled = _scaled_minimum(matrix, along[felt] / scale, low[felt] * scale, high[felt] * scale)
        x[felt] = np.clip(scaled / scale, low[felt], high[felt])
    return x


def least_squares_in_box(matrix: Array, right: Array, low: Array, high: Array) -> Array:
    """The x within bounds that makes least of \\|matrix x - right\\|; shapes (m, n), (m,), (n,), (n,)."""
    return least_in_box(matrix.T @ matrix, matrix.T @ right, low, high)


def _scaled_minimum(matrix: Array, right: Array, low: Array, high: Array) -> Array:
    fixed = low >= high
    free_minimum = np.linalg.solve(matrix, right)
    at_low, at_high = (free_minimum < low) | fixed, (free_minimum > high) & ~fixed
    for _ in range(_ROUNDS):
        x = _with_active_bounds(matrix, right, np.where(at_low, low, high), at_low | at_high)
        multiplier = right - matrix @ x  # of an unknown at its bound: towards which side it would go
        next_low = fixed | (at_low & (multiplier < 0)) | (~at_low & ~at_high & (x < low))
        next_high = ~fixed & ((at_high & (multiplier > 0)) | (~at_low & ~at_high & (x > high)))
        if np.array_equal(next_low, at_low) and np.array_equal(next_high, at_high):
            return x
        at_low, at_high = next_low, next_high
    return _by_other_method(matrix, right, low, high)


def _with_active_bounds(matrix: Array, right: Array, bounds: Array, active: NDArray[np.bool_]) -> Array:
    x = np.where(active, bounds, 0.0)
    free = ~active
    if free.any():
        x[free] = np.linalg.solve(matrix[np.ix_(free, free)], right[free] - matrix[np.ix_(free, active)] @ x[active])
    return x


def _by_other_method(matrix: Array, right: Array, low: Array, high: Array) -> Array:
    factor = cholesky(matrix)
    target = solve_triangular(factor, right, trans=1)
    apart = np.maximum(high, low + _WIDTH)
    return np.asarray(lsq_linear(factor, target, (low, apart), method="bvls").x)


__all__ = ["least_in_box", "least_squares_in_box"]
