"""Readings in steps: what the noise leaves of the right model is known, whatever the steps and wherever it holds."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from pam_cosim.comparison import (
    RunComparison,
    Series,
    expected_squares,
    residual_statistics,
    series_of,
    standardized_residuals,
)
from pam_cosim.comparison.rounding import slope
from pam_cosim.measurement import Signal
from tests.comparison.fake import run

Array = NDArray[np.float64]
STEPS = [0.2, 1.0, 3.0, 5.0, 10.0]
TIME = np.arange(20000) / 100.0


def coarse(steps: float) -> Signal:
    """Noise of one, rounded to so many standard deviations."""
    return Signal("x", "m", float(np.sqrt(1.0 + steps**2 / 12.0)), step=steps)


def readings(course: Array, steps: float, seed: int = 0) -> Array:
    noisy = course + np.random.default_rng([seed, 5]).standard_normal(len(course))
    return steps * np.round(noisy / steps)


def holds(steps: float, seed: int, count: int = 4) -> Array:
    """A few long rests between steps of the record, and quick ways from one to the next."""
    levels = np.random.default_rng([seed, 6]).uniform(0.0, 20.0 * steps, count)
    return np.repeat(levels, len(TIME) // count)


@pytest.mark.parametrize("steps", STEPS)
def test_slopes_are_those_of_the_residuals(steps: float) -> None:
    error, signal, h = np.linspace(-4.0 * steps - 3.0, 4.0 * steps + 3.0, 300), coarse(steps), 1e-4
    rise = (
        standardized_residuals(error + h, signal) - standardized_residuals(error - h, signal)
    ) / (2 * h)
    np.testing.assert_allclose(slope(error, signal), rise, atol=1e-5)
    assert np.all(np.diff(standardized_residuals(error, signal)) >= 0.0)


def test_fine_steps_are_none_and_far_off_the_noise_alone_counts() -> None:
    error = np.linspace(-5.0, 5.0, 101)
    np.testing.assert_allclose(standardized_residuals(error, coarse(1e-2)), error, atol=1e-3)
    far = np.array([1e3, -1e6])
    np.testing.assert_allclose(
        standardized_residuals(far, coarse(4.0)), far - np.sign(far) * 2.0, rtol=2e-5, atol=0.05
    )


@pytest.mark.parametrize("steps", STEPS)
@pytest.mark.parametrize("seed", range(5))
def test_the_right_model_leaves_noise_whatever_it_does(steps: float, seed: int) -> None:
    """Chi-square is as large as is said of it, to four standard errors: in motion, and in a few long holds."""
    for course in (20.0 * steps * np.sin(TIME / 7.0), holds(steps, seed)):
        error = readings(course, steps, seed) - course
        squares, expected = (
            standardized_residuals(error, coarse(steps)) ** 2,
            expected_squares(error, coarse(steps)),
        )
        assert squares.sum() == pytest.approx(
            expected.sum(), abs=4 * np.sqrt(2 * expected.sum()) + 1e-3
        )


@pytest.mark.parametrize("steps", [3.0, 10.0])
def test_holds_are_no_structure_and_an_offset_of_half_a_step_is(steps: float) -> None:
    excess = []
    for course in (holds(steps, 1, 40), holds(steps, 2, 4)):
        one, signal = run("r", TIME, x=readings(course, steps)), coarse(steps)
        right = residual_statistics(series_of([RunComparison(one, {"x": course})], {"x": signal}))
        wrong = residual_statistics(
            series_of([RunComparison(one, {"x": course + steps / 2})], {"x": signal})
        )
        assert abs(right.chi2_reduced - 1.0) < 0.1
        excess.append(wrong.excess)
    assert min(excess) > 1.0


def test_a_plain_record_counts_each_sample_once() -> None:
    signal, error = Signal("x", "m", 2.0), np.array([2.0, np.nan, -4.0])
    one = run("r", [0.0, 1.0, 2.0], x=error)
    (series,) = series_of([RunComparison(one, {"x": np.zeros(3)})], {"x": signal})
    assert series.values.tolist() == [1.0, -2.0] and series.samples == 2.0 and series.stated
    assert Series.plain(np.zeros(5)).pairs == 4.0


def test_steps_that_rule_are_known_although_the_noise_is_estimated() -> None:
    one = run("r", TIME, x=readings(np.sin(TIME), 5.0))
    for steps, known in ((0.5, False), (5.0, True)):
        signal = Signal("x", "m", coarse(steps).sigma, estimated=True, step=steps)
        (series,) = series_of([RunComparison(one, {"x": np.sin(TIME)})], {"x": signal})
        assert series.stated is known
