"""Data whose residual is white and says nothing all the same: no verdict calls them noise."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.measurement import DataSet
from tests.fitting.models import TIMES, discharge, vessel_data
from tests.tiers import quick

RNG = np.random.default_rng(7)
P = discharge()[0]
FAR = "The residuals are white, but .* times the stated noise: the noise level is wrong, or"
NOTHING = "These data cannot show anything. The smallest error that would have been found: p "


def measured(values: np.ndarray) -> DataSet:
    """Pressures in place of the vessel's, with a stated noise of 1 kPa."""
    return vessel_data(seed=None, clean=values)


def doubled() -> DataSet:
    """Every time stands twice, with readings 60 kPa apart."""
    data = vessel_data()
    (run,) = data.runs
    pair = np.repeat(P, 2) + np.tile([30e3, -30e3], len(P))
    pair += 1e3 * RNG.standard_normal(len(pair))
    time = np.repeat(TIMES, 2) + np.tile([0.0, 1e-6], len(P))
    return replace(data, runs=(replace(run, time=time, measurements={"p": pair}),))


CASES: dict[str, tuple[Callable[[], DataSet], str]] = {
    "two samples": (lambda: vessel_data(times=TIMES[[0, 40]]), NOTHING),
    "scatter far above the noise": (
        lambda: measured(P + 43e3 * RNG.standard_normal(len(P))),
        "The residual|" + FAR,
    ),
    "readings that contradict each other": (doubled, FAR),
    "a piece that is too short": (lambda: vessel_data(times=np.linspace(0, 0.06, 60)), NOTHING),
    "another unit": (
        lambda: replace(measured(1e-6 * P), parameters={"tank.p_start": 0.0}),
        "The residual|" + NOTHING,
    ),
}


@pytest.mark.parametrize("name", quick(CASES, "two samples"))
def test_nothing_is_not_said_to_be_missing(name: str) -> None:
    make, reason = CASES[name]
    verdict = pam.diagnose(make(), workers=0, explain=False).verdict
    assert verdict.kind == "unknown" and not verdict.families
    assert re.match(reason, verdict.reason), verdict.reason


def test_samples_within_their_noise_get_a_word() -> None:
    comparison = pam.compare(measured(1e-6 * P))
    assert "too_quiet" in [doubt.kind for doubt in comparison.doubts]


def test_a_good_record_says_what_it_would_have_shown() -> None:
    verdict = pam.diagnose(vessel_data(), workers=0, explain=False).verdict
    assert verdict.kind == "none_missing"
    (limit,) = verdict.limits
    assert limit.rmse == pytest.approx(1e3 * (14.1 / 59) ** 0.5, rel=0.05) and limit.is_useful
