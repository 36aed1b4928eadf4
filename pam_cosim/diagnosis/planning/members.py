"""Which models stand for the explanations that a verdict leaves: of each, the laws of its families that fit as well."""

from __future__ import annotations

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.diagnose import Diagnosis
from pam_cosim.diagnosis.judgement.candidate import Candidate

_MOST_LAWS = 3  # of each remaining explanation, that fit as well


def members(diagnosis: Diagnosis) -> list[list[Candidate]]:
    """The models of each explanation that is left, best first.

    An explanation is a set of families. Which of their laws is the right one may be as open as the families are: a run
    that separates one leak from a wall that warms up need not separate another leak from it.
    """
    return [laws_of(diagnosis, best) for best in diagnosis.rival_models]


def laws_of(diagnosis: Diagnosis, best: Candidate) -> list[Candidate]:
    """A model, and the other laws of its families that fit as well."""
    family = {c.effect: c.family for c in diagnosis.candidates}
    return [best, *_alike(diagnosis, best, family)]


def _alike(diagnosis: Diagnosis, best: Candidate, family: dict[str, str]) -> list[Candidate]:
    """Other laws of the same families, with no more parameters, whose chi-square is hardly larger than the best one's.

    A law with more parameters bends towards any rival until it is measured everywhere.
    """
    families_of_best, limit = _families(best, family), _chi2(best) + CRITERIA.evidence.very_strong
    fitted = [
        c
        for c in diagnosis.candidates
        if c.effects != best.effects and not c.brief and not c.has_general_member
    ]
    alternatives = [
        c
        for c in fitted
        if _families(c, family) == families_of_best
        and len(c.fit.parameters) <= len(best.fit.parameters)
    ]
    alternatives = sorted(
        (c for c in alternatives if _chi2(c) <= limit), key=lambda c: (_chi2(c), c.effects)
    )
    return alternatives[: _MOST_LAWS - 1]


def _families(candidate: Candidate, family: dict[str, str]) -> list[str]:
    return sorted(family.get(effect, effect) for effect in candidate.effects)


def _chi2(candidate: Candidate) -> float:
    """Of all runs; nothing is known of a fit without residuals, which is as good as any."""
    return sum(s.chi2 for s in candidate.fit.residuals.values() if s.samples)
