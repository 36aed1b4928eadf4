"""Which of the models that were fitted is best, and what a further one must come to.

The evidence orders them (``diagnosis.evidence``), on the scale of noise that the best leaves. Among models that leave
noise it would go on rewarding whoever follows the noise closest, so there what a model is made of counts first: as few
effects as leave noise are enough, unless more get by with fewer parameters. While nothing leaves noise, the
best model made of laws alone is carried on beside the best one: an effect that says whatever its family can takes away
a part of what another family hides, and no law that is right in the end looks like it then.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.candidate import Candidate
from pam_cosim.diagnosis.evidence import (
    Scale,
    any_structure_for_search,
    dominant_effect,
    evidence,
    refuted,
    scale,
)
from pam_cosim.diagnosis.search import Search
from pam_cosim.fitting import Fit


@dataclass(frozen=True)
class AcceptanceThreshold:
    """What a further model must come to, to be of interest.

    Attributes:
        evidence: at most.
        beside: the model that it has to leave much less than; None: it need not.
        laws: it is made of laws alone.
        cost: of its effects, at most, where it is to replace a model that leaves noise with fewer effects; None: not
            asked.
    """

    evidence: float
    beside: Candidate | None = None
    laws: bool = False
    cost: float | None = None


class Ranking:
    """The models so far.

    Args:
        search: what they are chosen from.
        base: the model without effects, fitted.
        known: the others by their effects, in the order in which these were added; whoever fits more adds them.

    Attributes:
        over: the time for the search is over: models that were fitted in a few steps count as they are.
    """

    def __init__(self, search: Search, base: Fit, known: Mapping[tuple[str, ...], Candidate]) -> None:
        self.search, self.base, self.known = search, base, known
        self.scale = scale([base])
        self.over = False
        self._left: dict[tuple[str, ...], tuple[Fit, bool]] = {}

    @property
    def fits(self) -> list[Fit]:
        """All fitted models."""
        return [self.base, *(c.fit for c in self.known.values())]

    @property
    def seen(self) -> set[frozenset[str]]:
        """The sets of effects that were fitted, or could not be."""
        return {frozenset(names) for names in (*self.known, *(f.effects for f in self.search.failed))}

    def renew(self) -> None:
        """Takes note of further fits."""
        self.scale = scale(self.fits)

    def noise(self) -> float:
        """Mean square of the noise, as low as a model leaves it."""
        return min(f.residuals["fit"].noise_floor for f in self.fits)

    def optimistic_scale(self) -> Scale:
        """The scale of what is possible: plain noise as long as the best model leaves more, else what that leaves."""
        return Scale(max(1.0, self.noise()), 1.0) if self.unsolved() else self.scale

    def evidence(self, c: Candidate | None, at: Scale | None = None) -> float:
        """The evidence against a model, None: the base model; on the scale of the best model unless given."""
        fit, effects = (c.fit, c.effects) if c else (self.base, ())
        return evidence(fit, at or self.scale, effects, self.search.choice, c)

    def of_laws(self, effects: Collection[str]) -> bool:
        """Whether none of them says whatever its family can."""
        return self.search.general.isdisjoint(effects)

    def models(self, most: int, laws: bool = False) -> list[Candidate]:
        """Models with so many effects at most, the best first."""
        some = [c for c in self.known.values() if len(c.effects) <= most and (not laws or self.of_laws(c.effects))]
        return sorted(some, key=lambda c: (self.evidence(c), c.effects))

    def best(self, laws: bool = False) -> Candidate | None:
        """Of those that leave noise, the best with the number of effects that is enough; else the best of all.

        None: none beats the base model. Where the evidence does not tell them apart, signals that were compared but
        not fitted may.

        Args:
            laws: only of models that are made of laws.
        """
        beaten = self.evidence(None) - CRITERIA.evidence.very_strong
        done = [c for c in self._done() if self.evidence(c) < beaten]
        done = [c for c in done if not laws or self.of_laws(c.effects)]
        at_noise = [c for c in done if not self.has_structure(c)]
        if at_noise:
            enough = self._sufficient_count(at_noise)
            done = [c for c in at_noise if len(c.effects) == enough]
        order = {c.effects: (self.evidence(c), c.effects) for c in done}
        first = min(order.values(), default=None)
        if first is None:
            return None
        near = [c for c in done if order[c.effects][0] < first[0] + CRITERIA.evidence.very_strong]
        sound = [c for c in near if not any(refuted(c.fit, other.fit) for other in near)]
        return min(sound or near, key=lambda c: order[c.effects])

    def _done(self) -> list[Candidate]:
        """The models that were fitted to the end, or as far as there was time for."""
        return [c for c in self.known.values() if self.over or not c.brief]

    def _sufficient_count(self, at_noise: Collection[Candidate]) -> int:
        """How many effects are enough, where all of these models leave noise.

        The fewest, unless more have fewer parameters, so few that it makes up for the choice, and better evidence.
        """
        first = min(at_noise, key=lambda c: (len(c.effects), self.evidence(c), c.effects))
        for c in sorted(at_noise, key=lambda c: (len(c.effects), self.evidence(c), c.effects)):
            better = self.evidence(c) < self.evidence(first) - CRITERIA.evidence.very_strong
            if better and self.cost(c.effects) < self.cost(first.effects):
                first = c
        return len(first.effects)

    def has_structure(self, c: Candidate) -> bool:
        """Whether a model leaves structure, in runs that were fitted or in others."""
        if c.effects not in self._left or self._left[c.effects][0] is not c.fit:
            self._left[c.effects] = (c.fit, any_structure_for_search(c.fit))
        return self._left[c.effects][1]

    def unsolved(self) -> bool:
        """Whether the best model leaves structure, or there is none."""
        best = self.best()
        return best is None or self.has_structure(best)

    def parents(self) -> list[Candidate]:
        """The models that the search goes on from: the best, and the best of laws; or what may replace the best.

        That is the best of those that would cost less even with one more effect, once the best leaves noise.
        """
        best = self.best()
        if best is not None and not self.has_structure(best):
            return [
                c for c in self.models(len(best.effects)) if self._with_one_more(c.effects) < self.cost(best.effects)
            ][:1]
        return list({c.effects: c for c in (best, self.best(laws=True)) if c is not None}.values())

    def cost(self, effects: Collection[str]) -> float:
        """What effects are charged for what they are made of: their parameters, and the choice of them."""
        return self._cost(effects, sum(self.search.cost[name] for name in effects))

    def _cost(self, effects: Collection[str], parameters: int) -> float:
        return parameters * self.scale.penalty(self.base) + self.search.choice.cost(effects)

    def _with_one_more(self, effects: Collection[str]) -> float:
        """The same with one more effect, of one parameter."""
        other = next(e.name for e in self.search.shelf if e.name not in effects)
        return self._cost((*effects, other), sum(self.search.cost[name] for name in effects) + 1)

    def more_effects_can_pay(self, count: int) -> bool:
        """Whether so many effects, of one parameter each, would cost less than the best model, which leaves noise."""
        best = self.best()
        if best is None or self.has_structure(best):
            return False
        return self._cost([e.name for e in self.search.shelf][:count], count) < self.cost(best.effects)

    def bars(self, count: int, at: Scale) -> list[AcceptanceThreshold]:
        """What models with so many effects must come to: to beat one of the best, to rival the answer, to replace it.

        Args:
            count: of effects.
            at: the scale on which their evidence is reckoned.
        """
        best = self.best()
        if best is None:
            return [AcceptanceThreshold(self.evidence(None, at))]
        if not self.has_structure(best):
            if count > len(best.effects):
                return [
                    AcceptanceThreshold(self.evidence(c, at), c, cost=self.cost(best.effects)) for c in self.parents()
                ]
            return [AcceptanceThreshold(self.evidence(best, at) + CRITERIA.evidence.very_strong)]
        bars = [AcceptanceThreshold(self.evidence(best, at), best)]
        if not self.of_laws(best.effects):
            own = self.best(laws=True)
            bars.append(AcceptanceThreshold(self.evidence(own, at), own, laws=True))
        return bars

    def answer(self) -> Candidate | None:
        """The best model; where it leaves structure, one effect that is beyond doubt all the same goes first."""
        best = self.best()
        if best is not None and self.has_structure(best):
            return dominant_effect(self.base, self._done()) or best
        return best
