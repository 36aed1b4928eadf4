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
_FIRST_TRUST_RADIUS = (
    1.0  # of a step in any coordinate: a factor of e, or the typical size of the parameter
)
_ACCEPTED = 1e-4  # gain ratio that a step must have: what it takes away over what was predicted
_TRUSTED = 0.25  # gain ratio from which on a small reduction means that little can still be gained
_RELIABLE = 0.5  # gain ratio from which on the trust radius grows
_STEP = 1e-7  # relative step that counts as none
_TINY = 1e-300  # lsq_linear requires different bounds


@dataclass(frozen=True)
class Minimum:
    """A local minimum: where a descent ended.

    Attributes:
        cost: sum of squared residuals.
        z: (n,) coordinates.
        jacobian: (m, n) there, as the triangular factor, which has the same norms and the same singular values.
    """

    cost: float
    z: Array
    jacobian: Array


def levenberg_marquardt(
    squares: Callable[[Array], float],
    triangle: Callable[[Array], Array],
    start: Array,
    bounds: tuple[Array, Array],
    precision: float,
    most_evaluations: int,
    is_over: Callable[[], bool] = lambda: False,
) -> Minimum:
    """Goes down from ``start``: a damped step at a time, no longer than a trust radius that grows with the gain ratio.

    Args:
        squares: sum of squared residuals at a place; infinite where the model breaks down, where no step leads then.
        triangle: (m, n + 1) the triangular factor of the slopes and the residuals; requested where ``squares`` was
            asked last and is finite.
        start: (n,) within the bounds, where the residuals are finite.
        bounds: lower and upper, (n,) each.
        precision: a descent ends where a step takes away less than this part of the cost, or one that takes nothing
            away promised less.
        most_evaluations: of ``squares``.
        is_over: asked before each step; the descent ends where it stands.
    """
    low, high = bounds
    z, cost, linear = start, squares(start), triangle(start)
    damping, growth, trust_radius = _FIRST_DAMPING, 2.0, _FIRST_TRUST_RADIUS
    size = np.linalg.norm(linear[:, :-1], axis=0)
    for _ in range(most_evaluations - 1):
        if is_over():
            break
        box = np.maximum(low - z, -trust_radius), np.minimum(high - z, trust_radius)
        step, predicted = _step(linear, np.where(size > 0, size, 1.0), damping, box)
        if predicted <= 0 or np.all(np.abs(step) <= _STEP * (_STEP + np.abs(z))):
            break
        candidate = np.clip(z + step, low, high)
        new = squares(candidate)
        reduction = cost - new
        gain_ratio = reduction / predicted
        if not gain_ratio > _ACCEPTED:  # an infinite residual is no gain either
            if predicted < precision * cost:
                break
            damping *= growth
            growth *= 2
            trust_radius = float(np.max(np.abs(step))) / 2
            continue
        little = reduction < precision * cost and gain_ratio > _TRUSTED
        z, cost, linear = candidate, new, triangle(candidate)
        size = np.maximum(size, np.linalg.norm(linear[:, :-1], axis=0))
        damping, growth = damping * max(1 / 3, 1 - (2 * gain_ratio - 1) ** 3), 2.0
        trust_radius *= 2 if gain_ratio > _RELIABLE else 1
        if little:
            break
    return Minimum(cost, z, linear[:, :-1])


def _step(
    triangle: Array, size: Array, damping: float, box: tuple[Array, Array]
) -> tuple[Array, float]:
    """The damped step within the bounds, and by how much it lowers the cost of the linearised residuals."""
    n = len(size)
    within, right = triangle[:n, :n], triangle[:n, n]
    rows = np.vstack([within / size, np.sqrt(damping) * np.eye(n)])
    bounds = np.minimum(box[0] * size, -_TINY), np.maximum(box[1] * size, _TINY)
    solution = lsq_linear(rows, np.concatenate([-right, np.zeros(n)]), bounds, method="bvls")
    step: Array = solution.x / size
    change = within @ step
    return step, -float(2 * right @ change + change @ change)
