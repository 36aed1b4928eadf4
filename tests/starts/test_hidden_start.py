"""A run may begin while a state that no signal shows still moves, though its command rests in all of the run."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.arrays import Array
from pam_cosim.measurement import DataSet, FreeParameter, Run
from pam_cosim.measurement.start import Start
from tests.fitting.models import data_set, recording

MODEL = str(Path(__file__).with_name("Drive.mo"))
TIMES = np.linspace(0.0, 4.0, 81)
SIGMA = 0.01


def _run(name: str, u_in: Array, u_out: Array, y: Array, seed: int) -> Run:
    noise = SIGMA * np.random.default_rng([seed, 11]).standard_normal(len(TIMES))
    run = recording(TIMES, {"y": y + noise}, inputs={"u_in": u_in, "u_out": u_out})
    return replace(run, name=name, start=Start(mode="estimated"), interpolation="previous")


def _filled(since: Array) -> Array:
    """What a drive with a time constant of 0.5 s has filled so long after a step of its command."""
    return np.asarray((1.0 - np.exp(-np.maximum(since, 0.0))) ** 2)


def _data() -> DataSet:
    """Two runs, of which the second begins as the inlet still shuts, whose command is zero by then."""
    t, shut = TIMES, np.zeros(len(TIMES))
    steps = _filled(t - 1.0) - 0.5 * _filled(t - 2.0)
    whole = _run("whole", (t >= 1.0) * 1.0, (t >= 2.0) * 0.5, steps, 1)
    late = _run("late", shut, shut, 2.0 * np.exp(-t) - np.exp(-2.0 * t), 2)
    tau = FreeParameter("tau", 0.1, 5.0, 1.0, "1")
    return data_set("Drive", [whole, late], {"y": SIGMA}, [tau])


def test_it_is_estimated_within_what_other_runs_do_to_it() -> None:
    fit = pam.fit(_data(), MODEL)
    assert 0.8 < fit.comparison.chi2_reduced("fit") < 1.2
    assert fit.values["tau"] == pytest.approx(0.5, rel=0.05)
    left = fit.start_values["z_in@late"] - fit.start_values["z_out@late"]  # all that a sample shows
    assert left == pytest.approx(1.0, abs=0.1)


def test_so_it_is_in_a_held_out_run() -> None:
    data = _data()
    whole, late = data.runs
    fit = pam.fit(replace(data, runs=(whole, replace(late, role="holdout"))), MODEL)
    assert 0.8 < fit.comparison.chi2_reduced("holdout") < 1.2
