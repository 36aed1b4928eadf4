"""Which effects a model needs: the models that promise most are fitted, until none is left that may be better.

One number orders all models (``diagnosis.ranking``): the evidence, of a model that was fitted as it is, of one that was
not, or not to the end, as far as linear algebra tells (``diagnosis.promise``). Whoever may still beat the best is
fitted next: single effects first; where the best of them leaves structure, pairs; then triples, for which effects are
looked at again beside the best models. What is made of more effects but of fewer parameters is asked for as well.
"""

from __future__ import annotations

import math
import time
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.candidate import Candidate
from pam_cosim.diagnosis.events import NothingTried, StepsSought
from pam_cosim.diagnosis.evidence import any_structure_for_search, evidence, may_have_structure, rank, scale
from pam_cosim.diagnosis.predicted_evidence import PredictedEvidence
from pam_cosim.diagnosis.probing import EffectProbe
from pam_cosim.diagnosis.ranking import Ranking
from pam_cosim.diagnosis.search import Search, Wanted
from pam_cosim.diagnosis.step_times import Retimed
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting import Fit


@dataclass(frozen=True)
class Selection:
    """What a search came to.

    Attributes:
        search, base: with the data that the models are judged by.
        path: the models that add the effects that are needed one after another; none where none is needed.
        tried: all models that were fitted.
        untried: effects of the models that promised to be better when the time was over, the most promising first.
        outliers: how many single samples were set aside on the way, by signal.
        probes: what each effect does beside the base model; none where nothing had to be looked for.
        timed: the data with commands that step between two samples at the times that explain what else remains, to
            select from anew; None: as they are.
    """

    search: Search
    base: Fit
    path: tuple[Candidate, ...] = ()
    tried: tuple[Candidate, ...] = ()
    untried: tuple[tuple[str, ...], ...] = ()
    outliers: Mapping[str, int] = field(default_factory=dict)
    probes: tuple[EffectProbe, ...] = ()
    timed: Retimed | None = None


def select_effects(search: Search, base: Fit, deadline: float = math.inf, clocks: bool = True) -> Selection:
    """The effects that are needed.

    Args:
        search: tries effects.
        base: the model without them, fitted, with its linear model.
        deadline: of ``time.monotonic``, after which no more models are fitted, but those that the answer needs.
        clocks: whether steps of commands may find their times between two samples.

    Raises:
        SimulationFailure: no effect could be tried at all.
    """
    if not any(may_have_structure(s) for s in base.tested.values()):
        search.say(NothingTried().message)
        return Selection(search, base)
    models = _Models(search, base, deadline)
    models.probe()
    models.try_single(CRITERIA.search.first_tried)
    for count in range(1, CRITERIA.search.most_effects + 1):
        models.improve(count)
        if count == 1 and models.ranking.unsolved():
            models.try_forms()
            models.improve(count)
        models.set_outliers_aside()
        if models.ranking.unsolved():
            timed = models.with_step_times(count) if clocks else None
            if timed is not None:
                return Selection(models.search, models.base, outliers=models.outliers, timed=timed)
        else:
            models.try_simpler()
            if not models.ranking.more_effects_can_pay(count + 1):
                break
        if 1 < count < CRITERIA.search.most_effects:
            models.look_again()
    models.try_without_one()
    return Selection(
        models.search,
        models.base,
        tuple(models.path()),
        tuple(models.tried),
        tuple(models.untried),
        models.outliers,
        tuple(models.probes),
    )


class _Models:
    """All models so far, by their effects."""

    def __init__(self, search: Search, base: Fit, deadline: float) -> None:
        self.deadline = deadline
        self.known: dict[tuple[str, ...], Candidate] = {}
        self.ranking = Ranking(search, base, self.known)
        self.predicted = PredictedEvidence(self.ranking)
        self.untried: list[tuple[str, ...]] = []
        self.probes: list[EffectProbe] = []
        self.outliers: Counter[str] = Counter()

    @property
    def search(self) -> Search:
        """What the models are chosen from."""
        return self.ranking.search

    @property
    def base(self) -> Fit:
        """The model without effects."""
        return self.ranking.base

    @property
    def tried(self) -> list[Candidate]:
        """All models, without what only the search needs."""
        return [c.without_slopes for c in self.known.values()]

    def probe(self) -> None:
        """What each effect does beside the base model; if the time is limited, those that stand for a family first."""
        every = [e.name for e in self.search.shelf]
        step = len(every)
        if self.deadline < math.inf:
            every.sort(key=lambda name: name not in self.search.broadest)
            step = CRITERIA.search.first_tried
        for at in range(0, len(every), max(step, 1)):
            if at and self._late([(name,) for name in every[at:]]):
                break
            self.probes += self.search.probed(self.base, (), every[at : at + step])
        if self.search.failed and not self.probes:
            failed = self.search.failed[-1]
            raise SimulationFailure(f"no effect could be tried; {failed.effect}: {failed.failure}")
        # What shows in time alone, or in a reading that nobody took, does so beside no effect.
        silent = frozenset(p.effect for p in self.probes if p.unread or (p.silent and self.search.at_rest))
        self.ranking.search = replace(
            self.search, unseen=silent, idle={p.effect: p.idle for p in self.probes if p.idle}
        )
        self.predicted.looked_at(self.probes)

    def look_again(self) -> None:
        """What further families do beside the models that the search goes on from.

        Beside the base model, which is far off then, the same parameters may do something else. Those that stand for
        their families are looked at first, then all members of the families that promise most.
        """
        for best in (c for c in self.ranking.parents() if c.fit.linear is not None):
            taken = {self.search.family[name] for name in best.effects}
            self._look_beside(best, [n for n in self.search.broadest if self.search.family[n] not in taken])
            leading = self.predicted.leading(best, CRITERIA.search.leading_families)
            own = [e.name for e in self.search.shelf if e.family in leading and e.name not in self.search.unseen]
            self._look_beside(best, own)

    def _look_beside(self, best: Candidate, effects: Sequence[str]) -> None:
        seen = self.predicted.seen_beside(best.effects)
        names = [name for name in effects if name not in seen]
        if names and not self._late([(*best.effects, name) for name in names]):
            self.predicted.looked_again(best, self.search.probed(best.fit, best.effects, names))

    def try_single(self, count: int) -> None:
        """So many of the effects that promise most by themselves, a few steps."""
        self._keep(self.search.briefly([self.predicted.wanted(e) for e in self.predicted.first(count)]))

    def _late(self, chosen: Sequence[tuple[str, ...]]) -> bool:
        """Whether the time is over; then what would have come next is noted."""
        if time.monotonic() < self.deadline:
            return False
        self.untried += [names for names in chosen if names not in self.untried]
        self.ranking.over = True
        return True

    def with_step_times(self, count: int) -> Retimed | None:
        """The model that leaves noise once each step of a command comes when it serves best within its interval.

        If it has at most so many effects, and no model with one more, each step counted as a parameter, promises more.
        """
        if not self.search.loose_steps or self._late([]):
            return None
        own = [(c.effects, c.fit) for c in self.ranking.models(count) if len(c.effects) == count]
        own = own[: CRITERIA.search.leading_families]
        self.search.say(StepsSought().message)
        timed = self.search.with_step_times([((), self.base)] * (count == 1) + own)
        timed = [r for r in timed if not any_structure_for_search(r.fit)]
        if not timed:
            return None
        at, noise = scale([*self.ranking.fits, *(r.fit for r in timed)]), self.ranking.noise()
        hopes = [self.ranking.evidence(c, at) for c in (None, *self.known.values())]
        hopes += [self.predicted.predicted_evidence(p, noise, at) for p in self.predicted.candidates(count + 1)]
        costs = {
            r.effects: evidence(r.fit, at, r.effects, self.search.choice) + r.steps * at.penalty(r.fit) for r in timed
        }
        best = min(timed, key=lambda r: (len(r.effects), costs[r.effects], r.effects))
        return best if costs[best.effects] < min(hopes) else None

    def set_outliers_aside(self) -> None:
        """Samples that the best model shows to be outliers, which worse ones hid: none is judged by them any more."""
        best = self.ranking.best()
        if best is None:
            return
        self.ranking.search, counts = self.search.without_outliers(best.fit)
        if counts:
            self.outliers.update(counts)
            data = self.search.data
            self.ranking.base = self.base.against(data)
            for names, c in self.known.items():
                self.known[names] = replace(c, fit=c.fit.against(data))
            self.ranking.renew()

    def try_forms(self) -> None:
        """The other members of the families that came farthest: slopes do not tell what a much richer law can do."""
        best: dict[str, tuple[str, ...]] = {}
        for c in self.ranking.models(1):
            best.setdefault(self.search.family[c.effect], c.effects)
        leading = dict(list(best.items())[: CRITERIA.search.leading_families])
        self._try([Wanted((e,), self.known[leading[f]].fit.values) for f in leading for e in self._members(f)])

    def try_simpler(self) -> None:
        """In the model that leaves noise, forms with fewer parameters in the place of each effect."""
        for _ in range(CRITERIA.search.most_effects):
            best = self.ranking.best()
            if best is None or self.ranking.has_structure(best):
                return
            before = len(self.known)
            for name in best.effects:
                simpler = [
                    e for e in self._members(self.search.family[name]) if self.search.cost[e] < self.search.cost[name]
                ]
                sets = [tuple(e if n == name else n for n in best.effects) for e in simpler]
                self._try([Wanted(effects, best.fit.values) for effects in sets])
            if len(self.known) == before:
                return
            self.improve(len(best.effects))

    def try_without_one(self) -> None:
        """What is chosen without each of its effects, to the end, until each of them is needed.

        What the search expects of a set is reckoned from slopes; an effect may have been chosen beside others that
        need it no more once they are fitted together.
        """
        while (best := self.ranking.answer()) is not None and len(best.effects) > 1:
            sets = [tuple(e for e in best.effects if e != name) for name in best.effects]
            self._try([Wanted(effects, best.fit.values) for effects in sets])
            brief = [c for c in self.ranking.known.values() if c.brief and set(c.effects) < set(best.effects)]
            brief = [c for c in brief if len(c.effects) == len(best.effects) - 1]
            if brief and not self._late([c.effects for c in brief]):
                self._finish(brief)
            if self.ranking.answer() is best:
                return

    def _members(self, family: str) -> Iterator[str]:
        """The effects of a family that can show."""
        return (e.name for e in self.search.shelf if e.family == family and e.name not in self.search.unseen)

    def _try(self, models: Sequence[Wanted]) -> None:
        """Fits models briefly that nobody tried."""
        seen = self.ranking.seen
        others = [w for w in models if frozenset(w.effects) not in seen]
        if others and not self._late([w.effects for w in others]):
            self._keep(self.search.briefly(others))

    def improve(self, count: int) -> None:
        """Fits models with so many effects, as long as some may be better than the best, or as good.

        A few steps those that nobody tried, and to the end those that still promise it then.
        """
        for _ in range(CRITERIA.search.rounds):
            brief = self.predicted.brief()
            chosen = [p.expected for p in self.predicted.candidates(count)]
            if not (brief or chosen) or self._late([*(c.effects for c in brief), *(e.effects for e in chosen)]):
                break
            self._finish(brief)
            if not brief:
                self._keep(self.search.briefly([self.predicted.wanted(e) for e in chosen]))
                self.predicted.learn(chosen)

    def _finish(self, brief: Sequence[Candidate]) -> None:
        """Fits models to the end that were fitted briefly."""
        self._keep(self.search.to_the_end(brief, self.base))
        for c in brief:  # whatever came of it, it is not brief any more
            self.known[c.effects] = replace(self.known[c.effects], brief=False)

    def path(self) -> list[Candidate]:
        """The best model's effects, added one after another; none if the best is no better than the base model.

        A model that breaks down at the accuracy of the verdict makes place for the next best.
        """
        while (best := self.ranking.answer()) is not None:
            models = self._one_by_one(best)
            if models and models[-1].effects == best.effects:
                return [c.without_slopes for c in models]
            del self.known[best.effects]
            self.ranking.renew()
        return []

    def _one_by_one(self, best: Candidate) -> list[Candidate]:
        models: list[Candidate] = []
        for k in range(1, len(best.effects) + 1):
            names = best.effects[:k]
            own = self.known.get(names)
            if own is None or own.brief or (own.general and k == len(best.effects)):
                finished = self.search.finished(names, best.fit.values)
                if finished is None:
                    continue
                own = finished
                self.known[names] = own
            before = models[-1].fit if models else self.base
            models.append(rank(before, [own])[0])
        return models

    def _keep(self, candidates: Sequence[Candidate]) -> None:
        """Keeps the better fit of each model; one to the end began where the brief one stood, and is more exact."""
        for c in candidates:
            old = self.known.get(c.effects)
            to_the_end = old is not None and old.brief and not c.brief
            if old is None or to_the_end or c.fit.chi2_minimised <= old.fit.chi2_minimised:
                self.known[c.effects] = c
        self.ranking.renew()
