"""Models that would fit as well as the answer if nothing were known of their parameters beforehand."""

from __future__ import annotations

from collections.abc import Sequence

from pam_cosim.diagnosis.candidate import Candidate
from pam_cosim.diagnosis.evidence import Scale, evidence
from pam_cosim.diagnosis.model_space import ModelSpace
from pam_cosim.units import format_quantity


def implausible(candidates: Sequence[Candidate], at: Scale, choice: ModelSpace, limit: float) -> tuple[str, ...]:
    """A sentence for each model that only what is known of its parameters beforehand keeps from being a rival.

    Args:
        candidates: of other families than the answer.
        at: the scale of the evidence.
        choice: what a choice among effects costs.
        limit: the evidence against a rival, at most.
    """
    hoped = [(_hoped(c, at, choice), c) for c in candidates if c.without_priors.values]
    near = [(hope, c) for hope, c in hoped if hope < limit <= evidence(c.fit, at, c.effects, choice, c)]
    return tuple(_needed(c) for _, c in sorted(near, key=lambda entry: (entry[0], entry[1].effects)))


def _hoped(c: Candidate, at: Scale, choice: ModelSpace) -> float:
    """The evidence against a model without its priors."""
    return evidence(c.fit, at, c.effects, choice, c) - c.fit.chi2_priors - c.without_priors.reduction / at.divisor


def _needed(c: Candidate) -> str:
    """What a model would need: the parameter that would be farthest from what is known of it."""
    wanted = c.without_priors.values
    priors = {n: prior for n in wanted if (prior := c.fit.parameters[n].prior) is not None}
    name = max(wanted, key=lambda n: abs(priors[n].surprise(wanted[n])))
    unit = c.fit.parameters[name].unit
    low, value, high = (format_quantity(v, unit) for v in (priors[name].low, wanted[name], priors[name].high))
    needs = f"{name} would have to be about {value}, where {low} to {high} is usual"
    return f"{' + '.join(c.effects)} would fit as well, but {needs}."
