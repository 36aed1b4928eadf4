"""Data that cannot separate families: the diagnosis says so, and which run would; unless neither is the answer."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.measurement import DataSet
from rig.measurement import TRUTH
from rig.muscle import simulate_muscle
from rig.named import effect_of
from rig.schedule import Phase, Schedule
from tests.fitting.models import (
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
