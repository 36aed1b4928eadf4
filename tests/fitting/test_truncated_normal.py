"""Samples between bounds are those of the distribution."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import kstest

from pam_cosim.fitting.truncated_normal import truncated_normal


def test_a_narrow_ridge_across_the_box_is_sampled_as_by_rejection() -> None:
    precision = np.linalg.inv(np.array([[1.0, 0.999], [0.999, 1.0]]))
    low, high = np.array([-0.5, -3.0]), np.array([1.0, 0.7])
    rng = np.random.default_rng(2)
    drawn = truncated_normal(np.zeros(2), precision, (low, high), np.zeros(2), 4000, rng)
    many = rng.multivariate_normal(np.zeros(2), np.linalg.inv(precision), 100_000)
    kept = many[np.all((many >= low) & (many <= high), axis=1)]
    assert drawn.mean(axis=0) == pytest.approx(kept.mean(axis=0), abs=0.03)
    assert drawn.std(axis=0) == pytest.approx(kept.std(axis=0), rel=0.05)


def test_what_nothing_is_known_of_is_uniform() -> None:
    bounds = np.array([2.0]), np.array([4.0])
    rng = np.random.default_rng(3)
    drawn = truncated_normal(
        np.array([3.0]), np.array([[1e-2]]), bounds, np.array([2.0]), 1000, rng
    )[:, 0]
    assert kstest(drawn[::2], "uniform", args=(2.0, 2.0)).pvalue > 0.01
