"""Trying effects on top of a model: all of them are screened in a few steps, the promising ones refined to the end."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

from pam_cosim.catalogue import EffectClass, compose_on, qualified
from pam_cosim.compiler import ClassTree, Structure, read_structure
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.candidate import Candidate, FailedTrial
from pam_cosim.diagnosis.evidence import rank
from pam_cosim.diagnosis.message import Message
from pam_cosim.diagnosis.trial import Trial, crashed, run_trial
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting import Fit
from pam_cosim.measurement import DataSet
from pam_cosim.units import format_quantity
from pam_cosim.workers import run_tasks


@dataclass(frozen=True)
class Search:
    """What every round of trials shares.

    Attributes:
        tree: the Modelica library with the user's classes.
        model: the base model.
        shelf: the effects there are.
        data: the measurement, with noise levels.
        files: further Modelica files.
        say: told each step and each result, in a line.
        workers: number of processes; None: the processors at hand.
        failed: trials without a fit so far; this grows.
    """

    tree: ClassTree
    model: str
    shelf: Sequence[EffectClass]
    data: DataSet
    files: tuple[Path, ...] = ()
    say: Callable[[Message], None] = lambda message: None
    workers: int | None = None
    failed: list[FailedTrial] = field(default_factory=list)

    @cached_property
    def structure(self) -> Structure:
        """Parts and replaceable classes of the base model."""
        return read_structure(qualified(self.tree, self.model), files=self.files)

    def round(
        self, added: Sequence[str], present: Fit, known: Sequence[Candidate] = (), below: float = math.inf
    ) -> list[Candidate]:
        """Tries one more effect on top of those that were added; best first.

        Args:
            added: names of effects in the model.
            present: the model with them, fitted.
            known: candidates of an earlier round, best first. The best of each family stands for it then, until it
                proves promising.
            below: excess that one of them must undercut in a few steps, for the promising ones to be fitted to the end.

        Raises:
            SimulationFailure: no effect could be tried at all.
        """
        trials = self._trials(added, present.values)
        simple = _simple(trials)
        first = (
            _of_each_family(simple, [*(c.effect for c in known), *(c.effect for c in self.failed)]) if known else simple
        )
        screened = self._screened(first)
        if first and not screened:
            raise SimulationFailure(f"no effect could be tried; {self.failed[-1].effect}: {self.failed[-1].failure}")
        if not any(c.fit.residuals["fit"].excess < below for c in screened):
            return rank(present, screened)
        leading = self._refined(trials, screened)
        if not any(at_noise(c.fit) for c in leading):
            left = self._untried(trials, [*screened, *leading])
            families = _leading_families([*screened, *leading], CRITERIA.search.further_families)
            rest = self._screened([t for t in left if t.effect.family in families])
            screened += rest
            leading = [*leading, *self._refined(trials, rest, [*screened, *leading])]
        better = {c.effect: c for c in leading}
        return rank(present, [better.pop(c.effect, c) for c in screened] + list(better.values()))

    def _screened(self, trials: Sequence[Trial]) -> list[Candidate]:
        return self._run("in a few steps", [t.screening() for t in trials])

    def _refined(
        self, trials: Sequence[Trial], candidates: Sequence[Candidate], among: Sequence[Candidate] = ()
    ) -> list[Candidate]:
        """Fits the promising ones of ``candidates`` (that are so ``among`` more) to the end.

        The other members of a leading family are fitted too, but richer ones only where a simple one came near: what
        bends in every direction must not stand in for a family that does not fit.
        """
        every = [*candidates, *among]
        near, chosen = _near(every), worth_refitting(every)
        names = {c.effect for c in candidates}
        own = _onwards(trials, [c for c in chosen if c.effect in names])
        again = [t.fitted_with(descents=t.options.descents + 1) for t in own]
        plain = {t.effect.name for t in _simple(trials)}
        families, rich = (
            _leading_families(chosen, CRITERIA.search.leading_families),
            _leading_families(near, CRITERIA.search.leading_families),
        )
        others = [
            t for t in self._untried(trials, every) if t.effect.family in (families if t.effect.name in plain else rich)
        ]
        return self._run("to the end, as they are promising,", [*again, *others])

    def _untried(self, trials: Sequence[Trial], candidates: Sequence[Candidate]) -> list[Trial]:
        seen = {c.effects for c in candidates} | {c.effects for c in self.failed}
        return [t for t in trials if t.effects not in seen]

    def with_effects(self, effects: Sequence[str], start: Mapping[str, float]) -> Candidate | None:
        """The model with just these effects, fitted to the end; the last of them counts as the one that is tried.

        None where it cannot be fitted.
        """
        return next(iter(self._run("to the end, without another effect,", self._composed([effects], start))), None)

    def exchanged(self, effects: Sequence[str], start: Mapping[str, float], general: bool) -> list[Candidate]:
        """Models with one of these effects replaced by another of its family, fitted to the end.

        Args:
            effects: names of the effects in the model.
            start: values to start from.
            general: whether by the general member, or by the others.
        """
        trials = self._composed(_exchanged(effects, self.shelf, lambda own, other: other.general is general), start)
        return self._run("to the end, with another form of an effect,", [_started(t) if general else t for t in trials])

    def general(self, present: Fit, known: Sequence[Candidate]) -> list[Candidate]:
        """Models with one effect, the general member of each leading family, fitted to the end.

        Args:
            present: the model without effects, fitted.
            known: candidates with one effect each; where the best of a family stands is one of the starts.
        """
        best = {c.family: c for c in reversed(_by_error(known))}
        leading = _leading_families(known, CRITERIA.search.leading_families)
        own = [e for e in self.shelf if e.general and e.family in leading]
        trials = [
            replace(_patient(t), further_start=best[t.effect.family].fit.values)
            for t in self._composed([(e.name,) for e in own], present.values)
        ]
        return self._run("to the end, in the general form of its family,", trials)

    def last_resort(self, present: Fit, known: Sequence[Candidate]) -> list[Candidate]:
        """Models with one effect, the general member of each other family, the leading ones fitted to the end."""
        seen = {c.effects for c in known} | {c.effects for c in self.failed}
        own = [(e.name,) for e in self.shelf if e.general and (e.name,) not in seen]
        trials = [_patient(t) for t in self._composed(own, present.values)]
        screened = self._screened(trials)
        chosen = _onwards(trials, _by_error(screened)[: CRITERIA.search.last_resorts])
        better = {c.effect: c for c in self._run("to the end, in the general form of any family,", chosen)}
        return rank(present, [better.get(c.effect, c) for c in screened])

    def fewer(self, effects: Sequence[str], start: Mapping[str, float], below: float) -> list[Candidate]:
        """Models with one of these effects less and another in a richer form of its family.

        Those whose excess is ``below`` that after a few steps are fitted to the end and returned.
        """
        less = [_exchanged([e for e in effects if e != left], self.shelf, _richer) for left in reversed(effects)]
        alike = {frozenset(names): names for some in less for names in some}
        trials = self._composed(list(alike.values()), start)
        near = [c for c in self._screened(trials) if c.fit.residuals["fit"].excess < below]
        return self._run("to the end, with one effect less,", [_started(t) for t in _onwards(trials, near)])

    def _run(self, how: str, trials: Sequence[Trial]) -> list[Candidate]:
        if trials:
            self.say(Message(f"fitting {how} {len(trials)} effect{'s' if len(trials) > 1 else ''}"))
        results = run_tasks(run_trial, trials, crashed, lambda c: self.say(told(c)), self.workers)
        self.failed.extend(c for c in results if isinstance(c, FailedTrial))
        return [c for c in results if isinstance(c, Candidate)]

    def _trials(self, added: Sequence[str], start: Mapping[str, float]) -> list[Trial]:
        taken = {e.family for e in self.shelf if e.name in added}
        listed = [e for e in self.shelf if not e.general]
        return self._composed([(*added, e.name) for e in listed if e.family not in taken], start)

    def _composed(self, chosen: Sequence[Sequence[str]], start: Mapping[str, float]) -> list[Trial]:
        """Trials of the last effect of each list, for those that find a place in the model."""
        own = {e.name: e for e in self.shelf}
        trials = []
        for names in chosen:
            composition = compose_on(self.tree, self.structure, names)
            if composition is not None:
                trials.append(Trial(own[names[-1]], tuple(names), composition, self.data, start, self.files))
        return trials


def _patient(trial: Trial) -> Trial:
    """A trial of a general member: from many starts, but not creeping along a valley that leads nowhere."""
    numbers = CRITERIA.search
    return trial.fitted_with(
        screened_starts=numbers.screened_starts,
        evaluations=numbers.general_evaluations,
        precision=numbers.general_precision,
    )


def _onwards(trials: Sequence[Trial], candidates: Sequence[Candidate]) -> list[Trial]:
    """Those of the trials that gave these candidates, with one more start: where the candidate stands."""
    values = {c.effects: c.fit.values for c in candidates}
    return [replace(t, further_start=values[t.effects]) for t in trials if t.effects in values]


def _started(trial: Trial) -> Trial:
    """A trial that starts from a fitted model: the best start is followed, and no other."""
    numbers, followed = CRITERIA.search, trial.fitted_with(descents=1)
    if not trial.effect.general:
        return followed
    return followed.fitted_with(evaluations=numbers.general_evaluations, precision=numbers.general_precision)


def _exchanged(
    effects: Sequence[str], shelf: Sequence[EffectClass], fits: Callable[[EffectClass, EffectClass], bool]
) -> list[tuple[str, ...]]:
    """The effects with one of them replaced by another of its family that ``fits``; that one stands last."""
    own = {e.name: e for e in shelf}
    return [
        (*(e for e in effects if e != changed), other.name)
        for changed in reversed(effects)
        for other in shelf
        if other.family == own[changed].family and other.name != changed and fits(own[changed], other)
    ]


def _richer(own: EffectClass, other: EffectClass) -> bool:
    return len(other.parameters) > len(own.parameters)


def told(c: Candidate | FailedTrial) -> Message:
    """A candidate in a line."""
    result = f"could not be fitted: {c.failure}" if isinstance(c, FailedTrial) else describe_fit(c.fit)
    return Message(f"{c.effect} ({c.family}): {result}", detail=True)


def describe_fit(fit: Fit) -> str:
    """Root mean square errors of a fit in units a person reads, and the reduced chi-square of the runs of each role."""
    scores = fit.comparison.scores["fit"]
    signals = fit.comparison.data.signals
    errors = ", ".join(f"{n} {format_quantity(s.rmse, signals[n].unit)}" for n, s in scores.items())
    text = f"rms error {errors}, chi2 {fit.comparison.chi2_reduced('fit'):.4g}"
    holdout = fit.comparison.chi2_reduced("holdout")
    return text if math.isnan(holdout) else f"{text} (holdout {holdout:.4g})"


def worth_refitting(candidates: Sequence[Candidate]) -> list[Candidate]:
    """Those that came near the best in a few steps, and at least a few, best first."""
    near = _near(candidates)
    return (
        near[: CRITERIA.search.most_refits]
        if len(near) >= CRITERIA.search.fewest_refits
        else _by_error(candidates)[: CRITERIA.search.fewest_refits]
    )


def _by_error(candidates: Sequence[Candidate]) -> list[Candidate]:
    fitted = [(c.fit.residuals["fit"].chi2, c.effect, c) for c in candidates]
    return [c for _, _, c in sorted(fitted, key=lambda entry: entry[:2])]


def _near(candidates: Sequence[Candidate]) -> list[Candidate]:
    """Those whose error beyond the noise a few more steps may still bring down to that of the best; best first."""
    ordered = _by_error(candidates)
    scored = [(c.fit.residuals["fit"], c) for c in ordered]
    if not scored:
        return []
    samples = scored[0][0].samples
    floor = min(max(s.noise_floor, 0.0) for s, _ in scored) * samples
    limit = (
        floor
        + CRITERIA.search.within_reach * max(scored[0][0].chi2 - floor, 0.0)
        + CRITERIA.search.reach_at_noise * samples
    )
    return [c for s, c in scored if s.chi2 <= limit]


def _leading_families(candidates: Sequence[Candidate], count: int) -> list[str]:
    return list(dict.fromkeys(c.family for c in _by_error(candidates)))[:count]


def at_noise(fit: Fit) -> bool:
    """Whether the residuals of the fitted runs are down at the level of the noise."""
    s = fit.residuals["fit"]
    return s.excess < CRITERIA.search.at_noise * max(1.0, s.noise_floor)


def _simple(trials: Sequence[Trial]) -> list[Trial]:
    """Effects with few parameters, and the simplest of each family; richer ones wait until these have failed."""
    fewest: dict[str, int] = {}
    for t in trials:
        size = len(t.effect.parameters)
        fewest[t.effect.family] = min(size, fewest.get(t.effect.family, size))
    return [t for t in trials if len(t.effect.parameters) <= max(CRITERIA.search.simple, fewest[t.effect.family])]


def _of_each_family(trials: Sequence[Trial], known: Sequence[str]) -> list[Trial]:
    """The effect of each family that did best before; those that nobody tried before all stay."""
    order = {name: i for i, name in enumerate(known)}
    best: dict[str, Trial] = {}
    new = []
    for t in trials:
        if t.effect.name not in order:
            new.append(t)
            continue
        rival = best.get(t.effect.family)
        if rival is None or order[t.effect.name] < order[rival.effect.name]:
            best[t.effect.family] = t
    return [t for t in trials if t in new or t in best.values()]
