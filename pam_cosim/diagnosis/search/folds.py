"""Which effects of a model are needed whichever runs are left out, and how good the model is on runs it never saw.

Cross-validation over runs (Stone, Journal of the Royal Statistical Society B 36, 1974): runs are left out in turn, the
model is fitted to the others with all its effects and without each of them, and judged on those that were left out. An
effect that is needed in some folds only stands in for something else.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.events import Remark
from pam_cosim.diagnosis.judgement.folds import Folds
from pam_cosim.diagnosis.search.search import FitRequest, Search
from pam_cosim.diagnosis.search.subject import Subject
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting import Fit, FitOptions, fit
from pam_cosim.measurement import DataSet
from pam_cosim.model.references import is_ratio


@dataclass(frozen=True)
class _HoldoutError:
    """What a model leaves on runs that were left out: error by signal [its unit], and all in noise variances."""

    rmse: Mapping[str, float]
    chi2: float
    runs: tuple[str, ...] = ()

    @property
    def excess(self) -> float:
        """What is left beyond the noise, in noise variances."""
        return max(self.chi2 - 1.0, 0.0)


def folds_of(subject: Subject, search: Search, effects: Sequence[str], final: Fit) -> Folds | None:
    """Leaves out runs in turn, and asks for each effect whether it is needed then; None: too few runs.

    Args:
        subject: the model and the measurement.
        search: with the data.
        effects: of the model.
        final: the model with them, fitted.
    """
    data = list(_folds(search.data))
    if not data:
        return None
    text = f"leaving out runs in turn, in {len(data)} folds: which effects are needed in all?"
    search.say(Remark(text).message)
    every = tuple(effects)
    without = {e: tuple(one for one in every if one != e) for e in every}
    errors, needed = [], dict.fromkeys(every, 0)
    for one in data:
        of_models = _holdout_errors(subject, search, one, [every, *without.values()], final.values)
        errors.append(of_models[every])
        for e, others in without.items():
            needed[e] += _is_needed(of_models[every], of_models[others])
    folds = Folds(len(data), needed, _unbelievable(every, final.values))
    named = folds.named
    if named != every:
        errors = [
            _holdout_errors(subject, search, one, [named], final.values)[named] for one in data
        ]
    return _with_errors(folds, [error for error in errors if error is not None])


def _unbelievable(effects: Sequence[str], values: Mapping[str, float]) -> dict[str, float]:
    """Ratios to what is stated that are too far from one, by the name of the effect."""
    ratios = {e: values[e] for e in effects if is_ratio(e) and e in values}
    limit = CRITERIA.folds.believable
    return {e: ratio for e, ratio in ratios.items() if not 1 / limit <= ratio <= limit}


def _with_errors(folds: Folds, errors: Sequence[_HoldoutError]) -> Folds:
    """With the error of each signal in the middle fold and in the worst."""
    by_signal: dict[str, list[tuple[float, tuple[str, ...]]]] = {}
    for error in errors:
        for name, rmse in error.rmse.items():
            by_signal.setdefault(name, []).append((rmse, error.runs))
    middle = {
        name: float(np.median([rmse for rmse, _ in each])) for name, each in by_signal.items()
    }
    return replace(folds, rmse=middle, worst={name: max(each) for name, each in by_signal.items()})


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


def _holdout_errors(
    subject: Subject,
    search: Search,
    data: DataSet,
    models: Sequence[tuple[str, ...]],
    values: Mapping[str, float],
) -> dict[tuple[str, ...], _HoldoutError | None]:
    """What models with these effects, fitted anew, leave on the runs that are held out; None: one broke down."""
    wanted = [FitRequest(effects, values) for effects in models if effects]
    fits = {c.effects: c.fit for c in replace(search, data=data, failed=[]).refit(wanted)}
    if () in models:
        fits |= _without_effects(subject, search, data)
    return {
        effects: _holdout_error(fits[effects]) if effects in fits else None for effects in models
    }


def _without_effects(subject: Subject, search: Search, data: DataSet) -> dict[tuple[str, ...], Fit]:
    try:
        with search.effort.counting(), subject.simulator() as simulator:
            return {(): fit(simulator, data, options=FitOptions(rules=False))}
    except SimulationFailure:
        return {}


def _holdout_error(model: Fit) -> _HoldoutError:
    comparison = model.comparison
    rmse = {n: s.rmse for n, s in comparison.scores["holdout"].items()}
    runs = tuple(r.run.name for r in comparison.runs if r.run.role == "holdout")
    return _HoldoutError(rmse, comparison.chi2_reduced("holdout"), runs)


def _is_needed(with_it: _HoldoutError | None, without: _HoldoutError | None) -> bool:
    """Whether what is left beyond the noise is visibly less with an effect."""
    if with_it is None or without is None:
        return with_it is not None
    return (
        without.excess > 0
        and without.excess - with_it.excess >= CRITERIA.folds.visible * without.excess
    )
