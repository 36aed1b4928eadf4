"""Models that would fit as well as the answer if nothing were known of their parameters beforehand."""

from __future__ import annotations

from collections.abc import Sequence

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.evidence import NoiseScale, information_criterion
from pam_cosim.diagnosis.judgement.model_space import ModelSpace
from pam_cosim.units import format_quantity


def implausible(
    best: Candidate, others: Sequence[Candidate], scale: NoiseScale, model_space: ModelSpace
) -> tuple[str, ...]:
    """A sentence for each model that only what is known of its parameters beforehand keeps from being a rival.

    Args:
        best: the answer.
        others: models with other families.
        scale: of the evidence.
        model_space: what a choice among effects costs.
    """

    def criterion(c: Candidate) -> float:
        return information_criterion(c.fit, scale, c.effects, model_space, c)

    limit = criterion(best) + CRITERIA.evidence.very_strong
    near = []
    for c in (c for c in others if c.without_priors.values):
        without = criterion(c) - c.fit.chi2_priors - c.without_priors.reduction / scale.divisor
        if without < limit <= criterion(c):
            near.append((without, c.effects, _needed(c)))
    return tuple(sentence for _, _, sentence in sorted(near))


def _needed(c: Candidate) -> str:
    """What a model would need: the parameter that would be farthest from what is known of it."""
    wanted = c.without_priors.values
    priors = {n: prior for n in wanted if (prior := c.fit.parameters[n].prior) is not None}
    name = max(wanted, key=lambda n: abs(priors[n].surprise(wanted[n])))
    unit = c.fit.parameters[name].unit
    low, value, high = (
        format_quantity(v, unit) for v in (priors[name].low, wanted[name], priors[name].high)
    )
    needs = f"{name} would have to be about {value}, where {low} to {high} is usual"
    return f"{' + '.join(c.effects)} would fit as well, but {needs}."
