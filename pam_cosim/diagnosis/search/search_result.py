"""The result of a search: the models that it has fitted, with the data that they are judged by."""

from __future__ import annotations

from dataclasses import dataclass

from pam_cosim.diagnosis.judgement.fitted_models import FittedModels
from pam_cosim.diagnosis.search.probing import EffectProbe
from pam_cosim.diagnosis.search.search import Search


@dataclass(frozen=True, kw_only=True)
class SearchResult(FittedModels):
    """The models that a search has fitted.

    Attributes:
        search: with the data that the models are judged by.
        untried: effects of the models that promised to be better when the effort was spent, the most promising first.
        probes: what each effect does beside the base model; none where nothing had to be looked for.
    """

    search: Search
    untried: tuple[tuple[str, ...], ...] = ()
    probes: tuple[EffectProbe, ...] = ()
