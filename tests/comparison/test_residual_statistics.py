"""Statistics of residuals on noise whose statistics are known."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from pam_cosim.comparison import ResidualStatistics, Series
from pam_cosim.comparison import residual_statistics as statistics_of_series
from pam_cosim.measurement import Run, Signal, StatedSignal, complete_noise
from tests.fitting.models import recording

Array = NDArray[np.float64]


def residual_statistics(series: list[Array]) -> ResidualStatistics:
    """Of residuals in standard deviations of a known noise."""
    return statistics_of_series([Series.plain(e) for e in series])


def white(seed: int, n: int = 400) -> Array:
    return np.random.default_rng([seed, 11]).standard_normal(n)


def red(rho: float, seed: int, n: int = 4000) -> Array:
    """First-order autoregression with variance one."""
    e = white(seed, n)
    for i in range(1, n):
        e[i] = rho * e[i - 1] + np.sqrt(1 - rho**2) * e[i]
    return e


def test_white_noise_has_a_standard_score() -> None:
    """Over 400 seeds: mean 0 +- 0.05, standard deviation 1 +- 0.035; thrice that is allowed."""
    statistics = [residual_statistics([white(s), white(s + 1000, 300)]) for s in range(400)]
    scores = np.array([f.whiteness_score for f in statistics])
    assert abs(scores.mean()) < 0.15
    assert scores.std() == pytest.approx(1.0, abs=0.11)
    assert np.mean([f.chi2_reduced for f in statistics]) == pytest.approx(1.0, abs=0.01)
    assert np.mean([f.white_variance for f in statistics]) == pytest.approx(1.0, abs=0.01)
    assert np.mean([f.correlation_time for f in statistics]) < 1.15


@pytest.mark.parametrize("rho", [0.3, 0.6, 0.9])
def test_autoregression(rho: float) -> None:
    """Correlation time (1 + rho)/(1 - rho), white part 1 - rho, score rho sqrt(n); no more than the noise."""
    statistics = [residual_statistics([red(rho, s)]) for s in range(20)]
    assert np.mean([f.correlation_time for f in statistics]) == pytest.approx(
        (1 + rho) / (1 - rho), rel=0.1
    )
    assert np.mean([f.white_variance for f in statistics]) == pytest.approx(1 - rho, rel=0.05)
    assert np.mean([f.chi2_reduced - f.white_variance for f in statistics]) == pytest.approx(
        rho, abs=0.05
    )
    assert np.mean([f.whiteness_score for f in statistics]) == pytest.approx(
        rho * np.sqrt(4000), rel=0.05
    )
    assert np.mean([f.excess for f in statistics]) < 0.05


def test_alternating_residuals_are_not_taken_for_drift() -> None:
    statistics = residual_statistics([red(-0.5, 0)])
    assert (
        statistics.whiteness_score < -20
        and statistics.correlation_time == 1.0
        and statistics.excess == 0.0
    )


def test_offset_shows_as_structure() -> None:
    """A constant of one noise standard deviation doubles the mean square; the white part does not see it."""
    statistics = residual_statistics([white(0, 2000) + 1.0])
    assert statistics.whiteness_score > 15
    assert statistics.excess == pytest.approx(1.0, abs=0.1)
    assert statistics.white_variance == pytest.approx(1.0, abs=0.1)


def test_series_are_not_joined() -> None:
    """The jump from one series to the next is no residual."""
    statistics = residual_statistics([white(1, 100) * 1e-3 + 1.0, white(2, 100) * 1e-3 - 1.0])
    assert statistics.white_variance == pytest.approx(1e-6, rel=0.3)
    assert (statistics.samples, statistics.chi2) == (200, pytest.approx(200, rel=1e-2))


def test_nothing_and_next_to_nothing() -> None:
    for series in ([], [np.zeros(0)], [np.array([2.0])], [np.zeros(50)]):
        statistics = residual_statistics(series)
        assert (statistics.whiteness_score, statistics.correlation_time) == (0.0, 1.0)
    assert residual_statistics([np.array([2.0])]).chi2_reduced == 4.0


TIME = np.linspace(0.0, 10.0, 201)


def completed(runs: list[Run], sigma: float | None) -> Signal:
    return complete_noise({"y": StatedSignal("y", "m", sigma)}, runs)["y"]


def test_stated_noise_is_kept() -> None:
    signal = completed([recording(TIME, {"y": np.sin(TIME)})], 0.5)
    assert signal.sigma == 0.5 and not signal.estimated


def test_noise_of_dense_samples_is_estimated() -> None:
    y = np.sin(TIME) + 0.05 * white(3, 201)
    signal = completed([recording(TIME, {"y": y})], None)
    assert signal.estimated and signal.sigma == pytest.approx(0.05, rel=0.25)


@pytest.mark.parametrize("count", [2, 5, 20])
def test_sparse_samples_get_a_hundredth_of_their_range(count: int) -> None:
    """Points read off a printed figure show no noise to estimate."""
    time = np.linspace(0.0, 10.0, count)
    signal = completed([recording(time, {"y": 40 * time})], None)
    assert signal.estimated and signal.sigma == pytest.approx(4.0)


def test_missing_samples_do_not_spoil_the_range() -> None:
    y = np.array([np.nan, 1.0, np.nan, 3.0])
    runs = [recording(np.arange(4.0), {"y": y}), recording(np.arange(4.0), {})]
    assert completed(runs, None).sigma == pytest.approx(0.02)


def test_constant_signal_still_has_a_level() -> None:
    for value in (0.0, 250.0):
        sigma = completed([recording(np.arange(4.0), {"y": np.full(4, value)})], None).sigma
        assert 0 < sigma <= 1e-3


def test_the_level_is_judged_by_the_spread_of_chi_square() -> None:
    """200 samples of mean square 1.44: 88 too much, where chance gives sqrt(2*200) = 20."""
    assert residual_statistics([np.full(200, 1.2)]).level_score == pytest.approx(4.4)
