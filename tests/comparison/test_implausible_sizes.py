"""Doubts about sizes: a measurement much larger than the model, an impossible reading, an input in a wrong unit."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from pam_cosim.comparison.plausibility import Doubt, doubts
from pam_cosim.comparison.residuals import RunComparison
from pam_cosim.measurement import Signal
from tests.comparison.test_plausibility import PRESSURE, TIME, compared

OTHER_COURSE = 1e5 * (2 + np.cos(2 * np.pi * TIME / 5))


def of_force(factor: float) -> list[Doubt]:
    """A force of a course of its own beside a model that nobody has fitted."""
    run = compared(factor * PRESSURE, OTHER_COURSE)
    run = replace(run, run=replace(run.run, inputs={"p_set": 4e7 * PRESSURE / PRESSURE.max()}))
    signals = {"p": Signal("p", "N", 1e-3 * factor)}
    every = doubts([run], signals, {"p_set": "Pa"}, fitted=False)
    return [doubt for doubt in every if doubt.kind == "far_off"]


@pytest.mark.parametrize("factor", [1e3, 1e30, 1e-3])
def test_a_measurement_is_doubted_too_large_and_too_small(factor: float) -> None:
    (doubt,) = of_force(factor)
    assert "times as large" in doubt.text
    assert "of an input: p_set goes to 40000 kPa" in doubt.text
    assert of_force(1.2) == []


def impossible(measured: np.ndarray, modelled: np.ndarray, unit: str = "Pa") -> list[Doubt]:
    runs: list[RunComparison] = [compared(measured, modelled)]
    every = doubts(runs, {"p": Signal("p", unit, 500.0 if unit == "Pa" else 0.1)}, {})
    return [doubt for doubt in every if doubt.kind == "impossible"]


def test_a_pressure_below_vacuum_is_reported() -> None:
    (doubt,) = impossible(-PRESSURE, PRESSURE)
    assert "below -101 kPa, a vacuum" in doubt.text and "at 0 s of run-01" in doubt.text
    assert "the sign, the unit and the zero" in doubt.text


def test_noise_at_a_vacuum_and_differences_of_pressures_are_not() -> None:
    assert impossible(np.full_like(TIME, -102e3), PRESSURE) == []
    assert impossible(-PRESSURE, -PRESSURE) == []


def test_a_temperature_below_zero_kelvin_is_reported() -> None:
    (doubt,) = impossible(np.full_like(TIME, -20.0), np.full_like(TIME, 293.0), "K")
    assert "absolute zero" in doubt.text
