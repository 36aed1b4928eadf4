"""The model by itself on the samples, its free parameters fitted again, to first order."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.ledger.smoothing_problem import LinearisedProblem, Point, SmoothingProblem, linearise


@dataclass(frozen=True)
class Unaugmented:
    """The model by itself on the samples.

    Attributes:
        deviance: as in ``Smoothed``.
        chi2: sum of squared residuals in noise variances.
    """

    deviance: float
    chi2: float


def unaugmented(problem: SmoothingProblem, states: tuple[Array, Array]) -> Unaugmented:
    """The model by itself.

    Args:
        problem: without unknown inputs.
        states: at the nodes and inside the steps, with the prior values of the free parameters.
    """
    free = problem.prior
    linear = linearise(problem, Point(*states, np.zeros((len(states[0]), 0)), free))
    residual = linear.residual / problem.sigma
    is_measured = np.isfinite(residual)
    rows, r = _output_slopes(problem, linear)[is_measured], residual[is_measured]
    matrix = rows.T @ rows + np.eye(len(free))
    change = _bounded(problem, matrix, rows.T @ r)
    chi2 = float(((r - rows @ change) ** 2).sum())
    deviance = chi2 + float((change**2).sum() + np.linalg.slogdet(matrix)[1])
    return Unaugmented(deviance, chi2)


def _bounded(problem: SmoothingProblem, matrix: Array, right: Array) -> Array:
    """The solution with free parameters held at a bound that they would pass."""
    low, high = ((bound - problem.prior) / problem.spread for bound in (problem.low, problem.high))
    held, change = np.zeros(len(right), dtype=bool), np.zeros(len(right))
    for _ in range(len(right) + 1):
        loose = ~held
        remaining_right = right[loose] - matrix[np.ix_(loose, held)] @ change[held]
        change[loose] = np.linalg.solve(matrix[np.ix_(loose, loose)], remaining_right)
        passed = loose & ((change < low) | (change > high))
        if not passed.any():
            break
        change = np.clip(change, low, high)
        held |= passed
    return change


def _output_slopes(problem: SmoothingProblem, linear: LinearisedProblem) -> Array:
    """(N, S, Q) by the free parameters, in standard deviations of the samples."""
    by_state, by_free = linear.flow
    grid = problem.grid
    n, q = problem.model.states, len(problem.prior)
    states = np.zeros((len(grid.time), n, q))
    for k, node in enumerate(grid.start_node.tolist()):
        states[node + 1] = by_state[k] @ states[node] + by_free[k]
    rows, rows_free = linear.rows
    slopes: Array = np.einsum("nsi,niq->nsq", rows[:, :, :n], states) + rows_free
    return slopes
