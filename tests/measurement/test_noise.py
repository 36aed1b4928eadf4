"""The estimate against noise of known standard deviation."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from pam_cosim.measurement import (
    DataSet,
    Run,
    StatedSignal,
    complete_noise,
    estimate_noise,
    record_step,
)

N = 2000
TIME = np.linspace(0.0, 4.0, N)
CURVES = {
    "constant": np.zeros(N),
    "slow exponential": 1 - np.exp(-TIME),
    "fast exponential": 1 - np.exp(-TIME / 0.05),
    "oscillation": np.sin(4 * np.pi * TIME),
    "steps": np.floor(5 * TIME) % 2 + np.exp(-TIME),
}


def white(seed: int, size: int = N) -> np.ndarray:
    return np.random.default_rng(seed).standard_normal(size)


@pytest.mark.parametrize("curve", CURVES)
@pytest.mark.parametrize("sigma", [0.03, 0.001])
def test_white_noise_on_smooth_signals_and_steps(curve, sigma):
    for seed in range(5):
        assert estimate_noise(TIME, CURVES[curve] + sigma * white(seed)) == pytest.approx(
            sigma, rel=0.1
        )


@pytest.mark.parametrize("quantum", [0.1, 1.0, 2.0])
def test_quantised_readings_have_noise_and_rounding(quantum):
    raw = 20 * CURVES["slow exponential"] + white(1)
    expected = np.sqrt(1 + quantum**2 / 12)
    assert estimate_noise(TIME, quantum * np.round(raw / quantum)) == pytest.approx(
        expected, rel=0.1
    )


def test_the_scale_of_the_unit_does_not_matter():
    values = 0.1 * np.round(10 * (20 * CURVES["slow exponential"] + white(3)))
    assert estimate_noise(TIME, 1e3 * values) == pytest.approx(
        1e3 * estimate_noise(TIME, values), rel=1e-6
    )


def test_missing_samples_uneven_times_and_double_rows():
    values = CURVES["slow exponential"] + 0.01 * white(2)
    holes = values.copy()
    holes[::3] = np.nan
    holes[500:700] = np.nan
    slow = np.full(N, np.nan)
    slow[::4] = values[::4]
    uneven = TIME + 0.3 * TIME[1] * np.random.default_rng(1).uniform(-1, 1, N)
    double = TIME.copy()
    double[1000:] -= TIME[1]
    assert double[1000] == pytest.approx(double[999])
    assert estimate_noise(TIME, holes) == pytest.approx(0.01, rel=0.15)
    assert estimate_noise(TIME, slow) == pytest.approx(0.01, rel=0.15)
    assert estimate_noise(
        np.sort(uneven), 1 - np.exp(-np.sort(uneven)) + 0.01 * white(2)
    ) == pytest.approx(0.01, rel=0.1)
    assert estimate_noise(double, values) == pytest.approx(0.01, rel=0.1)


def run(name: str, **measurements: np.ndarray) -> Run:
    return Run(name, Path(name), "fit", "linear", {}, TIME, {}, measurements)


def test_only_unknown_noise_is_filled_in():
    shaking = CURVES["constant"] + 30 * white(9)
    runs = [run(f"r{seed}", p=2.0 * white(seed), x=white(seed)) for seed in range(4)] + [
        run("shaking", p=shaking)
    ]
    runs.append(run("few", T=np.where(np.arange(len(TIME)) < 4, TIME, np.nan)))
    signals = [StatedSignal("p", "Pa"), StatedSignal("x", "m", 0.5), StatedSignal("T", "K")]
    filled = complete_noise({one.name: one for one in signals}, runs)
    assert filled["p"].sigma == pytest.approx(2.0, rel=0.1)
    assert (filled["p"].estimated, filled["p"].assumed) == (True, False)
    assert (filled["x"].sigma, filled["x"].estimated) == (0.5, False)
    assert filled["T"].sigma == pytest.approx(0.01 * TIME[3])
    assert (filled["T"].estimated, filled["T"].assumed) == (True, True)


@pytest.mark.parametrize("step", [0.25, 1.0])
def test_steps_of_a_record_come_on_top_of_a_stated_noise(step: float):
    smooth = 20 * np.sin(TIME) + 0.1 * white(3)
    assert record_step(step * np.round(smooth / step)) == pytest.approx(step)
    stated = StatedSignal("x", "m", 0.1)
    runs = (run("a", x=step * np.round(smooth / step)),)
    known = complete_noise({"x": stated}, runs)["x"]
    assert known.sigma == pytest.approx(np.hypot(0.1, step / np.sqrt(12)))
    assert known.step == pytest.approx(step) and not known.estimated
    data = DataSet(Path("."), "t", "M", {"x": known}, {}, {}, runs)
    assert "x is recorded in steps of" in " ".join(data.notes())
    assert known.as_stated() == stated
    assert complete_noise({"x": known.as_stated()}, runs)["x"] == known


@pytest.mark.parametrize(
    ("step", "digits"), [(0.02, 9), (0.0244140625, 3), (0.0244140625, 5), (0.3, 2)]
)
def test_steps_of_a_converter_are_seen_through_the_digits_of_the_file(step: float, digits: int):
    steps = step * np.round((20 * np.sin(TIME) + 0.01 * white(3)) / step)
    assert record_step(np.round(steps, digits)) == pytest.approx(step, rel=1e-3)
