"""The models that a search has fitted to the same runs, as a judgement compares them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.evidence import (
    NoiseScale,
    information_criterion,
    noise_scale,
    refuted_by_unfitted_signals,
)
from pam_cosim.diagnosis.judgement.model_space import ModelSpace
from pam_cosim.fitting import Fit

MOST_RIVALS = 4  # models that a run is designed for: six pairs


@dataclass(frozen=True)
class FittedModels:
    """Fitted models of one search.

    Attributes:
        base: the model without effects.
        family: family of every effect.
        model_space: what a choice among the effects costs.
        path: the models that add the effects that are needed one after another; empty where none is needed.
        tried: all models with effects.
    """

    base: Fit
    family: Mapping[str, str]
    model_space: ModelSpace
    path: tuple[Candidate, ...] = ()
    tried: tuple[Candidate, ...] = ()

    @property
    def last(self) -> Fit:
        """The model with all effects that are needed."""
        return self.path[-1].fit if self.path else self.base

    @cached_property
    def scale(self) -> NoiseScale:
        """Of the evidence: the noise as the best model leaves it."""
        return noise_scale([self.base, *(c.fit for c in self.tried)])

    def criterion(self, c: Candidate | None, scale: NoiseScale | None = None) -> float:
        """The information criterion of a model, None: of the base model; on ``scale`` unless another one is given."""
        fit, effects = (c.fit, c.effects) if c else (self.base, ())
        return information_criterion(fit, scale or self.scale, effects, self.model_space, c)

    def families(self, c: Candidate) -> frozenset[str]:
        """The families of a model's effects."""
        return frozenset(self.family[e] for e in c.effects)

    def best_of_each(self, models: Iterable[Candidate]) -> dict[frozenset[str], Candidate]:
        """The best model with each set of families, in the order of the models."""
        best: dict[frozenset[str], Candidate] = {}
        for c in models:
            families = self.families(c)
            if families not in best or self.criterion(c) < self.criterion(best[families]):
                best[families] = c
        return best

    @cached_property
    def of_other_families(self) -> list[Candidate]:
        """The models that lack a family of the answer: as few effects as the answer has are enough."""
        families_of_answer = self.families(self.path[-1])
        return [c for c in self.tried if not self.families(c) >= families_of_answer]

    def close_to_answer(self, models: Iterable[Candidate]) -> list[Candidate]:
        """The best model of each set of families, of those that are hardly worse than the answer; best first."""
        limit = self.criterion(self.path[-1]) + CRITERIA.evidence.very_strong
        close_models = (c for c in self.best_of_each(models).values() if self.criterion(c) < limit)
        return self.ordered(close_models)

    def first(self, models: Iterable[Candidate]) -> Candidate | None:
        """The best; None of none."""
        return next(iter(self.ordered(models)), None)

    def ordered(self, models: Iterable[Candidate]) -> list[Candidate]:
        """The best first."""
        return sorted(models, key=lambda c: (self.criterion(c), c.effects))

    @property
    def rivals(self) -> list[Candidate]:
        """Models of other families that the data hardly distinguish from the answer.

        Neither the evidence nor signals that were compared but not fitted may tell them apart. A general member is a
        rival of general members only, not of laws.
        """
        general = self.path[-1].has_general_member
        return self.close_to_answer(
            c
            for c in self.of_other_families
            if (general or not c.has_general_member) and not self.is_refuted(c)
        )

    def is_refuted(self, c: Candidate) -> bool:
        """Whether signals that were not fitted contradict a model, compared with the answer."""
        return refuted_by_unfitted_signals(c.fit, self.last)

    @property
    def nearest(self) -> list[Candidate]:
        """The models with most evidence, one of each set of families: what is left where each leaves structure."""
        fitted = self.best_of_each(c for c in self.tried if not c.brief).values()
        return self.ordered(fitted)[:MOST_RIVALS]
