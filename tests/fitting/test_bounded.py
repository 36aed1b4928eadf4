"""Least squares within bounds, beside SciPy's other method and the conditions of an optimum."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import lsq_linear

from pam_cosim.fitting.bounded import least_in_box, least_squares_in_box


@pytest.mark.parametrize("seed", range(60))
def test_the_optimum_is_that_of_another_method(seed: int) -> None:
    rng = np.random.default_rng(seed)
    rows, count = int(rng.integers(8, 40)), int(rng.integers(1, 8))
    matrix = rng.standard_normal((rows, count)) * 10.0 ** rng.uniform(-6, 6, count)
    right = rng.standard_normal(rows) * 10.0
    free = np.linalg.lstsq(matrix, right, rcond=None)[0]
    low = free - np.abs(free) * rng.uniform(-0.5, 1.0, count)
    high = low + np.abs(free) * rng.uniform(0.01, 2.0, count)
    low[rng.random(count) < 0.2] = -np.inf
    high[rng.random(count) < 0.2] = np.inf
    found = least_squares_in_box(matrix, right, low, high)
    assert np.all((low <= found) & (found <= high))
    size = np.linalg.norm(matrix, axis=0)
    other = lsq_linear(matrix / size, right, (low * size, high * size), method="bvls", tol=1e-14)
    cost = float(np.sum((matrix @ found - right) ** 2))
    assert cost <= 2 * other.cost * (1 + 1e-6)


def test_what_a_bound_held_back_is_released() -> None:
    """Alone, both leave the box; with the first at its bound the second belongs inside."""
    square = np.array([[1.0, 0.9], [0.9, 1.0]])
    along = np.array([3.0, 2.0])
    free = np.linalg.solve(square, along)
    assert free[1] < 0 and free[0] > 1
    assert least_in_box(square, along, np.zeros(2), np.array([1.0, 5.0])) == pytest.approx([1.0, 1.1], rel=1e-6)


def test_bounds_that_coincide_and_unknowns_that_do_nothing() -> None:
    square = np.diag([1.0, 0.0, 4.0])
    found = least_in_box(square, np.array([2.0, 0.0, 4.0]), np.array([0.5, 1.0, -9.0]), np.array([0.5, 2.0, 9.0]))
    assert found == pytest.approx([0.5, 1.0, 1.0])


def test_directions_that_say_the_same_share_what_there_is() -> None:
    square = np.ones((2, 2))
    found = least_in_box(square, np.array([2.0, 2.0]), np.full(2, -5.0), np.full(2, 5.0))
    assert found.sum() == pytest.approx(2.0, rel=1e-6)


def test_a_step_is_never_worse_than_none() -> None:
    rng = np.random.default_rng(0)
    for _ in range(300):
        count = int(rng.integers(2, 25))
        matrix = rng.standard_normal((count + 3, count)) @ np.diag(10.0 ** rng.uniform(-2, 2, count))
        matrix[:, -1] = matrix[:, 0] + 1e-3 * matrix[:, -1]  # nearly the same
        square, along = matrix.T @ matrix, matrix.T @ rng.standard_normal(count + 3)
        low, high = -rng.uniform(0, 1, count), rng.uniform(0, 1, count)
        step = least_in_box(square, along, low, high)
        assert step @ (2 * along - square @ step) >= -1e-9
