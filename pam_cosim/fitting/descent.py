"""Bounded least squares by the method of Levenberg and Marquardt, each step exact within the bounds.

Fits of models end at bounds more often than not: an exponent at 1.4, a friction that is not there. Methods that
keep to the inside of the bounds (trust region reflective) then creep along them, and those that go from face to face
of the box (dogbox) get stuck in corners. Here each step minimises the linearised residuals, damped, within the box
itself, by ``scipy.optimize.lsq_linear``; see Kanzow, Yamashita and Fukushima (2004), J. Comput. Appl. Math. 172, for
why that converges, and Nielsen (1999), IMM-REP-1999-05, for the damping.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.optimize import lsq_linear

from pam_cosim.arrays import Array

_FIRST_DAMPING = 1e-3  # of the squared size of each column
_FIRST_REACH = 1.0  # of a step in any coordinate: a factor of e, or the typical size of the parameter
_ACCEPTED = 1e-4  # of the gain that was foretold, that a step must bring
_TRUSTED = 0.25  # of it, from which on a small gain means that little is left to gain
_RELIABLE = 0.5  # of it, from which on a step may reach further
_STEP = 1e-7  # relative step that counts as none
_TINY = 1e-300  # lsq_linear wants the bounds apart


@dataclass(frozen=True)
class Descent:
    """Where a descent ended.

    Attributes:
        cost: sum of squared residuals.
        z: (n,) coordinates.
        jacobian: (m, n) there.
    """

    cost: float
    z: Array
    jacobian: Array


def descend(
    residuals: Callable[[Array], Array],
    jacobian: Callable[[Array], Array],
    start: Array,
    bounds: tuple[Array, Array],
    precision: float,
    most_evaluations: int,
) -> Descent:
    """Goes down from ``start``.

    Args:
        residuals: (m,) of (n,); infinite where the model breaks down, where no step leads then.
        jacobian: (m, n) of (n,); asked for where ``residuals`` was asked last and every residual is finite.
        start: (n,) within the bounds, where the residuals are finite.
        bounds: lower and upper, (n,) each.
        precision: a descent ends where a step takes away less than this part of the cost.
        most_evaluations: of ``residuals``.
    """
    low, high = bounds
    z, e, slopes = start, residuals(start), jacobian(start)
    cost, damping, patience, reach = float(e @ e), _FIRST_DAMPING, 2.0, _FIRST_REACH
    size, triangle = np.linalg.norm(slopes, axis=0), _triangle(slopes, e)
    for _ in range(most_evaluations - 1):
        room = np.maximum(low - z, -reach), np.minimum(high - z, reach)
        step, foretold = _step(triangle, np.where(size > 0, size, 1.0), damping, room)
        if foretold <= 0 or np.all(np.abs(step) <= _STEP * (_STEP + np.abs(z))):
            break
        moved = np.clip(z + step, low, high)
        new = residuals(moved)
        gain = cost - float(new @ new)
        quality = gain / foretold
        if not quality > _ACCEPTED:  # an infinite residual is no gain either
            damping *= patience
            patience *= 2
            reach = float(np.max(np.abs(step))) / 2
            continue
        little = gain < precision * cost and quality > _TRUSTED
        z, cost, slopes = moved, cost - gain, jacobian(moved)
        size, triangle = np.maximum(size, np.linalg.norm(slopes, axis=0)), _triangle(slopes, new)
        damping, patience = damping * max(1 / 3, 1 - (2 * quality - 1) ** 3), 2.0
        reach *= 2 if quality > _RELIABLE else 1
        if little:
            break
    return Descent(cost, z, slopes)


def _triangle(slopes: Array, e: Array) -> Array:
    """The linearised residuals e + slopes s as few rows: the triangular factor of the slopes beside the residuals."""
    return np.asarray(np.linalg.qr(np.column_stack([slopes, e]), mode="r"))


def _step(triangle: Array, size: Array, damping: float, room: tuple[Array, Array]) -> tuple[Array, float]:
    """The damped step within the bounds, and by how much it lowers the cost of the linearised residuals."""
    n = len(size)
    within, right = triangle[:n, :n], triangle[:n, n]
    rows = np.vstack([within / size, np.sqrt(damping) * np.eye(n)])
    apart = np.minimum(room[0] * size, -_TINY), np.maximum(room[1] * size, _TINY)
    found = lsq_linear(rows, np.concatenate([-right, np.zeros(n)]), apart, method="bvls")
    step: Array = found.x / size
    change = within @ step
    return step, -float(2 * right @ change + change @ change)
