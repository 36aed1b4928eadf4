"""Which effects of a model are needed whichever runs are left out, and how good the model is on runs it never saw.

Cross-validation over runs (Stone, Journal of the Royal Statistical Society B 36, 1974): runs are left out in turn, the
model is fitted to the others with all its effects and without each of them, and judged on those that were left out. An
effect that is needed in some folds only stands in for something else.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace

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
    without = {e: tuple(other for other in every if other != e) for e in every}
    fits = [
        _refitted(subject, search, one, [every, *without.values()], final.values) for one in data
    ]
    needed = {e: sum(_is_needed(f.get(every), f.get(without[e])) for f in fits) for e in every}
    ratios = {e: final.values[e] for e in every if is_ratio(e) and e in final.values}
    limit = CRITERIA.folds.believable
    unbelievable = {e: r for e, r in ratios.items() if not 1 / limit <= r <= limit}
    named = Folds(len(data), needed, unbelievable).named
    if named != every:
        fits = [_refitted(subject, search, one, [named], final.values) for one in data]
    errors: dict[str, list[tuple[float, tuple[str, ...]]]] = {}
    for comparison in (f[named].comparison for f in fits if named in f):
        runs = tuple(r.run.name for r in comparison.runs if r.run.role == "holdout")
        for name, score in comparison.scores["holdout"].items():
            errors.setdefault(name, []).append((score.rmse, runs))
    middle = {n: float(np.median([rmse for rmse, _ in each])) for n, each in errors.items()}
    worst = {name: max(each) for name, each in errors.items()}
    return Folds(len(data), needed, unbelievable, middle, worst)


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


def _refitted(
    subject: Subject,
    search: Search,
    data: DataSet,
    models: Sequence[tuple[str, ...]],
    values: Mapping[str, float],
) -> dict[tuple[str, ...], Fit]:
    """Models with these effects, fitted anew; without those that break down."""
    wanted = [FitRequest(effects, values) for effects in models if effects]
    fits = {c.effects: c.fit for c in replace(search, data=data, failed=[]).refit(wanted)}
    if () in models:
        with (
            suppress(SimulationFailure),
            search.effort.counting(),
            subject.simulator() as simulator,
        ):
            fits[()] = fit(simulator, data, options=FitOptions(rules=False))
    return fits


def _is_needed(with_it: Fit | None, without: Fit | None) -> bool:
    """Whether the error of the runs that were left out, beyond the noise, is visibly less with an effect."""
    if with_it is None or without is None:
        return with_it is not None
    less, more = (max(f.comparison.chi2_reduced("holdout") - 1.0, 0.0) for f in (with_it, without))
    return more > 0 and more - less >= CRITERIA.folds.visible * more
