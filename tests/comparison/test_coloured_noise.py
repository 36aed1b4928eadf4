"""The likelihood of residuals as white noise with a slow course besides, against dense matrices and known noise."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim.arrays import Array
from pam_cosim.comparison import Series, approximate_log_likelihood, noise_log_likelihood
from pam_cosim.comparison.coloured_noise import _form, _log_likelihood, _memories

ANY = 1e9  # noise of any size


def _slow(rng: np.random.Generator, n: int, memory: float) -> Array:
    left, course = np.exp(-1.0 / memory), np.empty(n)
    course[0] = rng.standard_normal()
    for k in range(1, n):
        course[k] = left * course[k - 1] + np.sqrt(1 - left**2) * rng.standard_normal()
    return course


def _of(*values: Array) -> float:
    return noise_log_likelihood([Series(v, np.ones(len(v)), True, "p") for v in values], ANY)


def _white(*values: Array) -> float:
    n = sum(map(len, values))
    return -0.5 * n * float(np.log(sum(float(v @ v) for v in values) / n))


@pytest.mark.parametrize("n", [1, 2, 50])
@pytest.mark.parametrize(("ratio", "memory"), [(0.5, 7.0), (30.0, 3.0), (1e-3, 1.0)])
def test_forms_are_those_of_the_whole_covariance(n: int, ratio: float, memory: float) -> None:
    """Of two series, of which no course goes on in the other."""
    values = np.random.default_rng(n).standard_normal(n + 3)
    distance = np.abs(np.subtract.outer(np.arange(n + 3), np.arange(n + 3)))
    slow = ratio * np.exp(-distance / memory)
    slow[:n, n:] = slow[n:, :n] = 0.0
    covariance = np.eye(n + 3) + slow
    square, determinant = _form(values, np.array([n - 1, n + 2]), ratio, memory)
    assert square == pytest.approx(values @ np.linalg.solve(covariance, values), rel=1e-9)
    assert determinant == pytest.approx(np.linalg.slogdet(covariance)[1], abs=1e-9)


def test_white_noise_has_no_colour() -> None:
    rng = np.random.default_rng(1)
    values = [rng.standard_normal(2000) for _ in range(3)]
    assert 0.0 <= _of(*values) - _white(*values) < 5.0


def test_a_drift_is_likelier_as_one_and_what_follows_it_gains_little() -> None:
    """White noise would give what takes a tenth of a drift's squares away hundreds; the colour gives it a few."""
    rng = np.random.default_rng(2)
    drift = 0.5 * _slow(rng, 5000, 200.0)
    values = drift + rng.standard_normal(5000)
    assert _of(values) - _white(values) > 200.0
    wave = np.sin(2 * np.pi * np.arange(5000) / 2500)
    follows = values - (values @ wave) / (wave @ wave) * wave
    assert 2 * (_white(follows) - _white(values)) > 2 * 2 * (_of(follows) - _of(values))
    assert 2 * (_of(follows) - _of(values)) < 10.0


def test_an_effect_is_no_drift() -> None:
    """What jumps with the command, and comes again with it, is far from any slow course beside the noise."""
    rng = np.random.default_rng(3)
    noise, jumps = rng.standard_normal(5000), 0.5 * np.sign(np.sin(np.arange(5000) / 40.0))
    assert 2 * (_of(noise) - _of(noise + jumps)) > 100.0


def test_signals_have_colours_of_their_own() -> None:
    rng = np.random.default_rng(4)
    one, other = _slow(rng, 1000, 50.0), rng.standard_normal(1000)
    series = [Series(v, np.ones(1000), True, name) for v, name in ((one, "p"), (other, "x"))]
    assert noise_log_likelihood(series, ANY) == pytest.approx(_of(one) + _of(other))
    assert noise_log_likelihood([], ANY) == 0.0


@pytest.mark.parametrize("largest", [1e9, 30.0])
@pytest.mark.parametrize(
    ("memory", "size", "noise"),
    [(1.0, 0.0, 1.0), (3.0, 1.0, 0.0), (100.0, 0.5, 1.0), (50.0, 5.0, 0.1)],
)
def test_the_quick_likelihood_is_near_the_exact_one(
    memory: float, size: float, noise: float, largest: float
) -> None:
    """Within what counts as positive evidence, of white noise, a filter, a drift and a course that is hardly noisy."""
    rng = np.random.default_rng(5)
    series = [
        Series.plain(size * _slow(rng, n, memory) + noise * rng.standard_normal(n), signal="p")
        for n in (300, 250, 20)
    ]
    exact, quick = (f(series, largest) for f in (noise_log_likelihood, approximate_log_likelihood))
    assert quick == pytest.approx(exact, abs=3.0)
    assert approximate_log_likelihood([], largest) == 0.0


@pytest.mark.parametrize("largest", [1e9, 1.3])
@pytest.mark.parametrize("course", ["white", "drift", "wave", "ramp", "jumps"])
def test_memories_and_ratios_that_the_grid_passes_over_are_no_likelier(
    course: str, largest: float
) -> None:
    rng, time = np.random.default_rng(6), np.linspace(0.0, 1.0, 700)
    own = {
        "white": 0.0 * time,
        "drift": 0.4 * _slow(rng, 700, 60.0),
        "wave": 0.5 * np.sin(20.0 * time),
        "ramp": time,
        "jumps": 0.4 * np.sign(np.sin(60.0 * time)),
    }
    values = own[course] + rng.standard_normal(700)
    every = [
        _log_likelihood(700, *_form(values, np.array([699]), ratio, memory), ratio, largest)
        for memory in _memories(700)
        for ratio in np.geomspace(1e-3, 1e3, 120).tolist()
    ]
    found = noise_log_likelihood([Series.plain(values)], largest)
    assert found >= max(map(float, every)) - 0.1


def test_noise_is_no_larger_than_it_may_be() -> None:
    """What exceeds that counts by its squares: seventeen variances of fifteen samples are no drift."""
    rng = np.random.default_rng(2)
    small = rng.standard_normal(15)
    large = small + 4.0 * np.sin(np.linspace(0.0, 3.0, 15))
    free = _of(small) - _of(large)
    bounded = noise_log_likelihood([Series.plain(small)], 1.3) - noise_log_likelihood(
        [Series.plain(large)], 1.3
    )
    assert bounded > 2.0 * free > 0.0
