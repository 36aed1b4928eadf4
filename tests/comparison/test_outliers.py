"""Single samples far off are set aside; steps, bends and noise are not."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim.comparison import outliers, without_outliers
from pam_cosim.comparison.residuals import RunComparison
from tests.comparison.fake import data_set, run

TIME = np.linspace(0.0, 10.0, 1001)


def _noise(seed: int) -> np.ndarray:
    return np.random.default_rng([seed, 5]).standard_normal(1001)


@pytest.mark.parametrize("seed", range(5))
def test_noise_alone_has_none(seed: int) -> None:
    for course in (
        0 * TIME,
        10 * np.sin(3 * TIME),
        20.0 * (TIME > 5),
        30 * np.exp(-((TIME - 5) ** 2) / 0.008),
    ):
        assert not outliers(_noise(seed) + course).any()


@pytest.mark.parametrize("seed", range(5))
def test_single_samples_are_found_among_missing_ones(seed: int) -> None:
    e = _noise(seed) + 10 * np.sin(3 * TIME)
    hit = np.array([3, 200, 500, 998])
    e[hit] += np.array([12.0, -15.0, 20.0, -12.0])
    e[100:130] = np.nan
    assert np.array_equal(np.flatnonzero(outliers(e)), hit)


def test_few_samples_and_many_outliers_are_left_alone() -> None:
    few = np.zeros(20)
    few[7] = 100.0
    assert not outliers(few).any()
    many = _noise(1)
    many[::20] += 30.0
    assert not outliers(many).any()


def test_they_become_missing_samples() -> None:
    measured = _noise(2)
    measured[400] = 50.0
    one = run("r", TIME, p=measured)
    data, counts = without_outliers(
        data_set([one], {"p": 1.0}), [RunComparison(one, {"p": 0 * TIME})]
    )
    assert counts == {"p": 1}
    assert np.flatnonzero(np.isnan(data.runs[0].measurements["p"])).tolist() == [400]
    assert one.measurements["p"][400] == 50.0


def test_two_neighbours_are_outliers_only_where_two_may_be() -> None:
    e = _noise(3)
    e[[300, 301]] += [18.0, -22.0]
    e[[600, 601, 602]] += 20.0
    assert not outliers(e).any()
    assert np.flatnonzero(outliers(e, together=2)).tolist() == [300, 301]


def test_a_fading_change_is_none_however_many_may_be_off_together() -> None:
    e = _noise(4)
    e[500:] += 30 * np.exp(-np.arange(501) / 4.0)
    assert not outliers(e, together=2).any()
