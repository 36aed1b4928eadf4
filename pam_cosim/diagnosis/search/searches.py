"""The base model that a search begins with, and its answer with fewer effects."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from pam_cosim.comparison import without_outliers
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.events import BaseFitted, Remark
from pam_cosim.diagnosis.judgement.evidence import rank
from pam_cosim.diagnosis.judgement.message import Message
from pam_cosim.diagnosis.search.search import FitRequest, Search
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


def one_by_one(
    search: Search,
    base: Fit,
    effects: Sequence[str],
    start: Mapping[str, float],
    fitted: dict[tuple[str, ...], Candidate],
) -> list[Candidate]:
    """A model's effects, added one after another, each with its evidence beside the model before.

    The model itself is fitted to the end; what leads there in a few steps, from the model with one effect more, which
    is enough to show how the error falls.

    Args:
        search: with the data.
        base: the model without effects.
        effects: of the model.
        start: values to start from [SI].
        fitted: models that were fitted, by their effects; what is fitted here is added.
    """
    models: list[Candidate] = []
    for count in range(len(effects), 0, -1):
        names = tuple(effects[:count])
        model = _in_order(search, names, fitted)
        if count == len(effects) and (model is None or model.brief or model.general):
            model = search.fit_final(names, start)
        elif model is None:
            request = (
                search.without_others(models[-1], names) if models else FitRequest(names, start)
            )
            model = next(iter(search.fit_briefly([request])), None)
        if model is not None:
            fitted[names] = model
            models.append(model)
    ranked: list[Candidate] = []
    for model in reversed(models):
        ranked += rank(ranked[-1].fit if ranked else base, [model])
    return ranked


def _in_order(
    search: Search, names: tuple[str, ...], fitted: Mapping[tuple[str, ...], Candidate]
) -> Candidate | None:
    """The model with these effects that was fitted, in whichever order they were added; None: there is none."""
    same = [c for effects, c in fitted.items() if frozenset(effects) == frozenset(names)]
    best = min(same, key=lambda c: (c.brief, c.fit.chi2_minimised), default=None)
    return best if best is None or best.effects == names else search.in_order(best, names)


def with_effects(result: SearchResult, effects: Sequence[str]) -> SearchResult:
    """The same, the model with only some of its effects."""
    fitted = {c.effects: c for c in result.tried}
    start = result.last.values_and_starts
    models = one_by_one(result.search, result.base, effects, start, fitted)
    return replace(result, path=tuple(c.without_slopes for c in models))
