"""The smallest error of each signal that data would have shown."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, log, sqrt

import numpy as np

from pam_cosim.criteria import CRITERIA
from pam_cosim.fitting import Fit


@dataclass(frozen=True)
class DetectionLimit:
    """The smallest error of a signal that would have been found, by an effect of one parameter.

    Attributes:
        signal, unit: its name and unit.
        rmse: root mean square of that error [unit]; infinite where there are no more samples than parameters.
        movement: standard deviation of the model's values in the fitted runs [unit].
    """

    signal: str
    unit: str
    rmse: float
    movement: float

    @property
    def is_useful(self) -> bool:
        """Whether an error that matters would have been found."""
        return self.rmse <= CRITERIA.evidence.detection_limit * self.movement


def detection_limits(fit: Fit) -> tuple[DetectionLimit, ...]:
    """The limits of the fitted signals, as independent samples with the noise that the fit leaves have them."""
    residuals, limits = fit.residuals["fit"], []
    for name, signal in fit.comparison.data.signals.items():
        runs = [r for r in fit.comparison.runs if r.run.role == "fit" and r.run.sample_count(name)]
        if not (signal.fitted and runs):
            continue
        values = np.concatenate(
            [r.model[name][np.isfinite(r.run.measurements[name])] for r in runs]
        )
        spare = values.size / residuals.correlation_time - len(fit.parameters)
        required_evidence = CRITERIA.evidence.very_strong + log(max(values.size, 2))
        noise = signal.sigma * sqrt(max(1.0, residuals.chi2_reduced))
        rmse = noise * sqrt(required_evidence / spare) if spare > 0 else inf
        limits.append(DetectionLimit(name, signal.unit, rmse, float(np.std(values))))
    return tuple(limits)
