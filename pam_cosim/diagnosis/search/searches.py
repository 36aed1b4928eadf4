"""The base model that a search begins with, and its answer with fewer effects."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace

from pam_cosim.comparison import without_outliers
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.events import BaseFitted, Remark
from pam_cosim.diagnosis.judgement.evidence import rank
from pam_cosim.diagnosis.judgement.message import Message
from pam_cosim.diagnosis.search.search_result import SearchResult
from pam_cosim.fitting import Fit, FitOptions, base_parameters, fit
from pam_cosim.measurement import DataSet
from pam_cosim.simulation import AnySimulator


def fit_base_model(
    simulator: AnySimulator, data: DataSet, say: Callable[[Message], None]
) -> tuple[DataSet, Fit]:
    """The data without outliers, and the base model fitted to them."""
    numbers = CRITERIA.search
    options = FitOptions(
        rows=numbers.rows,
        precision=numbers.precision,
        evaluations=numbers.evaluations,
        holdout_uncertainty=True,
    )
    base = fit(simulator, data, options=options)
    data, outliers = without_outliers(data, base.comparison.runs)
    if outliers:
        counts = ", ".join(f"{count} of {name}" for name, count in outliers.items())
        say(Remark(f"single samples far off their neighbours are set aside: {counts}").message)
        free = base_parameters(data, simulator.interface)
        again = [f.starting_at(base.values[f.name]) for f in free]
        base = fit(simulator, data, again, fixed=base.start_values, options=options)
    say(BaseFitted(base).message)
    for doubt in base.comparison.doubts:
        say(Remark(f"LOOK FIRST: {doubt.text}").message)
    return data, base


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
