"""What models that nobody fitted, or not to the end, promise: their evidence, as far as linear algebra tells."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from math import log
from typing import NamedTuple

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.evidence import NoiseScale, evidence_without_choice
from pam_cosim.diagnosis.search.expectation import (
    Additions,
    EffectDirections,
    LinearisedNeighbourhood,
    PredictedModel,
    addition,
)
from pam_cosim.diagnosis.search.probing import EffectProbe
from pam_cosim.diagnosis.search.ranking import AcceptanceThreshold, Ranking
from pam_cosim.diagnosis.search.search import FitRequest
from pam_cosim.fitting import Fit, Linear, bounded_step, coloured_deviance, reduction_by

_TINY = 1e-300  # keeps a logarithm off nought


def _white_deviance(chi2: float, samples: float, scale: NoiseScale) -> float:
    """Of residuals as white noise that is no larger than noise may be."""
    variance = min(max(chi2, _TINY) / samples, scale.largest)
    return samples * log(variance) + chi2 / variance


class Start:
    """A fitted model that others start from, with what is the same for all of these.

    Args:
        fit: of the model.
        candidate: the model; None: the base model.
    """

    def __init__(self, fit: Fit, candidate: Candidate | None) -> None:
        self.fit, self.candidate = fit, candidate
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

    def expected_gain(
        self,
        reduction: float,
        scale: NoiseScale,
        noise_floor: float,
        lost: float = CRITERIA.search.not_linear,
    ) -> float:
        """What a reduction of the squared error counts: some of it is lost on the way, as models are not linear.

        The error of the other runs is expected to fall as that of the fitted ones does; neither falls below the noise.
        """
        share = 1 - (1 - lost) * reduction / self._fitted_chi2
        after = [min(chi2, max(share * chi2, noise_floor * n)) for chi2, n in self._residuals]
        if scale.coloured:
            # as if no colour made up for what is gone
            pairs = zip(self._residuals, after, strict=True)
            return sum(
                _white_deviance(now, n, scale) - _white_deviance(then, n, scale)
                for (now, n), then in pairs
            )
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


class Proposal(NamedTuple):
    """A model that nobody fitted: from which one it starts, and what is expected of it."""

    start: Start
    prediction: PredictedModel


class PredictedEvidence:
    """What is known of effects beside the models so far.

    Args:
        ranking: the models.
    """

    def __init__(self, ranking: Ranking) -> None:
        self.ranking = ranking
        self._base_probes: list[EffectProbe] = []
        self._probed_beside_base = ranking.base.linear
        self._probes_beside: dict[tuple[str, ...], dict[str, EffectDirections]] = {}
        self._base_additions: tuple[list[Fit | None], Additions] | None = None
        self._merged: dict[tuple[str, ...], tuple[Additions, int, Additions]] = {}
        self._starts: dict[tuple[str, ...], Start] = {}
        self._neighbourhoods: dict[
            tuple[str, ...], tuple[Linear, Additions, LinearisedNeighbourhood]
        ] = {}

    # ---- what was looked at -----------------------------------------------------------------------------------

    def note_probes(self, probes: Sequence[EffectProbe]) -> None:
        """Takes note of what effects do beside the base model, of all that were looked at there just now."""
        self._base_probes = [p for p in probes if p.effect not in self.ranking.search.undetectable]
        self._probed_beside_base = self.ranking.base.linear

    def note_probes_beside(self, c: Candidate, probes: Sequence[EffectProbe]) -> None:
        """Takes note of what effects do beside another model, besides those that were looked at there before."""
        assert c.fit.linear is not None
        directions = self._probes_beside.setdefault(c.effects, {})
        directions |= {a.effect: a for p in probes if (a := addition(c.fit.linear, p)) is not None}

    def probed_beside(self, effects: tuple[str, ...]) -> Mapping[str, EffectDirections]:
        """The effects that were looked at beside a model."""
        return self._probes_beside.get(effects, {})

    # ---- what may be better -----------------------------------------------------------------------------------

    def most_promising(self, count: int) -> list[PredictedModel]:
        """So many of the effects that promise most by themselves."""
        return self._single_additions(None)[:count]

    def leading_families(self, c: Candidate, count: int) -> list[str]:
        """So many families of which a member promises most beside a model."""
        families = (self.ranking.search.family[e.added.effect] for e in self._single_additions(c))
        return list(dict.fromkeys(families))[:count]

    def _single_additions(self, c: Candidate | None) -> list[PredictedModel]:
        """One further effect beside a fitted model, None: the base model; what promises most first."""
        start = self._start(c)
        assert start.fit.linear is not None
        noise_floor, scale = self.ranking.noise_floor(), self.ranking.scale
        models = self._neighbourhood(c.effects if c else (), start.fit.linear).with_one
        return sorted(
            models,
            key=lambda e: (
                self.predicted_criterion(Proposal(start, e), noise_floor, scale),
                e.effects,
            ),
        )

    def promising_brief_fits(self) -> list[Candidate]:
        """Models that were fitted briefly and may be better than the best, or as good; the most promising ones."""
        possibly, noise_floor = self.ranking.optimistic_scale(), self.ranking.noise_floor()
        brief = [c for c in self.ranking.fitted.values() if c.brief]
        thresholds = {
            n: self.ranking.acceptance_thresholds(n, possibly)
            for n in {len(c.effects) for c in brief}
        }
        promising = [
            (self._optimistic_criterion(c, self.ranking.scale, noise_floor), c.effects)
            for c in brief
            if self._may_be_accepted(
                c, thresholds[len(c.effects)], self._optimistic_criterion(c, possibly, noise_floor)
            )
        ]
        return [
            self.ranking.fitted[names] for _, names in sorted(promising)[: CRITERIA.search.together]
        ]

    def _may_be_accepted(
        self, c: Candidate, thresholds: Sequence[AcceptanceThreshold], hope: float
    ) -> bool:
        """Whether one that was fitted briefly may be of interest, with the evidence that it is hoped to have."""
        return any(
            hope < threshold.fitted and self.ranking.may_be(threshold, c.effects)
            for threshold in thresholds
        )

    def proposals(self, count: int) -> list[Proposal]:
        """Untried models of so many effects that may pass a threshold, the best of each set of families for each."""
        possibly, noise_floor, tried = (
            self.ranking.optimistic_scale(),
            self.ranking.noise_floor(),
            self.ranking.attempted | self.ranking.search.displaced,
        )
        untried = [p for p in self._expected(count) if p.prediction.set_of_effects not in tried]
        chosen: dict[tuple[str, ...], Proposal] = {}
        for threshold in self.ranking.acceptance_thresholds(count, possibly):
            passing = [p for p in untried if self._may_pass(p, threshold, possibly, noise_floor)]
            best = self._first_of_families(passing)
            if possibly.coloured:
                best = [
                    p
                    for p in best
                    if self.predicted_criterion(p, noise_floor, possibly) <= threshold.criterion
                ]
            chosen |= {p.prediction.effects: p for p in best}
        return list(chosen.values())

    def _families_of(self, p: Proposal) -> frozenset[str]:
        return self.ranking.search.families_of(p.prediction.effects)

    def _first_of_families(self, promises: Sequence[Proposal]) -> list[Proposal]:
        """The most promising ones, one of each set of families."""
        noise_floor, scale = self.ranking.noise_floor(), self.ranking.scale
        possible = [
            (self.lowest_criterion(p, noise_floor, scale), n) for n, p in enumerate(promises)
        ]
        by_families: dict[frozenset[str], tuple[float, Proposal]] = {}
        for hope, n in sorted(
            possible, key=lambda entry: (entry[0], promises[entry[1]].prediction.effects, entry[1])
        ):
            first = sorted(h for h, _ in by_families.values())[: CRITERIA.search.together]
            if len(first) == CRITERIA.search.together and hope > first[-1]:
                break  # no further one can be as good as these
            p = promises[n]
            criterion = self.predicted_criterion(p, noise_floor, scale)
            families = self._families_of(p)
            if families not in by_families or criterion < by_families[families][0]:
                by_families[families] = (criterion, p)
        ordered = sorted(
            by_families.values(), key=lambda entry: (entry[0], entry[1].prediction.effects)
        )
        return [p for _, p in ordered[: CRITERIA.search.together]]

    def _may_pass(
        self, p: Proposal, threshold: AcceptanceThreshold, scale: NoiseScale, noise_floor: float
    ) -> bool:
        """Whether a model may come to what is asked of it."""
        if not self.ranking.may_be(threshold, p.prediction.effects):
            return False
        reference = threshold.reference
        if reference is not None and not self._expects_large_reduction(reference, p, noise_floor):
            return False
        return self.lowest_criterion(p, noise_floor, scale) <= threshold.criterion

    def _expected(self, count: int) -> Iterator[Proposal]:
        """Models of so many effects, from those that were fitted with one less."""
        first, unsolved = CRITERIA.search.starts, self.ranking.unsolved()
        lacking = self.ranking.with_one_less()
        leading = [*self.ranking.parents(), *self.ranking.models(count - 1)[:first]]
        if unsolved:
            leading += self.ranking.models(count - 1, specific=True)[:first]
        fitted = {c.effects: c for c in (*leading, *lacking.values())}
        starts: list[Candidate | None] = [
            c
            for effects, c in fitted.items()
            if len(effects) == count - 1 and (unsolved or effects in lacking)
        ]
        for c in starts if count > 1 else [None]:
            start = self._start(c)
            if start.fit.linear is not None:
                models = self._neighbourhood(c.effects if c else (), start.fit.linear).with_one
                yield from (Proposal(start, e) for e in models)

    @staticmethod
    def _expects_large_reduction(best: Candidate, p: Proposal, noise_floor: float) -> bool:
        """Whether a model is expected to leave much less than a best one does, which leaves structure."""
        best_residuals, start_residuals = best.fit.residuals["fit"], p.start.fit.residuals["fit"]
        excess = best_residuals.chi2 - noise_floor * best_residuals.samples
        expected_excess = (
            start_residuals.chi2 - p.prediction.reduction - noise_floor * start_residuals.samples
        )
        return expected_excess < CRITERIA.search.step * excess

    # ---- the numbers ------------------------------------------------------------------------------------------

    def predicted_criterion(self, p: Proposal, noise_floor: float, scale: NoiseScale) -> float:
        """The evidence that a model which nobody fitted is expected to have, its parameters within their bounds.

        Args:
            p: the model.
            noise_floor: mean square of the noise.
            scale: the scale.
        """
        start, fit = p.start, p.prediction.within_bounds
        criterion = self._without_reduction(p, scale) + (fit.chi2_priors - start.fit.chi2_priors)
        if scale.coloured:
            return criterion - start.coloured_gain(fit.residual, scale)
        return criterion - start.expected_gain(fit.reduction, scale, noise_floor)

    def lowest_criterion(self, p: Proposal, noise_floor: float, scale: NoiseScale) -> float:
        """The same if effects were free to bend, and nothing of the reduction were lost on the way."""
        reduction = p.prediction.reduction
        gain = p.start.expected_gain(reduction, scale, noise_floor, lost=0.0)
        return self._without_reduction(p, scale) - gain

    def _without_reduction(self, p: Proposal, scale: NoiseScale) -> float:
        """The evidence against a model that leaves what the one leaves from which it starts."""
        evidence, penalty = p.start.evidence(scale)
        choice = self.ranking.search.model_space.cost(p.prediction.effects)
        return evidence + choice + p.prediction.added.cost * penalty

    def _optimistic_criterion(self, c: Candidate, scale: NoiseScale, noise_floor: float) -> float:
        """The evidence of a candidate that was fitted briefly, if all goes as its slopes say."""
        gain = self._start(c).own_gain(scale, noise_floor)
        return self.ranking.information_criterion(c, scale) - gain

    def fit_request(self, e: PredictedModel) -> FitRequest:
        """A model to fit: from the fitted one, and the added effect as it was by itself, or as expected."""
        alone = self.ranking.fitted.get((e.added.effect,))
        values = alone.fit.values if alone else {}
        effects = e.beside.effects
        start = self.ranking.fitted[effects].fit if effects else self.ranking.base
        return FitRequest(e.effects, values | start.values_and_starts, e.within_bounds.values)

    def _start(self, c: Candidate | None) -> Start:
        """A fitted model to start from; None: the base model."""
        effects, fit = (c.effects, c.fit) if c else ((), self.ranking.base)
        start = self._starts.get(effects)
        if start is None or start.fit is not fit or start.candidate is not c:
            self._starts[effects] = start = Start(fit, c)
        return start

    def _additions(self) -> Additions:
        """What the effects can add to the base model, as far as probes and fits tell by now."""
        base, probed_beside = self.ranking.base, self._probed_beside_base
        assert base.linear is not None and probed_beside is not None
        alone = [self.ranking.fitted.get((p.effect,)) for p in self._base_probes]
        fits = [base, *(c.fit if c else None for c in alone)]
        cached = self._base_additions
        if cached is None or [*map(id, cached[0])] != [*map(id, fits)]:
            directions = [
                addition(probed_beside, p, (base.linear, f.linear) if f and f.linear else None)
                for p, f in zip(self._base_probes, fits[1:], strict=True)
            ]
            additions = Additions(
                [a for a in directions if a is not None], len(base.linear.residual)
            )
            self._base_additions = cached = (fits, additions)
        return cached[1]

    def _neighbourhood(self, effects: tuple[str, ...], linear: Linear) -> LinearisedNeighbourhood:
        """What can be added to a fitted model: as looked at beside it, or else as by itself."""
        additions, probed = self._additions(), self._probes_beside.get(effects)
        if probed:
            merged = self._merged.get(effects)
            if merged is None or merged[0] is not additions or merged[1] != len(probed):
                by_effect = {a.effect: a for a in additions.directions} | probed
                all_additions = Additions([*by_effect.values()], len(linear.residual))
                self._merged[effects] = merged = (additions, len(probed), all_additions)
            additions = merged[2]
        cached = self._neighbourhoods.get(effects)
        if cached is None or cached[0] is not linear or cached[1] is not additions:
            neighbourhood = LinearisedNeighbourhood(
                effects, linear, self.ranking.search.family, additions
            )
            self._neighbourhoods[effects] = cached = (linear, additions, neighbourhood)
        return cached[2]
