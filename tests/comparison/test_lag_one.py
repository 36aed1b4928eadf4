"""Correlation of neighbours on series whose correlation is known."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim.comparison import Series, lag_one
from pam_cosim.comparison.residuals import RunComparison
from pam_cosim.comparison.scores import score_signal
from pam_cosim.measurement import Signal
from tests.comparison.fake import run


def test_white_and_red_noise() -> None:
    rng = np.random.default_rng(3)
    white = [Series.plain(rng.standard_normal(2000)) for _ in range(3)]
    correlation, score = lag_one(white)
    assert abs(score) < 3 and score == pytest.approx(correlation * np.sqrt(3 * 1999))
    red = [Series.plain(np.convolve(e.values, [1.0, 1.0], "valid")) for e in white]
    assert lag_one(red)[0] == pytest.approx(0.5, abs=0.03)


def test_nothing_to_judge() -> None:
    still, single = Series.plain(np.zeros(9)), Series.plain(np.array([1.0]))
    assert lag_one([]) == (0.0, 0.0) and lag_one([still, single]) == (0.0, 0.0)


def test_scores_tell_it_of_each_signal() -> None:
    time = np.linspace(0.0, 1.0, 400)
    one = run("r", time, p=np.sin(9 * time))
    score = score_signal([RunComparison(one, {"p": 0 * time})], Signal("p", "Pa", 1.0))
    assert score is not None and score.autocorrelation > 0.95 and score.whiteness_score > 15
