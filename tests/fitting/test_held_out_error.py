"""What held-out runs leave is judged by what the fitted runs could know."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pam_cosim.fitting import Fit, FitOptions, fit
from pam_cosim.measurement import DataSet
from pam_cosim.simulation import Simulator
from tests.fitting.models import TRUE_C_D, TRUE_N, discharge, vessel_data

SIGMA = 200.0


def _both(short: float, c_d: float) -> DataSet:
    """A run that ends early, to fit, and a whole one of an orifice with some coefficient, held out; white noise."""
    whole = vessel_data(seed=1, sigma=SIGMA, clean=discharge(c_d)[0])
    times = np.linspace(0.0, short, 13)
    early = vessel_data(seed=2, sigma=SIGMA, clean=discharge(times=times)[0], times=times)
    held = replace(whole.runs[0], name="whole", role="holdout")
    return replace(early, runs=(early.runs[0], held))


@pytest.fixture
def fitted(bench: Callable[[str], Path]) -> Callable[[DataSet], Fit]:
    def run(data: DataSet) -> Fit:
        with Simulator(bench("VesselOrifice")) as simulator:
            return fit(simulator, data, options=FitOptions(holdout_uncertainty=True))

    return run


def test_an_error_within_the_uncertainty_of_the_parameters_is_none(
    fitted: Callable[[DataSet], Fit],
) -> None:
    result = fitted(_both(5.0, TRUE_C_D))
    raw, tested = result.residuals["holdout"], result.residuals_beyond_uncertainty["holdout"]
    assert abs(result.parameters["tank.n"].value - TRUE_N) > 0.002  # 5 s tell the exponent badly
    assert raw.chi2_reduced > 2.0
    assert tested.chi2_reduced < 1.5 and result.holdout_uncertainty.cost < 9.0
    assert result.residuals_beyond_uncertainty["fit"] == result.residuals["fit"]


@pytest.mark.parametrize("short", [1.0, 3.0])
def test_what_is_left_is_what_a_fit_of_all_runs_leaves(
    fitted: Callable[[DataSet], Fit], short: float
) -> None:
    """Also where slopes do not reach so far, or a parameter of the fit ended at a bound, as that of 1 s did."""
    data = _both(short, TRUE_C_D)
    result = fitted(data)
    together = fitted(replace(data, runs=tuple(replace(r, role="fit") for r in data.runs)))
    left = sum(s.chi2 for s in result.residuals_beyond_uncertainty.values())
    assert result.residuals["holdout"].chi2_reduced > 10.0
    assert left == pytest.approx(together.residuals["fit"].chi2, rel=1e-3)


def test_an_error_that_the_fitted_run_does_not_allow_stays(
    fitted: Callable[[DataSet], Fit],
) -> None:
    result = fitted(_both(60.0, 0.93 * TRUE_C_D))
    raw, tested = result.residuals["holdout"], result.residuals_beyond_uncertainty["holdout"]
    assert raw.chi2_reduced > 5.0
    assert tested.chi2_reduced > 3.0
