"""The measured discharge of a steel vessel (Dutton and Coverdill 1997), from the folder to the verdict."""

from __future__ import annotations

from pathlib import Path

import pytest

from pam_cosim import Diagnosis, study

FOLDER = Path(__file__).parents[2] / "examples" / "tank-discharge"


@pytest.fixture(scope="module")
def found(workers: int | None) -> Diagnosis:
    return study.diagnose(study.read(FOLDER), workers=workers)


def test_base_model_stays_as_far_off_as_others_found(found: Diagnosis) -> None:
    """The polytropic law with discharge coefficient and exponent both fitted: 8.4 kPa, C_d 0.76, n at its bound."""
    assert found.base.comparison.scores["fit"]["p"].rmse == pytest.approx(8410.0, abs=100.0)
    assert found.base.values["orifice.C_d"] == pytest.approx(0.76, abs=0.01)
    assert found.base.parameters["tank.n"].value == pytest.approx(1.4, abs=1e-3)
    assert found.base.parameters["tank.n"].at_bound


def test_energy_balance_is_what_is_missing(found: Diagnosis) -> None:
    assert found.verdict.kind == "identified", found.verdict
    assert found.verdict.families == ("gas_energy",)
    assert max(found.balance, key=lambda b: found.balance[b]) == "energy"


def test_fitted_vessel(found: Diagnosis) -> None:
    """Others: an energy balance with wall heat transfer fits to 2.0 kPa with C_d = 0.842; documented are 0.84."""
    assert found.final.comparison.scores["fit"]["p"].rmse <= 2500.0
    c_d = found.final.parameters["orifice.C_d"]
    assert 0.83 <= c_d.value <= 0.86
    assert c_d.low <= 0.84 <= c_d.high


def test_thermometer_that_was_not_fitted_agrees_better_too(found: Diagnosis) -> None:
    """An error of 80 K falls to some 16 K: the model was right to change."""
    before, after = (f.comparison.scores["fit"]["T"].rmse for f in (found.base, found.final))
    assert before > 70 and after < 20
