"""Which effects a model needs: forwards from the base model, downwards from a model of every family, and small moves.

One number orders all models (``diagnosis.ranking``): the information criterion, of a model that was fitted as it is, of
one that was not, or not to the end, as far as linear algebra predicts it (``diagnosis.predicted_evidence``). Single
effects are tried first, to the end where one may be enough. Where the best of them leaves structure, models with a
member of every family supply further sets of effects (``diagnosis.full_model``). From the best of both, single effects
are exchanged for others of their family, left out and added, until none of it pays.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Any

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.events import Remark
from pam_cosim.diagnosis.judgement.evidence import may_have_structure
from pam_cosim.diagnosis.search.predicted_evidence import PredictedEvidence
from pam_cosim.diagnosis.search.probing import EffectProbe
from pam_cosim.diagnosis.search.ranking import Ranking
from pam_cosim.diagnosis.search.search import FitRequest, Search
from pam_cosim.diagnosis.search.search_result import SearchResult
from pam_cosim.diagnosis.search.searches import one_by_one
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting import Fit


def select_effects(search: Search, base: Fit) -> SearchResult:
    """The effects that are needed.

    Args:
        search: tries effects, and ends where its effort is spent; only what the answer needs is fitted then.
        base: the model without them, fitted, with its linear model.

    Raises:
        SimulationFailure: no effect could be tried at all.
    """
    if not any(may_have_structure(s) for s in base.residuals_beyond_uncertainty.values()):
        search.say(Remark("what remains is noise: no effect is tried").message)
        return SearchResult(base, search.family, search.model_space, search=search)
    models = _Models(search, base)
    models.probe()
    models.try_single(CRITERIA.search.first_tried)
    if models.one_may_be_enough():
        models.improve(1)
    if models.ranking.unsolved() or models.has_general_answer():
        models.try_full_models()
    models.try_further_single(2 * CRITERIA.search.first_tried)
    models.improve(1)
    models.refine()
    path = tuple(models.path())
    return models.result(
        path=path,
        tried=tuple(c.without_slopes for c in models.fitted.values()),
        untried=tuple(models.untried),
        probes=tuple(models.probes),
    )


_FEW = 3  # effects of a model that is fitted in no time: all moves are tried


class _Models:
    """All models so far, by their effects."""

    def __init__(self, search: Search, base: Fit) -> None:
        self.fitted: dict[tuple[str, ...], Candidate] = {}
        self.ranking = Ranking(search, base, self.fitted)
        self.predicted = PredictedEvidence(self.ranking)
        self.untried: list[tuple[str, ...]] = []
        self.probes: list[EffectProbe] = []
        self._left, self._count = math.inf, 0  # by the leading model, with so many effects

    @property
    def search(self) -> Search:
        """What the models are chosen from."""
        return self.ranking.search

    @property
    def base(self) -> Fit:
        """The model without effects."""
        return self.ranking.base

    def result(self, **found: Any) -> SearchResult:
        """The result with the fields that were found."""
        search = self.search
        return SearchResult(self.base, search.family, search.model_space, search=search, **found)

    def probe(self) -> None:
        """What each effect does beside the base model, those first that stand for their families."""
        broad = self.search.family_representatives
        names = [*broad, *(e.name for e in self.search.available_effects if e.name not in broad)]
        self.probes += self.search.probe(self.base, (), names)
        seen = {p.effect for p in self.probes} | {f.effect for f in self.search.failed}
        seen.update(*self.search.displaced)
        self._is_effort_spent([(name,) for name in names if name not in seen])
        if self.search.failed and not self.probes:
            failed = self.search.failed[-1]
            raise SimulationFailure(f"no effect could be tried; {failed.effect}: {failed.failure}")
        if self.search.data.is_static:  # what shows in time alone does so beside no effect
            idle = {p.effect: p.idle_parameters for p in self.probes if not p.silent}
            silent = frozenset(p.effect for p in self.probes if p.silent)
            self.ranking.search = replace(
                self.search, undetectable=silent, inactive_parameters=idle
            )
        self.predicted.note_probes(None, self.probes)

    def _probe_further(self, best: Candidate) -> None:
        """What further families do beside a model: beside the base model the same parameters may do something else.

        Those that stand for their families are looked at first, then all members of the families that promise most.
        """
        family = self.search.family
        taken = {family[name] for name in best.effects}
        broad = [n for n in self.search.family_representatives if family[n] not in taken]
        self._probe_beside(best, broad)
        leading = self.predicted.leading_families(best, CRITERIA.search.leading_families)
        self._probe_beside(best, [e for f in leading for e in self._members(f)])

    def _probe_beside(self, best: Candidate, effects: Sequence[str]) -> None:
        seen = self.predicted.probed_beside(best.effects)
        names = [name for name in effects if name not in seen]
        if names and not self._is_effort_spent([(*best.effects, name) for name in names]):
            self.predicted.note_probes(best, self.search.probe(best.fit, best.effects, names))

    def try_single(self, count: int) -> None:
        """So many of the effects that promise most by themselves, a few steps, whatever the effort."""
        self._record(self.search.fit_briefly(self._single(count)))

    def try_further_single(self, count: int) -> None:
        """The same, more of them, where the best leaves structure and no model with several effects leads."""
        leading = self._leading()
        if self.ranking.unsolved() and (leading is None or len(leading.effects) == 1):
            self._try(self._single(count))

    def _single(self, count: int) -> list[FitRequest]:
        return [self.predicted.fit_request(e) for e in self.predicted.most_promising(count)]

    def one_may_be_enough(self) -> bool:
        """Whether a few steps bring a model with one effect near the noise."""
        far = CRITERIA.residuals.far_above
        return any(c.fit.residuals["fit"].chi2_reduced < far for c in self.fitted.values())

    def _is_effort_spent(self, chosen: Sequence[tuple[str, ...]]) -> bool:
        """Whether the effort is spent, or no hope is left; then what would have come next is noted."""
        if not (self.search.effort.spent or self.search.effort.hopeless):
            return False
        self.untried += [names for names in chosen if names not in self.untried]
        self.ranking.effort_spent = True
        return True

    def set_outliers_aside(self) -> None:
        """What is an outlier beside the best model does not count; what only was one beside a worse model does."""
        best = self.ranking.best()
        if best is None:
            return
        before, self.ranking.search = self.search, self.search.without_outliers(best.fit)
        if self.search is not before:
            data = self.search.data
            self.ranking.base = self.base.against(data)
            for names, c in self.fitted.items():
                self.fitted[names] = replace(c, fit=c.fit.against(data))
            self.ranking.update()

    def has_general_answer(self) -> bool:
        """Whether a general member leads, which may say what several laws say together."""
        best = self.ranking.best()
        return best is not None and best.has_general_member

    def try_full_models(self) -> None:
        """The effects that models with a member of every family need, fitted without the others."""
        first = [
            p.effect for p in self.predicted.most_promising(len(self.search.available_effects))
        ]
        if self._is_effort_spent([]):
            return
        full_models = [f for f in self.search.full_models(self.base, first) if f.effects]
        for full in sorted(full_models, key=lambda f: f.misfit)[:1]:
            self._try([FitRequest(full.effects, full.values)])
            self._reduce(full.effects)

    def _reduce(self, effects: tuple[str, ...]) -> None:
        """From a model of very many effects to one of as many as an explanation may have.

        Other members are tried in the place of each leading effect before any is left out: what a wrong member leaves
        is taken up by others.
        """
        first = self.fitted.get(effects)
        if first is None or self._is_effort_spent([]):
            return
        leading = self.search.reduced(first, CRITERIA.search.together).effects
        best = self._best_of([effects, *self._exchange_members(first, leading)])
        while best is not None and len(best.effects) > CRITERIA.search.most_effects:
            count = max(CRITERIA.search.most_effects, len(best.effects) - CRITERIA.search.together)
            fewer = self.search.reduced(best, count)
            self._try([fewer])
            best = self.fitted.get(fewer.effects)
        for names in [n for n in self.fitted if len(n) > CRITERIA.search.most_effects]:
            del self.fitted[names]  # they only led the way
        self.ranking.update()
        self._finish_best()

    def refine(self) -> None:
        """Small moves from the leading model, until none of them pays.

        An effect is exchanged for another of its family, left out, or added. What is
        predicted of a set comes from slopes; an effect may have been chosen beside others that need it no more, or that
        need another one, once they are fitted together. Of many effects a fit takes long: fewer moves have to do.
        """
        refined, exchanged = set[frozenset[str]](), False
        while (best := self._leading()) is not None and frozenset(best.effects) not in refined:
            if self._is_effort_spent([]):
                return
            refined.add(frozenset(best.effects))
            self.set_outliers_aside()
            few = len(best.effects) <= _FEW
            if few or not exchanged:
                exchanged = not few
                self._exchange_members(best)
                self._try(self._requests(best, self.search.simpler_laws(best)))
            self._finish_promising(best)
            self._leave_out(best)
            if not self._leads(best):
                continue
            if few:
                self.improve(len(best.effects))
            if self._leads(best) and self.ranking.has_structure(self.fitted[best.effects]):
                self._add_one(self.fitted[best.effects])
            if not few and self._leads(best):
                self._try(self._requests(best, _each_left_out(best)))

    def _finish_promising(self, best: Candidate) -> None:
        """Fits to the end what may be better than a model after a few steps; of many effects what is best then."""
        if len(best.effects) <= _FEW:
            self.improve(len(best.effects))
        else:
            self._finish_best()

    def _finish_best(self) -> None:
        """Fits to the end what is best after a few steps, if it may lead."""
        best = self.ranking.models.first(self.fitted.values())
        if best is not None and best.brief:
            self._finish_within_effort([best])

    @staticmethod
    def _requests(best: Candidate, sets: Iterable[tuple[str, ...]]) -> list[FitRequest]:
        """Sets of effects, to be fitted from where a model stands."""
        return [FitRequest(effects, best.fit.values_and_starts) for effects in sets]

    def _leading(self) -> Candidate | None:
        """The model to go on from: the answer, or what leaves least while nothing beats the base model."""
        return self.ranking.answer() or self.ranking.leader()

    def _leads(self, c: Candidate) -> bool:
        """Whether a model still is the one to go on from, perhaps after another fit."""
        leading = self._leading()
        return leading is not None and leading.effects == c.effects

    def _exchange_members(
        self, best: Candidate, leading: Sequence[str] | None = None
    ) -> list[tuple[str, ...]]:
        """Tries other members of its family in the place of each effect, and the best of all of them together.

        Where the model leaves noise, only members with fewer parameters; among many effects, only plain ones. The
        general member of a family is tried where the law leaves more than noise, if ever so little.

        Args:
            best: the model.
            leading: the effects that are exchanged; None: all.

        Returns:
            the sets of effects.
        """
        few, cost = len(best.effects) <= _FEW, self.search.cost
        structured = self.ranking.has_structure(best)
        plain = max(cost.values()) if few else CRITERIA.search.combined_parameters
        open_form = any(map(may_have_structure, best.fit.residuals_beyond_uncertainty.values()))
        forms = {
            name: [
                effects
                for e, effects in self._other_forms(best.effects, name).items()
                if cost[e] <= plain
                and (open_form if e in self.search.general else structured or cost[e] < cost[name])
            ]
            for name in (best.effects if leading is None else leading)
        }
        sets_tried = [effects for sets in forms.values() for effects in sets]
        self._try(self._requests(best, sets_tried))
        first = {name: self._best_of([best.effects, *sets]) for name, sets in forms.items()}
        better = {
            name: c for name, c in first.items() if c is not None and c.effects != best.effects
        }
        if len(better) > 1:
            member = {name: c.effect for name, c in better.items()}
            values = {n: v for c in better.values() for n, v in c.fit.values.items()}
            together = tuple(member.get(name, name) for name in best.effects)
            self._try([FitRequest(together, values | best.fit.values_and_starts)])
            sets_tried.append(together)
        return sets_tried

    def _best_of(self, sets: Sequence[tuple[str, ...]]) -> Candidate | None:
        """The best of some sets of effects that were fitted."""
        candidates = (c for effects in sets if (c := self.fitted.get(effects)) is not None)
        return self.ranking.models.first(candidates)

    def _leave_out(self, best: Candidate) -> None:
        """The model without each of its effects; to the end where that decides whether the effect matters.

        Of many effects the one is left out that is needed least.
        """
        few = len(best.effects) <= _FEW + 1  # those that are fitted have one less
        each = self._requests(best, filter(None, _each_left_out(best)))
        requests = each if few else [self.search.reduced(best, len(best.effects) - 1)]
        if not requests or self._is_effort_spent([]):
            return
        self._record(self.search.fit_briefly(requests))
        sets = [request.effects for request in requests]
        less = [c for s in sets if (c := self.fitted.get(s)) is not None]
        small = [c for c in less if not self.ranking.matters(best, c, 2.0)]
        self._finish_within_effort([c for c in small if c.brief])
        nearest = self._best_of(sets)
        if nearest is not None and few:  # other members may say what they do not
            self._exchange_members(nearest)
        self._finish_promising(nearest or best)

    def _add_one(self, best: Candidate) -> None:
        """One more effect beside the model."""
        count = len(best.effects) + 1
        if count > CRITERIA.search.most_effects:
            return
        self._probe_further(best)
        if count <= _FEW:
            self.improve(count)
            return
        proposed = self.predicted.proposals(count)
        self._try([self.predicted.fit_request(p) for p in proposed])
        self._finish_best()

    def _other_forms(self, effects: Sequence[str], name: str) -> dict[str, tuple[str, ...]]:
        """By member of its family, the effects with that member, the last, in the place of one of them."""
        kept = _without(effects, name)
        return {e: (*kept, e) for e in self._members(self.search.family[name]) if e != name}

    def _members(self, family: str) -> Iterator[str]:
        """The effects of a family that can show."""
        return (
            e.name
            for e in self.search.available_effects
            if e.family == family and e.name not in self.search.undetectable
        )

    def _try(self, models: Sequence[FitRequest]) -> None:
        """Fits models briefly that nobody tried."""
        seen = self.ranking.attempted
        untried = [w for w in models if frozenset(w.effects) not in seen]
        if untried and not self._is_effort_spent([w.effects for w in untried]):
            self._record(self.search.fit_briefly(untried))

    def improve(self, count: int) -> None:
        """Fits models with so many effects, as long as some may be better than the best, or as good.

        A few steps those that nobody tried, and to the end those that still promise it then.
        """
        if self.ranking.effort_spent:  # what would come next was noted when it was
            return
        for _ in range(CRITERIA.search.rounds):
            brief = self.predicted.promising_brief_fits()
            needed = not brief or self.search.effort.spent
            chosen = self.predicted.proposals(count) if needed else []
            if not (brief or chosen) or self._is_effort_spent(
                [*(c.effects for c in brief), *(e.effects for e in chosen)]
            ):
                break
            self._finish(brief)
            if not brief:
                self._record(
                    self.search.fit_briefly([self.predicted.fit_request(e) for e in chosen])
                )

    def _finish_within_effort(self, brief: Sequence[Candidate]) -> None:
        """The same as ``_finish``, unless the effort is spent."""
        if brief and not self._is_effort_spent([c.effects for c in brief]):
            self._finish(brief)

    def _finish(self, brief: Sequence[Candidate]) -> None:
        """Fits models to the end that were fitted briefly."""
        self._record(self.search.fit_completely(brief, self.base))
        for c in brief:  # whatever came of it, it is not brief any more
            self.fitted[c.effects] = replace(self.fitted[c.effects], brief=False)

    def path(self) -> list[Candidate]:
        """The best model's effects, added one after another; none if the best is no better than the base model.

        A model that breaks down at the accuracy of the verdict makes place for the next best.
        """
        finished = set[tuple[str, ...]]()
        while (best := self.ranking.answer()) is not None:
            models = self._one_by_one(best)
            if not models or {*models[-1].effects} != {*best.effects}:
                del self.fitted[best.effects]
                self.ranking.update()
                continue
            answer = self.ranking.answer()  # one of the models on the way may turn out to be enough
            if best.effects in finished or answer is None or {*answer.effects} == {*best.effects}:
                return [c.without_slopes for c in models]
            finished.add(best.effects)
        return []

    def _one_by_one(self, best: Candidate) -> list[Candidate]:
        effects = best.effects if len(best.effects) <= _FEW else self.search.by_need(best)
        start = best.fit.values_and_starts
        models = one_by_one(self.search, self.base, effects, start, self.fitted)
        self.ranking.update()
        return models

    def _record(self, candidates: Sequence[Candidate]) -> None:
        """Keeps the better fit of each model; one to the end began where the brief one stood, and is more exact."""
        for c in candidates:
            old = self.fitted.get(c.effects)
            to_the_end = old is not None and old.brief and not c.brief
            if old is None or to_the_end or c.fit.chi2_minimised <= old.fit.chi2_minimised:
                self.fitted[c.effects] = c
        self.ranking.update()
        self._note_progress()

    def _note_progress(self) -> None:
        """Takes note where the leading model leaves visibly less than before, or needs fewer effects."""
        leader = self.ranking.leader()
        left = (leader.fit if leader else self.base).residuals["fit"].excess
        count = len(leader.effects) if leader else 0
        if left < (1 - CRITERIA.evidence.visible) * self._left or count < self._count:
            self.search.effort.note_progress()
        self._left, self._count = min(left, self._left), count


def _each_left_out(c: Candidate) -> list[tuple[str, ...]]:
    """The effects of a model without each of them."""
    return [_without(c.effects, name) for name in c.effects]


def _without(effects: Sequence[str], name: str) -> tuple[str, ...]:
    """The effects but for one."""
    return tuple(e for e in effects if e != name)
