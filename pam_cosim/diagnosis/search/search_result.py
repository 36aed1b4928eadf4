"""The result of a search: the models that it has fitted, with the data that they are judged by."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field

from pam_cosim.diagnosis.judgement.fitted_models import FittedModels
from pam_cosim.diagnosis.search.probing import EffectProbe
from pam_cosim.diagnosis.search.search import Search
from pam_cosim.diagnosis.search.step_times import Retimed


@dataclass(frozen=True, kw_only=True)
class SearchResult(FittedModels):
    """The models that a search has fitted.

    Attributes:
        search: with the data that the models are judged by.
        untried: effects of the models that promised to be better when the effort was spent, the most promising first.
        outliers: how many single samples were set aside on the way, by signal.
        step_times: how many steps of commands got a time between two samples.
        probes: what each effect does beside the base model; none where nothing had to be looked for.
        retimed: the data with commands that step between two samples at the times that explain what else remains, to
            select from anew; None: as they are.
    """

    search: Search
    untried: tuple[tuple[str, ...], ...] = ()
    outliers: Counter[str] = field(default_factory=Counter)
    step_times: int = 0
    probes: tuple[EffectProbe, ...] = ()
    retimed: Retimed | None = None
