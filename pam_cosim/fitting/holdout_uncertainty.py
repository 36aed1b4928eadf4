"""How far held-out runs may be off because the fitted runs determine the parameters only so well.

A prediction is as uncertain as its parameters. What a model leaves in runs that were not fitted is structure only as
far as no values of the parameters that the fitted runs allow take it away: to first order a linear least squares
problem, in which the fitted runs say what a change costs. That is what a fit of all runs together would leave.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.fitting.levenberg_marquardt import Minimum
from pam_cosim.fitting.objective import Objective


@dataclass(frozen=True)
class HoldoutUncertainty:
    """What held-out runs gain when the parameters move as the fitted ones allow.

    Attributes:
        shifts: (n,) what is added to the weighted residuals, by run and signal; zero where a sample is missing.
        cost: what that costs in the fitted runs, in variances of the noise.
    """

    shifts: Mapping[tuple[str, str], Array] = field(default_factory=dict)
    cost: float = 0.0


def estimate_holdout_uncertainty(held: Objective, end: Minimum, spread: float) -> HoldoutUncertainty:
    """What held-out runs gain when the parameters move within their uncertainty.

    Args:
        held: the objective of these runs alone, with the parameters of the fit.
        end: where the fit ended, with the slopes of the fitted runs.
        spread: factor by which colour and size of the residuals widen the parameters' uncertainty.
    """
    residuals = held.residuals(end.z)
    if not np.all(np.isfinite(residuals)):
        return HoldoutUncertainty()
    slopes, known = held.jacobian(end.z, residuals)[: held.size], end.jacobian / spread
    low, high = held.bounds
    room = CRITERIA.fit.at_bound * (high - low)
    free = (end.z > low + room) & (end.z < high - room) & (np.linalg.norm(known, axis=0) > 0)
    rows = np.vstack([known[:, free], slopes[:, free]])
    wanted = np.concatenate([np.zeros(len(known)), -residuals[: held.size]])
    step = np.linalg.lstsq(rows, wanted, rcond=None)[0]
    paid = known[:, free] @ step
    return HoldoutUncertainty(_shifts(held, slopes[:, free] @ step), float(paid @ paid))


def _shifts(held: Objective, moved: Array) -> dict[tuple[str, str], Array]:
    """What the residuals of each series move by."""
    shifts, row = {}, 0
    for (run, name), kept in zip(held.series, held.kept, strict=True):
        shift = np.zeros(len(kept))
        shift[kept] = moved[row : row + int(kept.sum())]
        shifts[run.name, name] = shift
        row += int(kept.sum())
    return shifts
