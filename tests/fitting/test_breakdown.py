"""Fits survive parameter values at which the model has no answer."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting import fit
from pam_cosim.measurement import DataSet, FreeParameter
from pam_cosim.simulation import Simulator
from tests.fitting.models import data_set, recording

TIME = np.linspace(0.0, 3.0, 61)


@pytest.fixture
def fragile() -> Iterator[Simulator]:
    """y = exp(-a t) sqrt((6 - a)/4): a real number for a <= 6 only."""
    with Simulator(study.build(str(Path(__file__).parent / "Fragile.mo"))) as simulator:
        yield simulator


def decay(a: float, low: float, high: float, start: float) -> DataSet:
    y = np.exp(-a * TIME) * np.sqrt((6 - a) / 4) + 0.01 * np.random.default_rng(0).standard_normal(
        len(TIME)
    )
    return data_set(
        "Fragile",
        [recording(TIME, {"y": y})],
        {"y": 0.01},
        [FreeParameter("a", low, high, start, "1")],
    )


def test_model_does_break_down(fragile: Simulator) -> None:
    with pytest.raises(SimulationFailure, match="'y' is not a finite number"):
        fragile.run(TIME, parameters={"a": 6.5})


@pytest.mark.parametrize(
    "start", [0.01, 5.9, 9.0, 60.0], ids=["far", "at the edge", "beyond", "far beyond"]
)
def test_fit_gets_around_the_hole(fragile: Simulator, start: float) -> None:
    result = fit(fragile, decay(2.0, 0.0, 100.0, start))
    estimate = result.parameters["a"]
    assert estimate.low <= 2.0 <= estimate.high
    assert estimate.high - estimate.low < 0.1
    assert bool(result.failures) == (
        start > 5.5
    )  # at 5.9 the first difference reaches into the hole
    if result.failures:
        assert "not a finite number" in result.failures[0] and "a = " in result.failures[0]


@pytest.mark.parametrize(
    "start", [0.01, 5.9, 9.0, 60.0], ids=["far", "at the edge", "beyond", "far beyond"]
)
def test_an_assertion_is_a_hole_like_any_other(start: float) -> None:
    with Simulator(study.build(str(Path(__file__).parent / "Guarded.mo"))) as guarded:
        with pytest.raises(SimulationFailure, match="at time 0.25 s: too fast at s = 0.19"):
            guarded.run(TIME, parameters={"a": 6.5})
        result = fit(guarded, decay(2.0, 0.0, 100.0, start))
    estimate = result.parameters["a"]
    assert estimate.low <= 2.0 <= estimate.high
    assert bool(result.failures) == (start > 5.5)
    if result.failures:
        assert "too fast at s = " in result.failures[0] and "a = " in result.failures[0]


def test_no_usable_value_at_all_is_one_clear_failure(fragile: Simulator) -> None:
    with pytest.raises(
        SimulationFailure, match="no start value within the bounds can be simulated: .*finite"
    ):
        fit(fragile, decay(2.0, 7.0, 100.0, 50.0))
