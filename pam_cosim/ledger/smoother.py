"""States and missing terms from all samples of all runs at once.

The model holds between the nodes of a grid (Radau IIA of order 3), but for the terms without a law: each is a random
walk whose noise intensity is the one that makes the samples most probable (Laplace's approximation of the marginal
likelihood). Free parameters are estimated along, so that what a value of theirs explains is not called missing.
Every iteration solves the linearised problem exactly; its matrix is block tridiagonal, and its inverse gives the
standard deviations (the smoother of Rauch, Tung and Striebel, in information form; iterated: Bell 1994).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import minimize

from pam_cosim.arrays import Array
from pam_cosim.ledger.block_tridiagonal import BlockTridiagonal, CholeskyFactor
from pam_cosim.ledger.grid import STAGE, Grid
from pam_cosim.ledger.model import Model

_SLACK = 1e-5  # of a state's range: what a step may miss the model by
_FIRST_SLACKS = (1e-2, 1e-3, 1e-4)  # the same in the first iterations, which come from far
_START = 1e-3  # of a state's range: how well the model knows its own start
_ITERATIONS = 15
_CLOSE = 1e-3  # change of a state, over its range, at which the iteration ends
_SHORTENED = 6
_SETTLED = 0.1  # the same at which the noise intensity is sought anew
_NOISE_INTENSITY_ROUNDS = 2


@dataclass(frozen=True)
class SmoothingProblem:
    """What is to be smoothed.

    Attributes:
        model: right-hand side with Q free parameters and m unknown inputs.
        grid: N nodes and M steps.
        sigma: (S,) standard deviations of the samples [SI].
        prior: (Q,) values of the free parameters [SI], and ``spread`` (Q,) how far they may be off.
        low, high: (Q,) bounds.
        size: (n,) sizes of the states.
        unknown_size: (m,) sizes of the missing terms [SI].
    """

    model: Model
    grid: Grid
    sigma: Array
    prior: Array
    spread: Array
    low: Array
    high: Array
    size: Array
    unknown_size: Array

    def parameters(self, free: Array) -> Array:
        """All parameters of the runs, (R, P), with values for the free ones."""
        p = self.grid.parameters.copy()
        p[:, self.model.free_at] = free
        return p


@dataclass(frozen=True)
class Point:
    """An estimate: states at nodes (N, n) and inside steps (M, n), missing terms (N, m), free parameters (Q,)."""

    x: Array
    s: Array
    w: Array
    free: Array


@dataclass(frozen=True)
class LinearisedProblem:
    """The problem about a point, in scaled variables: all rows but those of the random walks.

    Attributes:
        matrix: of its normal equations; ``gradient`` (N, n + m) and ``corner_gradient`` (Q,) of half the cost.
        cost: sum of the squares of all rows.
        log_weights: logarithm of the determinant of the matrix without samples and walks.
        residual: (N, S) sample minus model [SI], and ``outputs`` (N, S) the model.
        stage: how the states inside the steps follow from the ends.
        flow: (M, n, n) and (M, n, Q), how the end of a step follows from its start and the free parameters.
        rows: (N, S, n + m) and (N, S, Q), how the modelled samples follow, in standard deviations.
    """

    matrix: BlockTridiagonal
    gradient: Array
    corner_gradient: Array
    cost: float
    log_weights: float
    residual: Array
    outputs: Array
    stage: tuple[Array, Array, Array, Array, Array]
    flow: tuple[Array, Array]
    rows: tuple[Array, Array]


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
        converged: whether the iteration came to rest.
        linear: the problem about the estimate.
    """

    point: Point
    deviation: Array
    residual: Array
    noise_intensity: Array
    deviance: float
    chi2: float
    converged: bool
    linear: LinearisedProblem


def smooth(problem: SmoothingProblem, start: Point) -> Smoothed:
    """Smooths all runs, from a start.

    Raises:
        numpy.linalg.LinAlgError: the model gives no finite numbers about the start.
    """
    q = np.full(len(problem.unknown_size), 1 / float(_spans(problem.grid).max()))
    point, converged, rounds, before, part, growing = start, False, 0, np.inf, 1.0, False
    linear = linearise(problem, point, _FIRST_SLACKS[0])
    enough = _NOISE_INTENSITY_ROUNDS if len(q) else 0
    for iteration in range(_ITERATIONS):
        last = iteration >= len(_FIRST_SLACKS)
        slack = _SLACK if last else _FIRST_SLACKS[iteration]
        settled = before < _SETTLED or iteration >= _ITERATIONS // 2
        if last and rounds < enough and (rounds == 0 or settled):
            q, rounds, part = likeliest_noise_intensity(problem, linear, point, q), rounds + 1, 1.0
        elif before > _CLOSE and iteration > len(_FIRST_SLACKS) + 1:
            part = max(part / 2, 0.25) if growing else min(2 * part, 1.0)
        point, linear, moved = _advanced(problem, linear, point, q, part, slack)
        growing, before = moved > 0.7 * before, moved
        converged = last and moved < _CLOSE
        if converged and rounds == enough:
            break
    return _result(problem, linear, point, q, converged)


def _advanced(
    problem: SmoothingProblem, linear: LinearisedProblem, point: Point, q: Array, part: float, slack: float
) -> tuple[Point, LinearisedProblem, float]:
    """One iteration; a step that leads out of what the model can evaluate is shortened."""
    for _ in range(_SHORTENED):
        new, moved = _stepped(problem, linear, point, q, part)
        with np.errstate(all="ignore"):
            about = linearise(problem, new, slack)
        if np.isfinite(about.cost) and np.isfinite(about.matrix.diagonal).all() and np.isfinite(about.gradient).all():
            return new, about, moved
        part /= 3
    raise np.linalg.LinAlgError("the model has no finite values near the samples")


def _result(problem: SmoothingProblem, linear: LinearisedProblem, point: Point, q: Array, converged: bool) -> Smoothed:
    factored = CholeskyFactor(_with_walk(problem, linear.matrix, q))
    covariance, _ = factored.covariances()
    variance = np.diagonal(covariance, axis1=1, axis2=2)[:, problem.model.states :]
    return Smoothed(
        point,
        np.sqrt(variance) * problem.unknown_size,
        linear.residual,
        q,
        deviance(problem, linear, point, q, factored),
        float(np.nansum((linear.residual / problem.sigma) ** 2)),
        converged,
        linear,
    )


# ---- one iteration --------------------------------------------------------------------------------------------


def _stepped(
    problem: SmoothingProblem, linear: LinearisedProblem, point: Point, q: Array, part: float
) -> tuple[Point, float]:
    """A part of the way to the minimum of the linearised problem, and how far a state has to go, over its range."""
    factored = CholeskyFactor(_with_walk(problem, linear.matrix, q))
    blocks = linear.gradient + _walk_gradient(problem, point, q)
    change, outer = factored.solve(-blocks, -linear.corner_gradient)
    n, grid = problem.model.states, problem.grid
    dx, dw, df = change[:, :n] * problem.size, change[:, n:] * problem.unknown_size, outer * problem.spread
    dx, dw, df = part * dx, part * dw, part * df
    constant, by_left, by_right, by_walk, by_free = linear.stage
    at = grid.left
    ds = -(part * constant + _times(by_left, dx[at]) + _times(by_right, dx[at + 1]) + by_free @ df)
    ds -= _times(by_walk, np.concatenate([dw[at], dw[at + 1]], axis=1))
    free = np.clip(point.free + df, problem.low, problem.high)
    new = Point(point.x + dx, point.s + ds, point.w + dw, free)
    return new, float(np.max(np.abs(change[:, :n])))


def _times(matrices: Array, vectors: Array) -> Array:
    products: Array = np.einsum("kij,kj->ki", matrices, vectors)
    return products


def linearise(problem: SmoothingProblem, point: Point, slack: float = _SLACK) -> LinearisedProblem:
    """The problem about a point; a step may miss the model by ``slack`` of the range of a state."""
    model, grid = problem.model, problem.grid
    n, m, at = model.states, model.unknown_inputs, grid.left
    p = problem.parameters(point.free)[grid.run_of_node]
    p_stage = p[at].copy()
    p[:, model.unknown_at] = point.w
    p_stage[:, model.unknown_at] = (1 - STAGE) * point.w[at] + STAGE * point.w[at + 1]
    h = grid.step
    node = model.everything(grid.time, point.x, grid.node_inputs, grid.node_delayed, p)
    inner = model.rates(grid.time[at] + STAGE * h, point.s, grid.stage_inputs, grid.stage_delayed, p_stage)
    f2, a2, b2, c2 = (v[at + 1, :n] for v in node)
    f1, a1, b1, c1 = inner
    hh, h1 = h[:, None, None], h[:, None]
    eye = np.eye(n)
    # the state inside a step follows from its ends
    solve = np.asarray(np.linalg.inv(eye - hh * a1 * 5 / 12), dtype=np.float64)
    d1 = point.s - point.x[at] - h1 * (5 * f1 - f2) / 12
    w1 = np.concatenate([-(1 - STAGE) * hh * b1 * 5 / 12, -STAGE * hh * b1 * 5 / 12 + hh * b2 / 12], axis=2)
    c_in = -hh * c1 * 5 / 12 + hh * c2 / 12
    stage = (_times(solve, d1), -solve, solve @ (hh * a2 / 12), solve @ w1, solve @ c_in)
    # the end of a step follows from its start
    k = hh * a1 * 3 / 4
    d2 = point.x[at + 1] - point.x[at] - h1 * (3 * f1 + f2) / 4
    w2 = np.concatenate([-(1 - STAGE) * hh * b1 * 3 / 4, -STAGE * hh * b1 * 3 / 4 - hh * b2 / 4], axis=2)
    end = np.asarray(np.linalg.inv(eye - hh * a2 / 4 + k @ stage[2]), dtype=np.float64)
    scale = problem.size
    defect = _times(end, d2 + _times(k, stage[0])) / scale
    by_left = end @ (-eye + k @ stage[1]) * scale / scale[:, None]
    by_walk = end @ (w2 + k @ stage[3]) * np.tile(problem.unknown_size, 2) / scale[:, None]
    by_free = end @ (-hh * (3 * c1 + c2) / 4 + k @ stage[4]) * problem.spread / scale[:, None]
    by_right = np.concatenate([np.broadcast_to(eye, (len(h), n, n)), by_walk[:, :, m:]], axis=2)
    by_left = np.concatenate([by_left, by_walk[:, :, :m]], axis=2)
    weight = 1 / slack**2

    values = [v[:, n:] for v in node]
    kept = np.isfinite(grid.measured)
    residual = np.where(kept, grid.measured - values[0], np.nan)
    r = np.where(kept, -residual / problem.sigma, 0.0)
    rows = np.concatenate([values[1] * scale, values[2] * problem.unknown_size], axis=2) / problem.sigma[:, None]
    rows = np.where(kept[:, :, None], rows, 0.0)
    rows_free = np.where(kept[:, :, None], values[3] * problem.spread / problem.sigma[:, None], 0.0)

    b = n + m
    diagonal = np.einsum("nsi,nsj->nij", rows, rows)
    coupling = np.zeros((len(point.x) - 1, b, b))
    border = np.einsum("nsi,nsq->niq", rows, rows_free)
    gradient = np.einsum("nsi,ns->ni", rows, r)
    corner = np.einsum("nsq,nsr->qr", rows_free, rows_free)
    corner_gradient = np.einsum("nsq,ns->q", rows_free, r)
    for side, by in ((at, by_left), (at + 1, by_right)):
        diagonal[side] += weight * np.einsum("kij,kil->kjl", by, by)
        gradient[side] += weight * np.einsum("kij,ki->kj", by, defect)
        border[side] += weight * np.einsum("kij,kiq->kjq", by, by_free)
    coupling[at] += weight * np.einsum("kij,kil->kjl", by_left, by_right)
    corner += weight * np.einsum("kiq,kir->qr", by_free, by_free)
    corner_gradient += weight * np.einsum("kiq,ki->q", by_free, defect)
    cost = float((r**2).sum() + weight * (defect**2).sum())
    log_weights = defect.size * np.log(weight)

    # the starts of the runs, and what is known of the free parameters
    first = grid.first[:-1]
    begins = model.initial(problem.parameters(point.free), grid)
    start = (point.x[first] - begins) / scale / _START
    diagonal[first, :n, :n] += np.eye(n) / _START**2
    gradient[first, :n] += start / _START
    away = (point.free - problem.prior) / problem.spread
    corner += np.eye(len(away))
    corner_gradient += away
    cost += float((start**2).sum() + (away**2).sum())
    log_weights -= 2 * len(first) * n * np.log(_START)
    matrix = BlockTridiagonal(diagonal, coupling, border, corner)
    flow = (-by_left[:, :, :n], -by_free)
    return LinearisedProblem(
        matrix, gradient, corner_gradient, cost, log_weights, residual, values[0], stage, flow, (rows, rows_free)
    )


# ---- the random walks -----------------------------------------------------------------------------------------


def _with_walk(problem: SmoothingProblem, matrix: BlockTridiagonal, q: Array) -> BlockTridiagonal:
    if not len(q):
        return matrix
    n, at = problem.model.states, problem.grid.left
    diagonal, coupling = matrix.diagonal.copy(), matrix.coupling.copy()
    first, spans = problem.grid.first[:-1], _spans(problem.grid)
    for j, intensity in enumerate(q.tolist()):
        weight = 1 / (intensity * problem.grid.step)
        i = n + j
        diagonal[first, i, i] += 1 / (intensity * spans)
        diagonal[at, i, i] += weight
        diagonal[at + 1, i, i] += weight
        coupling[at, i, i] -= weight
    return replace(matrix, diagonal=diagonal, coupling=coupling)


def _spans(grid: Grid) -> Array:
    """Durations of the runs [s]: a walk starts as far from zero as it may go in a run."""
    return grid.time[grid.first[1:] - 1] - grid.time[grid.first[:-1]]


def _increments(problem: SmoothingProblem, point: Point) -> Array:
    at = problem.grid.left
    return (point.w[at + 1] - point.w[at]) / problem.unknown_size


def _walk_gradient(problem: SmoothingProblem, point: Point, q: Array) -> Array:
    n, at = problem.model.states, problem.grid.left
    gradient = np.zeros((len(point.x), n + len(q)))
    pull = _increments(problem, point) / (q * problem.grid.step[:, None])
    gradient[at + 1, n:] += pull
    gradient[at, n:] -= pull
    first = problem.grid.first[:-1]
    gradient[first, n:] += point.w[first] / problem.unknown_size / (q * _spans(problem.grid)[:, None])
    return gradient


def deviance(
    problem: SmoothingProblem, linear: LinearisedProblem, point: Point, q: Array, factored: CholeskyFactor | None = None
) -> float:
    """Minus twice the log marginal likelihood of the linearised problem, at its own minimum."""
    factored = factored or CholeskyFactor(_with_walk(problem, linear.matrix, q))
    blocks = linear.gradient + _walk_gradient(problem, point, q)
    change, outer = factored.solve(blocks, linear.corner_gradient)
    steps = problem.grid.step[:, None] * q
    starts = _spans(problem.grid)[:, None] * q
    walk = float((_increments(problem, point) ** 2 / steps).sum())
    walk += float(((point.w[problem.grid.first[:-1]] / problem.unknown_size) ** 2 / starts).sum())
    gain = float((blocks * change).sum() + linear.corner_gradient @ outer)
    log_weights = linear.log_weights - float(np.log(steps).sum() + np.log(starts).sum())
    return linear.cost + walk - gain + factored.log_determinant - log_weights


_LOWEST, _HIGHEST = -18.0, 9.0  # natural logarithm of the noise intensity


CLOSED = float(np.exp(_LOWEST))
"""The noise intensity of a term that is as good as absent."""


def likeliest_noise_intensity(
    problem: SmoothingProblem, linear: LinearisedProblem, point: Point, q: Array, active: Sequence[int] | None = None
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


def with_some(problem: SmoothingProblem, smoothed: Smoothed, active: Sequence[int]) -> tuple[float, float]:
    """Deviance and chi-square with only some of the terms, of the problem linearised about an estimate with all."""
    q = np.full(len(smoothed.noise_intensity), CLOSED)
    q[list(active)] = smoothed.noise_intensity[list(active)]
    if active:
        q[list(active)] = np.maximum(q[list(active)], 1e-3)
        q = likeliest_noise_intensity(problem, smoothed.linear, smoothed.point, q, active)
    linear = smoothed.linear
    factored = CholeskyFactor(_with_walk(problem, linear.matrix, q))
    blocks = linear.gradient + _walk_gradient(problem, smoothed.point, q)
    change, outer = factored.solve(-blocks, -linear.corner_gradient)
    rows, rows_free = linear.rows
    r = -linear.residual / problem.sigma + _times(rows, change) + rows_free @ outer
    return deviance(problem, linear, smoothed.point, q, factored), float(np.nansum(r**2))


def unknown_sizes(model: Model, grid: Grid, x: Array, free: Array, parameters: Array, sigma: Sequence[float]) -> Array:
    """(m,) [SI]: the term that would change a rate by its own largest size, or an output by its range.

    Zero where a term acts on nothing.
    """
    p = parameters[grid.run_of_node]
    slopes = model.everything(grid.time, x, grid.node_inputs, grid.node_delayed, p)
    n = model.states
    rate = np.quantile(np.abs(slopes.value[:, :n]), 0.95, axis=0)
    reach = np.concatenate([rate, np.ptp(slopes.value[:, n:], axis=0)])
    slope = np.max(np.abs(slopes.by_unknown_input), axis=0)
    sizes = np.zeros(model.unknown_inputs)
    for j in range(model.unknown_inputs):
        felt = slope[:, j] > 0
        if felt.any():
            sizes[j] = np.min(reach[felt] / slope[felt, j])
    return sizes
