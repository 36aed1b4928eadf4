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
from pam_cosim.diagnosis.search.ranking import AcceptanceThreshold, Ranking
from pam_cosim.diagnosis.search.search import FitRequest
from pam_cosim.fitting import Fit, Linear, bounded_step, coloured_deviance, reduction_by

_TINY = 1e-300  # keeps a quotient finite


class Start:
    """A fitted model that others start from, with what is the same for all of these.

    Args:
        fit: of the model.
        candidate: the model; None: the base model.
    """

    def __init__(self, fit: Fit, candidate: Candidate | None) -> None:
        self.fit, self.candidate = fit, candidate
        self.effects = candidate.effects if candidate else ()
        self._residuals = [
            (s.chi2, s.samples) for s in fit.residuals_beyond_uncertainty.values() if s.samples
        ]
        self._fitted_chi2 = max(fit.residuals["fit"].chi2, _TINY)
        self._evidence: dict[NoiseScale, tuple[float, float]] = {}
        self._deviance_of_rows: dict[NoiseScale, float] = {}

    def evidence(self, scale: NoiseScale) -> tuple[float, float]:
        """The evidence against it, but for how many sets of effects there are; and what a parameter costs."""
        if scale not in self._evidence:
            evidence = evidence_without_choice(self.fit, scale, self.candidate)
            self._evidence[scale] = evidence, scale.penalty(self.fit)
        return self._evidence[scale]

    def expected_gain(self, reduction: float, scale: NoiseScale, noise_floor: float) -> float:
        """What a reduction of the squared error counts: some of it is lost on the way, as models are not linear.

        The error of the other runs is expected to fall as that of the fitted ones does; neither falls below the noise.
        """
        share = 1 - (1 - CRITERIA.search.not_linear) * reduction / self._fitted_chi2
        after = [min(chi2, max(share * chi2, noise_floor * n)) for chi2, n in self._residuals]
        return (
            sum(now - then for (now, _), then in zip(self._residuals, after, strict=True))
            / scale.divisor
        )

    def coloured_gain(self, residual: Array, scale: NoiseScale) -> float:
        """What it counts, beside noise of any colour, that fitted runs leave a residual (m,), if others gain as much.

        In the rows of the linear model, in which a slow course counts for all samples that a row is the mean of.
        """
        linear, fitted = self.fit.linear, self.fit.residuals["fit"].samples
        assert linear is not None
        largest = scale.largest * max(fitted / len(residual), 1.0)
        if scale not in self._deviance_of_rows:
            self._deviance_of_rows[scale] = coloured_deviance(linear, linear.residual, largest)
        gain = self._deviance_of_rows[scale] - coloured_deviance(linear, residual, largest)
        return max(gain, 0.0) * sum(n for _, n in self._residuals) / fitted

    def own_gain(self, scale: NoiseScale, noise_floor: float) -> float:
        """What it counts that the model comes to where its own slopes promise."""
        linear = self.fit.linear
        if linear is None:
            return 0.0
        if scale.coloured:
            return self.coloured_gain(linear.residual - linear.slopes @ self._step, scale)
        return self.expected_gain(reduction_by(linear, self._step), scale, noise_floor)

    @cached_property
    def _step(self) -> Array:
        assert self.fit.linear is not None
        return bounded_step(self.fit.linear)


@dataclass(frozen=True)
class Proposal:
    """A model that nobody fitted: a fitted one with a further effect.

    Attributes:
        start: the fitted model.
        effect: the further effect; ``cost``: number of its parameters.
        forms: what it does by itself about some values of its parameters, where it was looked at and where it was
            fitted.
    """

    start: Start
    effect: str
    cost: int
    forms: tuple[Linear, ...]

    @property
    def effects(self) -> tuple[str, ...]:
        """All effects."""
        return (*self.start.effects, self.effect)

    @cached_property
    def expected(self) -> Expectation:
        """What it is expected to come to."""
        model = self.start.fit.linear
        assert model is not None
        fits = (expected(model, form) for form in self.forms)
        return max(fits, key=lambda fit: fit.reduction - fit.chi2_priors)


class PredictedEvidence:
    """What is known of effects beside the models so far.

    Args:
        ranking: the models.
    """

    def __init__(self, ranking: Ranking) -> None:
        self.ranking = ranking
        self._probes: dict[tuple[str, ...], tuple[Linear, dict[str, EffectProbe]]] = {}

    def note_probes(self, model: Candidate | None, probes: Sequence[EffectProbe]) -> None:
        """Takes note of what effects do beside a model, None: the base model, besides what was noted before."""
        effects, fit = (model.effects, model.fit) if model else ((), self.ranking.base)
        assert fit.linear is not None
        _, known = self._probes.setdefault(effects, (fit.linear, {}))
        known |= {p.effect: p for p in probes if p.effect not in self.ranking.search.undetectable}

    def probed_beside(self, effects: tuple[str, ...]) -> Collection[str]:
        """The effects that were looked at beside a model."""
        return self._probes[effects][1] if effects in self._probes else ()

    # ---- what may be better -----------------------------------------------------------------------------------

    def most_promising(self, count: int) -> list[Proposal]:
        """So many of the effects that promise most by themselves."""
        return self._ordered(self._with_one_more(None))[:count]

    def leading_families(self, c: Candidate, count: int) -> list[str]:
        """So many families of which a member promises most beside a model."""
        proposals = self._ordered(self._with_one_more(c))
        return list(dict.fromkeys(self.ranking.search.family[p.effect] for p in proposals))[:count]

    def promising_brief_fits(self) -> list[Candidate]:
        """Models that were fitted briefly and may be better than the best, or as good; the most promising ones."""
        possibly, noise_floor = self.ranking.optimistic_scale(), self.ranking.noise_floor()
        promising = []
        for c in self.ranking.fitted.values():
            if not c.brief:
                continue
            start = Start(c.fit, c)

            def at_end(scale: NoiseScale, c: Candidate = c, start: Start = start) -> float:
                gain = start.own_gain(scale, noise_floor)
                return self.ranking.information_criterion(c, scale) - gain

            thresholds = self.ranking.acceptance_thresholds(len(c.effects), possibly)
            if any(
                at_end(possibly) < threshold.criterion and self.ranking.may_be(threshold, c.effects)
                for threshold in thresholds
            ):
                promising.append((at_end(self.ranking.scale), c.effects))
        return [
            self.ranking.fitted[names] for _, names in sorted(promising)[: CRITERIA.search.together]
        ]

    def proposals(self, count: int) -> list[Proposal]:
        """Untried models of so many effects that may pass a threshold, the best of each set of families for each."""
        possibly, noise_floor = self.ranking.optimistic_scale(), self.ranking.noise_floor()
        tried = self.ranking.attempted | self.ranking.search.displaced
        untried = [
            p
            for start in self._starts(count)
            for p in self._with_one_more(start)
            if frozenset(p.effects) not in tried
        ]
        chosen: dict[tuple[str, ...], Proposal] = {}
        for threshold in self.ranking.acceptance_thresholds(count, possibly):
            passing = [p for p in untried if self._may_pass(p, threshold, possibly, noise_floor)]
            first: dict[frozenset[str], Proposal] = {}
            for p in self._ordered(passing):
                first.setdefault(self.ranking.search.families_of(p.effects), p)
            chosen |= {p.effects: p for p in [*first.values()][: CRITERIA.search.together]}
        return list(chosen.values())

    def _may_pass(
        self, p: Proposal, threshold: AcceptanceThreshold, scale: NoiseScale, noise_floor: float
    ) -> bool:
        """Whether a model may come to what is asked of it."""
        reference = threshold.reference
        return (
            self.ranking.may_be(threshold, p.effects)
            and (reference is None or _expects_large_reduction(reference, p, noise_floor))
            and self.predicted_criterion(p, noise_floor, scale) <= threshold.criterion
        )

    def _starts(self, count: int) -> Sequence[Candidate | None]:
        """The fitted models that those of so many effects are predicted from."""
        if count == 1:
            return [None]
        if not self.ranking.unsolved():
            return [c for c in self.ranking.with_one_less() if len(c.effects) == count - 1]
        return [c for c in self.ranking.parents() if len(c.effects) == count - 1]

    def _with_one_more(self, c: Candidate | None) -> list[Proposal]:
        """A model, None: the base model, with each effect of another family: as looked at beside it, or by itself."""
        start, search = Start(c.fit if c else self.ranking.base, c), self.ranking.search
        if start.fit.linear is None:
            return []
        forms: dict[str, tuple[Linear, ...]] = {}
        for effects in dict.fromkeys([(), start.effects]):
            beside, probes = self._probes.get(effects, (start.fit.linear, {}))
            for name, probe in probes.items():
                forms[name] = (effect_alone(beside, probe.linear, probe.own_parameters),)
                alone = self.ranking.fitted.get((name,))
                if not effects and alone is not None and alone.fit.linear is not None:
                    base = self.ranking.base.linear
                    assert base is not None
                    own = effect_alone(base, alone.fit.linear, probe.own_parameters)
                    forms[name] = (*forms[name], own)
        taken = search.families_of(start.effects)
        return [
            Proposal(start, name, search.cost[name], of_effect)
            for name, of_effect in forms.items()
            if search.family[name] not in taken
            and any(np.any(form.slopes) or np.any(form.residual) for form in of_effect)
        ]

    def _ordered(self, proposals: Sequence[Proposal]) -> list[Proposal]:
        """What promises most first."""
        noise_floor, scale = self.ranking.noise_floor(), self.ranking.scale
        return sorted(
            proposals,
            key=lambda p: (self.predicted_criterion(p, noise_floor, scale), p.effects),
        )

    # ---- the numbers ------------------------------------------------------------------------------------------

    def predicted_criterion(self, p: Proposal, noise_floor: float, scale: NoiseScale) -> float:
        """The evidence that a model which nobody fitted is expected to have, its parameters within their bounds.

        Args:
            p: the model.
            noise_floor: mean square of the noise.
            scale: the scale.
        """
        (evidence, penalty), fit = p.start.evidence(scale), p.expected
        choice = self.ranking.search.model_space.cost(p.effects)
        priors = fit.chi2_priors - p.start.fit.chi2_priors
        criterion = evidence + choice + p.cost * penalty + priors
        if scale.coloured:
            return criterion - p.start.coloured_gain(fit.residual, scale)
        return criterion - p.start.expected_gain(fit.reduction, scale, noise_floor)

    def fit_request(self, p: Proposal) -> FitRequest:
        """A model to fit: from the fitted one, and the added effect as it was by itself, or as expected."""
        alone = self.ranking.fitted.get((p.effect,))
        values = alone.fit.values if alone else {}
        return FitRequest(p.effects, values | p.start.fit.values_and_starts, p.expected.values)


def _expects_large_reduction(best: Candidate, p: Proposal, noise_floor: float) -> bool:
    """Whether a model is expected to leave much less than a best one does, which leaves structure."""
    best_residuals, start_residuals = best.fit.residuals["fit"], p.start.fit.residuals["fit"]
    excess = best_residuals.chi2 - noise_floor * best_residuals.samples
    expected_excess = (
        start_residuals.chi2 - p.expected.reduction - noise_floor * start_residuals.samples
    )
    return expected_excess < CRITERIA.search.step * excess
