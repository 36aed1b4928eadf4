"""The families that may be missing, each with its probability and what it is worth, whatever else is missing.

A laboratory asks of each family whether it is missing, not of an exact set. The probability of a family is summed over
the models that were fitted; families of which one stands for another are a row together.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.fitted_models import FittedModels
from pam_cosim.diagnosis.judgement.posterior import Posterior
from pam_cosim.diagnosis.judgement.size import EffectSize, size_of_effect
from pam_cosim.files import Plain

_LISTED = 0.05  # probability of a row at least
_SURE = 0.95  # of one family, which then needs no other one in its row
_EXCLUSIVE = 0.9  # of its probability, that a family has without the others of its row


@dataclass(frozen=True)
class FamilyRow(Plain):
    """One family, or several of which one is missing.

    Attributes:
        families: their names.
        probability: that one of them is missing, whatever else is.
        effects: of the answer, or else of the best model that has one of them.
        share: of the base model's error beyond the noise that they remove, the others fitted again; None: no model
            without them was fitted.
        rms: root of the mean square that they remove, by fitted signal [SI].
    """

    families: tuple[str, ...]
    probability: float
    effects: tuple[str, ...] = ()
    share: float | None = None
    rms: dict[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class FamilyTable(Plain):
    """The families that may be missing.

    Attributes:
        rows: the most probable first.
        small: effects that are measurable, but too small to be called missing.
        unexplained: share of the base model's error beyond the noise that the answer leaves.
    """

    rows: tuple[FamilyRow, ...] = ()
    small: tuple[FamilyRow, ...] = ()
    unexplained: float = 0.0


def family_table(models: FittedModels, probabilities: Posterior) -> FamilyTable:
    """The table of a search's models and their probabilities."""
    named_effects = [*models.path[-1].effects] if models.path else []
    groups = _exchanged(probabilities)
    rows = []
    for families, probability in groups:
        effects = tuple(e for e in named_effects if models.family[e] in families)
        size = _size(models, named_effects, effects)
        rows.append(_row(models, families, probability, effects, size))
    base, last = models.base.residuals["fit"], models.last.residuals["fit"]
    remaining_error = last.excess / base.excess if base.excess > 0 else 0.0
    rows.sort(key=lambda row: (-row.probability, -(row.share or 0.0), row.families))
    return FamilyTable(tuple(rows), tuple(_small(models)), min(remaining_error, 1.0))


def credibility(models: FittedModels) -> dict[str, float]:
    """How far each family of an answer that leaves structure is believed, by what it is worth beside what is left."""
    effects = models.path[-1].effects if models.path else ()
    sizes = {e: _size(models, effects, (e,)) for e in effects}
    return {models.family[e]: size.credibility for e, size in sizes.items() if size}


def _row(
    models: FittedModels,
    families: tuple[str, ...],
    probability: float,
    effects: tuple[str, ...],
    size: EffectSize | None,
) -> FamilyRow:
    if size is None:
        return FamilyRow(families, probability, effects)
    scores = models.base.comparison.scores["all"]
    rms = {name: number * scores[name].noise_rmse for name, number in size.rms.items()}
    return FamilyRow(families, probability, effects, size.share, rms)


def _exchanged(probabilities: Posterior) -> list[tuple[tuple[str, ...], float]]:
    """Families with their probabilities, those together that exclude each other where one of them is missing."""
    remaining_families = {f: p for f, p in probabilities.by_family.items() if p >= _LISTED}
    groups = []
    while remaining_families:
        first = next(iter(remaining_families))
        group = [first]
        for other in [f for f in remaining_families if f != first]:
            if remaining_families[first] < _SURE and probabilities.probability_of_any(
                [*group, other]
            ) >= (probabilities.probability_of_any(group) + _EXCLUSIVE * remaining_families[other]):
                group.append(other)
        groups.append((tuple(group), probabilities.believed(group)))
        remaining_families = {f: p for f, p in remaining_families.items() if f not in group}
    return groups


def _size(
    models: FittedModels, named_effects: Sequence[str], effects: Sequence[str]
) -> EffectSize | None:
    """What effects of the answer are worth: the answer compared with the best model without them; None: not known."""
    remaining_effects = frozenset(named_effects) - frozenset(effects)
    if not effects:
        return None
    without = models.base if not remaining_effects else None
    if without is None:
        fits = [c.fit for c in models.tried if frozenset(c.effects) == remaining_effects]
        without = min(fits, key=lambda fit: fit.chi2_minimised, default=None)
    return size_of_effect(models.base, without, models.last) if without else None


def _small(models: FittedModels) -> Iterable[FamilyRow]:
    """Effects that would be worth adding by the evidence, and are too small."""
    if not models.path:
        return
    answer = models.path[-1]
    limit = models.criterion(answer) - CRITERIA.evidence.very_strong
    larger_models = [c for c in models.tried if frozenset(c.effects) > frozenset(answer.effects)]
    best: dict[str, Candidate] = {}
    for c in sorted(larger_models, key=lambda c: (models.criterion(c), c.effects)):
        if len(c.effects) == len(answer.effects) + 1 and models.criterion(c) < limit:
            (added,) = frozenset(c.effects) - frozenset(answer.effects)
            best.setdefault(added, c)
    for effect, c in best.items():
        size = size_of_effect(models.base, answer.fit, c.fit)
        if not size.matters():
            yield _row(models, (models.family[effect],), 0.0, (effect,), size)
