"""Which of the models that were fitted is best, and what a further one must come to.

The evidence orders them (``diagnosis.evidence``), on the scale of noise that the best leaves. Among models that leave
noise more effects need very strong evidence. While nothing leaves noise, the best model made of laws alone is carried
on beside the best one: a general member takes away a part of what another family hides, and no law that is right in the
end looks like it then.
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
    information_criterion,
    noise_scale,
    refuted_by_unfitted_signals,
)
from pam_cosim.diagnosis.judgement.size import size_of_effect
from pam_cosim.diagnosis.search.search import Search
from pam_cosim.fitting import Fit


@dataclass(frozen=True)
class AcceptanceThreshold:
    """What a further model must come to, to be of interest.

    Attributes:
        criterion: at most, as slopes expect it.
        reference: the model that it has to leave much less than; None: it need not.
        specific: it is made of laws alone.
        rival_of: families of the answer that it is to rival: it has to lack one of them; None: it need not.
    """

    criterion: float
    reference: Candidate | None = None
    specific: bool = False
    rival_of: frozenset[str] | None = None


class Ranking:
    """The models so far.

    Args:
        search: what they are chosen from.
        base: the model without effects, fitted.
        fitted: the others by their effects, in the order in which these were added; whoever fits more adds them.

    Attributes:
        effort_spent: the search has ended at a limit: models that were fitted in a few steps count as they are.
    """

    def __init__(
        self, search: Search, base: Fit, fitted: Mapping[tuple[str, ...], Candidate]
    ) -> None:
        self.search, self.base, self.fitted = search, base, fitted
        self.scale = noise_scale([base])
        self.effort_spent = False

    @property
    def fits(self) -> list[Fit]:
        """All fitted models."""
        return [self.base, *(c.fit for c in self.fitted.values())]

    @property
    def attempted(self) -> set[frozenset[str]]:
        """The sets of effects that were fitted, or could not be."""
        return {
            frozenset(names) for names in (*self.fitted, *(f.effects for f in self.search.failed))
        }

    def update_scale(self) -> None:
        """Takes note of further fits."""
        self.scale = noise_scale(self.fits)

    def noise_floor(self) -> float:
        """Mean square of the noise, as low as a model leaves it."""
        return min(f.residuals["fit"].noise_floor for f in self.fits)

    def optimistic_scale(self) -> NoiseScale:
        """The scale of what is possible: plain noise as long as the best model leaves more, else what that leaves."""
        if not self.unsolved():
            return self.scale
        return self.scale._replace(variance=max(1.0, self.noise_floor()), time=1.0)

    def information_criterion(self, c: Candidate | None, scale: NoiseScale | None = None) -> float:
        """The evidence against a model, None: the base model; on the scale of the best model unless given."""
        fit, effects = (c.fit, c.effects) if c else (self.base, ())
        return information_criterion(fit, scale or self.scale, effects, self.search.model_space, c)

    def is_specific(self, effects: Collection[str]) -> bool:
        """Whether none of them is the general member of a family."""
        return self.search.general.isdisjoint(effects)

    def models(self, most: int, specific: bool = False) -> list[Candidate]:
        """Models with so many effects at most, the best first."""
        models = [
            c
            for c in self.fitted.values()
            if len(c.effects) <= most and (not specific or self.is_specific(c.effects))
        ]
        return sorted(models, key=lambda c: (self.information_criterion(c), c.effects))

    def of_each_families(self, count: int) -> list[Candidate]:
        """Of models with so many effects, fitted to the end, the best of each set of families, the best first."""
        complete = {c.effects for c in self._complete()}
        complete_models = (
            c for c in self.models(count) if len(c.effects) == count and c.effects in complete
        )
        first: dict[frozenset[str], Candidate] = {}
        for c in complete_models:
            first.setdefault(self.search.families_of(c.effects), c)
        return list(first.values())

    def best(self, specific: bool = False) -> Candidate | None:
        """Of those that leave noise, the best with the number of effects that is enough; else the best of all.

        None: none beats the base model. Where the evidence does not tell them apart, signals that were compared but
        not fitted may.

        Args:
            specific: only of models that are made of laws.
        """
        beaten = self.information_criterion(None) - CRITERIA.evidence.very_strong
        done = [c for c in self._complete() if self.information_criterion(c) < beaten]
        done = [c for c in done if not specific or self.is_specific(c.effects)]
        at_noise = [c for c in done if not self.has_structure(c)]
        if at_noise:
            enough = self._sufficient_count(at_noise)
            done = [c for c in at_noise if len(c.effects) == enough]
        order = {c.effects: (self.information_criterion(c), c.effects) for c in done}
        first = min(order.values(), default=None)
        if first is None:
            return None
        close = [c for c in done if order[c.effects][0] < first[0] + CRITERIA.evidence.very_strong]
        sound = [
            c
            for c in close
            if not any(refuted_by_unfitted_signals(c.fit, other.fit) for other in close)
        ]
        return min(sound or close, key=lambda c: order[c.effects])

    def _complete(self) -> list[Candidate]:
        """The models that were fitted to the end, or as far as the effort allowed."""
        return [c for c in self.fitted.values() if self.effort_spent or not c.brief]

    def _sufficient_count(self, at_noise: Collection[Candidate]) -> int:
        """How many effects are enough, where all of these models leave noise: more need very strong evidence."""
        evidence = {c.effects: self.information_criterion(c) for c in at_noise}
        ordered = sorted(at_noise, key=lambda c: (len(c.effects), evidence[c.effects], c.effects))
        first = ordered[0]
        for c in ordered:
            if evidence[c.effects] < evidence[first.effects] - CRITERIA.evidence.very_strong:
                first = c
        return len(first.effects)

    def with_one_less(self) -> list[Candidate]:
        """The models that lack one of the effects of the best, which has several."""
        best = self.best()
        return self._with_one_less_than(best) if best else []

    def has_structure(self, c: Candidate) -> bool:
        """Whether a model leaves structure, in runs that were fitted or in others.

        The noise is that of the instruments, whatever the model: where nobody stated it, no larger than beside the
        model that leaves least. What a model leaves may look like red noise by itself.
        """
        return self._leaves_structure(c.fit)

    def _leaves_structure(self, fit: Fit) -> bool:
        floor = self.noise_floor()
        return any(
            has_structure(replace(s, noise_floor=min(s.noise_floor, floor)))
            for s in fit.residuals_beyond_uncertainty.values()
        )

    def unsolved(self) -> bool:
        """Whether the best model leaves structure; where none beats the base model, whether that does."""
        best = self.best()
        return self._leaves_structure(self.base if best is None else best.fit)

    def leader(self, specific: bool = False) -> Candidate | None:
        """The model that the search goes on from while nothing leaves noise: the best, or else the nearest to it.

        Where what is left is as slow as a run is long, there are too few independent samples to prefer any model to the
        base model. Then the best on the scale of what is possible leads: two effects may explain the data together of
        which neither does anything alone, as a thermometer that lags behind a gas with its energy.

        Args:
            specific: only of models that are made of laws.
        """
        best = self.best(specific)
        if best is not None:
            return best
        models = [c for c in self._complete() if not specific or self.is_specific(c.effects)]
        scale = self.optimistic_scale()
        evidence = {c.effects: self.information_criterion(c, scale) for c in models}
        base = self.information_criterion(None, scale)
        models = [c for c in models if self.has_structure(c) and evidence[c.effects] < base]
        return min(models, key=lambda c: (evidence[c.effects], c.effects), default=None)

    def parents(self) -> list[Candidate]:
        """The models that the search goes on from: the best, the best of laws, and the best of other families.

        Of as many sets of families as lead; the right ones may leave more than a rich law of wrong ones.
        """
        best = self.leader()
        leading = self.of_each_families(len(best.effects)) if best is not None else []
        parents = (best, self.leader(specific=True), *leading[: CRITERIA.search.leading_families])
        return list({c.effects: c for c in parents if c is not None}.values())

    def may_be(self, threshold: AcceptanceThreshold, effects: Collection[str]) -> bool:
        """Whether a threshold is for models with these effects."""
        if threshold.specific and not self.is_specific(effects):
            return False
        # asked of thousands of proposals, so that families are only looked up where they count
        return threshold.rival_of is None or not threshold.rival_of.issubset(
            self.search.family[name] for name in effects
        )

    def acceptance_thresholds(self, count: int, scale: NoiseScale) -> list[AcceptanceThreshold]:
        """What models with so many effects must come to: to beat one of the best, to rival the answer, to replace it.

        Args:
            count: of effects.
            scale: the scale on which their evidence is reckoned.
        """
        best = self.leader()
        if best is None:
            reached = self.information_criterion(None, scale)
            return [AcceptanceThreshold(reached)]
        reached, worth = self.information_criterion(best, scale), CRITERIA.evidence.very_strong
        if not self.has_structure(best):
            if count > len(best.effects):
                return []
            # what has the same families can replace the answer, but not rival it: as good is not enough
            families = self.search.families_of(best.effects)
            rival = AcceptanceThreshold(reached + worth, rival_of=families)
            return [AcceptanceThreshold(reached), rival]
        bars = [AcceptanceThreshold(reached, best)]
        if not self.is_specific(best.effects):
            law = self.leader(specific=True)
            reached = self.information_criterion(law, scale)
            bars.append(AcceptanceThreshold(reached, law, specific=True))
        return bars

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
        while less := [c for c in self._with_one_less_than(best) if not self.matters(best, c)]:
            best = min(less, key=lambda c: (self.information_criterion(c), c.effects))
        return best

    def _with_one_less_than(self, best: Candidate) -> list[Candidate]:
        names = frozenset(best.effects)
        smaller = (c for c in self.fitted.values() if 0 < len(c.effects) == len(names) - 1)
        return [c for c in smaller if names.issuperset(c.effects)]

    def matters(self, best: Candidate, without: Candidate, times: float = 1.0) -> bool:
        """Whether the effect that a model lacks, compared with a better one, is large enough to be called missing."""
        return size_of_effect(self.base, without.fit, best.fit).matters(times)
