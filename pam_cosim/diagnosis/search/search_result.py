"""What a search comes to that is given the fitted runs; where held-out runs contradict it, what all runs come to.

Fitted runs may leave the choice between effects to chance that held-out runs tell apart: the model that was chosen, or
the base model already, leaves noise in the first and structure in the others. Then the effects are searched for anew
with all runs fitted. The answer has taken every run there is, so that nothing checks it any more, and it says so.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from pam_cosim.comparison import without_outliers
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.events import (
    AllRunsSearched,
    BaseFitted,
    DoubtRaised,
    OutliersSetAside,
    StepTimesFound,
)
from pam_cosim.diagnosis.judgement.evidence import (
    contradicted_by_holdout,
    leaves_structure,
    rank,
)
from pam_cosim.diagnosis.judgement.message import Message
from pam_cosim.diagnosis.search.search import Search
from pam_cosim.diagnosis.search.selection import Selection, select_effects
from pam_cosim.diagnosis.search.subject import Subject
from pam_cosim.fitting import Fit, FitOptions, fit
from pam_cosim.measurement import DataSet, Role
from pam_cosim.simulation import Simulator


@dataclass(frozen=True)
class SearchResult:
    """The models that the answer is judged by.

    Attributes:
        search: with the data.
        base: the model without effects, fitted.
        selection: the models with effects.
        outliers: how many single samples were set aside, by signal.
        step_times: how many steps of commands got a time between two samples.
    """

    search: Search
    base: Fit
    selection: Selection
    outliers: Mapping[str, int] = field(default_factory=dict)
    step_times: int = 0

    @property
    def path(self) -> tuple[Candidate, ...]:
        """The effects that are needed, one after another."""
        return self.selection.path

    @property
    def last(self) -> Fit:
        """The model with all of them."""
        return self.path[-1].fit if self.path else self.base


def fit_base_model(
    simulator: Simulator, data: DataSet, say: Callable[[Message], None]
) -> tuple[DataSet, Fit, dict[str, int]]:
    """The data without outliers, the base model fitted to them, and how many samples were set aside."""
    options = FitOptions(rows=CRITERIA.search.rows, holdout_uncertainty=True)
    base = fit(simulator, data, options=options)
    data, outliers = without_outliers(data, base.comparison.runs)
    if outliers:
        say(OutliersSetAside(outliers).message)
        base = fit(simulator, data, options=options)
    say(BaseFitted(base).message)
    for doubt in base.comparison.doubts:
        say(DoubtRaised(doubt).message)
    return data, base, outliers


def search_fit_runs(
    subject: Subject, search: Search, base: Fit, outliers: Mapping[str, int]
) -> SearchResult:
    """What the fitted runs come to; from anew where steps of commands get their times between two samples.

    Args:
        subject: the model and the measurement.
        search: tries effects on the data.
        base: the model without effects, fitted to these.
        outliers: that were set aside for it.
    """
    selection, steps = select_effects(search, base), 0
    before = Counter[str]()
    if selection.retimed is not None:
        steps = selection.retimed.steps
        before = Counter(outliers) + Counter(selection.outliers)
        search.say(StepTimesFound(steps).message)
        search, base, outliers = _restarted(subject, search, selection.retimed.data)
        selection = select_effects(search, base, retime=False)
    set_aside = before + Counter(outliers) + Counter(selection.outliers)
    return SearchResult(selection.search, selection.base, selection, set_aside, steps)


def search_all_runs(subject: Subject, fit_runs_result: SearchResult) -> SearchResult | None:
    """What all runs come to, where held-out runs contradict what the fitted ones did, or the base model alone.

    None where they do not, where all runs together leave structure too, and where the effort is spent.

    Args:
        subject: as for ``search_fit_runs``.
        fit_runs_result: what the fitted runs came to.
    """
    # fitted runs in which the base model leaves noise cannot tell what is missing in the others
    contradicted = any(
        contradicted_by_holdout(fit, fit_runs_result.base)
        for fit in (fit_runs_result.last, fit_runs_result.base)
    )
    if not contradicted or fit_runs_result.search.effort.spent:
        return None
    fit_runs_result.search.say(AllRunsSearched().message)
    roles: list[Role] = ["fit"] * len(fit_runs_result.search.data.runs)
    search, base, outliers = _restarted(
        subject, fit_runs_result.search, _with_roles(fit_runs_result.search.data, roles)
    )
    earlier = fit_runs_result.selection.tried
    selection = select_effects(search, base, retime=False, earlier=earlier)
    set_aside = Counter(outliers) + Counter(selection.outliers)
    all_runs_result = SearchResult(selection.search, selection.base, selection, set_aside)
    if selection.untried or not all_runs_result.path or leaves_structure(all_runs_result.last):
        return None
    return all_runs_result


def with_effects(fit_runs_result: SearchResult, effects: Sequence[str]) -> SearchResult:
    """The same, the model with only some of its effects."""
    path: list[Candidate] = []
    known = {c.effects: c for c in fit_runs_result.selection.tried if not c.brief}
    for k in range(1, len(effects) + 1):
        names = tuple(effects[:k])
        candidate = known.get(names) or fit_runs_result.search.fit_final(
            names, fit_runs_result.last.values
        )
        if candidate is not None:
            path += rank(path[-1].fit if path else fit_runs_result.base, [candidate.without_slopes])
    return replace(fit_runs_result, selection=replace(fit_runs_result.selection, path=tuple(path)))


def _restarted(
    subject: Subject, search: Search, data: DataSet
) -> tuple[Search, Fit, Mapping[str, int]]:
    with search.effort.counting(), subject.simulator() as simulator:
        data, base, outliers = fit_base_model(simulator, data, search.say)
    return (
        replace(search, data=data, failed=[], undetectable=frozenset(), inactive_parameters={}),
        base,
        outliers,
    )


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
    data = _with_roles(
        all_runs_result.search.data, [run.role for run in fit_runs_result.search.data.runs]
    )
    search, base = replace(all_runs_result.search, data=data), fit_runs_result.base.against(data)
    path: list[Candidate] = []
    for candidate in all_runs_result.path:
        refitted = search.fit_final(candidate.effects, candidate.fit.values)
        refitted = refitted or replace(candidate, fit=candidate.fit.against(data))
        path += rank(path[-1].fit if path else base, [refitted])
    outliers = Counter(fit_runs_result.outliers) + Counter(all_runs_result.outliers)
    return SearchResult(
        search,
        base,
        replace(all_runs_result.selection, path=tuple(c.without_slopes for c in path)),
        outliers,
        fit_runs_result.step_times,
    )
