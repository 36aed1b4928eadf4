"""Bands of predictions hold what they promise, on data of the independent simulator."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.cli.app import main
from pam_cosim.fitting import Fit
from tests.fitting.models import C_D, TIMES, N, discharge, vessel_data

EARLY = np.linspace(0.0, 12.0, 13)


@pytest.fixture(scope="module")
def fitted() -> Fit:
    """The beginning of a discharge, seen with noise."""
    return study.fit(vessel_data(times=EARLY, sigma=5e3))


def test_samples_agree_with_the_intervals_of_the_fit(fitted: Fit) -> None:
    bands = study.predict(fitted, stop_time=60, samples=400)
    posterior = bands.posterior
    assert posterior.names == ("orifice.C_d", "tank.n")
    for name, column in zip(posterior.names, posterior.samples.T, strict=True):
        estimate, free = fitted.parameters[name], {"orifice.C_d": C_D, "tank.n": N}[name]
        assert free.min <= column.min() and column.max() <= free.max
        if free.min < estimate.low and estimate.high < free.max:
            order = np.argsort(column)
            low, high = np.interp(
                [0.025, 0.975], np.cumsum(posterior.weights[order]), column[order]
            )
            width = estimate.high - estimate.low
            assert (low, high) == pytest.approx((estimate.low, estimate.high), abs=0.2 * width)


def test_the_band_is_narrow_where_it_was_measured_and_wide_beyond(fitted: Fit) -> None:
    band = study.predict(fitted, stop_time=30, interval=1).bands["p"]
    width = band.high - band.low
    assert width[5] < 10e3 and width[20] > 1.3 * width[5]
    assert np.all(band.reading_high - band.reading_low > 2 * 1.9 * 5e3)
    assert np.all(band.low <= band.high)


@pytest.mark.full
def test_the_truth_lies_within_the_band_as_often_as_promised() -> None:
    """Twenty fits to other noise; each predicts what was not measured, at 20 s."""
    truth = discharge()[0][20]
    inside = 0
    for seed in range(20):
        fitted = study.fit(vessel_data(seed=seed, times=EARLY, sigma=5e3))
        band = study.predict(fitted, stop_time=20, interval=1, samples=60).bands["p"]
        inside += bool(band.low[20] <= truth <= band.high[20])
    assert 17 <= inside <= 20  # 19 are expected; fewer than 17 come once in 60 times


def test_the_command(tmp_path: Path, fitted: Fit, capsys: pytest.CaptureFixture[str]) -> None:
    saved = study.save(fitted, tmp_path / "fit.npz")
    files = [tmp_path / name for name in ("p.csv", "p.png", "p.json")]
    words = ["predict", str(saved), "--stop-time", "60 s", "--interval", "1 s", "--samples", "20"]
    assert (
        main([*words, "-o", str(files[0]), "--plot", str(files[1]), "--json", str(files[2])]) == 0
    )
    assert "predicted with 20 samples of 2 parameters" in capsys.readouterr().out
    lines = files[0].read_text().splitlines()
    assert (
        lines[0] == "time [s],p [Pa],p.low [Pa],p.high [Pa],p.reading_low [Pa],p.reading_high [Pa]"
    )
    assert len(lines) == 1 + len(TIMES)
    assert len(json.loads(files[2].read_text())["signals"]["p"]["low"]) == len(TIMES)
    content = json.loads(files[2].read_text())["signals"]["p"]
    assert content["discrepancy"]["runs"] == ["run"]
    assert content["mean_low"] < content["mean"] < content["mean_high"]
    without = ["--no-discrepancy", "--json", str(tmp_path / "without.json")]
    assert main([*words, *without]) == 0
    assert (
        json.loads((tmp_path / "without.json").read_text())["signals"]["p"]["discrepancy"] is None
    )
    assert main(["predict", str(saved), "--set", "tank.V=0 kg"]) == 2
    recorded_run = ["predict", str(saved), "--run", "run", "--samples", "20", "--discrepancy"]
    assert main([*recorded_run, "--json", str(tmp_path / "run.json")]) == 0
    assert "of the readings are within their band" in capsys.readouterr().out
    whole = json.loads((tmp_path / "run.json").read_text())
    assert whole["run"] == "run" and len(whole["time"]) == len(EARLY)
    assert whole["signals"]["p"]["discrepancy"] == content["discrepancy"]
