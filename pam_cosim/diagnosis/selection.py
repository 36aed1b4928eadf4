"""Which effects a model needs: the models that promise most are fitted, until none is left that may be better.

One number orders all models: the evidence (``diagnosis.evidence``), of a model that was fitted as it is, of one that
was not, or not to the end, as far as linear algebra tells (``diagnosis.expectation``). Whoever may still beat the best
is fitted next: single effects first; where the best of them leaves structure, pairs; then triples, for which effects
are looked at again beside the best model. As few effects as leave noise are enough, and among models with as many the
evidence decides.
"""

from __future__ import annotations

import math
import time
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.candidate import Candidate
from pam_cosim.diagnosis.events import NothingTried, StepsSought
from pam_cosim.diagnosis.evidence import (
    Scale,
    coherent,
    dominant_effect,
    evidence,
    rank,
    refuted,
    scale,
    unexplained,
)
from pam_cosim.diagnosis.expectation import Addition, Additions, Beside, Expected, addition, reduction
from pam_cosim.diagnosis.probing import Probe
from pam_cosim.diagnosis.search import Search, Wanted
from pam_cosim.diagnosis.step_times import Retimed
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting import Fit, Linear


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
    probes: tuple[Probe, ...] = ()
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
    if not any(coherent(s) for s in base.tested.values()):
        search.say(NothingTried().message)
        return Selection(search, base)
    models = _Models(search, base, deadline)
    models.probe()
    models.try_single(CRITERIA.search.first_tried)
    for count in range(1, CRITERIA.search.most_effects + 1):
        models.improve(count)
        if count == 1 and models.unsolved():
            models.try_forms()
            models.improve(count)
        models.set_outliers_aside()
        if not models.unsolved():
            break
        timed = models.with_step_times(count) if clocks else None
        if timed is not None:
            return Selection(models.search, models.base, outliers=models.outliers, timed=timed)
        if 1 < count < CRITERIA.search.most_effects:
            models.look_again()
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
        self.search, self.base, self.deadline = search, base, deadline
        self.untried: list[tuple[str, ...]] = []
        self.known: dict[tuple[str, ...], Candidate] = {}
        self.probes: list[Probe] = []
        self._again: dict[tuple[str, ...], list[Addition]] = {}
        self._added: tuple[tuple[int, ...], Additions] = ((), Additions([]))
        self._merged: dict[tuple[str, ...], tuple[Additions, Additions]] = {}
        self._scale = scale([base])
        self._left: dict[tuple[str, ...], tuple[Fit, bool]] = {}
        self._came_true: defaultdict[int, list[float]] = defaultdict(list)
        self.outliers: Counter[str] = Counter()

    @property
    def tried(self) -> list[Candidate]:
        """All models, without what only the search needs."""
        return [replace(c, fit=replace(c.fit, linear=None)) for c in self.known.values()]

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
        if self.search.at_rest:  # what shows in time alone does so beside no effect
            self.search = replace(self.search, unseen=frozenset(p.effect for p in self.probes if p.silent))

    def look_again(self) -> None:
        """What further families do beside the best model, which leaves structure.

        Beside the base model, which is far off then, the same parameters may do something else.
        """
        best = self._best()
        if best is None or best.fit.linear is None or best.effects in self._again:
            return
        taken = {self.search.family[name] for name in best.effects}
        others = [name for name in self.search.broadest if self.search.family[name] not in taken]
        if not self._late([(*best.effects, name) for name in others]):
            probes = self.search.probed(best.fit, best.effects, others)
            made = [addition(best.fit.linear, p) for p in probes]
            self._again[best.effects] = [a for a in made if a is not None]

    def try_single(self, count: int) -> None:
        """So many of the effects that promise most by themselves, a few steps."""
        assert self.base.linear is not None
        noise, beside = self._noise(), self._beside((), self.base.linear)
        every = sorted(
            beside.with_one(), key=lambda e: (self._hoped(self.base, None, e, noise, self._scale), e.effects)
        )
        self._keep(self.search.briefly([self._wanted(e) for e in every[:count]]))

    def _additions(self) -> Additions:
        """What the effects can add to the base model, as far as probes and fits tell by now."""
        assert self.base.linear is not None
        probes = [p for p in self.probes if p.effect not in self.search.unseen]
        fitted = [self.known.get((p.effect,)) for p in probes]
        key = tuple(id(c.fit) if c else 0 for c in fitted)
        if key != self._added[0]:
            made = [addition(self.base.linear, p, c) for p, c in zip(probes, fitted, strict=True)]
            self._added = (key, Additions([a for a in made if a is not None]))
        return self._added[1]

    def _beside(self, effects: tuple[str, ...], linear: Linear) -> Beside:
        """What can be added to a fitted model: as looked at beside it, or else as by itself."""
        additions = self._additions()
        if effects in self._again:
            if self._merged.get(effects, (None,))[0] is not additions:
                own = {a.effect: a for a in self._again[effects]}
                self._merged[effects] = (additions, Additions([own.get(a.effect, a) for a in additions.every]))
            additions = self._merged[effects][1]
        return Beside(effects, linear, self.search.family, additions)

    def _seen(self) -> set[tuple[str, ...]]:
        return {*self.known, *(c.effects for c in self.search.failed)}

    def _late(self, chosen: Sequence[tuple[str, ...]]) -> bool:
        """Whether the time is over; then what would have come next is noted."""
        if time.monotonic() < self.deadline:
            return False
        self.untried += [names for names in chosen if names not in self.untried]
        return True

    def unsolved(self) -> bool:
        """Whether the best model leaves structure, or there is none."""
        best = self._best()
        return best is None or self._leaves_structure(best)

    def with_step_times(self, count: int) -> Retimed | None:
        """The model that leaves noise once each step of a command comes when it serves best within its interval.

        If it has at most so many effects, and no model with one more, each step counted as a parameter, promises more.
        """
        if not self.search.loose_steps or self._late([]):
            return None
        models = sorted(self.known.values(), key=lambda c: (self._evidence(c), c.effects))
        own = [(c.effects, c.fit) for c in models if len(c.effects) == count][: CRITERIA.search.leading_families]
        self.search.say(StepsSought().message)
        timed = self.search.with_step_times([((), self.base)] * (count == 1) + own)
        timed = [r for r in timed if not unexplained(r.fit)]
        if not timed:
            return None
        at, noise = scale([*self._fits, *(r.fit for r in timed)]), self._noise()
        hopes = [self._evidence(c, at) for c in (None, *self.known.values())]
        for e in self._promising(count + 1):
            start = self.known.get(e.start)
            hopes.append(self._hoped(start.fit if start else self.base, start, e, noise, at))
        costs = {
            r.effects: evidence(r.fit, at, r.effects, self.search.choice) + r.steps * at.penalty(r.fit) for r in timed
        }
        best = min(timed, key=lambda r: (len(r.effects), costs[r.effects], r.effects))
        return best if costs[best.effects] < min(hopes) else None

    def set_outliers_aside(self) -> None:
        """Samples that the best model shows to be outliers, which worse ones hid: none is judged by them any more."""
        best = self._best()
        if best is None:
            return
        self.search, counts = self.search.without_outliers(best.fit)
        if counts:
            self.outliers.update(counts)
            data = self.search.data
            self.base = self.base.against(data)
            self.known = {names: replace(c, fit=c.fit.against(data)) for names, c in self.known.items()}
            self._scale = scale(self._fits)

    def try_forms(self) -> None:
        """The other members of the families that came farthest: slopes do not tell what a much richer law can do."""
        single = sorted((self._evidence(c), c.effects) for c in self.known.values() if len(c.effects) == 1)
        best: dict[str, tuple[str, ...]] = {}
        for _, names in single:
            best.setdefault(self.search.family[names[0]], names)
        leading = dict(list(best.items())[: CRITERIA.search.leading_families])
        others = [
            Wanted((e.name,), self.known[leading[e.family]].fit.values)
            for e in self.search.shelf
            if e.family in leading and (e.name,) not in self._seen() and e.name not in self.search.unseen
        ]
        if not self._late([w.effects for w in others]):
            self._keep(self.search.briefly(others))

    def improve(self, count: int) -> None:
        """Fits models with so many effects, as long as some may be better than the best, or as good.

        A few steps those that nobody tried, and to the end those that still promise it then.
        """
        for _ in range(CRITERIA.search.rounds):
            brief = self._brief()
            chosen = self._promising(count)
            if not (brief or chosen) or self._late([*(c.effects for c in brief), *(e.effects for e in chosen)]):
                break
            self._keep(self.search.to_the_end(brief, self.base))
            for c in brief:  # whatever came of it, it is not brief any more
                self.known[c.effects] = replace(self.known[c.effects], brief=False)
            if not brief:
                self._keep(self.search.briefly([self._wanted(e) for e in chosen]))
                self._learn(chosen)

    def _learn(self, tried: Sequence[Expected]) -> None:
        """Notes how much of the expected reductions came true."""
        for e in (e for e in tried if not e.exchanged):
            start = self.known[e.start].fit if e.start else self.base
            after = self.known[e.effects].fit if e.effects in self.known else start
            gained = start.residuals["fit"].chi2 - after.residuals["fit"].chi2
            self._came_true[len(e.effects)].append(max(gained, 0.0) / max(e.reduction, 1e-300))

    def _trust(self, count: int) -> float:
        """What part of an expected reduction may come true: the most that it did of late for as many effects."""
        late = self._came_true[count][-CRITERIA.search.together :]
        return max(late) if len(late) == CRITERIA.search.together else 1.0

    def _brief(self) -> list[Candidate]:
        """Models that were fitted briefly and may be better than the best, or as good; the most promising ones."""
        possibly = self._possibly()
        limit = self._limit(possibly)
        hopes = ((self._hope(c, self._scale), c) for c in self.known.values() if c.brief)
        promising = [(hope, c.effects) for hope, c in hopes if self._hope(c, possibly) < limit]
        return [self.known[names] for _, names in sorted(promising)[: CRITERIA.search.together]]

    def _answer(self) -> Candidate | None:
        """The best model; where it leaves structure, one effect that is beyond doubt all the same goes first."""
        best = self._best()
        if best is not None and self._leaves_structure(best):
            return dominant_effect(self.base, [c for c in self.known.values() if not c.brief]) or best
        return best

    def path(self) -> list[Candidate]:
        """The best model's effects, added one after another; none if the best is no better than the base model."""
        best = self._answer()
        if best is None:
            return []
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
        return [replace(c, fit=replace(c.fit, linear=None)) for c in models]

    # ---- order ------------------------------------------------------------------------------------------------

    @property
    def _fits(self) -> list[Fit]:
        return [self.base, *(c.fit for c in self.known.values())]

    def _evidence(self, c: Candidate | None, at: Scale | None = None) -> float:
        """The evidence against a model, None: the base model; on the scale of the best model unless given."""
        fit, effects = (c.fit, c.effects) if c else (self.base, ())
        return evidence(fit, at or self._scale, effects, self.search.choice, c)

    def _best(self) -> Candidate | None:
        """Of those that leave noise, the best with the fewest effects; else the best; None: none beats the base.

        Where the evidence does not tell them apart, signals that were compared but not fitted may.
        """
        beaten = self._evidence(None) - CRITERIA.evidence.very_strong
        done = [c for c in self.known.values() if not c.brief and self._evidence(c) < beaten]
        order = {c.effects: (self._leaves_structure(c), self._evidence(c), c.effects) for c in done}
        enough = [len(names) for names, (left, _, _) in order.items() if not left]
        done = [c for c in done if not enough or len(c.effects) == min(enough)]
        first = min(done, key=lambda c: order[c.effects], default=None)
        if first is None:
            return None
        left, lowest, _ = order[first.effects]
        near = [
            c for c in done if (own := order[c.effects])[0] == left and own[1] < lowest + CRITERIA.evidence.very_strong
        ]
        sound = [c for c in near if not any(refuted(c.fit, other.fit) for other in near)]
        return min(sound or near, key=lambda c: order[c.effects])

    def _leaves_structure(self, c: Candidate) -> bool:
        if c.effects not in self._left or self._left[c.effects][0] is not c.fit:
            self._left[c.effects] = (c.fit, unexplained(c.fit))
        return self._left[c.effects][1]

    def _limit(self, at: Scale) -> float:
        """The evidence that a model may have at most to be of interest: the best one's; or a rival's of the answer."""
        best = self._best()
        rivals_count = best is not None and not self._leaves_structure(best)
        return self._evidence(best, at) + CRITERIA.evidence.very_strong * rivals_count

    def _possibly(self) -> Scale:
        """The scale of what is possible: plain noise as long as the best model leaves more, else what that leaves."""
        return Scale(max(1.0, self._noise()), 1.0) if self.unsolved() else self._scale

    def _hope(self, c: Candidate, at: Scale) -> float:
        """The evidence of a candidate that was fitted briefly, if all goes as its slopes say."""
        gain = reduction(c.fit.linear) if c.fit.linear is not None else 0.0
        return self._evidence(c, at) - self._worth(gain, c.fit, at, self._noise())

    def _worth(
        self, reduction: float, fit: Fit, at: Scale, noise: float, lost: float = CRITERIA.search.not_linear
    ) -> float:
        """What a reduction of the squared error counts: some of it is lost on the way, as models are not linear.

        The error of the other runs is expected to fall as that of the fitted ones does; neither falls below the noise.
        """
        fitted, held = fit.residuals["fit"], fit.residuals["holdout"]
        left = 1 - (1 - lost) * reduction / max(fitted.chi2, 1e-300)
        gain = sum(max(s.chi2 - max(left * s.chi2, noise * s.samples), 0.0) for s in (fitted, held) if s.samples)
        return gain / at.divisor

    def _noise(self) -> float:
        """Mean square of the noise, as low as a model leaves it."""
        return min(f.residuals["fit"].noise_floor for f in self._fits)

    def _promising(self, count: int) -> list[Expected]:
        """Untried models of so many effects that may be better than the best, the best of each set of families."""
        noise, possibly, at = self._noise(), self._possibly(), self._scale
        tried, best, limit = {frozenset(n) for n in self._seen()}, self._best(), self._limit(possibly)
        left, trust = best if best is not None and self._leaves_structure(best) else None, self._trust(count)
        possible = [
            (self._hoped(fit, c, e, noise, at, e.reduction, 0.0), e.effects, n, fit, c, e)
            for n, (fit, c, e) in enumerate(_nearest(self._expected(count)))
            if frozenset(e.effects) not in tried
            and (left is None or self._goes_on(left, fit, e, noise))
            and self._hoped(fit, c, e, noise, possibly, e.reduction, 1 - trust) <= limit
        ]
        by_families: dict[frozenset[str], tuple[float, Expected]] = {}
        for hope, _, _, fit, c, e in sorted(possible, key=lambda entry: entry[:3]):
            first = sorted(h for h, _ in by_families.values())[: CRITERIA.search.together]
            if len(first) == CRITERIA.search.together and hope > first[-1]:
                break  # no further one can be as good as these
            own = self._hoped(fit, c, e, noise, at)
            families = frozenset(self.search.family[n] for n in e.effects)
            if families not in by_families or own < by_families[families][0]:
                by_families[families] = (own, e)
        ordered = sorted(by_families.values(), key=lambda entry: (entry[0], entry[1].effects))
        return [e for _, e in ordered[: CRITERIA.search.together]]

    def _expected(self, count: int) -> Iterator[tuple[Fit, Candidate | None, Expected]]:
        """Models of so many effects from those that were fitted: their fit, what they are, what is expected."""
        first = CRITERIA.search.starts
        unsolved = self.unsolved()
        models = sorted(self.known.values(), key=lambda c: (self._evidence(c), c.effects))
        starts: list[Candidate | None] = [None, *[c for c in models if len(c.effects) <= count][:first]]
        for c in starts:
            fit, effects = (c.fit, c.effects) if c else (self.base, ())
            if fit.linear is None or len(effects) + 2 < count:
                continue
            beside = self._beside(effects, fit.linear)
            more = count - len(effects)
            if more == 0 and unsolved:
                every = beside.with_another_form()
            elif more == 1 and (count == 1 or unsolved):
                every = beside.with_one()
            elif more == 2 and unsolved and effects:
                every = beside.with_two(first)
            else:
                continue
            yield from ((fit, c, e) for e in every)

    def _goes_on(self, best: Candidate, fit: Fit, e: Expected, noise: float) -> bool:
        """Whether a model is expected to leave much less than the best one does, which leaves structure."""
        now, own = best.fit.residuals["fit"], fit.residuals["fit"]
        excess = now.chi2 - noise * now.samples
        if len(e.effects) > len(best.effects) and excess < CRITERIA.search.at_noise * noise * now.samples:
            return False  # the fitted runs have nothing left to tell a further effect by
        left = own.chi2 - self._trust(len(e.effects)) * e.reduction - noise * own.samples
        return left < CRITERIA.search.step * excess

    def _hoped(
        self,
        fit: Fit,
        start: Candidate | None,
        e: Expected,
        noise: float,
        at: Scale,
        reduction: float | None = None,
        lost: float = CRITERIA.search.not_linear,
    ) -> float:
        """The evidence that a model which nobody fitted is expected to have, from one that was fitted.

        With a reduction of the squared error that may be given; default: that within the bounds of all parameters.
        """
        reduction = e.within_bounds[0] if reduction is None else reduction
        more = sum(a.cost for a in e.added) - (self.search.cost[e.exchanged] if e.exchanged else 0)
        known = evidence(fit, at, e.effects, self.search.choice, start)
        return known + more * at.penalty(fit) - self._worth(reduction, fit, at, noise, lost)

    def _wanted(self, e: Expected) -> Wanted:
        """A model to fit: from the fitted one, and the added effects as they were by themselves, or as expected."""
        values: dict[str, float] = {}
        for a in e.added:
            if (a.effect,) in self.known:
                values |= self.known[(a.effect,)].fit.values
        start = self.known[e.start].fit.values if e.start else self.base.values
        return Wanted(e.effects, values | start, e.within_bounds[1])

    def _keep(self, candidates: Sequence[Candidate]) -> None:
        for c in candidates:
            old = self.known.get(c.effects)
            if old is None or c.fit.residuals["fit"].chi2 <= old.fit.residuals["fit"].chi2:
                self.known[c.effects] = c
        self._scale = scale(self._fits)


def _nearest(
    expected: Iterable[tuple[Fit, Candidate | None, Expected]],
) -> list[tuple[Fit, Candidate | None, Expected]]:
    """What is expected of each set of effects by the models that lack least of it: they know most of it."""
    every = list(expected)
    lack: dict[frozenset[str], int] = {}
    for _, _, e in every:
        names = frozenset(e.effects)
        lack[names] = min(len(e.added), lack.get(names, len(e.added)))
    return [entry for entry in every if len(entry[2].added) == lack[frozenset(entry[2].effects)]]
