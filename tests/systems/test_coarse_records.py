"""Rounding with little noise and long holds: a reading stands still for seconds, off by up to half a step."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.measurement import DataSet, complete_noise
from rig.effect import Effect
from rig.instruments import Quantisation, readings
from rig.measurement import TRUTH, Measurement, Noise, write_data_set
from rig.muscle import simulate_muscle
from rig.named import effect_of
from rig.plan import Run
from rig.schedule import Phase

QUIET = Noise(p=150.0, x=8e-6, T=0.05)
STEPS = {"p": 2e3, "x": 1e-4, "T": 0.5}  # Pa, m, K: ten times the noise and more
DURATION, RATE = 24.0, 50.0  # s, Hz


def _holds(seed: int) -> tuple[Phase, ...]:
    """Three levels on the way up and down, each held for seconds; commands step where samples are taken."""
    rng = np.random.default_rng(seed)
    up = [(Phase(float(n) / RATE, u_in=0.32), Phase(3.5)) for n in rng.integers(12, 30, 3)]
    down = [(Phase(float(n) / RATE, u_out=0.33), Phase(3.0)) for n in rng.integers(12, 25, 3)]
    return tuple(phase for pair in up + down for phase in pair)


def _measured(folder: Path, effects: Sequence[Effect], stated: bool, seed: int) -> DataSet:
    rng, times, fine = (
        np.random.default_rng(seed),
        np.arange(int(DURATION * RATE)) / RATE,
        RATE * 10,
    )
    dense = np.arange(int(DURATION * fine) + 1) / fine
    faults, made = [Quantisation(name, step) for name, step in STEPS.items()], []
    for load, role in ((2.27, "fit"), (4.0, "fit"), (3.0, "holdout")):
        run = Run(load, 220e3, _holds(seed + len(made)), role)
        simulated = simulate_muscle(
            replace(TRUTH, load=load), run.p_supply, run.schedule, dense, effects
        )
        clean = {"p": simulated.p, "x": simulated.x, "T": simulated.temperature}
        made.append(
            Measurement(run, times, readings(faults, dense, clean, times, QUIET.as_dict(), rng))
        )
    write_data_set(folder, made, QUIET, step_rows=True)
    data = study.read(folder)
    if stated:
        return data
    blind = {name: replace(signal.as_stated(), sigma=None) for name, signal in data.signals.items()}
    return replace(data, signals=complete_noise(blind, data.runs))


@pytest.mark.full
@pytest.mark.parametrize("stated", [True, False], ids=["stated", "estimated"])
@pytest.mark.parametrize("hidden", [[], ["elasticity:linear"]], ids=["nothing", "elasticity"])
def test_a_rounded_hold_is_no_physics_and_hides_none(
    tmp_path: Path, hidden: list[str], stated: bool, workers: int | None
) -> None:
    data = _measured(tmp_path / "data", [effect_of(name) for name in hidden], stated, seed=3)
    diagnosis = study.diagnose(data, explain=False, workers=workers)
    assert list(diagnosis.verdict.families) == [name.split(":")[0] for name in hidden]
    assert diagnosis.verdict.kind == ("identified" if hidden else "none_missing")
    assert len(diagnosis.data.steps()) == 3
    assert diagnosis.final.residuals["holdout"].chi2_reduced < 1.2
