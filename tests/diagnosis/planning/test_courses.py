"""Courses keep the limits of a rig, and are written so that a rig can play them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pam_cosim.diagnosis.planning import limits_of
from pam_cosim.diagnosis.planning.moves import Moves
from pam_cosim.measurement import DataSet, Run, Signal

TIME = np.linspace(0.0, 5.0, 51)
VALVE = np.where(TIME < 2.0, 0.3, 0.0)
STROKE = 0.01 * np.sin(TIME)


def _run(name: str, supply: float, load: float) -> Run:
    inputs = {"u": VALVE, "s": STROKE, "p_supply": np.full(51, supply)}
    known = {"load.m": load, "muscle.L0": 0.2}
    return Run(name, Path(f"{name}.csv"), "fit", "linear", known, TIME, inputs, {"x": STROKE})


@pytest.fixture
def data() -> DataSet:
    runs = (_run("one", 2e5, 1.0), _run("two", 3e5, 4.0))
    return DataSet(Path("rig"), "a rig", "M", {"x": Signal("x", "m", 1e-4)}, {}, {}, runs)


def test_limits_are_what_the_recordings_span(data: DataSet) -> None:
    limits = limits_of(data)
    assert limits.inputs == {
        "u": (0.0, 0.3),
        "s": (STROKE.min(), STROKE.max()),
        "p_supply": (2e5, 3e5),
    }
    assert limits.constant == {"p_supply"} and limits.moving == ("u", "s")
    assert limits.parameters == {"load.m": (1.0, 4.0)}
    assert np.isinf(limits.rates["u"])  # all of its range within a sample
    assert limits.rates["s"] == pytest.approx(0.01, rel=0.01)  # the steepest slope of the sine
    assert (limits.seconds, limits.interval) == (5.0, pytest.approx(0.1))


def test_a_bench_without_inputs_has_parameters_to_plan(data: DataSet) -> None:
    still = replace(data, runs=tuple(replace(run, inputs={}) for run in data.runs))
    limits, rng = limits_of(still), np.random.default_rng(0)
    moves = Moves(limits, still.runs)
    for course in (*moves.recorded(), *(moves.drawn(rng) for _ in range(20))):
        time, inputs = course.table(limits)
        assert len(time) == 51 and not inputs
        assert 1.0 <= moves.changed(rng, course).parameters["load.m"] <= 4.0


def test_stated_limits_come_first(data: DataSet) -> None:
    limits = limits_of(
        data, {"u": (0.1, 0.4), "muscle.L0": (0.1, 0.2), "x": (0.0, 0.005)}, seconds=2.0
    )
    assert limits.inputs["u"] == (0.1, 0.4) and limits.parameters["muscle.L0"] == (0.1, 0.2)
    assert limits.outputs == {"x": (0.0, 0.005)} and limits.seconds == 2.0


@pytest.mark.parametrize(
    ("readings", "constant"),
    [
        (lambda rng: 5e5 + 300 * rng.standard_normal(51), {"p_supply"}),
        (lambda rng: 1e3 * rng.standard_normal(51), {"p_supply"}),  # about zero
        (lambda rng: 5e5 - 8e3 * TIME + 300 * rng.standard_normal(51), set()),  # it droops
        (lambda rng: np.where(TIME < 2, 5e5, 4e5), set()),
    ],
)
def test_the_noise_of_a_reading_is_no_range(
    data: DataSet, readings: Callable[[np.random.Generator], np.ndarray], constant: set[str]
) -> None:
    rng = np.random.default_rng(3)
    runs = [replace(r, inputs={**r.inputs, "p_supply": readings(rng)}) for r in data.runs]
    limits = limits_of(replace(data, runs=tuple(runs)))
    assert limits.constant == constant
    low, high = limits.inputs["p_supply"]
    if constant:
        assert low <= high <= low + 0.02 * max(abs(low), 1e5)
        drawn = Moves(limits, runs).drawn(rng).table(limits)[1]["p_supply"]
        assert np.ptp(drawn) == 0


def test_every_course_keeps_the_limits(data: DataSet) -> None:
    limits, rng = limits_of(data), np.random.default_rng(1)
    moves = Moves(limits, data.runs)
    courses = [moves.drawn(rng) for _ in range(30)] + moves.recorded()
    for _ in range(100):
        a, b = (courses[int(rng.integers(len(courses)))] for _ in range(2))
        courses += [moves.changed(rng, a), moves.joined(rng, a, b)]
    for course in courses:
        time, table = course.table(limits)
        assert np.all(np.diff(time) >= 0) and time[0] == 0.0 and time[-1] == 5.0
        assert np.unique(time).size >= time.size / 2  # two rows at one time at most
        for name, values in table.items():
            low, high = limits.inputs[name]
            assert values.min() >= low - 1e-12 and values.max() <= high * (1 + 1e-12)
        assert np.ptp(table["p_supply"]) == 0
        assert np.abs(np.diff(table["s"])).max() <= limits.rates["s"] * 0.1 * (1 + 1e-9)
        assert 1.0 <= course.parameters["load.m"] <= 4.0
        assert np.array_equal(course.knots, np.sort(course.knots)) and course.knots[0] == 0
