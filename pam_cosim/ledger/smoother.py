"""States and missing terms from all samples of all runs at once.

The model holds between the nodes of a grid (Radau IIA of order 3), but for the terms without a law: each is a random
walk whose noise intensity is the one that makes the samples most probable (Laplace's approximation of the marginal
likelihood). Free parameters are estimated along, so that what a value of theirs explains is not called missing.
Every iteration solves the linearised problem exactly; its matrix is block tridiagonal, and its inverse gives the
standard deviations (the smoother of Rauch, Tung and Striebel, in information form; iterated: Bell 1994).
"""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.ledger.block_tridiagonal import CholeskyFactor
from pam_cosim.ledger.random_walks import (
    CLOSED,
    deviance,
    likeliest_noise_intensity,
    run_spans,
    walk_gradient,
    with_walk,
)
from pam_cosim.ledger.smoothing_problem import (
    SLACK,
    LinearisedProblem,
    Point,
    SmoothingProblem,
    linearise,
    products,
)

_FIRST_SLACKS = (
    1e-2,
    1e-3,
    1e-4,
)  # a step may miss the model by this in the first iterations, which come from far
_ITERATIONS = 15
_CLOSE = 1e-3  # change of a state, over its range, at which the iteration ends
_SHORTENED = 6
_SETTLED = 0.1  # the same at which the noise intensity is sought again
_NOISE_INTENSITY_ROUNDS = 2


@dataclass(frozen=True)
class Smoothed:
    """The result of a smoother.

    Attributes:
        point: the estimate.
        deviation: (N, m) standard deviation of the missing terms [SI].
        residual: (N, S) sample minus model [SI], NaN without a sample.
        noise_intensity: (m,) of the random walks: variance per second over the square of the term's size.
        deviance: minus twice the logarithm of the marginal likelihood, but for a constant of the samples.
        chi2: sum of squared residuals in noise variances.
        linear: the problem about the estimate.
    """

    point: Point
    deviation: Array
    residual: Array
    noise_intensity: Array
    deviance: float
    chi2: float
    linear: LinearisedProblem


def smooth(problem: SmoothingProblem, start: Point, deadline: float = math.inf) -> Smoothed:
    """Smooths all runs, from a start.

    Raises:
        numpy.linalg.LinAlgError: the model gives no finite numbers about the start.
        TimeoutError: the deadline, of ``time.monotonic`` [s], came first.
    """
    q = np.full(len(problem.unknown_size), 1 / float(run_spans(problem.grid).max()))
    point, rounds, before, part, growing = start, 0, np.inf, 1.0, False
    linear = linearise(problem, point, _FIRST_SLACKS[0])
    enough = _NOISE_INTENSITY_ROUNDS if len(q) else 0
    for iteration in range(_ITERATIONS):
        if time.monotonic() >= deadline:
            raise TimeoutError("the time limit was reached")
        last = iteration >= len(_FIRST_SLACKS)
        slack = SLACK if last else _FIRST_SLACKS[iteration]
        settled = before < _SETTLED or iteration >= _ITERATIONS // 2
        if last and rounds < enough and (rounds == 0 or settled):
            q, rounds, part = likeliest_noise_intensity(problem, linear, point, q), rounds + 1, 1.0
        elif before > _CLOSE and iteration > len(_FIRST_SLACKS) + 1:
            part = max(part / 2, 0.25) if growing else min(2 * part, 1.0)
        point, linear, distance = _advanced(problem, linear, point, q, part, slack)
        growing, before = distance > 0.7 * before, distance
        if last and distance < _CLOSE and rounds == enough:
            break
    return _result(problem, linear, point, q)


def _advanced(
    problem: SmoothingProblem,
    linear: LinearisedProblem,
    point: Point,
    q: Array,
    part: float,
    slack: float,
) -> tuple[Point, LinearisedProblem, float]:
    """One iteration; a step that leads out of what the model can evaluate is shortened."""
    for _ in range(_SHORTENED):
        new, distance = _stepped(problem, linear, point, q, part)
        with np.errstate(all="ignore"):
            about = linearise(problem, new, slack)
        if (
            np.isfinite(about.cost)
            and np.isfinite(about.matrix.diagonal).all()
            and np.isfinite(about.gradient).all()
        ):
            return new, about, distance
        part /= 3
    raise np.linalg.LinAlgError("the model has no finite values near the samples")


def _result(
    problem: SmoothingProblem, linear: LinearisedProblem, point: Point, q: Array
) -> Smoothed:
    factored = CholeskyFactor(with_walk(problem, linear.matrix, q))
    covariance, _ = factored.covariances()
    variance = np.diagonal(covariance, axis1=1, axis2=2)[:, problem.model.states :]
    return Smoothed(
        point,
        np.sqrt(variance) * problem.unknown_size,
        linear.residual,
        q,
        deviance(problem, linear, point, q, factored),
        float(np.nansum((linear.residual / problem.sigma) ** 2)),
        linear,
    )


def _stepped(
    problem: SmoothingProblem, linear: LinearisedProblem, point: Point, q: Array, part: float
) -> tuple[Point, float]:
    """A part of the way to the minimum of the linearised problem, and how far a state has to go, over its range."""
    factored = CholeskyFactor(with_walk(problem, linear.matrix, q))
    blocks = linear.gradient + walk_gradient(problem, point, q)
    change, outer = factored.solve(-blocks, -linear.corner_gradient)
    n, grid = problem.model.states, problem.grid
    dx, dw, df = (
        change[:, :n] * problem.size,
        change[:, n:] * problem.unknown_size,
        outer * problem.spread,
    )
    dx, dw, df = part * dx, part * dw, part * df
    constant, by_left, by_right, by_walk, by_free = linear.stage
    at = grid.start_node
    ds = -(
        part * constant + products(by_left, dx[at]) + products(by_right, dx[at + 1]) + by_free @ df
    )
    ds -= products(by_walk, np.concatenate([dw[at], dw[at + 1]], axis=1))
    free = np.clip(point.free + df, problem.low, problem.high)
    new = Point(point.x + dx, point.s + ds, point.w + dw, free)
    return new, float(np.max(np.abs(change[:, :n])))


def with_some(
    problem: SmoothingProblem, smoothed: Smoothed, active: Sequence[int]
) -> tuple[float, float]:
    """Deviance and chi-square with only some of the terms, of the problem linearised about an estimate with all."""
    q = np.full(len(smoothed.noise_intensity), CLOSED)
    q[list(active)] = smoothed.noise_intensity[list(active)]
    if active:
        q[list(active)] = np.maximum(q[list(active)], 1e-3)
        q = likeliest_noise_intensity(problem, smoothed.linear, smoothed.point, q, active)
    linear = smoothed.linear
    factored = CholeskyFactor(with_walk(problem, linear.matrix, q))
    blocks = linear.gradient + walk_gradient(problem, smoothed.point, q)
    change, outer = factored.solve(-blocks, -linear.corner_gradient)
    rows, rows_free = linear.rows
    r = -linear.residual / problem.sigma + products(rows, change) + rows_free @ outer
    return deviance(problem, linear, smoothed.point, q, factored), float(np.nansum(r**2))
