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


def estimate_holdout_uncertainty(
    holdout: Objective, end: Minimum, spread: float
) -> HoldoutUncertainty:
    """What held-out runs gain when the parameters move within their uncertainty.

    Args:
        holdout: the objective of these runs alone, with the parameters of the fit.
        end: where the fit ended, with the slopes of the fitted runs.
        spread: factor by which colour and size of the residuals widen the parameters' uncertainty.
    """
    residuals = holdout.residuals(end.z)
    if not np.all(np.isfinite(residuals)):
        return HoldoutUncertainty()
    slopes, slopes_of_fit = (
        holdout.jacobian(end.z, residuals)[: holdout.size],
        end.jacobian / spread,
    )
    low, high = holdout.bounds
    room = CRITERIA.fit.at_bound * (high - low)
    free = (
        (end.z > low + room) & (end.z < high - room) & (np.linalg.norm(slopes_of_fit, axis=0) > 0)
    )
    rows = np.vstack([slopes_of_fit[:, free], slopes[:, free]])
    wanted = np.concatenate([np.zeros(len(slopes_of_fit)), -residuals[: holdout.size]])
    step = np.linalg.lstsq(rows, wanted, rcond=None)[0]
    cost_rows = slopes_of_fit[:, free] @ step
    return HoldoutUncertainty(
        _shifts(holdout, slopes[:, free] @ step), float(cost_rows @ cost_rows)
    )


def _shifts(holdout: Objective, shift_rows: Array) -> dict[tuple[str, str], Array]:
    """What the residuals of each series move by."""
    shifts, row = {}, 0
    for (run, name), kept in zip(holdout.series, holdout.kept, strict=True):
        shift = np.zeros(len(kept))
        shift[kept] = shift_rows[row : row + int(kept.sum())]
        shifts[run.name, name] = shift
        row += int(kept.sum())
    return shifts
