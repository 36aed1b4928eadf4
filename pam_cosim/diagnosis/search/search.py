"""Trying effects on top of a model: briefly, or to the end, many at a time."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TypeVar

import numpy as np

from pam_cosim.catalogue import EffectClass, compose_on, qualified
from pam_cosim.comparison import without_outliers
from pam_cosim.compiler import ClassTree, Structure, library_hash, read_structure
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Candidate, FailedTrial
from pam_cosim.diagnosis.judgement.events import CandidateTried, EffectProbed, Remark
from pam_cosim.diagnosis.judgement.message import Message
from pam_cosim.diagnosis.judgement.model_space import ModelSpace
from pam_cosim.diagnosis.search.effort import Effort
from pam_cosim.diagnosis.search.elimination import (
    elimination,
    fitted_with,
    left_out,
    needed_effects,
)
from pam_cosim.diagnosis.search.full_model import FullModel, FullTrial, run_full
from pam_cosim.diagnosis.search.probing import EffectProbe, StatedEffect
from pam_cosim.diagnosis.search.trial import (
    Trial,
    crashed,
    run_probe,
    run_stated,
    run_trial_without_samples,
    values_of_absence,
)
from pam_cosim.fitting import Fit, Linear
from pam_cosim.measurement import DataSet
from pam_cosim.model.references import is_ratio

Result = TypeVar("Result")


@dataclass(frozen=True)
class FitRequest:
    """A model that is to be fitted.

    Attributes:
        effects: that it has.
        start: values to start from [SI]. second_start: others.
    """

    effects: tuple[str, ...]
    start: Mapping[str, float]
    second_start: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Search:
    """What all trials share.

    Attributes:
        tree: the Modelica library with the user's classes.
        model: the base model.
        available_effects: the effects there are.
        data: the measurement, with noise levels, without outliers.
        files: further Modelica files.
        say: told each step and each result, in a line.
        workers: number of processes; None: the processors at hand.
        failed: trials without a fit so far; this grows.
        displaced: sets of effects of which one finds no place beside the others; this grows.
        expected: names of effects that are likely.
        undetectable: names of effects that these cannot show, beside whatever else.
        inactive_parameters: by effect, full names of its parameters that no sample depends on; they are not fitted.
        effort: its limits, and what it took so far; this grows.
        recorded: the measurement with outliers; None: there are none.
    """

    tree: ClassTree
    model: str
    available_effects: Sequence[EffectClass]
    data: DataSet
    files: tuple[Path, ...] = ()
    say: Callable[[Message], None] = lambda message: None
    workers: int | None = None
    failed: list[FailedTrial] = field(default_factory=list)
    displaced: set[frozenset[str]] = field(default_factory=set)
    expected: frozenset[str] = frozenset()
    undetectable: frozenset[str] = frozenset()
    inactive_parameters: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    effort: Effort = field(default_factory=Effort)
    recorded: DataSet | None = None

    @cached_property
    def structure(self) -> Structure:
        """Parts and replaceable classes of the base model."""
        return read_structure(qualified(self.tree, self.model), files=self.files)

    @cached_property
    def library(self) -> str:
        """Hash of the library, which a diagnosis takes as it finds it."""
        return library_hash()

    @cached_property
    def family(self) -> dict[str, str]:
        """Family of each effect."""
        return {e.name: e.family for e in self.available_effects}

    def families_of(self, effects: Iterable[str]) -> frozenset[str]:
        """The families of some effects."""
        return frozenset(self.family[name] for name in effects)

    @cached_property
    def model_space(self) -> ModelSpace:
        """What a choice among the effects costs."""
        return ModelSpace(len(self.available_effects), self.expected & self.family.keys())

    @cached_property
    def cost(self) -> dict[str, int]:
        """Number of parameters of each effect that are fitted."""
        return {
            e.name: max(len(e.parameters) - len(self.inactive_parameters.get(e.name, ())), 1)
            for e in self.available_effects
        }

    @cached_property
    def family_representatives(self) -> list[str]:
        """The effects that stand for their families: the general members, and all of families without one."""
        covered = {e.family for e in self.available_effects if e.general}
        broad = [e.name for e in self.available_effects if e.general or e.family not in covered]
        return [name for name in broad if name not in self.undetectable]

    @cached_property
    def general(self) -> frozenset[str]:
        """The effects that say whatever their families can."""
        return frozenset(e.name for e in self.available_effects if e.general)

    def probe(self, fitted: Fit, has: Sequence[str], effects: Sequence[str]) -> list[EffectProbe]:
        """What each of some effects does to the samples beside a fitted model, which has others."""
        begins = fitted.values_and_starts
        brief = self.brief_trials([FitRequest((*has, name), begins) for name in effects])
        trials = [replace(t, reference=fitted.linear) for t in brief]
        beside = f" beside {' + '.join(has)}" * bool(has)
        text = f"looking at what each of {len(trials)} effects would change{beside}"
        self.say(Remark(text).message)
        return self._run_probes(run_probe, trials)

    def probe_stated(
        self, beside: Linear, starts: Mapping[str, float], rows: int
    ) -> list[StatedEffect]:
        """What each effect does at its stated strength and when it is weaker, in about so many rows.

        Args:
            beside: the model without it. starts: its start values that were estimated.
            rows: how many.
        """
        values = {**dict(zip(beside.names, beside.values.tolist(), strict=True)), **starts}
        wanted = [FitRequest((e.name,), values) for e in self.available_effects]
        trials = [
            replace(t.screening().fitted_with(rows=rows), reference=beside)
            for t in self._trials(wanted)
        ]
        return self._run_probes(run_stated, trials)

    def _run_probes(
        self, look: Callable[[Trial], Result | FailedTrial], trials: Sequence[Trial]
    ) -> list[Result]:
        """Looks at the models of some trials, at a few at a time where a limit may be reached; at the first always."""
        most = len(trials) * CRITERIA.search.looks * len(self.data.fit_runs)
        together = len(trials) if self.effort.affords(most) else CRITERIA.search.first_tried
        number, results = itertools.count(1), list[Result | FailedTrial]()
        for at in range(0, len(trials), max(together, 1)):
            if at and self.effort.spent:
                break
            results += self.effort.run_tasks(
                look,
                trials[at : at + together],
                crashed,
                lambda _: self.say(EffectProbed(next(number), len(trials)).message),
                self.workers,
            )
        self.failed.extend(c for c in results if isinstance(c, FailedTrial))
        return [c for c in results if not isinstance(c, FailedTrial)]

    def without_outliers(self, fit: Fit) -> Search:
        """The search without the samples that are outliers beside a fit, and with those that only seemed to be."""
        recorded = self.recorded or self.data
        runs = fit.comparison.against(recorded).runs
        data, _ = without_outliers(recorded, runs, CRITERIA.noise.outliers_together)
        return self if _has_same_samples(data, self.data) else replace(self, data=data)

    @property
    def outliers(self) -> dict[str, int]:
        """How many single samples are set aside, by signal."""
        recorded = self.recorded or self.data
        counts = {
            name: sum(
                before.sample_count(name) - after.sample_count(name)
                for before, after in zip(recorded.runs, self.data.runs, strict=True)
                if name in before.measurements
            )
            for name in recorded.signals
        }
        return {name: count for name, count in counts.items() if count}

    def fit_briefly(self, models: Sequence[FitRequest]) -> list[Candidate]:
        """Models with these effects, a few steps from these values: enough to tell whether they promise anything."""
        trials = self.brief_trials(models)
        return self._run(
            "in a few steps", [t.fitted_with(holdout_uncertainty=True) for t in trials]
        )

    def brief_trials(self, models: Sequence[FitRequest]) -> list[Trial]:
        """Trials of a few steps, of those models whose effects find a place."""
        trials = [t.screening() for t in self._trials(models)]
        return [t.fitted_with(rows=CRITERIA.search.rows) for t in trials]

    def fit_completely(self, candidates: Sequence[Candidate], base: Fit) -> list[Candidate]:
        """Models that were fitted briefly, to the end: from where they stand, and from where they began."""
        trials = self._trials(
            [
                FitRequest(c.effects, {**base.values, **c.fit.start_values}, c.fit.values)
                for c in candidates
            ]
        )
        numbers = CRITERIA.search
        options = {
            "rows": numbers.rows,
            "precision": numbers.precision,
            "evaluations": numbers.evaluations,
            "second_look": False,
            "holdout_uncertainty": True,
        }
        several = options | {"screened_starts": 0}
        return self._run(
            "to the end",
            [t.fitted_with(**(options if len(t.effects) == 1 else several)) for t in trials],
        )

    def fit_final(self, effects: Sequence[str], start: Mapping[str, float]) -> Candidate | None:
        """The model with just these effects, the last of them without what it does not need; None: it breaks down."""
        rows = CRITERIA.search.rows
        trials = [
            replace(
                t.fitted_with(rows=rows, screened_starts=0, holdout_uncertainty=True), prune=True
            )
            for t in self._trials([FitRequest(tuple(effects), start)])
        ]
        return next(iter(self._run("to the end", trials)), None)

    def full_models(self, base: Fit, promising: Sequence[str]) -> list[FullModel]:
        """What the data need of a model with the plainest member of every family, one for each way to compose it.

        Args:
            base: the base model, fitted.
            promising: effects with a place, those that promise most first.
        """
        misfit = max(base.residuals["fit"].chi2_reduced, 1.0)
        fulls = [
            FullTrial(trial, tuple(self.effect(name) for name in trial.effects), misfit, self.price)
            for effects in filter(None, self._full_sets(promising))
            for trial in self._trials([FitRequest(effects, base.values_and_starts)])
        ]
        if not fulls:
            return []
        self.say(Remark(f"fitting {len(fulls)} models with a member of every family").message)
        results = self.effort.run_tasks(
            run_full, fulls, lambda full: crashed(full.trial), lambda _: None, self.workers
        )
        self.failed.extend(r for r in results if isinstance(r, FailedTrial))
        return [r for r in results if isinstance(r, FullModel)]

    @property
    def price(self) -> float:
        """What the choice of one more effect costs, about."""
        return 2 * math.log(max(len(self.available_effects), 1))

    def reduced(self, c: Candidate, most: int) -> FitRequest:
        """A fitted model with the effects that the data need, so many at most, and its values, to first order."""
        if c.fit.linear is None:
            return self.without_others(c, c.effects)
        needed = needed_effects(c.fit.linear, *self._absence(c), self.price, most)
        return self.without_others(c, needed)

    def without_others(self, c: Candidate, kept: Sequence[str]) -> FitRequest:
        """A fitted model with some of its effects only, and its values then, to first order."""
        start = c.fit.values_and_starts
        if c.fit.linear is None:
            return FitRequest(tuple(kept), start)
        names, absent, _ = self._absence(c)
        fixed = left_out(kept, names, c.fit.values, absent)
        return FitRequest(tuple(kept), start, fitted_with(c.fit.linear, fixed)[0])

    def in_order(self, c: Candidate, effects: Sequence[str]) -> Candidate | None:
        """A fitted model as if its effects had been added in this order; None: it would be another model then."""
        for trial in self._trials([FitRequest(tuple(effects), {})]):
            names = [n for e in effects for n in trial.composition.parameters[e]]
            if c.fit.parameters.keys() >= {*names}:
                return replace(trial.candidate(c.fit), brief=c.brief)
        return None

    def by_need(self, c: Candidate) -> tuple[str, ...]:
        """The effects of a fitted model, those that are left out last first, to first order."""
        if c.fit.linear is None:
            return c.effects
        order = [e for e, _ in elimination(c.fit.linear, *self._absence(c), self.price)]
        return (*(e for e in c.effects if e not in order), *reversed(order))

    def _absence(self, c: Candidate) -> tuple[dict[str, tuple[str, ...]], dict[str, float], float]:
        """What leaving effects of a fitted model out depends on.

        The parameters of each effect by full name, their values where the effects vanish [SI], and the misfit: the
        mean square of what the model leaves, at least one [noise variances].
        """
        composition = compose_on(self.tree, self.structure, c.effects)
        assert composition is not None  # it was fitted
        names = {e: composition.parameters[e] for e in c.effects}
        misfit = max(c.fit.residuals["fit"].chi2_reduced, 1.0)
        return names, values_of_absence([*map(self.effect, c.effects)], names), misfit

    def simpler_laws(self, c: Candidate) -> list[tuple[str, ...]]:
        """A fitted model with the law that one of its effects turns into where a parameter ended at a bound."""
        composition, linear = compose_on(self.tree, self.structure, c.effects), c.fit.linear
        if composition is None or linear is None:
            return []
        margin = CRITERIA.fit.at_bound * (linear.high - linear.low)
        at_low, at_high = (
            linear.values <= linear.low + margin,
            linear.values >= linear.high - margin,
        )
        ends = dict(zip(linear.names, zip(at_low, at_high, strict=True), strict=True))
        laws = []
        for name in c.effects:
            kept = tuple(e for e in c.effects if e != name)
            for full in composition.parameters[name]:
                simpler = self.effect(name).simpler.get(full.rpartition(".")[2], (None, None))
                for law, is_there in zip(simpler, ends.get(full, (False, False)), strict=True):
                    family = self.family.get(law or "")
                    if law and family and is_there and family not in self.families_of(kept):
                        laws.append((*kept, law))
        return laws

    def _full_sets(self, promising: Sequence[str]) -> list[tuple[str, ...]]:
        """Sets of effects, one of each family; a law that replaces the base model's has a set of its own."""
        plain: dict[str, EffectClass] = {}
        for e in map(self.effect, promising):
            best = plain.get(e.family)
            if e.general or is_ratio(e.name):
                continue
            if best is None or (not e.absent, self.cost[e.name]) < (
                not best.absent,
                self.cost[best.name],
            ):
                plain[e.family] = e
        nested = [e.name for e in plain.values() if e.absent]
        replacing = [e.name for e in plain.values() if not e.absent]
        starts: list[tuple[str, ...]] = [(), *((name,) for name in replacing)]
        return [self._with_place(start, nested) for start in starts]

    def _with_place(self, first: tuple[str, ...], names: Sequence[str]) -> tuple[str, ...]:
        """Effects, and of further ones those that find a place beside them."""
        for name in names:
            if compose_on(self.tree, self.structure, (*first, name)) is not None:
                first = (*first, name)
        return first

    def effect(self, name: str) -> EffectClass:
        """An effect by its name."""
        return self._effects[name]

    @cached_property
    def _effects(self) -> dict[str, EffectClass]:
        return {e.name: e for e in self.available_effects}

    def _run(self, how: str, trials: Sequence[Trial]) -> list[Candidate]:
        if trials:
            count = f"{len(trials)} model{'s' * (len(trials) > 1)}"
            self.say(Remark(f"fitting {how}: {count}").message)
        results = self.effort.run_tasks(
            run_trial_without_samples,
            trials,
            crashed,
            lambda c: self.say(result_message(c)),
            self.workers,
        )
        self.failed.extend(c for c in results if isinstance(c, FailedTrial))
        return [self._with_data(c) for c in results if isinstance(c, Candidate)]

    def _with_data(self, c: Candidate) -> Candidate:
        return replace(c, fit=replace(c.fit, comparison=c.fit.comparison.with_data(self.data)))

    def _trials(self, models: Sequence[FitRequest]) -> list[Trial]:
        """Trials of the last effect of each model, of those whose effects find a place."""
        trials = []
        for m in models:
            composition = compose_on(self.tree, self.structure, m.effects)
            if composition is None:
                self.displaced.add(frozenset(m.effects))
            else:
                trial = Trial(
                    self.effect(m.effects[-1]),
                    m.effects,
                    composition,
                    self.data,
                    m.start,
                    self.files,
                )
                idle = {name for e in m.effects for name in self.inactive_parameters.get(e, ())}
                trials.append(
                    replace(
                        trial.without(idle),
                        further_start=m.second_start,
                        library=self.library,
                        general_before=not self.general.isdisjoint(m.effects[:-1]),
                    )
                )
        return trials


def _has_same_samples(data: DataSet, other: DataSet) -> bool:
    return all(
        np.array_equal(samples, b.measurements[name], equal_nan=True)
        for a, b in zip(data.runs, other.runs, strict=True)
        for name, samples in a.measurements.items()
    )


def result_message(c: Candidate | FailedTrial) -> Message:
    """A candidate in a line."""
    return CandidateTried(c).message
