"""The run that shows best what an effect does."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pam_cosim.comparison import RunComparison
from pam_cosim.measurement import Signal
from pam_cosim.reporting.figures.layer import Layer


def most_telling(
    layers: Sequence[Layer], signals: Sequence[Signal]
) -> tuple[RunComparison, Signal] | None:
    """The holdout run (a fitted one where there is none) and signal in which the last layer gains most on the first.

    The gain is the fall of the mean square error in noise variances; without a second layer, that error itself.
    """
    earliest, latest = layers[0], layers[-1]
    signals = [s for s in signals if s.fitted] or list(signals)
    runs = [r for r in latest.comparison.runs if r.run.role == "holdout"] or list(
        latest.comparison.runs
    )
    gains: list[tuple[float, RunComparison, Signal]] = []
    for run in runs:
        before = earliest.run(run.run.name)
        for signal in signals:
            if before is not None and run.run.sample_count(signal.name):
                after = _mean_square(run, signal) if latest is not earliest else 0.0
                gains.append((_mean_square(before, signal) - after, run, signal))
    return max(gains, key=lambda f: f[0])[1:] if gains else None


def _mean_square(run: RunComparison, signal: Signal) -> float:
    return float(np.nanmean(run.residual(signal.name) ** 2)) / signal.sigma**2
