"""What is smoothed, a point of it, and the problem linearised about that point."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.ledger.block_tridiagonal import BlockTridiagonal
from pam_cosim.ledger.grid import STAGE, Grid
from pam_cosim.ledger.model import Model, Slopes

SLACK = 1e-5  # of a state's range: what a step may miss the model by
_START = 1e-3  # of a state's range: how well the model knows its own start


@dataclass(frozen=True)
class SmoothingProblem:
    """What is to be smoothed.

    Attributes:
        model: right-hand side with Q free parameters and m unknown inputs.
        grid: N nodes and M steps.
        sigma: (S,) standard deviations of the samples [SI].
        prior: (Q,) values of the free parameters [SI], and ``spread`` (Q,) how far they may be off.
        low, high: (Q,) bounds.
        acts: (R, Q) whether a free parameter acts on a run: one that is known for it, or is its own, does not.
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
    acts: NDArray[np.bool_]
    size: Array
    unknown_size: Array

    def parameters(self, free: Array) -> Array:
        """All parameters of the runs, (R, P), with values for the free ones."""
        return with_free(self.grid.parameters, self.model, free, self.acts)

    def everything(self, x: Array, p: Array) -> Slopes:
        """Rates and signals at the nodes, with states (N, n) and parameters (N, P)."""
        grid = self.grid
        slopes = self.model.everything(grid.time, x, grid.node_inputs, grid.node_delayed, p)
        return self._where_they_act(slopes, grid.run_of_node)

    def rates_inside(self, s: Array, p: Array) -> Slopes:
        """Rates inside the steps, with states (M, n) and parameters (M, P)."""
        grid = self.grid
        time = grid.time[grid.start_node] + STAGE * grid.step
        slopes = self.model.rates(time, s, grid.stage_inputs, grid.stage_delayed, p)
        return self._where_they_act(slopes, grid.run_of_node[grid.start_node])

    def _where_they_act(self, slopes: Slopes, run: NDArray[np.intp]) -> Slopes:
        return slopes._replace(by_parameter=slopes.by_parameter * self.acts[run][:, None, :])


def with_free(parameters: Array, model: Model, free: Array, acts: NDArray[np.bool_]) -> Array:
    """All parameters of the runs, (R, P), with values (Q,) for the free ones where they act (R, Q)."""
    p = parameters.copy()
    p[:, model.free_at] = np.where(acts, free, p[:, model.free_at])
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


def products(matrices: Array, vectors: Array) -> Array:
    """(K, i) of (K, i, j) and (K, j)."""
    result: Array = np.einsum("kij,kj->ki", matrices, vectors)
    return result


def linearise(problem: SmoothingProblem, point: Point, slack: float = SLACK) -> LinearisedProblem:
    """The problem about a point; a step may miss the model by ``slack`` of the range of a state."""
    model, grid = problem.model, problem.grid
    n, m, at = model.states, model.unknown_inputs, grid.start_node
    p = problem.parameters(point.free)[grid.run_of_node]
    p_stage = p[at].copy()
    p[:, model.unknown_at] = point.w
    p_stage[:, model.unknown_at] = (1 - STAGE) * point.w[at] + STAGE * point.w[at + 1]
    h = grid.step
    node = problem.everything(point.x, p)
    inner = problem.rates_inside(point.s, p_stage)
    f2, a2, b2, c2 = (v[at + 1, :n] for v in node)
    f1, a1, b1, c1 = inner
    hh, h1 = h[:, None, None], h[:, None]
    eye = np.eye(n)
    # the state inside a step follows from its ends
    solve = np.asarray(np.linalg.inv(eye - hh * a1 * 5 / 12), dtype=np.float64)
    d1 = point.s - point.x[at] - h1 * (5 * f1 - f2) / 12
    w1 = np.concatenate(
        [-(1 - STAGE) * hh * b1 * 5 / 12, -STAGE * hh * b1 * 5 / 12 + hh * b2 / 12], axis=2
    )
    c_in = -hh * c1 * 5 / 12 + hh * c2 / 12
    stage = (products(solve, d1), -solve, solve @ (hh * a2 / 12), solve @ w1, solve @ c_in)
    # the end of a step follows from its start
    k = hh * a1 * 3 / 4
    d2 = point.x[at + 1] - point.x[at] - h1 * (3 * f1 + f2) / 4
    w2 = np.concatenate(
        [-(1 - STAGE) * hh * b1 * 3 / 4, -STAGE * hh * b1 * 3 / 4 - hh * b2 / 4], axis=2
    )
    end = np.asarray(np.linalg.inv(eye - hh * a2 / 4 + k @ stage[2]), dtype=np.float64)
    scale = problem.size
    defect = products(end, d2 + products(k, stage[0])) / scale
    by_left = end @ (-eye + k @ stage[1]) * scale / scale[:, None]
    by_walk = end @ (w2 + k @ stage[3]) * np.tile(problem.unknown_size, 2) / scale[:, None]
    by_free = end @ (-hh * (3 * c1 + c2) / 4 + k @ stage[4]) * problem.spread / scale[:, None]
    by_right = np.concatenate([np.broadcast_to(eye, (len(h), n, n)), by_walk[:, :, m:]], axis=2)
    by_left = np.concatenate([by_left, by_walk[:, :, :m]], axis=2)
    weight = 1 / slack**2

    values = [v[:, n:] for v in node]
    is_measured = np.isfinite(grid.measured)
    residual = np.where(is_measured, grid.measured - values[0], np.nan)
    r = np.where(is_measured, -residual / problem.sigma, 0.0)
    rows = (
        np.concatenate([values[1] * scale, values[2] * problem.unknown_size], axis=2)
        / problem.sigma[:, None]
    )
    rows = np.where(is_measured[:, :, None], rows, 0.0)
    rows_free = np.where(
        is_measured[:, :, None], values[3] * problem.spread / problem.sigma[:, None], 0.0
    )

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
    run_starts = grid.first[:-1]
    begins = model.initial(problem.parameters(point.free), grid)
    start = (point.x[run_starts] - begins) / scale / _START
    diagonal[run_starts, :n, :n] += np.eye(n) / _START**2
    gradient[run_starts, :n] += start / _START
    away = (point.free - problem.prior) / problem.spread
    corner += np.eye(len(away))
    corner_gradient += away
    cost += float((start**2).sum() + (away**2).sum())
    log_weights -= 2 * len(run_starts) * n * np.log(_START)
    matrix = BlockTridiagonal(diagonal, coupling, border, corner)
    flow = (-by_left[:, :, :n], -by_free)
    return LinearisedProblem(
        matrix,
        gradient,
        corner_gradient,
        cost,
        log_weights,
        residual,
        values[0],
        stage,
        flow,
        (rows, rows_free),
    )


def unknown_sizes(problem: SmoothingProblem, x: Array, parameters: Array) -> Array:
    """(m,) [SI]: the term that would change a rate by its own largest size, or an output by its range.

    Zero where a term acts on nothing.
    """
    model = problem.model
    slopes = problem.everything(x, parameters[problem.grid.run_of_node])
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
