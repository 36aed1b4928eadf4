"""How far held-out runs may be off because the fitted runs determine the parameters only so well.

A prediction is as uncertain as its parameters. What a model leaves in runs that were not fitted is structure only as
far as no values of the parameters that the fitted runs allow take it away. These are found by going on from the fit
with all runs together, the fitted ones as wide as the colour and the size of what they leave make them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.fitting.levenberg_marquardt import levenberg_marquardt
from pam_cosim.fitting.objective import Objective
from pam_cosim.fitting.options import FitOptions


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
    fitted: Objective, holdout: Objective, z: Array, spread: float, options: FitOptions
) -> HoldoutUncertainty:
    """What held-out runs gain when the parameters move within their uncertainty; nothing where they are met.

    Args:
        fitted: the objective of the fitted runs and of the priors.
        holdout: that of the others alone, with the same parameters, without priors.
        z: where the fit ended.
        spread: factor by which colour and size of the residuals widen the parameters' uncertainty.
        options: of the fit: when the descent ends.
    """
    cost, before = fitted.squares(z), holdout.residuals(z)
    if not np.all(np.isfinite(before)) or before @ before <= holdout.samples:
        return HoldoutUncertainty()

    def squares(z: Array) -> float:
        return holdout.squares(z) + fitted.squares(z) / spread**2

    def triangle(z: Array) -> Array:
        rows = np.vstack([holdout.triangle(z), fitted.triangle(z) / spread])
        return np.asarray(np.linalg.qr(rows, mode="r"))

    end = levenberg_marquardt(
        squares,
        triangle,
        z,
        fitted.bounds,
        options.precision,
        options.evaluations,
        fitted.is_over,
    )
    shifts = (holdout.residuals(end.z) - before)[: holdout.size]
    paid = (fitted.squares(end.z) - cost) / spread**2
    return HoldoutUncertainty(_by_series(holdout, shifts), float(max(paid, 0.0)))


def _by_series(holdout: Objective, shift_rows: Array) -> dict[tuple[str, str], Array]:
    """What the residuals of each series move by."""
    shifts, row = {}, 0
    for (run, name), sample_mask in zip(holdout.series, holdout.kept, strict=True):
        shift = np.zeros(len(sample_mask))
        shift[sample_mask] = shift_rows[row : row + int(sample_mask.sum())]
        shifts[run.name, name] = shift
        row += int(sample_mask.sum())
    return shifts
