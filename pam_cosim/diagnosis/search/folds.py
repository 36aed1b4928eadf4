"""Which effects of a model are needed whichever runs are left out, and how good the model is on runs it never saw.

Cross-validation over runs (Stone, Journal of the Royal Statistical Society B 36, 1974): runs are left out in turn, the
model is fitted to the others, and judged on those that were left out; without each of its effects, the other
parameters fitted again to first order. An effect that is needed in some folds only stands in for something else.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from pam_cosim.catalogue import EffectClass
from pam_cosim.comparison import Comparison, compare
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import FailedTrial
from pam_cosim.diagnosis.judgement.events import Remark
from pam_cosim.diagnosis.judgement.folds import Folds
from pam_cosim.diagnosis.search.elimination import fitted_with, left_out
from pam_cosim.diagnosis.search.search import FitRequest, Search
from pam_cosim.diagnosis.search.subject import Subject
from pam_cosim.diagnosis.search.trial import (
    Trial,
    attempted,
    begin_of,
    crashed,
    free_parameters,
    values_of_absence,
)
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting import Fit, FitOptions, estimated_starts, fit
from pam_cosim.measurement import DataSet
from pam_cosim.model.references import is_ratio
from pam_cosim.simulation import Simulator


@dataclass(frozen=True)
class FoldTrial:
    """What a worker needs for one fold.

    Attributes:
        trial: the model, and the data with some runs held out.
        members: its effects.
    """

    trial: Trial
    members: tuple[EffectClass, ...]


@dataclass(frozen=True)
class FoldResult:
    """What the runs that were left out say.

    Attributes:
        errors: rms error of each signal [its unit]; ``runs``: names of the runs.
        excess: beyond the noise with all effects [noise variances].
        without: the same without each of the effects of which it is known with which values they vanish.
    """

    errors: Mapping[str, float]
    runs: tuple[str, ...]
    excess: float
    without: Mapping[str, float]

    def needs(self, effect: str) -> bool:
        """Whether the error beyond the noise is visibly less with an effect."""
        if effect not in self.without:
            return True
        more = self.without[effect]
        return more > 0 and more - self.excess >= CRITERIA.evidence.visible * more


def folds_of(subject: Subject, search: Search, effects: Sequence[str], final: Fit) -> Folds | None:
    """Leaves out runs in turn, and asks for each effect whether it is needed then; None: too few runs.

    Args:
        subject: the base model.
        search: with the data.
        effects: of the model.
        final: the model with them, fitted.
    """
    data = list(_folds(search.data))
    if not data:
        return None
    text = f"leaving out runs in turn, in {len(data)} folds: which effects are needed in all?"
    search.say(Remark(text).message)
    results = fold_results(search, data, tuple(effects), final)
    needed = {e: sum(result.needs(e) for result in results) for e in effects}
    ratios = {e: final.values[e] for e in effects if is_ratio(e) and e in final.values}
    limit = CRITERIA.folds.believable
    unbelievable = {e: r for e, r in ratios.items() if not 1 / limit <= r <= limit}
    named = Folds(len(data), needed, unbelievable).named
    if not named:
        results = base_results(subject, search, data)
    elif named != tuple(effects):
        results = fold_results(search, data, named, final)
    errors: dict[str, list[tuple[float, tuple[str, ...]]]] = {}
    for result in results:
        for name, rmse in result.errors.items():
            errors.setdefault(name, []).append((rmse, result.runs))
    middle = {n: float(np.median([rmse for rmse, _ in each])) for n, each in errors.items()}
    worst = {name: max(each) for name, each in errors.items()}
    return Folds(len(data), needed, unbelievable, middle, worst)


def fold_results(
    search: Search, data: Sequence[DataSet], effects: tuple[str, ...], final: Fit
) -> list[FoldResult]:
    """A model with these effects in each fold, a few steps from the final model; without those that break down."""
    members = tuple(map(search.effect, effects))
    trials = [
        FoldTrial(trial, members)
        for fold in data
        for trial in replace(search, data=fold).brief_trials(
            [FitRequest(effects, final.values_and_starts)]
        )
    ]
    results = search.effort.run_tasks(
        run_fold, trials, lambda fold: crashed(fold.trial), lambda _: None, search.workers
    )
    return [r for r in results if isinstance(r, FoldResult)]


def base_results(subject: Subject, search: Search, data: Sequence[DataSet]) -> list[FoldResult]:
    """The base model in each fold; without those in which it breaks down."""
    results = []
    for fold in data:
        with (
            suppress(SimulationFailure),
            search.effort.counting(),
            subject.simulator() as simulator,
        ):
            results.append(_result(fit(simulator, fold, options=FitOptions(rules=False)), {}))
    return results


def _folds(data: DataSet) -> Iterator[DataSet]:
    """The data set with some runs held out and all others fitted, each run once; none of too few runs."""
    count = min(len(data.runs), CRITERIA.folds.most)
    if count < CRITERIA.folds.fewest:
        return
    for fold in range(count):
        runs = (
            replace(r, role="holdout" if i % count == fold else "fit")
            for i, r in enumerate(data.runs)
        )
        yield replace(data, runs=tuple(runs))


def run_fold(fold: FoldTrial) -> FoldResult | FailedTrial:
    """Builds the model, fits it to the runs of a fold, and judges it on the others."""
    return attempted(fold.trial, partial(_left_out, fold), brief=True)


def _left_out(fold: FoldTrial, trial: Trial, simulator: Simulator) -> FoldResult:
    moved, _ = free_parameters(trial, simulator.interface)
    begins = begin_of(trial, simulator.interface)
    best = fit(simulator, trial.data, moved, fixed=begins, options=trial.options)
    without = {}
    parameters = trial.composition.parameters
    for effect in fold.members:
        absent = values_of_absence([effect], parameters)
        if absent and best.linear is not None:
            kept = parameters.keys() - {effect.name}
            values, _ = fitted_with(best.linear, left_out(kept, parameters, best.values, absent))
            without[effect.name] = _excess(_judged(simulator, trial.data, best.values | values))
    return _result(best, without)


def _result(fitted: Fit, without: Mapping[str, float]) -> FoldResult:
    scores = fitted.comparison.scores["holdout"]
    return FoldResult(
        {name: score.rmse for name, score in scores.items()},
        tuple(run.name for run in fitted.comparison.data.holdout_runs),
        _excess(fitted.comparison),
        without,
    )


def _judged(simulator: Simulator, data: DataSet, values: Mapping[str, float]) -> Comparison:
    """The runs that were left out, with given parameters [SI]."""
    held = replace(data, runs=tuple(data.holdout_runs))
    starts = estimated_starts(simulator, data, held.runs, values, second_look=False)
    values_and_starts = {**values, **{name: e.value for name, e in starts.items()}}
    return compare(simulator, held, values_and_starts, rules=False)


def _excess(comparison: Comparison) -> float:
    """Mean square of the error of held-out runs beyond the noise [noise variances]."""
    return max(comparison.chi2_reduced("holdout") - 1.0, 0.0)
