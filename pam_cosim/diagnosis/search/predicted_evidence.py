"""What models that nobody fitted, or not to the end, promise: their evidence, as far as linear algebra tells."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.evidence import NoiseScale, evidence_without_choice
from pam_cosim.diagnosis.search.expectation import Expectation, effect_alone, expected
from pam_cosim.diagnosis.search.probing import EffectProbe
from pam_cosim.diagnosis.search.ranking import Ranking
from pam_cosim.diagnosis.search.search import FitRequest
from pam_cosim.fitting import Fit, Linear, bounded_step, coloured_deviance

_TINY = 1e-300  # keeps a quotient finite


class Start:
    """A fitted model that others start from, with what is the same for all of these.

    Args:
        fit: of the model.
        candidate: the model; None: the base model.
        scale: on which evidence counts.
        noise_floor: mean square of the noise.
    """

    def __init__(
        self, fit: Fit, candidate: Candidate | None, scale: NoiseScale, noise_floor: float
    ) -> None:
        self.fit, self.candidate = fit, candidate
        self.effects = candidate.effects if candidate else ()
        self._scale, self._floor = scale, noise_floor

    @cached_property
    def evidence(self) -> float:
        """The evidence against it, but for how many sets of effects there are."""
        return evidence_without_choice(self.fit, self._scale, self.candidate)

    @cached_property
    def penalty(self) -> float:
        """What a parameter costs."""
        return self._scale.penalty(self.fit)

    def gain(self, residual: Array) -> float:
        """What it counts that fitted runs leave a residual (m,), in the rows of the linear model.

        Other runs are expected to gain as much, and nothing falls below the noise. Noise of any colour may follow a
        slow course, which counts for all samples that a row is the mean of.
        """
        linear, fitted = self.fit.linear, self.fit.residuals["fit"]
        assert linear is not None
        left = [s for s in self.fit.residuals_beyond_uncertainty.values() if s.samples]
        if self._scale.coloured:
            gain = self._deviance_of_rows - coloured_deviance(linear, residual, self._largest)
            return max(gain, 0.0) * sum(s.samples for s in left) / fitted.samples
        reduction = max(float(linear.residual @ linear.residual - residual @ residual), 0.0)
        share = 1 - reduction / max(fitted.chi2, _TINY)
        after = [min(s.chi2, max(share * s.chi2, self._floor * s.samples)) for s in left]
        return sum(s.chi2 - then for s, then in zip(left, after, strict=True)) / self._scale.divisor

    @property
    def _largest(self) -> float:
        """Mean square that noise may have in a row."""
        assert self.fit.linear is not None
        in_row = self.fit.residuals["fit"].samples / len(self.fit.linear.residual)
        return self._scale.largest * max(in_row, 1.0)

    @cached_property
    def _deviance_of_rows(self) -> float:
        assert self.fit.linear is not None
        return coloured_deviance(self.fit.linear, self.fit.linear.residual, self._largest)


@dataclass(frozen=True)
class Proposal:
    """A model that nobody fitted: a fitted one with a further effect.

    Attributes:
        start: the fitted model.
        effect: the further effect; ``cost``: number of its parameters.
        expected: what the model is expected to come to.
    """

    start: Start
    effect: str
    cost: int
    expected: Expectation

    @property
    def effects(self) -> tuple[str, ...]:
        """All effects."""
        return (*self.start.effects, self.effect)

    @cached_property
    def gain(self) -> float:
        """What it counts that the fitted runs leave less."""
        return self.start.gain(self.expected.residual)


class PredictedEvidence:
    """What is known of effects beside the models so far.

    Args:
        ranking: the models.
    """

    def __init__(self, ranking: Ranking) -> None:
        self.ranking = ranking
        self._probes: dict[tuple[str, ...], tuple[Linear, dict[str, EffectProbe]]] = {}
        self._expected: dict[tuple[str, ...], tuple[tuple[Linear, ...], Expectation | None]] = {}

    def note_probes(self, model: Candidate | None, probes: Sequence[EffectProbe]) -> None:
        """Takes note of what effects do beside a model, None: the base model, besides what was noted before."""
        effects, fit = (model.effects, model.fit) if model else ((), self.ranking.base)
        assert fit.linear is not None
        _, known = self._probes.setdefault(effects, (fit.linear, {}))
        known |= {p.effect: p for p in probes if p.effect not in self.ranking.search.undetectable}

    def probed_beside(self, effects: tuple[str, ...]) -> Collection[str]:
        """The effects that were looked at beside a model."""
        return self._probes[effects][1] if effects in self._probes else ()

    def most_promising(self, count: int) -> list[Proposal]:
        """So many of the effects that promise most by themselves."""
        return self._ordered(self._with_one_more(None))[:count]

    def leading_families(self, c: Candidate, count: int) -> list[str]:
        """So many families of which a member promises most beside a model."""
        proposals = self._ordered(self._with_one_more(c))
        return list(dict.fromkeys(self.ranking.search.family[p.effect] for p in proposals))[:count]

    def promising_brief_fits(self) -> list[Candidate]:
        """Models that were fitted briefly and may be better than the best, or as good; the most promising ones."""
        target, promising = self.ranking.target(), []
        for c in filter(lambda c: c.brief, self.ranking.fitted.values()):
            criterion = self.ranking.models.criterion(c, target.scale)
            if (linear := c.fit.linear) is not None:
                residual = linear.residual - linear.slopes @ bounded_step(linear)
                criterion -= self._start(c, target.scale).gain(residual)
            if self.ranking.reaches(target, c.effects, criterion):
                promising.append((criterion, c.effects))
        return [
            self.ranking.fitted[names] for _, names in sorted(promising)[: CRITERIA.search.together]
        ]

    def proposals(self, count: int) -> list[Proposal]:
        """Untried models of so many effects that may be better than the best, or as good, one of each families."""
        target, tried = (
            self.ranking.target(),
            self.ranking.attempted | self.ranking.search.displaced,
        )
        passing = [
            p
            for start in self._starts(count)
            for p in self._with_one_more(start, target.scale)
            if frozenset(p.effects) not in tried
            and self.ranking.reaches(target, p.effects, self.predicted_criterion(p, hopeful=True))
        ]
        first: dict[frozenset[str], Proposal] = {}
        for p in self._ordered(passing):
            first.setdefault(self.ranking.search.families_of(p.effects), p)
        return [*first.values()][: CRITERIA.search.together]

    def _starts(self, count: int) -> Sequence[Candidate | None]:
        """The models that those of so many effects are predicted from: what leads, and the leader with one less."""
        if count == 1:
            return [None]
        leader = self.ranking.leader()
        less = self.ranking.with_one_less_than(leader) if leader else []
        starts = [*self.ranking.leading(count - 1)[: CRITERIA.search.starts], *less]
        return [*{c.effects: c for c in starts if len(c.effects) == count - 1}.values()]

    def _with_one_more(
        self, c: Candidate | None, scale: NoiseScale | None = None
    ) -> list[Proposal]:
        """A model, None: the base model, with each effect of another family: as looked at beside it, or by itself."""
        search, start = self.ranking.search, self._start(c, scale or self.ranking.models.scale)
        model = start.fit.linear
        if model is None:
            return []
        probes = {
            name: (beside, probe)
            for effects in dict.fromkeys([(), start.effects])
            if effects in self._probes
            for beside, known in [self._probes[effects]]
            for name, probe in known.items()
        }
        taken = search.families_of(start.effects)
        return [
            Proposal(start, name, search.cost[name], expectation)
            for name, (beside, probe) in probes.items()
            if search.family[name] not in taken
            and (expectation := self._expectation(start, model, beside, probe)) is not None
        ]

    def _start(self, c: Candidate | None, scale: NoiseScale) -> Start:
        fit = c.fit if c else self.ranking.base
        return Start(fit, c, scale, self.ranking.noise_floor())

    def _expectation(
        self, start: Start, model: Linear, beside: Linear, probe: EffectProbe
    ) -> Expectation | None:
        """What a model comes to with an effect, as it was looked at or fitted alone; None: it does nothing."""
        alone, base = self.ranking.fitted.get((probe.effect,)), self.ranking.base.linear
        sources = [model, beside, probe.linear]
        if base is not None and alone is not None and alone.fit.linear is not None:
            sources += [base, alone.fit.linear]
        key = (*start.effects, probe.effect)
        known = self._expected.get(key)
        if known is None or [*map(id, known[0])] != [*map(id, sources)]:
            pairs = zip(sources[1::2], sources[2::2], strict=True)
            forms = [effect_alone(*pair) for pair in pairs]
            moving = [f for f in forms if np.any(f.slopes) or np.any(f.residual)]
            fits = (expected(model, form) for form in moving)
            best = max(fits, key=lambda fit: fit.reduction - fit.chi2_priors, default=None)
            self._expected[key] = known = tuple(sources), best
        return known[1]

    def _ordered(self, proposals: Sequence[Proposal]) -> list[Proposal]:
        """What promises most first."""
        return sorted(proposals, key=lambda p: (self.predicted_criterion(p), p.effects))

    def predicted_criterion(self, p: Proposal, hopeful: bool = False) -> float:
        """The evidence that a model which nobody fitted is expected to have, its parameters within their bounds.

        Args:
            p: the model.
            hopeful: as good as it may come out: models are not linear, and what is known of parameters may be wrong.
        """
        start, fit = p.start, p.expected
        choice = self.ranking.search.model_space.cost(p.effects)
        criterion = start.evidence + choice + p.cost * start.penalty
        if hopeful:
            return criterion - (1 + CRITERIA.search.not_linear) * p.gain
        priors = fit.chi2_priors - start.fit.chi2_priors
        return criterion + priors - (1 - CRITERIA.search.not_linear) * p.gain

    def fit_request(self, p: Proposal) -> FitRequest:
        """A model to fit: from the fitted one, and the added effect as it was by itself, or as expected."""
        alone = self.ranking.fitted.get((p.effect,))
        values = alone.fit.values if alone else {}
        return FitRequest(p.effects, values | p.start.fit.values_and_starts, p.expected.values)
