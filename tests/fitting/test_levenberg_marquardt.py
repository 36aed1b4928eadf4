"""Levenberg and Marquardt's method against SciPy's: at bounds, and beside places where nothing is defined."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import least_squares

from pam_cosim.fitting.levenberg_marquardt import Minimum
from pam_cosim.fitting.levenberg_marquardt import levenberg_marquardt as descend

Array = NDArray[np.float64]


def levenberg_marquardt(residuals, jacobian, start, bounds, precision, most) -> Minimum:  # type: ignore[no-untyped-def]
    """The descent of residuals and slopes as vectors."""
    latest: list[Array] = []

    def squares(z: Array) -> float:
        latest[:] = [residuals(z)]
        return float(latest[0] @ latest[0])

    def triangle(z: Array) -> Array:
        return np.asarray(np.linalg.qr(np.column_stack([jacobian(z), latest[0]]), mode="r"))

    return descend(squares, triangle, start, bounds, precision, most)


def _rosenbrock(z: Array) -> Array:
    return np.array([10 * (z[1] - z[0] ** 2), 1 - z[0]])


def _its_slopes(z: Array) -> Array:
    return np.array([[-20 * z[0], 10.0], [-1.0, 0.0]])


@pytest.mark.parametrize(
    ("low", "high"),
    [((-2.0, -2.0), (2.0, 2.0)), ((-2.0, -2.0), (0.5, 2.0)), ((-1.5, 1.5), (0.0, 3.0))],
)
def test_valley_is_followed_to_the_same_end_as_by_scipy(
    low: tuple[float, float], high: tuple[float, float]
) -> None:
    bounds = np.array(low), np.array(high)
    start = np.clip([-1.2, 1.0], *bounds)
    minimum = levenberg_marquardt(_rosenbrock, _its_slopes, start, bounds, 1e-14, 200)
    inner = np.clip(start, bounds[0] + 1e-9, bounds[1] - 1e-9)
    theirs = least_squares(
        _rosenbrock, inner, _its_slopes, bounds=bounds, xtol=1e-15, ftol=1e-15, gtol=1e-15
    )
    assert minimum.z == pytest.approx(theirs.x, abs=1e-5)
    assert minimum.cost == pytest.approx(2 * theirs.cost, abs=1e-8)
    assert np.all(minimum.z >= bounds[0]) and np.all(minimum.z <= bounds[1])
    slopes = _its_slopes(minimum.z)
    assert minimum.jacobian.T @ minimum.jacobian == pytest.approx(slopes.T @ slopes)


def test_where_the_model_breaks_down_no_step_ends() -> None:
    def residuals(z: Array) -> Array:
        return np.full(2, np.inf) if z[0] > 1 else np.array([z[0] - 1.0, 0.1 * z[0]])

    minimum = levenberg_marquardt(
        residuals,
        lambda z: np.array([[1.0], [0.1]]),
        np.zeros(1),
        (np.zeros(1), np.full(1, 9.0)),
        1e-10,
        50,
    )
    assert minimum.z[0] == pytest.approx(1 / 1.01, abs=1e-4)
    # nor from a place whose best step leads out of what can be simulated
    cliff = levenberg_marquardt(
        lambda z: np.full(1, np.inf) if z[0] > 1 else np.array([z[0] - 5.0]),
        lambda z: np.ones((1, 1)), np.zeros(1), (np.zeros(1), np.full(1, 9.0)), 1e-10, 100,
    )  # fmt: skip
    assert 0.9 < cliff.z[0] <= 1.0
