"""Least squares within bounds, against SciPy's, which goes to the minimum another way."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.optimize import lsq_linear

from pam_cosim.fitting.bounded_linear import bounded_least_squares

Array = NDArray[np.float64]
Problem = tuple[Array, Array, Array, Array]


@st.composite
def problems(draw: st.DrawFn) -> Problem:
    """Random problems: columns of very different size, nearly alike, or none; bounds on one side, both or together."""
    random = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    n, more = draw(st.integers(1, 9)), draw(st.integers(0, 12))
    matrix = random.normal(size=(n + more, n))
    if n > 1 and draw(st.booleans()):
        matrix[:, 0] = matrix[:, 1] + 10.0 ** draw(st.integers(-5, 0)) * matrix[:, 0]
    matrix *= 10.0 ** random.integers(-4, 5, size=n)
    if draw(st.booleans()):
        matrix[:, random.integers(n)] = 0.0
    right = random.normal(size=n + more) * 10.0 ** draw(st.integers(-3, 3))
    middle = random.normal(size=n) / np.maximum(np.linalg.norm(matrix, axis=0), 1e-4)
    low, high = (middle + sign * random.exponential(size=n) * abs(middle) for sign in (-1, 1))
    low[random.random(n) < 0.2] = -np.inf
    high[random.random(n) < 0.2] = np.inf
    fixed = random.random(n) < 0.1
    low[fixed] = high[fixed] = middle[fixed]
    return matrix, right, low, high


def cost(problem: Problem, x: Array) -> float:
    """What is left of the right side."""
    matrix, right, _, _ = problem
    left = matrix @ x - right
    return float(left @ left)


@settings(max_examples=300, deadline=None)
@given(problems())
def test_it_is_within_bounds_and_as_low_as_scipys(problem: Problem) -> None:
    matrix, right, low, high = problem
    x = bounded_least_squares(*problem)
    assert np.all(x >= low) and np.all(x <= high)
    apart = low < high  # SciPy's bounds must be
    rest = right - matrix[:, ~apart] @ x[~apart]
    size = np.maximum(np.linalg.norm(matrix, axis=0), 1e-300)[apart]
    edges = (low[apart] * size, high[apart] * size)
    if apart.any():
        other = x.copy()
        scaled = lsq_linear(
            matrix[:, apart] / size, rest, edges, method="bvls", tol=1e-14, max_iter=1000
        ).x
        other[apart] = scaled / size
        assert cost(problem, x) <= cost(problem, other) + 1e-9 * max(
            cost(problem, other), float(right @ right)
        )


def test_a_bound_is_released_again() -> None:
    """Without bounds the second coordinate is beyond; once the first one is held, it is not."""
    matrix, right = np.array([[1.0, 0.9], [0.0, 0.5]]), np.array([1.0, -1.0])
    free = np.linalg.solve(matrix, right)
    low, high = np.array([-3.0, -1.5]), np.array([1.0, 3.0])
    assert free[0] > high[0] and free[1] < low[1]
    x = bounded_least_squares(matrix, right, low, high)
    assert x[0] == 1.0 and x[1] == pytest.approx(-0.5 / 1.06)
