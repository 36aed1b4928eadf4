"""Steps of commands between two samples are seen, and only these; they can be given a time."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pam_cosim.measurement import Run, between_samples, with_step_times

TIME = np.arange(1001) / 100


def _run(u: np.ndarray, time: np.ndarray = TIME) -> Run:
    x = np.where(np.arange(len(time)) % 2 == 0, np.sin(time), np.nan)
    return Run("run", Path("run.csv"), "fit", "previous", {}, time, {"u": u}, {"x": x})


def _steps(noise: float = 0.0) -> np.ndarray:
    u = np.where((TIME >= 2.0) & (TIME < 5.0), 0.35, 0.0) + np.where(TIME >= 7.0, 0.1, 0.0)
    return u + noise * np.random.default_rng(1).standard_normal(len(TIME))


@pytest.mark.parametrize("noise", [0.0, 1e-3])
def test_steps_are_seen(noise: float) -> None:
    assert between_samples(_run(_steps(noise))).tolist() == [199, 499, 699]


@pytest.mark.parametrize(
    "u",
    [np.sin(TIME), 0.1 * TIME, np.clip(TIME - 5.0, 0.0, 0.05), np.zeros(len(TIME))],
    ids=["sine", "ramp", "quick ramp", "nothing"],
)
def test_courses_have_none(u: np.ndarray) -> None:
    assert between_samples(_run(u)).size == 0


def test_a_step_in_two_rows_is_where_it_is() -> None:
    run = _run(_steps())
    timed = with_step_times(run, np.array([199, 499, 699]), np.array([1.993, 4.9951, 6.9999]))
    assert between_samples(timed).size == 0
    assert between_samples(replace(timed, along=None, inputs={})).size == 0


def test_a_step_gets_its_time_and_no_sample_is_lost() -> None:
    run, rows, times = _run(_steps()), np.array([199, 499, 699]), np.array([1.993, 4.9951, 6.9999])
    timed = with_step_times(run, rows, times)
    assert len(timed.time) == len(run.time) + 6
    assert np.all(np.diff(timed.time) >= 0)
    at = np.flatnonzero(np.diff(timed.time) == 0)
    np.testing.assert_array_equal(timed.time[at], times)
    np.testing.assert_allclose(timed.inputs["u"][at], [0.0, 0.35, 0.0], atol=1e-12)
    np.testing.assert_allclose(timed.inputs["u"][at + 1], [0.35, 0.0, 0.1], atol=1e-12)
    kept = np.isfinite(timed.measurements["x"])
    np.testing.assert_array_equal(
        timed.measurements["x"][kept], run.measurements["x"][np.isfinite(run.measurements["x"])]
    )
    assert timed.sample_count("x") == run.sample_count("x")
