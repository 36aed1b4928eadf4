"""Faults of instruments in the rig, against what can be worked out by hand."""

from __future__ import annotations

import numpy as np
import pytest

from rig.instruments import (
    FAULTS,
    Bow,
    ClockOffset,
    DeadTime,
    Gain,
    Lag,
    Offset,
    OffsetAndGain,
    Quantisation,
    Saturation,
    SensorFault,
    TransducerSaturation,
    TwoLags,
    disturbed,
    fault_of,
    readings,
)

TIME = np.linspace(0.0, 2.0, 401)
CLEAN = {"p": 2e5 * TIME, "x": 0.02 * TIME, "F": 100.0 * TIME, "T": 293.15 + 5.0 * TIME}


def shown(fault: SensorFault) -> np.ndarray:
    return disturbed([fault], TIME, CLEAN)[fault.signal]


def test_offset_and_gain():
    assert shown(Offset("x", 1e-3))[0] == 1e-3
    assert shown(Gain("p", 1.03))[-1] == pytest.approx(1.03 * 4e5)
    assert shown(Gain("T", 1.1, zero=293.15))[-1] == pytest.approx(293.15 + 11.0)
    both = shown(OffsetAndGain("F", offset=2.0, gain=0.9))
    assert both[0] == 2.0
    assert both[-1] == pytest.approx(182.0)


def test_a_bow_is_right_at_both_ends_of_the_range():
    bow = shown(Bow("x", bow=1e-3, full=0.04))
    assert bow[[0, -1]] == pytest.approx(CLEAN["x"][[0, -1]], abs=1e-12)
    assert (bow - CLEAN["x"]).max() == pytest.approx(1e-3, rel=1e-6)


@pytest.mark.parametrize(
    ("fault", "late"), [(Lag("p", 0.05), 0.05), (TwoLags("p", 0.05, r=0.4), 0.07)]
)
def test_behind_a_ramp_a_lag_is_late_by_its_time_constants(fault: SensorFault, late: float):
    assert shown(fault)[-1] == pytest.approx(2e5 * (2.0 - late), rel=1e-6)
    assert shown(fault)[0] == 0.0


def test_a_lag_of_a_step_is_an_exponential_on_any_grid():
    time = np.sort(np.r_[np.linspace(0.0, 1.0, 37), 0.2 - 1e-9])
    step = np.where(time >= 0.2 - 1e-10, 1.0, 0.0)
    late = disturbed([Lag("x", 0.1)], time, {"x": step})["x"]
    after = time > 0.25
    assert np.any(after)
    # the step is a line over the interval that it lies in
    began = time[np.flatnonzero(step)[0] - 1 : np.flatnonzero(step)[0] + 1].mean()
    assert late[after] == pytest.approx(1 - np.exp(-(time[after] - began) / 0.1), abs=2e-3)


def test_dead_time_and_clock_shift():
    assert shown(DeadTime("x", 0.1))[-1] == pytest.approx(0.02 * 1.9)
    assert shown(DeadTime("x", 0.1))[10] == 0.0  # the reading at rest
    late, early = (disturbed([ClockOffset(s)], TIME, CLEAN) for s in (0.05, -0.05))
    for name in CLEAN:
        assert late[name][50:] == pytest.approx(CLEAN[name][40:-10])
        assert early[name][:-10] == pytest.approx(CLEAN[name][10:])


def test_a_reading_ends_at_its_limits_with_its_noise_and_a_transducer_without():
    rng = np.random.default_rng(1)
    end = readings([Saturation("p", high=1e5)], TIME, CLEAN, TIME, {"p": 500.0}, rng)["p"]
    stop = readings([TransducerSaturation("p", high=1e5)], TIME, CLEAN, TIME, {"p": 500.0}, rng)[
        "p"
    ]
    beyond = CLEAN["p"] > 1.1e5
    assert np.ptp(end[beyond]) == 0.0
    assert stop[beyond].std() == pytest.approx(500.0, rel=0.1)


def test_steps_of_a_reading_add_noise_of_a_step_by_root_12():
    rng = np.random.default_rng(1)
    coarse = readings([Quantisation("x", 1e-3)], TIME, CLEAN, TIME, {"x": 0.0}, rng)["x"]
    assert np.unique(np.round(coarse / 1e-3, 9) % 1).size == 1
    assert (coarse - CLEAN["x"]).std() == pytest.approx(1e-3 / np.sqrt(12), rel=0.05)


@pytest.mark.parametrize("kind", FAULTS)
def test_a_fault_of_one_reading_leaves_the_others(kind):
    fault = kind()
    after = disturbed([fault], TIME, CLEAN)
    if isinstance(fault, SensorFault):
        assert all(np.array_equal(after[n], CLEAN[n]) for n in CLEAN if n != fault.signal)
    assert fault.family != "none"


@pytest.mark.parametrize(
    ("text", "family"),
    [
        ("offset:signal=p_1", "pressure_offset"),
        ("lag:signal=p,tau=0.1", "pressure_sensor_lag"),
        ("gain:signal=eps", "position_sensor"),
        ("lag:signal=T", "thermocouple_lag"),
        ("offset:signal=T", "temperature_sensor"),
        ("dead_time:signal=F", "force_sensor"),
        ("shift:shift=-0.02", "clock_offset"),
        ("limits:signal=p,high=1e5", "saturation"),
        ("steps:signal=x,step=1e-3", "quantisation"),
    ],
)
def test_faults_by_name(text: str, family: str):
    assert fault_of(text).family == family
