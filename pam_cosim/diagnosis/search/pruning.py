"""Coefficients that a fit does not need are held at zero, so that they do not bend where nobody measured."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.evidence import deviance, noise_scale
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting import Estimate, Fit, FitOptions, Free, fit
from pam_cosim.measurement import DataSet
from pam_cosim.simulation import Simulator


def pruned(
    simulator: Simulator,
    data: DataSet,
    free: Sequence[Free],
    names: Sequence[str],
    full: Fit,
    precision: float,
) -> Fit:
    """The fit without those of its coefficients whose interval holds zero and that the evidence does not miss.

    One after another, the least certain first; backward elimination by the Bayesian information criterion of all runs:
    a held-out run may need what the fitted ones do not. What is held stays among the parameters, as zero and not
    determined.

    Args:
        simulator: the model.
        data: the measurement.
        free: all parameters that were fitted.
        names: of those that may be held.
        full: the fit with all of them.
        precision: at which a descent ends.
    """
    if full.residuals["fit"].exceeds(CRITERIA.search.pruning_excess):
        return full
    scale = noise_scale([full])
    few = CRITERIA.search.evaluations
    options = FitOptions(
        evaluations=few, screened_starts=0, precision=precision, holdout_uncertainty=True
    )
    held: dict[str, Estimate] = {}
    needed: set[str] = set()
    best = full
    while name := _least_certain(best, [n for n in names if n not in needed and n not in held]):
        moved = [
            replace(f, start=best.values[f.name])
            for f in free
            if f.name != name and f.name not in held
        ]
        zeros = dict.fromkeys([*held, name], 0.0)
        try:
            less = fit(simulator, data, moved, fixed=zeros, options=options)
        except SimulationFailure:
            needed.add(name)
            continue
        if deviance(less, scale) - deviance(best, scale) > scale.penalty(full):
            needed.add(name)
            continue
        held[name] = replace(
            best.parameters[name], value=0.0, at_bound=False, determined=False, held=True
        )
        best = less
    return replace(
        best,
        parameters={f.name: (best.parameters | held)[f.name] for f in free},
        correlation=np.zeros((0, 0))
        if held
        else best.correlation,  # nobody knows it of all of them
    )


def _least_certain(fitted: Fit, names: Sequence[str]) -> str:
    """The coefficient that is least distinct from zero, if its interval holds zero; else nothing."""
    uncertain = [
        (n, e) for n in names if (e := fitted.parameters[n]).low <= 0 <= e.high and e.high > e.low
    ]
    return min((abs(e.value) / (e.high - e.low), n) for n, e in uncertain)[1] if uncertain else ""
