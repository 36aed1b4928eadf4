"""Which of the models that were fitted is best, and what a further one must come to.

The evidence orders them (``diagnosis.evidence``), on the scale of noise that the best leaves. Among models that leave
noise more effects need very strong evidence.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.evidence import (
    NoiseScale,
    dominant_effect,
    has_structure,
    refuted_by_unfitted_signals,
)
from pam_cosim.diagnosis.judgement.fitted_models import FittedModels
from pam_cosim.diagnosis.judgement.size import size_of_effect
from pam_cosim.diagnosis.search.search import Search
from pam_cosim.fitting import Fit


@dataclass(frozen=True)
class Target:
    """What a further model must come to, to be of interest (``Ranking.target``).

    Attributes:
        scale: on which its evidence counts.
        criterion: to replace the leader.
        of_laws: to replace the best model made of laws alone; or the leader, once that leaves noise.
        families: of a leader that leaves noise; None: it leaves structure.
    """

    scale: NoiseScale
    criterion: float
    of_laws: float
    families: frozenset[str] | None


class Ranking:
    """The models so far.

    Args:
        search: what they are chosen from.
        base: the model without effects, fitted.
        fitted: the others by their effects, in the order in which these were added; whoever fits more adds them.

    Attributes:
        models: those that were noted.
        effort_spent: the search has ended at a limit: models that were fitted in a few steps count as they are.
    """

    def __init__(
        self, search: Search, base: Fit, fitted: Mapping[tuple[str, ...], Candidate]
    ) -> None:
        self.search, self.base, self.fitted = search, base, fitted
        self.effort_spent = False
        self.update()

    def update(self) -> None:
        """Takes note of further fits."""
        search, tried = self.search, tuple(self.fitted.values())
        self.models = FittedModels(self.base, search.family, search.model_space, tried=tried)

    @property
    def attempted(self) -> set[frozenset[str]]:
        """The sets of effects that were fitted, or could not be."""
        return {
            frozenset(names) for names in (*self.fitted, *(f.effects for f in self.search.failed))
        }

    def noise_floor(self) -> float:
        """Mean square of the noise, as low as a model leaves it."""
        fits = (self.base, *(c.fit for c in self.fitted.values()))
        return min(f.residuals["fit"].noise_floor for f in fits)

    def leading(self, count: int) -> list[Candidate]:
        """Of models with so many effects the best of each set of families, with a general member and without one.

        The right families may leave more than a rich law of wrong ones.
        """
        first: dict[tuple[frozenset[str], bool], Candidate] = {}
        for c in self.models.ordered(c for c in self.fitted.values() if len(c.effects) == count):
            first.setdefault((self.models.families(c), c.has_general_member), c)
        return list(first.values())

    def best(self) -> Candidate | None:
        """Of those that leave noise, the best with the number of effects that is enough; else the best of all.

        None: none beats the base model. Where the evidence does not tell them apart, signals that were compared but
        not fitted may.
        """
        beaten, worth = self.models.criterion(None), CRITERIA.evidence.very_strong
        done = [c for c in self._complete() if self.models.criterion(c) < beaten - worth]
        at_noise = [c for c in done if not self.has_structure(c)]
        if at_noise:
            enough = self._sufficient_count(at_noise)
            done = [c for c in at_noise if len(c.effects) == enough]
        if not done:
            return None
        first, *others = self.models.ordered(done)
        limit = self.models.criterion(first) + worth
        close = [first, *(c for c in others if self.models.criterion(c) < limit)]
        sound = (
            c
            for c in close
            if not any(refuted_by_unfitted_signals(c.fit, other.fit) for other in close)
        )
        return next(sound, first)

    def _complete(self) -> list[Candidate]:
        """The models that were fitted to the end, or as far as the effort allowed."""
        return [c for c in self.fitted.values() if self.effort_spent or not c.brief]

    def _sufficient_count(self, at_noise: Collection[Candidate]) -> int:
        """How many effects are enough, where all of these models leave noise: more need very strong evidence."""
        evidence = {c.effects: self.models.criterion(c) for c in at_noise}
        ordered = sorted(at_noise, key=lambda c: (len(c.effects), evidence[c.effects], c.effects))
        first = ordered[0]
        for c in ordered:
            if evidence[c.effects] < evidence[first.effects] - CRITERIA.evidence.very_strong:
                first = c
        return len(first.effects)

    def has_structure(self, c: Candidate | None) -> bool:
        """Whether a model, None: the base model, leaves structure, in runs that were fitted or in others.

        The noise is that of the instruments, whatever the model: where nobody stated it, no larger than beside the
        model that leaves least. What a model leaves may look like red noise by itself.
        """
        fit, floor = c.fit if c else self.base, self.noise_floor()
        return any(
            has_structure(replace(s, noise_floor=min(s.noise_floor, floor)))
            for s in fit.residuals_beyond_uncertainty.values()
        )

    def unsolved(self) -> bool:
        """Whether the best model leaves structure; where none beats the base model, whether that does."""
        return self.has_structure(self.best())

    def leader(self) -> Candidate | None:
        """The model that the search goes on from: the best, or while none beats the base model the nearest to it.

        Two effects may explain the data together of which neither does anything alone, as a thermometer that lags
        behind a gas with its energy.
        """
        best = self.best()
        if best is not None:
            return best
        base = self.models.criterion(None)
        nearer = (c for c in self._complete() if self.models.criterion(c) < base)
        return self.models.first(filter(self.has_structure, nearer))

    def target(self) -> Target:
        """What a further model must come to, to be of interest.

        While nothing leaves noise, what is left is missing: it counts as beside white noise. And laws need not be
        better than a general member, but than laws: it takes away a part of what another family hides, and no law that
        is right in the end looks like it then.
        """
        best = self.leader()
        if best is not None and not self.has_structure(best):
            criterion = self.models.criterion(best)
            families = self.search.families_of(best.effects)
            return Target(self.models.scale, criterion, criterion, families)
        scale = NoiseScale(max(1.0, self.noise_floor()), 1.0)
        law = self.models.first(c for c in self._complete() if not c.has_general_member)
        criteria = [self.models.criterion(c, scale) for c in (best, law)]
        return Target(scale, criteria[0], max(criteria), None)

    def reaches(self, target: Target, effects: Collection[str], criterion: float) -> bool:
        """Whether a model with some effects and so much evidence on the scale of a target is of interest.

        What has the same families can replace an answer, but not rival it: as good is not enough.
        """
        if target.families is None:
            laws = self.search.general.isdisjoint(effects)
            return criterion <= (target.of_laws if laws else target.criterion)
        rivals = not target.families <= self.search.families_of(effects)
        enough = len(effects) <= len(target.families)
        return enough and criterion <= target.criterion + CRITERIA.evidence.very_strong * rivals

    def answer(self) -> Candidate | None:
        """The best model without further effects that are too small to matter.

        Where it leaves structure, one effect that is beyond doubt all the same goes first.
        """
        best = self.best()
        if best is None:
            return None
        if self.has_structure(best):
            dominant = dominant_effect(self.base, list(self.fitted.values()))
            if dominant is not None:
                return self.fitted[dominant.effects]
        while less := [c for c in self.with_one_less_than(best) if not self.matters(best, c)]:
            best = self.models.ordered(less)[0]
        return best

    def with_one_less_than(self, best: Candidate) -> list[Candidate]:
        """The models that lack one of the effects of another, which has several."""
        names = frozenset(best.effects)
        smaller = (c for c in self.fitted.values() if 0 < len(c.effects) == len(names) - 1)
        return [c for c in smaller if names.issuperset(c.effects)]

    def matters(self, best: Candidate, without: Candidate, times: float = 1.0) -> bool:
        """Whether the effect that a model lacks, compared with a better one, is large enough to be called missing."""
        return size_of_effect(self.base, without.fit, best.fit).matters(times)
