"""Data that cannot separate families: the diagnosis says so, and which run would; unless neither is the answer."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.measurement import DataSet
from rig.flow import P_ATM
from rig.measurement import TRUTH
from rig.muscle import simulate_muscle
from rig.named import effect_of
from rig.schedule import Phase, Schedule
from rig.tank import Vessel, orifice_port, simulate_vessel
from tests.fitting.models import (
    DIAMETER,
    KNOWN,
    P_START,
    T_START,
    TRUE_C_D,
    TRUE_N,
    VOLUME,
    data_set,
    recording,
)


def _one_hold(seed: int) -> DataSet:
    """A muscle with a stiff bladder is filled in four steps, but only the hold after the last one was recorded.

    At one pressure and one contraction a spring, a slow creep and ends that do not contract all shorten it alike.
    """
    schedule = Schedule.of(
        [phase for _ in range(4) for phase in (Phase(0.36, u_in=0.35), Phase(1.0))]
    )
    times = np.arange(272) / 50
    simulated = simulate_muscle(
        replace(TRUTH, load=2.27), 207e3, schedule, times, [effect_of("elasticity:linear")]
    )
    rng = np.random.default_rng(seed)
    recorded = (times > 5.08) & (times < 5.43)
    measured = {
        "p": np.where(recorded, simulated.p + 500.0 * rng.standard_normal(len(times)), np.nan),
        "x": np.where(recorded, simulated.x + 0.2e-3 * rng.standard_normal(len(times)), np.nan),
    }
    currents = np.array([schedule.at(t) for t in times.tolist()])
    inputs = {
        "u_in": currents[:, 0],
        "u_out": currents[:, 1],
        "p_supply": np.full(len(times), 207e3),
    }
    known = {"load.m": 2.27, "valve.C_A": TRUTH.calibration, "muscle.mu_fb": TRUTH.mu_fb}
    run = replace(
        recording(times, measured, inputs=inputs), interpolation="previous", parameters=known
    )
    return data_set(
        "PneumaticMuscle.Benches.Isotonic", [run], {"p": 500.0, "x": 0.2e-3}, parameters=known
    )


@pytest.mark.full
def test_one_hold_cannot_separate_what_shortens_the_stroke(workers: int | None) -> None:
    diagnosis = study.diagnose(_one_hold(1), workers=workers)
    verdict = diagnosis.verdict
    assert verdict.kind == "ambiguous", verdict
    assert "elasticity" in verdict.families and len(verdict.families) >= 2
    assert len(verdict.families) == len(dict.fromkeys(verdict.families)) == len(verdict.effects)
    assert diagnosis.missing_term is None
    plan = diagnosis.next_experiment
    assert plan is not None
    assert plan.run == "run" and plan.change
    assert set(plan.between) <= set(verdict.families)
    # the run is worth making: it tells the two apart by more than the evidence that counts as very strong
    assert plan.evidence > 10
    best, other = (
        next(c for c in diagnosis.candidates if c.family == f) for f in verdict.families[:2]
    )
    assert abs(best.delta_bic - other.delta_bic) < 10


def _swinging_vessel(seed: int) -> DataSet:
    """A vessel that takes heat from its wall while it empties, beside a machine that makes its gauge swing by 4 kPa.

    From the pressure alone a gauge that bends says the same as the heat, to the noise; what swings, nobody says.
    """
    times = np.linspace(0.0, 20.0, 201)
    vessel = Vessel(VOLUME, TRUE_N, P_START + P_ATM, T_START)
    port = orifice_port(DIAMETER, TRUE_C_D, 0.0)
    simulated = simulate_vessel(
        vessel, port, times, P_START, effects=[effect_of("gas_energy:film:h=12")]
    )
    swing = 4e3 * np.sin(2 * np.pi * times * 9 / 20)
    p = simulated.p + swing + 1e3 * np.random.default_rng(seed).standard_normal(len(times))
    known = {**KNOWN, "orifice.C_d": TRUE_C_D, "tank.n": TRUE_N}
    run = replace(recording(times, {"p": p}), parameters=known)
    return data_set("PneumaticMuscle.Benches.VesselOrifice", [run], {"p": 1e3}, parameters=known)


@pytest.mark.full
def test_a_gauge_that_nobody_has_is_no_rival_and_what_swings_is_unknown(
    workers: int | None,
) -> None:
    diagnosis = study.diagnose(_swinging_vessel(3), workers=workers, explain=False)
    verdict = diagnosis.verdict
    assert (verdict.kind, verdict.families, verdict.effects) == (
        "unknown",
        ("gas_energy",),
        ("EnergyGas",),
    ), verdict
    assert "what remains has structure" in verdict.reason
    (sentence,) = verdict.implausible
    assert (
        "FlexibleGauge would fit as well, but manometer.gain" in sentence
    )  # to the data alone both are alike
    assert diagnosis.next_experiment is None  # it would decide between two that are wrong
    assert diagnosis.missing_term is not None
