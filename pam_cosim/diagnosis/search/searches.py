"""The searches of a diagnosis: among the fitted runs; among all runs, where held-out runs contradict the first.

Fitted runs may leave the choice between effects to chance that held-out runs tell apart: the model that was chosen, or
the base model already, leaves noise in the first and structure in the others. Then the effects are searched for anew
with all runs fitted. The answer has taken every run there is, so that nothing checks it any more, and it says so.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

from pam_cosim.comparison import without_outliers
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.events import BaseFitted, Remark, SearchRestarted
from pam_cosim.diagnosis.judgement.evidence import (
    contradicted_by_holdout,
    leaves_structure,
    rank,
)
from pam_cosim.diagnosis.judgement.message import Message
from pam_cosim.diagnosis.search.search import Search
from pam_cosim.diagnosis.search.search_result import SearchResult
from pam_cosim.diagnosis.search.selection import select_effects
from pam_cosim.diagnosis.search.subject import Subject
from pam_cosim.fitting import Fit, FitOptions, fit
from pam_cosim.measurement import DataSet, Role
from pam_cosim.simulation import AnySimulator

_ALL_RUNS = "the answer of the fitted runs fails on the held-out runs; restarting the search with all runs fitted"


def fit_base_model(
    simulator: AnySimulator, data: DataSet, say: Callable[[Message], None]
) -> tuple[DataSet, Fit]:
    """The data without outliers, and the base model fitted to them."""
    options = FitOptions(rows=CRITERIA.search.rows, holdout_uncertainty=True)
    base = fit(simulator, data, options=options)
    data, outliers = without_outliers(data, base.comparison.runs)
    if outliers:
        counts = ", ".join(f"{count} of {name}" for name, count in outliers.items())
        say(Remark(f"single samples far off their neighbours are set aside: {counts}").message)
        base = fit(simulator, data, options=options)
    say(BaseFitted(base).message)
    for doubt in base.comparison.doubts:
        say(Remark(f"LOOK FIRST: {doubt.text}").message)
    return data, base


def search_all_runs(subject: Subject, fit_runs_result: SearchResult) -> SearchResult | None:
    """The result for all runs, where held-out runs contradict that for the fitted ones, or the base model alone.

    None where they do not, where all runs together leave structure too, and where the effort is spent.

    Args:
        subject: the model and the measurement.
        fit_runs_result: what the fitted runs came to.
    """
    search = fit_runs_result.search
    # fitted runs in which the base model leaves noise cannot tell what is missing in the others
    contradicted = any(
        contradicted_by_holdout(fit, fit_runs_result.base)
        for fit in (fit_runs_result.last, fit_runs_result.base)
    )
    if not contradicted or search.effort.spent:
        return None
    search.say(SearchRestarted(_ALL_RUNS).message)
    data = _with_roles(search.recorded or search.data, ["fit"] * len(search.data.runs))
    result = _restarted(subject, search, data, fit_runs_result.tried)
    if result.untried or not result.path or leaves_structure(result.last):
        return None
    return result


def with_effects(result: SearchResult, effects: Sequence[str]) -> SearchResult:
    """The same, the model with only some of its effects."""
    known = {c.effects: c for c in result.tried if not c.brief}
    steps = [tuple(effects[: k + 1]) for k in range(len(effects))]
    models = (known.get(s) or result.search.fit_final(s, result.last.values) for s in steps)
    return replace(result, path=_path(result.base, filter(None, models)))


def _path(base: Fit, models: Iterable[Candidate]) -> tuple[Candidate, ...]:
    """Models with their evidence, each compared with the one before."""
    path: list[Candidate] = []
    for c in models:
        path += rank(path[-1].fit if path else base, [c.without_slopes])
    return tuple(path)


def _restarted(
    subject: Subject, search: Search, recorded: DataSet, earlier: Sequence[Candidate] = ()
) -> SearchResult:
    """The result of a search from anew on other data."""
    with search.effort.counting(), subject.simulator() as simulator:
        data, base = fit_base_model(simulator, recorded, search.say)
    search = replace(
        search,
        data=data,
        recorded=recorded,
        failed=[],
        undetectable=frozenset(),
        inactive_parameters={},
    )
    return select_effects(search, base, earlier=earlier)


def _with_roles(data: DataSet, roles: Sequence[Role]) -> DataSet:
    return replace(
        data,
        runs=tuple(replace(run, role=role) for run, role in zip(data.runs, roles, strict=True)),
    )


def refit_by_role(fit_runs_result: SearchResult, all_runs_result: SearchResult) -> SearchResult:
    """What all runs came to as the fitted runs alone have it: fitted to these, the others held out.

    Args:
        fit_runs_result: what the fitted runs came to. all_runs_result: what all runs came to.
    """
    roles = [run.role for run in fit_runs_result.search.data.runs]
    data = _with_roles(all_runs_result.search.data, roles)
    recorded = _with_roles(all_runs_result.search.recorded or data, roles)
    search = replace(all_runs_result.search, data=data, recorded=recorded)
    base = fit_runs_result.base.against(data)
    models = (
        search.fit_final(c.effects, c.fit.values) or replace(c, fit=c.fit.against(data))
        for c in all_runs_result.path
    )
    return replace(
        all_runs_result,
        search=search,
        base=base,
        path=_path(base, models),
    )
