"""How much the data speak for one model over another."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import NamedTuple

from pam_cosim.comparison import ResidualStatistics
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.model_space import ModelSpace
from pam_cosim.fitting import Fit
from pam_cosim.measurement import ROLES


def _correlated(s: ResidualStatistics) -> bool:
    return s.whiteness_score > (
        CRITERIA.residuals.correlated
        if s.samples >= CRITERIA.residuals.many_samples
        else CRITERIA.residuals.correlated_of_few
    )


def has_structure(s: ResidualStatistics) -> bool:
    """Whether residuals hold more than noise of instruments, which may have any colour and drift.

    Many samples show it by their correlation in time and by its size. Few cannot; there the level against the stated
    noise decides too.
    """
    if not s.samples:
        return False
    if _correlated(s) and s.exceeds(CRITERIA.residuals.drift):
        return True
    few = s.samples < CRITERIA.residuals.many_samples
    return few and s.chi2_reduced > 1 + CRITERIA.residuals.level_of_few * math.sqrt(2 / s.samples)


def leaves_structure(fit: Fit) -> bool:
    """Whether a model leaves structure, in runs that were fitted or in others that no values excuse."""
    return any(map(has_structure, fit.residuals_beyond_uncertainty.values()))


def may_have_structure(s: ResidualStatistics) -> bool:
    """Whether residuals are larger than noise, if ever so slightly, be it a drift of the instruments.

    Or red noise: where nobody stated a level, residuals of any size may be that, and only a better model tells. They
    are correlated, or larger than the noise that was stated: what is quick against the samples looks white.
    """
    if s.samples < CRITERIA.residuals.many_samples:
        return has_structure(s)
    known_variance = min(s.noise_floor, max(1.0, s.white_variance))
    seen = _correlated(s) or s.level_score > CRITERIA.residuals.level_of_few
    return seen and s.chi2_reduced - known_variance > CRITERIA.residuals.slight_excess


class NoiseScale(NamedTuple):
    """Noise variance and samples per independent sample, both as the best model leaves them.

    Where some model leaves no more than instruments may drift by, the noise of each model has the colour that suits it
    best: an effect must say more than that.
    """

    variance: float
    time: float
    coloured: bool = False

    @property
    def divisor(self) -> float:
        """What a sum of squares is divided by to count as evidence."""
        return self.variance * self.time

    @property
    def largest(self) -> float:
        """Mean square that noise may have, drifts of instruments among it."""
        return self.variance * (1 + CRITERIA.residuals.drift)

    def penalty(self, fit: Fit) -> float:
        """What a parameter costs: the logarithm of the effective number of fitted samples."""
        effective = fit.residuals["fit"].samples / self.time
        return math.log(max(effective, CRITERIA.evidence.least_samples))


def noise_scale(fits: Sequence[Fit]) -> NoiseScale:
    """Noise variance and samples per independent sample, both as the best model leaves them.

    Args:
        fits: the base model first.
    """
    best = min((f.residuals["fit"] for f in fits), key=lambda s: s.chi2)
    return NoiseScale(
        max(1.0, best.chi2_reduced), best.correlation_time, any(map(_may_be_drift, fits))
    )


def _may_be_drift(fit: Fit) -> bool:
    """Whether what a model leaves is no more than a drift of instruments; few samples do not tell, nor a rest."""
    enough = fit.residuals["fit"].samples >= CRITERIA.residuals.many_samples
    moving = not any(r.run.is_static for r in fit.comparison.runs)
    statistics_by_series = (s for s in fit.residuals_beyond_uncertainty.values() if s.samples)
    return (
        enough
        and moving
        and not any(s.exceeds(CRITERIA.residuals.drift) for s in statistics_by_series)
    )


def information_criterion(
    fit: Fit,
    scale: NoiseScale,
    effects: Collection[str],
    model_space: ModelSpace,
    candidate: Candidate | None = None,
) -> float:
    """How much the data speak against a model: minus twice the logarithm of its probability, but for a constant.

    The fitted runs by the Bayesian information criterion, which pays for every parameter that the effects brought, and
    for parameters that are not where they are known to be beforehand; the others, which paid for nothing, by what a
    fit of all runs together would leave of them beyond that; and how many sets of so many effects there are.
    """
    return evidence_without_choice(fit, scale, candidate) + model_space.cost(effects)


def evidence_without_choice(fit: Fit, scale: NoiseScale, candidate: Candidate | None) -> float:
    """The information criterion but for how many sets of effects there are.

    An effect pays for every parameter it brings, also for those that have done their work at one end of their range.
    """
    lost = _undetermined_count(candidate) if candidate else 0
    return deviance(fit, scale) + scale.penalty(fit) * (fit.freedom + lost)


def deviance(fit: Fit, scale: NoiseScale) -> float:
    """Minus twice the logarithm of the likelihood of all runs, and what the priors add, but for a constant."""
    if scale.coloured:
        return fit.coloured_deviance(scale.largest)
    tested = fit.residuals_beyond_uncertainty.values()
    return sum(s.chi2 for s in tested if s.samples) / scale.divisor + fit.chi2_priors


def rank(base: Fit, candidates: Sequence[Candidate]) -> list[Candidate]:
    """Candidates with their evidence relative to the base model, best first."""
    if not candidates:
        return []
    scale = noise_scale([base, *(c.fit for c in candidates)])
    start = evidence_without_choice(base, scale, None)
    scored = [
        replace(c, delta_bic=evidence_without_choice(c.fit, scale, c) - start) for c in candidates
    ]
    lowest = min(0.0, *(c.delta_bic for c in scored))
    weights = {c.effects: math.exp(-(c.delta_bic - lowest) / 2) for c in scored}
    total = math.exp(lowest / 2) + sum(weights.values())
    ranked = [replace(c, probability=weights[c.effects] / total) for c in scored]
    ranked.sort(key=lambda c: (c.delta_bic, c.effects))
    return ranked


def _undetermined_count(candidate: Candidate) -> int:
    return sum(not e.determined for e in candidate.effect_parameters.values())


def refuted_by_unfitted_signals(rival: Fit, best: Fit) -> bool:
    """Whether signals that were compared but not fitted refute a model, compared with another model."""
    signals = best.comparison.data.signals
    ratios = [
        score.rmse / other.rmse
        for name, score in rival.comparison.scores["all"].items()
        if not signals[name].fitted and (other := best.comparison.scores["all"][name]).rmse > 0
    ]
    return bool(ratios) and math.prod(ratios) ** (1 / len(ratios)) > CRITERIA.evidence.refuted


def missed_signals(fit: Fit) -> tuple[str, ...]:
    """Signals that were compared but not fitted, and that a model misses by more than their noise."""
    comparison = fit.comparison
    scores = comparison.scores.get("all", {})
    unfitted = {n: s for n, s in scores.items() if not comparison.data.signals[n].fitted}
    return tuple(
        n for n, s in unfitted.items() if s.rmse > CRITERIA.evidence.refuted * s.noise_rmse
    )


def dominant_effect(base: Fit, candidates: Sequence[Candidate]) -> Candidate | None:
    """The effect that takes away nearly all that exceeds the noise, where no other family comes near; else None.

    In the fitted runs and in the others. What is left has structure then, and still the family is beyond doubt: what
    belongs to no family, other families do not imitate that well. Where it is far above the noise, more than a form
    is open.

    Args:
        base: the model without effects, fitted.
        candidates: fitted models; only those with one effect are compared.
    """
    ranked = rank(base, [c for c in candidates if len(c.effects) == 1])
    least_excess: dict[str, float] = {}
    for c in ranked:
        least_excess[c.family] = min(
            least_excess.get(c.family, math.inf), c.fit.residuals["fit"].excess
        )
    family = min(least_excess, key=lambda f: least_excess[f], default="")
    if any(
        excess <= CRITERIA.evidence.rival_ratio * least_excess[family]
        for other, excess in least_excess.items()
        if other != family
    ):
        return None
    candidates_of_family = (c for c in ranked if c.family == family)
    return next((c for c in candidates_of_family if _explains_nearly_all(base, c.fit)), None)


def _explains_nearly_all(base: Fit, fit: Fit) -> bool:
    residuals_by_role = [
        (base.residuals[r], fit.residuals[r]) for r in ROLES if base.residuals[r].samples
    ]
    return all(
        after.excess <= CRITERIA.evidence.beyond_doubt * before.excess
        and after.chi2_reduced <= CRITERIA.residuals.far_above
        for before, after in residuals_by_role
    )
