"""How probable it is that some families are missing, that nothing is, or that it is something no effect describes.

Each set of families has the weight of its best model's evidence, and nothing that of the base model. The evidence is
tempered: samples, models and noise are not as independent as it assumes. "Something else" is no model whose evidence
could be reckoned; its probability is a logistic function of what makes an answer doubtful, fitted to cases of which the
truth is known (``benchmarks.hidden_effects.posterior``).
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field
from math import exp, nan

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.evidence import has_structure, missed_signals
from pam_cosim.diagnosis.judgement.fitted_models import FittedModels
from pam_cosim.fitting import Fit


@dataclass(frozen=True)
class Explanation:
    """Families that may be what is missing, these and no others.

    Attributes:
        families: in alphabetical order; none: nothing is missing.
        evidence: against their best model, less that against the answer: twice the logarithm of the odds.
        probability: of these families.
    """

    families: tuple[str, ...]
    evidence: float
    probability: float


@dataclass(frozen=True)
class Posterior:
    """What may be missing, with probabilities that sum to one.

    Attributes:
        explanations: the sets of families of which a model was fitted, the most probable first.
        something_else: probability of what no effect describes; NaN: not known.
        credibility: by family of an answer that leaves structure, how far it is believed (``family_table``).
        doubts: what made that more probable, some of ``DOUBTS``.
    """

    json_keys = "explanations families=by_family something_else doubts"

    explanations: tuple[Explanation, ...] = ()
    something_else: float = nan
    doubts: tuple[str, ...] = ()
    credibility: dict[str, float] = field(default_factory=dict)

    @property
    def by_family(self) -> dict[str, float]:
        """Probability that a family is missing, whatever else is; the most probable first.

        Over the fitted sets of families; an additional cause without an effect does not lower it, but where it leaves
        as much as a family is worth.
        """
        families = dict.fromkeys(f for e in self.explanations for f in e.families)
        sums = {family: self.believed((family,)) for family in families}
        return dict(sorted(sums.items(), key=lambda entry: (-entry[1], entry[0])))

    def believed(self, families: Collection[str]) -> float:
        """``probability_of_any``, as far as these families are believed."""
        credibility = max(self.credibility.get(family, 1.0) for family in families)
        return credibility * self.probability_of_any(families)

    def probability_of_any(self, families: Collection[str]) -> float:
        """Probability that at least one of some families is missing, whatever else is."""
        total = sum(e.probability for e in self.explanations)
        probabilities = (e.probability for e in self.explanations if {*families} & {*e.families})
        return sum(probabilities) / total if total > 0 else 0.0


DOUBTS = ("structure", "form_open", "nothing", "unchecked", "several", "general")
"""What makes it more probable that something else is missing, in the order of ``evidence.something_else``, whose first
number is there always.

structure: what remains is no noise. form_open: the same, but one family is beyond doubt. nothing: no effect was added,
and what remains is noise. Where an effect leaves noise: unchecked, no held-out run speaks for it, or a signal that was
not fitted speaks against it; several, there is more than one; general, one is a general member.
"""


def posterior(models: FittedModels, doubts: Collection[str]) -> Posterior:
    """The probabilities of the answer and of the other sets of families.

    Models that were fitted in a few steps only do not count, nor those with more effects than the answer, which would
    follow the noise (one effect where there is none), nor those that signals speak against which were not fitted.

    Args:
        models: the answer is the last of their path.
        doubts: of the answer, some of ``DOUBTS``.
    """
    answer = models.path[-1:]
    most = max([1, *(len(c.effects) for c in answer)])
    counted = [
        c
        for c in models.tried
        if not c.brief and len(c.effects) <= most and not models.is_refuted(c)
    ]
    best = models.best_of_each([*counted, *answer])
    criteria = {frozenset[str](): models.criterion(None)} | {
        f: models.criterion(c) for f, c in best.items()
    }
    criterion_of_answer = criteria[models.families(answer[0]) if answer else frozenset()]
    weights = {
        f: exp(min((criterion_of_answer - e) / (2 * CRITERIA.evidence.temperature), 0.0))
        for f, e in criteria.items()
    }
    other = something_else(doubts)
    share = (1 - other) / sum(weights.values())
    explanations = [
        Explanation(tuple(sorted(f)), criteria[f] - criterion_of_answer, share * weights[f])
        for f in criteria
    ]
    explanations.sort(key=lambda e: (-e.probability, e.evidence, e.families))
    return Posterior(tuple(explanations), other, tuple(name for name in DOUBTS if name in doubts))


def doubts_of(selected: Sequence[Candidate], structure: bool, form_open: bool) -> frozenset[str]:
    """What makes an answer doubtful, some of ``DOUBTS``.

    Args:
        selected: models that add one effect after another; none where nothing was added.
        structure: whether what remains is no noise.
        form_open: whether the family is beyond doubt all the same.
    """
    if structure or form_open:
        return frozenset({"form_open" if form_open else "structure"})
    if not selected:
        return frozenset({"nothing"})
    applies = {
        "unchecked": not _checked(selected[-1].fit),
        "several": len(selected[-1].effects) > 1,
        "general": any(c.general for c in selected),
    }
    return frozenset(name for name, true in applies.items() if true)


def something_else(doubts: Collection[str]) -> float:
    """Probability that a cause is missing, alone or in addition, that no effect describes."""
    always, *more = CRITERIA.evidence.something_else
    logit = always + sum(
        number for name, number in zip(DOUBTS, more, strict=True) if name in doubts
    )
    return 1 / (1 + exp(-logit))


def _checked(fit: Fit) -> bool:
    """Whether runs that were held out speak for a model, and no signal that was compared but not fitted against it.

    Held-out runs that only the uncertainty of the parameters excuses check little.
    """
    held = fit.residuals["holdout"]
    return bool(held.samples) and not has_structure(held) and not missed_signals(fit)
