"""Rest, steps and switches of courses whose answer is known."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim.drafting.shapes import is_constant, is_held, is_switch, moving, noise_at_rest, rests

RNG = np.random.default_rng(4)
TIME = 0.01 * np.arange(1000)
RAMP = np.clip(TIME - 3.0, 0.0, 2.0)  # rests until 3 s and from 5 s


def test_rest_is_found_beside_noise() -> None:
    found = rests(TIME, [RAMP + RNG.normal(0.0, 0.01, 1000)])
    assert [one.start for one in found][0] == 0
    assert (
        len(found) == 2
        and 2.5 < TIME[found[0].stop - 1] < 3.05
        and 4.95 < TIME[found[1].start] < 5.5
    )


def test_all_columns_must_rest() -> None:
    other = np.where(TIME > 1.5, 1.0, 0.0)
    assert TIME[rests(TIME, [RAMP, other])[0].stop - 1] < 1.55


@pytest.mark.parametrize("value", [0.015, 0.7, 6.1e5])
def test_what_stays_where_it_is_rests_whatever_its_last_digit(value: float) -> None:
    """The mean of 39 times 0.015 is not that of 40 times 0.015."""
    own = RAMP + np.random.default_rng(5).normal(0.0, 0.01, 1000)
    assert rests(TIME, [own, np.full(1000, value)]) == rests(TIME, [own])


def test_nothing_rests() -> None:
    assert rests(TIME, [np.sin(3.0 * TIME) + RNG.normal(0.0, 0.01, 1000)]) == []


def test_a_slow_drift_moves() -> None:
    assert moving(TIME, 0.1 * TIME + RNG.normal(0.0, 1e-3, 1000)).all()


def test_a_long_recording() -> None:
    """Rests of a second are seen in a recording of ten minutes, and a ramp of ten minutes is no rest of ten minutes."""
    time = 0.01 * np.arange(60_000)
    steps = np.where(time % 4.0 < 2.0, 0.0, 1.0)
    found = rests(time, [steps + RNG.normal(0.0, 0.01, 60_000)])
    assert len(found) > 250 and 100 < max(one.count for one in found) < 210
    ramp = rests(time, [time / 600.0 + RNG.normal(0.0, 0.01, 60_000)])
    assert max(one.count for one in ramp) < 3000


@pytest.mark.parametrize("sigma", [0.003, 0.02])
def test_noise_at_rest(sigma: float) -> None:
    values = RAMP + RNG.normal(0.0, sigma, 1000)
    value, step = noise_at_rest(TIME, values, rests(TIME, [values])[0])
    assert value == pytest.approx(sigma, rel=0.25)
    assert step == 0.0


def test_noise_below_the_step_of_the_record() -> None:
    values = np.round(RAMP / 0.05) * 0.05
    value, step = noise_at_rest(TIME, values, rests(TIME, [values])[0])
    assert step == pytest.approx(0.05, rel=1e-6) and value == pytest.approx(
        0.05 / np.sqrt(12.0), rel=1e-3
    )


def test_computed_numbers_have_no_noise() -> None:
    values = np.sqrt(RAMP) + 1e-9 * np.sin(17.0 * TIME)
    assert noise_at_rest(TIME, values, rests(TIME, [values])[0]) == (0.0, 0.0)


def test_kinds_of_courses() -> None:
    stairs = np.repeat(np.arange(20.0), 50)
    lagged = np.convolve(stairs, np.exp(-np.arange(60) / 12.0) / 12.0)[:1000]
    assert is_held(stairs) and not is_held(lagged) and not is_held(np.ones(1000))
    assert (
        is_switch(np.where(TIME > 2.0, 1.0, 0.0))
        and not is_switch(stairs)
        and not is_switch(np.ones(5))
    )
    assert is_constant(207.0 + RNG.normal(0.0, 0.3, 1000)) and not is_constant(RAMP)
