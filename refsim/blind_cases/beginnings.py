"""Recordings that begin in the middle of motion: when the rig is neither at rest nor in a steady state.

The run is simulated from rest; what comes before the first sample that is recorded is in no file.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from blind_cases.setups import Setup
from rig.integrate import Array
from rig.trial import Trial

IN_THE_MIDDLE = ("stated", "unstated")
"""Whether the data set says so (`start = "estimated"`) or leaves it to who reads it."""
STARTS = ("rest", *IN_THE_MIDDLE)
EARLIEST, LATEST = 0.1, 0.6  # of a run's duration, between which it may begin
MOVING = 0.4  # of the run's usual quick rate of change: what counts as motion there
_QUICK = 90.0  # percentile of the rates of change that is usual for quick motion


def begun(setup: Setup, rng: np.random.Generator) -> Setup:
    """The same with runs that begin where their first signal moves, without what is hidden."""
    base = setup.simulate()
    name = setup.signals[0]
    plan = [
        replace(trial, begin=_place(trial, run[name], rng))
        for trial, run in zip(setup.plan, base, strict=True)
    ]
    return replace(setup, plan=tuple(plan))


def rates(trial: Trial, y: Array) -> Array:
    """How quickly a signal changes at each sample, by what is usual for quick motion in its run.

    That is its 90th percentile; in a run that rests for most of the time, what takes it once through its range.
    """
    size = np.abs(np.gradient(y, 1 / trial.rate))
    once = float(np.ptp(y)) * trial.rate / trial.samples
    return np.asarray(size / max(float(np.percentile(size, _QUICK)), once, 1e-12))


def _place(trial: Trial, y: Array, rng: np.random.Generator) -> int:
    """A sample in motion; where the run has none that may be the first, the quickest."""
    first, last = int(EARLIEST * trial.samples) + 1, int(LATEST * trial.samples)
    quick = rates(trial, y)[first:last]
    moving = np.flatnonzero(quick >= MOVING)
    return first + int(rng.choice(moving) if len(moving) else np.argmax(quick))
