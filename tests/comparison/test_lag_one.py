"""Correlation of neighbours on series whose correlation is known."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim.comparison import lag_one
from pam_cosim.comparison.residuals import RunComparison
from pam_cosim.comparison.scores import score_signal
from pam_cosim.measurement import Signal
from tests.comparison.fake import run


def test_white_and_red_noise() -> None:
    rng = np.random.default_rng(3)
    white = [rng.standard_normal(2000) for _ in range(3)]
    correlation, score = lag_one(white)
    assert abs(score) < 3 and score == pytest.approx(correlation * np.sqrt(3 * 1999))
    red = [np.convolve(e, [1.0, 1.0], "valid") for e in white]
    assert lag_one(red)[0] == pytest.approx(0.5, abs=0.03)


def test_nothing_to_judge() -> None:
    assert lag_one([]) == (0.0, 0.0) and lag_one([np.zeros(9), np.array([1.0])]) == (0.0, 0.0)


def test_scores_tell_it_of_each_signal() -> None:
    time = np.linspace(0.0, 1.0, 400)
    one = run("r", time, p=np.sin(9 * time))
    score = score_signal([RunComparison(one, {"p": 0 * time})], Signal("p", "Pa", 1.0))
    assert score is not None and score.autocorrelation > 0.95 and score.whiteness_score > 15
