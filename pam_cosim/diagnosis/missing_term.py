"""What can be said of an error that no effect explains."""

from __future__ import annotations

import numpy as np

from pam_cosim.criteria import CRITERIA
from pam_cosim.fitting import Fit


def missing_term(fit: Fit, balance: dict[str, float]) -> dict[str, object]:
    """Describes what a fitted model leaves: in which balance, how large, and what it goes with.

    Returns:
        ``balance``, and for each signal its ``rmse`` [SI], its size in noise standard deviations and the modelled
        output with which the residual correlates most.
    """
    signals: dict[str, object] = {}
    for name, score in fit.comparison.scores["all"].items():
        strongest: tuple[float, str] = (0.0, "")
        runs = [r for r in fit.comparison.runs if r.run.sample_count(name)]
        residual = np.concatenate([r.residual(name) for r in runs])
        kept = np.isfinite(residual)
        for output in fit.comparison.runs[0].model:
            values = np.concatenate([r.model[output] for r in runs])
            if np.ptp(values[kept]) > 0 and np.ptp(residual[kept]) > 0:
                r = float(np.corrcoef(residual[kept], values[kept])[0, 1])
                if abs(r) > abs(strongest[0]):
                    strongest = (r, output)
        signals[name] = {
            "rmse": score.rmse,
            "noise_standard_deviations": score.chi2_reduced**0.5,
            "correlates_with": strongest[1],
            "correlation": strongest[0],
        }
    return {
        "balance": max(sorted(balance), key=lambda b: balance[b]) if balance else None,
        "signals": signals,
        "where": [vars(rule) for rule in fit.comparison.where[: CRITERIA.next_experiment.listed_rules]],
    }
