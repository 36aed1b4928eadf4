"""What can be said of an error that no effect explains."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pam_cosim.comparison import Rule
from pam_cosim.fitting import Fit

_MOST_RULES = 5  # of the error regions, as many as are read


@dataclass(frozen=True)
class LeftInSignal:
    """What a fitted model leaves in one signal.

    Attributes:
        rmse: [SI]; ``noise_standard_deviations`` the same in those.
        correlates_with: the modelled output with which the residual correlates most, and how much (``correlation``).
    """

    rmse: float
    noise_standard_deviations: float
    correlates_with: str
    correlation: float


@dataclass(frozen=True)
class MissingTerm:
    """An error that no effect explains.

    Attributes:
        balance: whose effects come closest; None where none explains anything.
        signals: what is left in each.
        where: the rules that hold most of it.
    """

    balance: str | None
    signals: dict[str, LeftInSignal]
    where: tuple[Rule, ...]


def missing_term(fit: Fit, balance: dict[str, float]) -> MissingTerm:
    """Describes what a fitted model leaves: in which balance, how large, and what it goes with."""
    comparison = fit.comparison
    signals = {}
    for name, score in comparison.scores["all"].items():
        runs = [r for r in comparison.runs if r.run.sample_count(name)]
        residual = np.concatenate([r.residual(name) for r in runs])
        is_measured = np.isfinite(residual)
        output, correlation = "", 0.0
        for other in comparison.runs[0].model:
            values = np.concatenate([r.model[other] for r in runs])[is_measured]
            if np.ptp(values) > 0 and np.ptp(residual[is_measured]) > 0:
                r = float(np.corrcoef(residual[is_measured], values)[0, 1])
                if abs(r) > abs(correlation):
                    output, correlation = other, r
        signals[name] = LeftInSignal(score.rmse, score.chi2_reduced**0.5, output, correlation)
    return MissingTerm(
        max(sorted(balance), key=lambda b: balance[b], default=None),
        signals,
        tuple(comparison.where[:_MOST_RULES]),
    )
