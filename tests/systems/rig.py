"""Data of the independent rig, short enough for tests that run on every change."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from tests.reference.effects import Effect
from tests.reference.muscle import simulate_muscle
from tests.reference.plan import Run
from tests.reference.rig import TRUTH, Measurement, Noise, write_data_set
from tests.reference.schedule import Phase

DURATION, RATE = 4.0, 50.0  # s, Hz


def _fill(duration: float, current: float = 0.35) -> Phase:
    return Phase(duration, u_in=current)


def _vent(duration: float) -> Phase:
    return Phase(duration, u_out=0.35)


def _hold(duration: float) -> Phase:
    return Phase(duration)


PLAN = (
    Run(2.27, 207e3, (_fill(0.5), _hold(0.4), _fill(0.9, 0.3), _hold(0.4), _vent(0.4), _hold(0.4), _vent(1.0))),
    Run(4.0, 240e3, (_fill(1.2, 0.3), _hold(0.8), _vent(0.5), _hold(0.6), _vent(0.9)), "holdout"),
)
"""One run to fit and one to judge: filling fast and slow, holding at three levels, venting in parts."""


def measure_light(effects: Sequence[Effect] = (), seed: int = 0) -> list[Measurement]:
    """Both runs with the rig's usual noise."""
    times = np.arange(round(DURATION * RATE) + 1) / RATE
    rng = np.random.default_rng([seed, 7])
    sigma = Noise().as_dict()
    measured = []
    for run in PLAN:
        found = simulate_muscle(replace(TRUTH, load=run.load), run.p_supply, run.schedule, times, effects)
        clean = {"p": found.p, "x": found.x, "T": found.temperature}
        noisy = {name: y + sigma[name] * rng.standard_normal(len(y)) for name, y in clean.items()}
        measured.append(Measurement(run, times, noisy))
    return measured


def write_light_data(folder: Path, effects: Sequence[Effect] = (), seed: int = 0) -> Path:
    """A data set of the Isotonic bench."""
    write_data_set(folder, measure_light(effects, seed))
    return folder
