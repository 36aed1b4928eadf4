"""Missing terms as random walks: what they add to the problem, and the noise intensity that is most probable."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy.optimize import minimize

from pam_cosim.arrays import Array
from pam_cosim.ledger.block_tridiagonal import BlockTridiagonal, CholeskyFactor
from pam_cosim.ledger.grid import Grid
from pam_cosim.ledger.smoothing_problem import LinearisedProblem, Point, SmoothingProblem


def with_walk(problem: SmoothingProblem, matrix: BlockTridiagonal, q: Array) -> BlockTridiagonal:
    """The matrix of the linearised problem with the walks, of noise intensities ``q`` (m,)."""
    if not len(q):
        return matrix
    n, at = problem.model.states, problem.grid.start_node
    diagonal, coupling = matrix.diagonal.copy(), matrix.coupling.copy()
    run_starts, spans = problem.grid.first[:-1], run_spans(problem.grid)
    for j, intensity in enumerate(q.tolist()):
        weight = 1 / (intensity * problem.grid.step)
        i = n + j
        diagonal[run_starts, i, i] += 1 / (intensity * spans)
        diagonal[at, i, i] += weight
        diagonal[at + 1, i, i] += weight
        coupling[at, i, i] -= weight
    return replace(matrix, diagonal=diagonal, coupling=coupling)


def run_spans(grid: Grid) -> Array:
    """Durations of the runs [s]: a walk starts as far from zero as it may go in a run."""
    return grid.time[grid.first[1:] - 1] - grid.time[grid.first[:-1]]


def _increments(problem: SmoothingProblem, point: Point) -> Array:
    at = problem.grid.start_node
    return (point.w[at + 1] - point.w[at]) / problem.unknown_size


def walk_gradient(problem: SmoothingProblem, point: Point, q: Array) -> Array:
    """(N, n + m) what the walks add to the gradient."""
    n, at = problem.model.states, problem.grid.start_node
    gradient = np.zeros((len(point.x), n + len(q)))
    pull = _increments(problem, point) / (q * problem.grid.step[:, None])
    gradient[at + 1, n:] += pull
    gradient[at, n:] -= pull
    run_starts = problem.grid.first[:-1]
    gradient[run_starts, n:] += (
        point.w[run_starts] / problem.unknown_size / (q * run_spans(problem.grid)[:, None])
    )
    return gradient


def deviance(
    problem: SmoothingProblem,
    linear: LinearisedProblem,
    point: Point,
    q: Array,
    factored: CholeskyFactor | None = None,
) -> float:
    """Minus twice the log marginal likelihood of the linearised problem, at its own minimum.

    Args:
        problem: the model and its samples.
        linear: the problem about ``point``.
        point: the estimate.
        q: (m,) noise intensity of each unknown input [square of its size per s].
        factored: the Cholesky factor with these walks, if it is known.
    """
    factored = factored or CholeskyFactor(with_walk(problem, linear.matrix, q))
    blocks = linear.gradient + walk_gradient(problem, point, q)
    change, outer = factored.solve(blocks, linear.corner_gradient)
    steps = problem.grid.step[:, None] * q
    starts = run_spans(problem.grid)[:, None] * q
    walk = float((_increments(problem, point) ** 2 / steps).sum())
    walk += float(((point.w[problem.grid.first[:-1]] / problem.unknown_size) ** 2 / starts).sum())
    gain = float((blocks * change).sum() + linear.corner_gradient @ outer)
    log_weights = linear.log_weights - float(np.log(steps).sum() + np.log(starts).sum())
    return linear.cost + walk - gain + factored.log_determinant - log_weights


_LOWEST, _HIGHEST = -18.0, 9.0  # natural logarithm of the noise intensity


CLOSED = float(np.exp(_LOWEST))
"""The noise intensity of a term that is practically absent."""


def likeliest_noise_intensity(
    problem: SmoothingProblem,
    linear: LinearisedProblem,
    point: Point,
    q: Array,
    active: Sequence[int] | None = None,
) -> Array:
    """(m,) the noise intensity of the (active) walks that makes the samples most probable, from ``q`` on."""
    chosen = list(range(len(q)) if active is None else active)

    def full(z: Array) -> Array:
        intensity = q.copy()
        intensity[chosen] = np.exp(np.clip(z, _LOWEST, _HIGHEST))
        return intensity

    def cost(z: Array) -> float:
        return deviance(problem, linear, point, full(z))

    z = np.log(q[chosen])
    simplex = np.vstack([z, z + 2.0 * np.eye(len(z))])
    options = {"initial_simplex": simplex, "xatol": 0.2, "fatol": 0.5, "maxfev": 16 * len(z)}
    return full(minimize(cost, z, method="Nelder-Mead", options=options).x)
