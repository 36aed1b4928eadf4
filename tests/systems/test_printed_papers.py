"""The examples about the papers, with the examples' own functions: the temperature of a muscle, the area of a valve."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import pytest

from pam_cosim import study
from tests.documentation.pages import absent, unsaid
from tests.systems.test_real_data import script

STORY = "stories.md#The temperature that a paper prints"


@pytest.fixture(scope="module")
def temperature() -> ModuleType:
    return script("gas-temperature")


@pytest.fixture(scope="module")
def calibration() -> ModuleType:
    return script("valve-calibration")


@pytest.fixture(scope="module")
def rig(temperature: ModuleType, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder: Path = tmp_path_factory.mktemp("rig") / "gas-temperature"
    temperature.write_data(folder)
    return folder


@pytest.mark.full
def test_paper_points_to_the_energy_of_its_gas(
    temperature: ModuleType, rig: Path, workers: int | None
) -> None:
    diagnosis = study.diagnose(study.read(rig), workers=workers)
    assert diagnosis.verdict.kind == "identified", diagnosis.verdict
    assert diagnosis.verdict.families == ("gas_energy",)
    before, after = (f.comparison.scores["holdout"] for f in (diagnosis.base, diagnosis.final))
    assert before["p"].rmse > 50e3 and after["p"].rmse < 0.55e3
    assert before["T"].rmse > 8 and after["T"].rmse < 0.33

    assert (
        unsaid(
            STORY,
            f"{diagnosis}\n{study.diagnose(study.read(rig), temperature.FILMS, workers=workers)}",
        )
        == []
    )
    singles = [c for c in diagnosis.candidates if len(c.effects) == 1]
    other = next(c for c in singles if c.family != "gas_energy")
    own = {name: f"{e.value:.4g}" for name, e in diagnosis.final.parameters.items()}
    left = other.fit.comparison.scores["holdout"]["p"].rmse / 1e3
    told = f"C_A comes back as {own['valve.C_A']} and mu_fb as {own['muscle.mu_fb']}. "
    assert (
        absent([told + f"The next best family, {other.family}, leaves {left:.0f} kPa."], STORY)
        == []
    )


@pytest.mark.full
def test_error_falls_rung_by_rung(temperature: ModuleType, rig: Path, tmp_path: Path) -> None:
    """Only the printed wall with the balance of energy reaches the noise; films cannot."""
    fits = [temperature.fitted(rig, rung, tmp_path) for rung in temperature.LADDER]
    errors = [f.comparison.scores["holdout"]["p"].rmse / 1e3 for f in fits]
    assert errors == pytest.approx([59.2, 12.0, 2.48, 0.48], rel=0.05)
    assert fits[2].parameters["muscle.gas.h"].at_bound
    assert (
        absent(
            [temperature.holdout_row(r, f) for r, f in zip(temperature.LADDER, fits, strict=True)],
            STORY,
        )
        == []
    )
    assert fits[3].parameters["valve.C_A"].value == pytest.approx(0.72, abs=1e-3)


def test_regression_gives_62_with_its_pressure_taken_as_absolute(calibration: ModuleType) -> None:
    slope, offset = calibration.regression(calibration.STATED)
    assert slope == pytest.approx(1.80e-6, rel=2.5e-3) and offset == pytest.approx(
        2.61e-7, rel=2.5e-3
    )
    gauge = calibration.regression(calibration.STATED + calibration.P_ATM)
    assert gauge[0] / slope == pytest.approx(0.773, abs=1e-3)
    assert calibration.MEASURED / calibration.printed_area(0.35) == pytest.approx(0.699, abs=1e-3)
    area = gauge[0] * 0.35 - gauge[1]
    assert calibration.MEASURED / area == pytest.approx(0.905, abs=2e-3)
