"""Courses keep the limits of a rig, and are written so that a rig can play them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from pam_cosim.diagnosis.planning import Limits, limits_of
from pam_cosim.diagnosis.planning.course import Course
from pam_cosim.diagnosis.planning.design import _Search
from pam_cosim.diagnosis.planning.moves import Moves
from pam_cosim.diagnosis.planning.rivals import soft_minimum
from pam_cosim.errors import InputError
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


def test_what_never_moved_moves_where_limits_are_stated_for_it_and_may_be_held(
    data: DataSet,
) -> None:
    wide = {"p_supply": (1e5, 4e5)}
    free, held = limits_of(data, wide), limits_of(data, wide, held=["p_supply"])
    assert free.moving == ("u", "s", "p_supply") and held.moving == ("u", "s")
    assert np.isinf(free.rates["p_supply"])
    rng = np.random.default_rng(1)
    supplies = [Moves(free, data.runs).drawn(rng).table(free)[1]["p_supply"] for _ in range(30)]
    assert any(np.ptp(values) > 1e4 for values in supplies)
    assert all(values.min() >= 1e5 and values.max() <= 4e5 for values in supplies)
    for _ in range(30):
        values = Moves(held, data.runs).drawn(rng).table(held)[1]["p_supply"]
        assert np.ptp(values) == 0 and 1e5 <= values[0] <= 4e5
    assert limits_of(data, {"p_supply": (2e5, 2e5)}).constant == {"p_supply"}  # no choice is left
    with pytest.raises(InputError, match="no input 'p_suply' to hold; did you mean 'p_supply'"):
        limits_of(data, held=["p_suply"])


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


@pytest.mark.parametrize(
    ("stated", "seconds", "message"),
    [
        ({"u_inn": (0.0, 1.0)}, None, "nothing 'u_inn' to limit"),
        ({"u": (1.0, 0.0)}, None, "begin above their end"),
        ({}, 0.0, "longer than nothing"),
    ],
)
def test_limits_that_make_no_sense(
    data: DataSet, stated: dict, seconds: float | None, message: str
) -> None:
    with pytest.raises(InputError, match=message):
        limits_of(data, stated, seconds)


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


def test_a_recorded_course_is_what_was_recorded(data: DataSet) -> None:
    limits = limits_of(data)
    first, second = Moves(limits, data.runs).recorded()
    assert (first.parameters["load.m"], second.constants["p_supply"]) == (1.0, 3e5)
    time, table = first.table(limits)
    assert np.interp(time, TIME, VALVE) == pytest.approx(table["u"], abs=1e-12)
    assert np.interp(time, TIME, STROKE) == pytest.approx(table["s"], abs=2e-4)


def test_a_step_is_two_rows_at_one_time() -> None:
    limits = Limits({"u": (0.0, 1.0)}, frozenset(), {"u": np.inf}, {"u": 0.0}, {}, {}, 1.0, 0.1)
    course = Course(np.array([0.0, 0.5]), np.array([[0.2], [0.8]]), True, np.zeros((1, 4)), {}, {})
    time, table = course.table(limits)
    at = np.flatnonzero(time == 0.5)
    assert len(at) == 2 and table["u"][at].tolist() == [0.2, 0.8]
    joined = replace(course, is_stepped=False).table(limits)[1]["u"]
    assert joined[:6] == pytest.approx(np.linspace(0.2, 0.8, 6))


def test_the_soft_minimum_lies_above_the_least_pair_and_near_it() -> None:
    assert soft_minimum(np.array([40.0, 40.0])) == pytest.approx(40.0)
    far = soft_minimum(np.array([40.0, 4000.0]))
    assert 40.0 < far < 40.0 + 8 * np.log(2) + 1e-9
    assert soft_minimum(np.array([41.0, 4000.0])) > far  # the nearest pair counts most


class _ThreeCourses:
    """Moves and rivals of a rig that knows three courses: one that brings most, one that brings less and is simpler,
    and one that is simplest and brings next to nothing."""

    pairs = ((0, 1),)

    def __init__(self) -> None:
        kinds = ((100.0, 9), (90.0, 5), (0.1, 1))
        self.courses = [SimpleNamespace(chi2=chi2, complexity=size) for chi2, size in kinds]
        self.number = 0

    def drawn(self, rng: object) -> SimpleNamespace:
        self.number += 1
        return self.courses[self.number % 3]

    def recorded(self) -> list[SimpleNamespace]:
        return []

    def changed(self, rng: object, course: SimpleNamespace) -> SimpleNamespace:
        return course

    def joined(self, rng: object, one: SimpleNamespace, two: SimpleNamespace) -> SimpleNamespace:
        return one

    def thinned(self, course: SimpleNamespace) -> np.ndarray:
        return np.array([course.chi2])


@pytest.mark.parametrize("known", [0.0, 500.0])
def test_a_later_run_is_chosen_by_what_it_adds(
    known: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """However much the runs before it have brought, the simplest course is no substitute for one that decides."""
    rig, chosen = _ThreeCourses(), []
    monkeypatch.setattr(_Search, "_planned", lambda self, course, *rest: chosen.append(course))
    search = _Search(rig, rig, np.random.default_rng(0), known=np.array([known]))  # type: ignore[arg-type]
    search.best(("a", "b"))
    assert chosen[0].chi2 == 90.0
