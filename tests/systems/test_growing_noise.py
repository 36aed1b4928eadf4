"""Noise that grows with the reading: every sample counts by its own, and what scatters is not taken for physics."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.comparison import standardized_residuals
from pam_cosim.comparison.rounding import slope
from pam_cosim.errors import InputError
from pam_cosim.measurement import DataSet, Signal
from rig.measurement import measure, simulate_plan, write_data_set
from rig.plan import default_plan

GROWTH = 0.02  # of the reading
AT_ZERO = 500.0  # Pa


def _folder(path: Path, statement: str) -> Path:
    """Runs of the independent rig, whose pressure gauge scatters by 2 % of the reading besides."""
    plan = (default_plan()[0], default_plan()[2], default_plan()[4])
    rng = np.random.default_rng(7)
    measured = []
    for noisy, clean in zip(measure(plan, seed=3), simulate_plan(plan), strict=True):
        p = clean.signals["p"]
        scatter = GROWTH * p * rng.standard_normal(len(p))
        measured.append(
            replace(noisy, signals={**noisy.signals, "p": noisy.signals["p"] + scatter})
        )
    write_data_set(path, measured)
    file = path / "experiment.toml"
    head, signals, rest = file.read_text().partition("[signals.p]\n")
    file.write_text(f"{head}{signals}{statement}{rest}")
    return path


@pytest.fixture
def data(tmp_path: Path) -> Callable[[str], DataSet]:
    return lambda statement: pam.read(_folder(tmp_path / "data", statement))


@pytest.mark.full
def test_each_sample_counts_by_its_own_noise(data: Callable[[str], DataSet]) -> None:
    growing = data(f"sigma_of_reading = {GROWTH}\n")
    signal = growing.signals["p"]
    readings = np.concatenate([run.measurements["p"] for run in growing.runs])
    assert signal.sigma == pytest.approx(np.sqrt(AT_ZERO**2 + GROWTH**2 * np.mean(readings**2)))
    np.testing.assert_allclose(
        signal.sigma_at(np.array([0.0, 2e5])), [AT_ZERO, np.hypot(AT_ZERO, 4000.0)]
    )
    assert "0.5 kPa and 2 % of the reading" in signal.source
    fitted = pam.fit(growing)
    assert fitted.comparison.chi2_reduced("fit") == pytest.approx(1.0, abs=0.06)
    assert fitted.comparison.chi2_reduced("holdout") == pytest.approx(1.0, abs=0.06)


def test_weights_of_single_readings() -> None:
    signal = Signal("p", "Pa", 1.0, sigma_of_reading=0.1, sigma_at_zero=3.0)
    reading = np.array([0.0, 40.0])
    np.testing.assert_allclose(
        standardized_residuals(np.array([3.0, 10.0]), signal, reading), [1.0, 2.0]
    )
    np.testing.assert_allclose(slope(np.array([3.0, 10.0]), signal, reading), [1 / 3, 1 / 5])


def test_the_noise_at_zero_is_needed(tmp_path: Path) -> None:
    file = _folder(tmp_path / "data", f"sigma_of_reading = {GROWTH}\n") / "experiment.toml"
    text = file.read_text()
    start = text.index("[signals.p]")
    own = "\n".join(line for line in text[start:].splitlines() if not line.startswith("sigma ="))
    file.write_text(text[:start] + own)
    with pytest.raises(InputError, match="needs sigma, the noise where the reading is zero"):
        pam.read(file.parent)
