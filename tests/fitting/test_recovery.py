"""Parameters of the independent simulator are found again, and the intervals are as wide as they should be."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.fitting import fit
from pam_cosim.fitting.free import base_parameters
from pam_cosim.measurement import FreeParameter, read_data_set
from pam_cosim.simulation import Simulator
from rig.measurement import TRUTH
from rig.short import write_light_data
from tests.fitting.models import C_D, TRUE_C_D, TRUE_N, N, discharge, vessel_data

TRUE = {"orifice.C_d": TRUE_C_D, "tank.n": TRUE_N}
Bench = Callable[[str], Path]


@pytest.fixture
def vessel(bench: Bench):  # type: ignore[no-untyped-def]
    with Simulator(bench("VesselOrifice")) as simulator:
        yield simulator


def test_exact_data_give_the_exact_parameters(vessel: Simulator) -> None:
    """Two independent solutions of the same equations agree to the digits of their solvers."""
    result = fit(vessel, vessel_data(seed=None))
    assert result.values == pytest.approx(TRUE, rel=2e-4)
    assert result.comparison.scores["fit"]["p"].rmse < 50.0


def test_intervals_hold_the_truth_as_often_as_they_say(vessel: Simulator) -> None:
    """95 % intervals over 40 seeds: 33 or fewer hits of 40 have a probability of 0.3 %.

    The width is right on both sides: estimates scatter as the intervals say (standard error of that ratio: 11 %).
    """
    clean = discharge()[0]
    fits = [fit(vessel, vessel_data(seed, clean=clean)) for seed in range(40)]
    for name, true in TRUE.items():
        estimates = [f.parameters[name] for f in fits]
        hits = sum(e.low <= true <= e.high for e in estimates)
        assert hits >= 34, (name, hits)
        scatter = np.std([e.value for e in estimates], ddof=1)
        stated = np.mean([(e.high - e.low) / 2 / 1.96 for e in estimates])
        assert 0.7 < scatter / stated < 1.35, (name, scatter / stated)
        assert abs(np.mean([e.value for e in estimates]) - true) < 4 * scatter / np.sqrt(40)


def test_muscle(bench: Bench, tmp_path: Path) -> None:
    """Valve calibration and bladder friction of the reference rig's muscle from three noisy signals."""
    write_light_data(tmp_path / "d", seed=3)
    with Simulator(bench("Isotonic")) as simulator:
        result = fit(simulator, read_data_set(tmp_path / "d", lambda _: simulator.interface))
    for name, true in (("valve.C_A", TRUTH.calibration), ("muscle.mu_fb", TRUTH.mu_fb)):
        e = result.parameters[name]
        assert e.low <= true <= e.high, (name, str(e))
        assert (e.high - e.low) / true < 0.02
    assert 0.85 < result.residuals["fit"].chi2_reduced < 1.15
    assert 0.85 < result.residuals["holdout"].chi2_reduced < 1.15
    assert result.freedom == 2


def test_noise_twice_as_large_as_stated_widens_the_interval(vessel: Simulator) -> None:
    honest = fit(vessel, vessel_data(1, sigma=1000.0))
    loud = vessel_data(1, sigma=2000.0)
    stated = replace(loud, signals={"p": replace(loud.signals["p"], sigma=1000.0)})
    told, untold = fit(vessel, loud), fit(vessel, stated)
    for name in TRUE:
        width = [f.parameters[name].high - f.parameters[name].low for f in (honest, told, untold)]
        assert width[1] == pytest.approx(2 * width[0], rel=0.1)
        assert width[2] == pytest.approx(width[1], rel=0.2)
    assert untold.comparison.chi2_reduced("fit") == pytest.approx(4.0, rel=0.4)


def test_correlated_errors_widen_the_interval(vessel: Simulator) -> None:
    """The same power in noise that drifts says less than white noise."""
    clean = discharge()[0]
    rng = np.random.default_rng(5)
    drift = np.zeros(len(clean))
    for i in range(1, len(drift)):
        drift[i] = 0.9 * drift[i - 1] + np.sqrt(1 - 0.81) * 1000.0 * rng.standard_normal()
    white, red = fit(vessel, vessel_data(5)), fit(vessel, vessel_data(None, clean=clean + drift))
    for name in TRUE:
        a, b = (f.parameters[name].high - f.parameters[name].low for f in (white, red))
        assert b > 1.5 * a


def test_parameter_at_a_bound_is_reported(vessel: Simulator) -> None:
    result = fit(vessel, vessel_data(fit=(FreeParameter("orifice.C_d", 0.5, 0.8, 0.7, "1"), N)))
    estimate = result.parameters["orifice.C_d"]
    assert estimate.value == pytest.approx(0.8, abs=1e-6)
    assert estimate.at_bound and estimate.high == pytest.approx(0.8)
    assert "at its bound" in str(estimate)
    inside = fit(vessel, vessel_data()).parameters["orifice.C_d"]
    assert not inside.at_bound and "bound" not in str(inside)


def test_parameter_without_a_say_is_not_determined_and_not_counted(tmp_path: Path) -> None:
    """With gas that keeps an energy balance the polytropic exponent has no effect any more."""
    study.add(["EnergyGas"], "VesselOrifice", tmp_path / "Warm.mo")
    data = vessel_data(fit=(C_D, N, FreeParameter("tank.gas.h", 0.5, 100.0, 10.0, "W/(m2.K)")))
    with Simulator(study.build(str(tmp_path / "Warm.mo"))) as simulator:
        result = fit(simulator, data)
    dead = result.parameters["tank.n"]
    assert not dead.determined
    assert (dead.low, dead.high) == pytest.approx((1.0, 1.4))
    assert "not determined by these data" in str(dead)
    assert result.freedom == 2
    assert result.parameters["orifice.C_d"].determined


def test_two_parameters_that_only_act_as_a_product_are_not_determined(vessel: Simulator) -> None:
    """The flow knows C_d d^2 alone: two confident numbers would be a lie."""
    hole = FreeParameter("orifice.d", 2e-3, 3.4e-3, 2.6e-3, "m")
    data = vessel_data(fit=(C_D, hole))
    free_hole = [
        replace(r, parameters={k: v for k, v in r.parameters.items() if k != "orifice.d"})
        for r in data.runs
    ]
    result = fit(vessel, replace(data, runs=tuple(free_hole)), fixed={"tank.n": TRUE_N})
    assert not any(e.determined for e in result.parameters.values())
    area = result.values["orifice.C_d"] * result.values["orifice.d"] ** 2
    assert area == pytest.approx(TRUE_C_D * 2.71e-3**2, rel=0.01)


@pytest.mark.parametrize("start", [0.1, 5.0])
def test_start_outside_the_bounds_begins_at_the_bound(vessel: Simulator, start: float) -> None:
    data = vessel_data(fit=(FreeParameter("orifice.C_d", 0.5, 1.1, start, "1"), N))
    (first, _) = base_parameters(data, vessel.interface)
    assert first.start in (0.5, 1.1)
    result = fit(vessel, data, starts=[{"orifice.C_d": start * 10, "tank.n": -3.0}])
    assert result.values == pytest.approx(TRUE, rel=0.02)
