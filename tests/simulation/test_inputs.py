"""Sampled inputs as pieces, and the plan of communication points."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pam_cosim.errors import InputError
from pam_cosim.simulation import Inputs
from pam_cosim.simulation.inputs import pieces
from pam_cosim.simulation.plan import plan


def test_constant_is_one_piece_and_its_ends() -> None:
    time = np.linspace(0.0, 10.0, 1001)
    course = pieces(time, np.full(1001, 0.35), "linear")
    assert course.slope.tolist() == [0.0, 0.0, 0.0]
    assert plan(
        np.array([0.0, 10.0]), 0.0, Inputs(time, {"u": np.full(1001, 0.35)})
    ).times.tolist() == [0.0, 10.0]


def test_step_is_applied_at_its_second_row() -> None:
    course = pieces(np.array([0.0, 1.0, 1.0, 2.0]), np.array([0.0, 0.0, 5.0, 5.0]), "linear")
    assert course.at(np.array([0.5, 1.0 - 1e-9, 1.0, 1.5, 9.0]))[0].tolist() == [
        0.0,
        0.0,
        5.0,
        5.0,
        5.0,
    ]


def test_previous_holds_until_the_next_sample() -> None:
    course = pieces(np.array([0.0, 1.0, 2.0, 3.0]), np.array([1.0, 1.0, 4.0, 4.0]), "previous")
    assert course.time.tolist() == [-np.inf, 2.0]
    assert course.at(np.array([-5.0, 1.9, 2.0, 99.0]))[0].tolist() == [1.0, 1.0, 4.0, 4.0]


def test_held_before_the_first_and_after_the_last_sample() -> None:
    course = pieces(np.array([1.0, 2.0]), np.array([3.0, 5.0]), "linear")
    values, slopes = course.at(np.array([0.0, 1.5, 2.0, 7.0]))
    assert values.tolist() == [3.0, 4.0, 5.0, 5.0] and slopes.tolist() == [0.0, 2.0, 0.0, 0.0]


def test_single_sample() -> None:
    for interpolation in ("linear", "previous"):
        course = pieces(np.array([1.0]), np.array([3.0]), interpolation)
        assert course.at(np.array([0.0, 9.0]))[0].tolist() == [3.0, 3.0]


@pytest.mark.full
@settings(max_examples=200, deadline=None)
@given(
    st.lists(st.integers(0, 20), min_size=1, max_size=30).map(sorted),
    st.data(),
)
def test_pieces_say_the_same_as_interpolation(ticks: list[int], data: st.DataObject) -> None:
    """Against numpy's interpolation, between the samples where a step cannot be meant otherwise."""
    time = np.array(ticks, dtype=float) / 7.0
    levels = st.sampled_from([-2.0, 0.0, 0.1, 1.0, 3.0])
    values = np.array(data.draw(st.lists(levels, min_size=len(ticks), max_size=len(ticks))))
    course = pieces(time, values, "linear")
    distinct, first = np.unique(time, return_index=True)
    last = np.append(first[1:], time.size) - 1
    assert course.at(distinct)[0] == pytest.approx(values[last], abs=1e-9)
    for i in range(distinct.size - 1):
        inside = distinct[i] + (distinct[i + 1] - distinct[i]) * np.array([0.25, 0.9])
        line = values[last[i]] + (values[first[i + 1]] - values[last[i]]) * np.array([0.25, 0.9])
        assert course.at(inside)[0] == pytest.approx(line, abs=1e-9)


def test_slow_curve_of_many_tiny_bends_is_kept() -> None:
    """Each bend is below rounding of the signal, their sum is not."""
    time = np.linspace(0.0, 1.0, 1_000_001)
    values = 1e3 + 0.1 * time**2
    course = pieces(time, values, "linear")
    at = np.linspace(0.0, 1.0, 97)
    assert course.at(at)[0] == pytest.approx(1e3 + 0.1 * at**2, abs=1e-6)


def test_change_beside_an_output_by_rounding_happens_there() -> None:
    inputs = Inputs(np.array([0.0, 0.1 + 0.2, 0.1 + 0.2]), {"u": np.array([0.0, 0.0, 1.0])})
    points = plan(np.array([0.0, 0.3, 1.0]), 0.0, inputs)
    assert points.times.tolist() == [0.0, 0.3, 1.0]
    assert points.values.tolist() == [[0.0], [1.0]] and points.knots.tolist() == [0, 1, -1]


def test_outputs_before_and_after_a_step() -> None:
    points = plan(np.array([1.0, 2.0, 2.0, 3.0, 3.0, 3.0]), 0.0, None)
    assert points.times.tolist() == [0.0, 1.0, 2.0, 3.0]
    assert points.rows_after.tolist() == [-1, 0, 1, 2] and points.rows_before.tolist() == [
        -1,
        -1,
        3,
        4,
    ]
    assert points.rows.tolist() == [0, 3, 1, 4, 2, 2]


def test_changes_outside_the_run_are_left_out() -> None:
    inputs = Inputs(np.array([0.0, 1.0, 5.0, 9.0]), {"u": np.array([0.0, 1.0, 0.0, 1.0])})
    assert plan(np.array([2.0, 6.0]), 2.0, inputs).times.tolist() == [2.0, 5.0, 6.0]


@pytest.mark.parametrize(
    ("time", "values", "message"),
    [
        ([], [], "non-empty"),
        ([0.0, 2.0, 1.0], [0.0, 0.0, 0.0], "decrease after 2 s"),
        ([0.0, np.nan], [0.0, 0.0], "finite"),
        ([0.0, 1.0], [0.0, np.inf], "input 'u' has a value that is not a finite number"),
        ([0.0, 1.0], [0.0], "input 'u' has 1 values for 2 times"),
    ],
)
def test_unusable_inputs(time: list[float], values: list[float], message: str) -> None:
    with pytest.raises(InputError, match=message):
        Inputs(np.array(time), {"u": np.array(values)})


@pytest.mark.parametrize(
    ("times", "start", "message"),
    [
        ([], 0.0, "non-empty"),
        ([0.0, -1.0], -1.0, "must not decrease"),
        ([0.0, 1.0], 0.5, "cannot start at 0.5 s"),
    ],
)
def test_unusable_times(times: list[float], start: float, message: str) -> None:
    with pytest.raises(InputError, match=message):
        plan(np.array(times), start, None)
