"""What a model is off by beside the noise is found again from residuals of known size, memory and noise."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.arrays import Array
from pam_cosim.comparison import RunComparison
from pam_cosim.fitting import Band, Discrepancy, discrepancies
from pam_cosim.measurement import Run, Signal
from tests.fitting.models import discharge, recording, vessel_data

SIGNALS = {"y": Signal("y", "1", 0.5)}
SD, MEMORY, STEP = 2.0, 0.3, 0.02


def course(rng: np.random.Generator, count: int, step: float = STEP) -> Array:
    """A first-order autoregressive course."""
    kept = float(np.exp(-step / MEMORY))
    values = [SD * rng.standard_normal()]
    for _ in range(count - 1):
        values.append(kept * values[-1] + SD * np.sqrt(1 - kept**2) * rng.standard_normal())
    return np.array(values)


def compared(name: str, error: Array, role: str = "fit", step: float = STEP) -> RunComparison:
    run = Run(
        name,
        Path(f"{name}.csv"),
        role,  # type: ignore[arg-type]
        "linear",
        {},
        step * np.arange(len(error)),
        {},
        {"y": error},
    )
    return RunComparison(run, {"y": np.zeros(len(error))})


def noisy(seed: int, count: int = 1500, share: float = 1.0) -> Array:
    rng = np.random.default_rng([seed, 5])
    return share * course(rng, count) + 0.5 * rng.standard_normal(count)


def test_size_and_memory_beside_white_noise() -> None:
    found = discrepancies([compared(str(i), noisy(i)) for i in range(6)], SIGNALS, 0)["y"]
    assert found.sd == pytest.approx(SD, rel=0.1)
    assert found.memory == pytest.approx(MEMORY, rel=0.25)
    assert found.pieces == pytest.approx(6 * 30 / (2 * MEMORY), rel=0.25)
    assert not found.held_out and found.runs == tuple("012345")


def test_white_noise_alone_is_no_model_error() -> None:
    found = discrepancies([compared("a", noisy(1, share=0.0))], SIGNALS, 0)["y"]
    assert found.reach() < 0.4 * 1.96 * SIGNALS["y"].sigma
    quiet = discrepancies([compared("a", 0.5 * noisy(1, share=0.0))], SIGNALS, 0)["y"]
    assert quiet.sd == 0.0 and quiet.reach() == 0.0


def test_held_out_runs_count_before_fitted_ones_and_the_predicted_one_not() -> None:
    runs = [
        compared("small", noisy(1, share=0.1)),
        compared("large", noisy(2), "holdout"),
        compared("larger", noisy(3, share=3.0), "holdout"),
    ]
    assert discrepancies(runs, SIGNALS, 0)["y"].runs == ("large", "larger")
    assert discrepancies(runs, SIGNALS, 0, "larger")["y"].runs == ("large",)
    alone = discrepancies(runs[:2], SIGNALS, 0, "large")["y"]
    assert alone.runs == ("small",) and not alone.held_out
    assert discrepancies(runs[:1], SIGNALS, 0, "small")["y"].runs == ("small",)
    assert not discrepancies([], SIGNALS, 0)


@pytest.mark.parametrize("seconds", [0.05, 0.6, 6.0])
def test_the_mean_over_time_is_held_as_often_as_promised(seconds: float) -> None:
    off = Discrepancy(SD, MEMORY, 1e6, ("a",), True)
    rng = np.random.default_rng(3)
    means = [course(rng, 100, seconds / 100).mean() for _ in range(1500)]
    # 95 % of 1500, to 3.5 of its own deviations (0.56 %)
    assert np.mean(np.abs(means) < off.reach(seconds)) == pytest.approx(0.95, abs=0.02)


def of_a_wrong_gauge() -> Band:
    """Two discharges whose gauge is off by a slow wave, the model without; one is fitted, the other predicted."""
    times = np.linspace(0.0, 60.0, 61)
    clean = discharge(times=times)[0]
    wrong = clean + 4e3 * np.sin(times / 4.0)
    data = vessel_data(clean=wrong, times=times)
    other = clean + 4e3 * np.sin(times / 4.0 + 1.0) + 1e3 * np.random.default_rng(9).normal(size=61)
    held = replace(recording(times, {"p": other}, "holdout"), name="held")
    held = replace(held, parameters=dict(data.runs[0].parameters))
    fitted = study.fit(replace(data, runs=(*data.runs, held)))
    return study.predict(fitted, run="held", samples=60).bands["p"]


def test_a_band_holds_the_readings_of_a_run_with_what_the_model_lacks() -> None:
    band = of_a_wrong_gauge()
    off = band.discrepancy
    assert off is not None and off.sd == pytest.approx(4e3 / np.sqrt(2), rel=0.3)
    centre = (band.reading_low + band.reading_high) / 2
    narrow = np.sqrt((band.reading_high - centre) ** 2 - off.reach() ** 2)
    # of 61 readings in a 95 % band, 80 % is five deviations too few
    assert np.mean(np.abs(band.measured - centre) <= narrow) < 0.8
    assert band.coverage > 0.9
    mean = float(np.trapezoid(band.measured, np.linspace(0.0, 60.0, 61))) / 60.0
    assert band.mean_low < mean < band.mean_high
    assert band.mean_high - band.mean_low < 0.7 * np.median(band.reading_high - band.reading_low)
