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
from pam_cosim.fitting import base_parameters
from pam_cosim.fitting.objective import Objective
from pam_cosim.fmu import build_model
from pam_cosim.measurement import DataSet, Signal
from pam_cosim.simulation import Simulator
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


@pytest.mark.full
def test_without_the_statement_the_scatter_is_left(data: Callable[[str], DataSet]) -> None:
    assert pam.fit(data("")).comparison.scores["fit"]["p"].chi2_reduced > 10.0


@pytest.mark.full
def test_slopes_are_those_of_the_residuals(data: Callable[[str], DataSet]) -> None:
    growing = data('sigma_of_reading = "2 %"\n')
    with Simulator(
        build_model("Isotonic", sensitivities=["valve.C_A", "muscle.mu_fb"], brief=True)
    ) as simulator:
        free = base_parameters(growing, simulator.interface)
        objective = Objective(simulator, growing, growing.fit_runs, free, tolerance=1e-9)
        z = np.array([one.to_z(one.start) for one in free])
        exact = objective.jacobian(z, objective.residuals(z))
        for i in range(len(z)):
            step = np.zeros(len(z))
            step[i] = 1e-4 * abs(z[i])
            difference = (objective.residuals(z + step) - objective.residuals(z - step)) / (
                2.0 * step[i]
            )
            np.testing.assert_allclose(
                exact[:, i], difference, atol=2e-3 * np.abs(exact[:, i]).max()
            )


@pytest.mark.full
def test_the_statement_is_kept_when_a_data_set_is_written(
    data: Callable[[str], DataSet], tmp_path: Path
) -> None:
    growing = data(f"sigma_of_reading = {GROWTH}\n")
    from pam_cosim.measurement import write_data_set as write

    copy = write(tmp_path / "copy", growing, pam.describe(growing.model))
    assert (copy.signals["p"].sigma_at_zero, copy.signals["p"].sigma_of_reading) == (
        AT_ZERO,
        GROWTH,
    )


def test_repeated_runs_that_differ_more_take_its_place() -> None:
    from pam_cosim.measurement.repeatability import with_repeatability

    signal = Signal(
        "p", "Pa", 600.0, repeatability=900.0, sigma_of_reading=0.02, sigma_at_zero=500.0
    )
    raised = with_repeatability({"p": signal}, [])["p"]
    assert raised.sigma_at(1e6) == 900.0


def test_weights_of_single_readings() -> None:
    signal = Signal("p", "Pa", 1.0, sigma_of_reading=0.1, sigma_at_zero=3.0)
    reading = np.array([0.0, 40.0])
    np.testing.assert_allclose(
        standardized_residuals(np.array([3.0, 10.0]), signal, reading), [1.0, 2.0]
    )
    np.testing.assert_allclose(slope(np.array([3.0, 10.0]), signal, reading), [1 / 3, 1 / 5])


@pytest.mark.full
@pytest.mark.parametrize(
    ("statement", "problem"),
    [
        ("sigma_of_reading = 1.5\n", "sigma_of_reading of p is a share of the reading, below 1"),
        ("sigma_of_reading = -0.1\n", "sigma_of_reading of p must be greater than zero"),
        ('sigma_of_reading = "2 kPa"\n', "sigma_of_reading of p"),
    ],
)
def test_what_is_no_share_is_refused(
    data: Callable[[str], DataSet], statement: str, problem: str
) -> None:
    with pytest.raises(InputError, match=problem):
        data(statement)


def test_the_noise_at_zero_is_needed(tmp_path: Path) -> None:
    file = _folder(tmp_path / "data", f"sigma_of_reading = {GROWTH}\n") / "experiment.toml"
    text = file.read_text()
    start = text.index("[signals.p]")
    own = "\n".join(line for line in text[start:].splitlines() if not line.startswith("sigma ="))
    file.write_text(text[:start] + own)
    with pytest.raises(InputError, match="needs sigma, the noise where the reading is zero"):
        pam.read(file.parent)


@pytest.mark.full
def test_nothing_is_missing_where_only_the_noise_grows(data: Callable[[str], DataSet]) -> None:
    found = pam.diagnose(data(f"sigma_of_reading = {GROWTH}\n"), workers=0)
    assert found.verdict.kind == "none_missing"
