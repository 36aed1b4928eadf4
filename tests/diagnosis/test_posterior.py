"""The probabilities of what may be missing: of sets of families, of nothing, of what no effect describes."""

from __future__ import annotations

import math
from collections.abc import Sequence

import pytest

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis import Candidate
from pam_cosim.diagnosis.judgement.posterior import (
    DOUBTS,
    Posterior,
    posterior,
    something_else,
)
from tests.diagnosis.synthetic import candidate, fitted, judged, models_of

BASE = fitted(10.0, holdout=9.0, score=50.0)
GOOD = candidate("Leak", fitted(1.0, holdout=1.0), "leak")
SURE = frozenset[str]()


def near(effect: str, family: str, reduced: float = 1.003) -> Candidate:
    """A model that fits nearly as well."""
    return candidate(effect, fitted(reduced, holdout=1.0), family)


def known(best: Candidate | None, tried: Sequence[Candidate]) -> Posterior:
    return posterior(models_of(BASE, [best] if best else [], tried, every=40), SURE)


def test_they_sum_to_one_and_the_answer_comes_first() -> None:
    own = known(GOOD, [GOOD, near("Wall", "wall"), near("Gauge", "gauge", 1.01)])
    assert sum(one.probability for one in own.explanations) + own.something_else == pytest.approx(
        1.0
    )
    assert own.explanations[0].families == ("leak",) and own.explanations[0].evidence == 0
    assert set(own.by_family) == {"leak", "wall", "gauge"}
    shares = [one.probability for one in own.explanations]
    assert shares == sorted(shares, reverse=True)


def test_odds_are_those_of_the_tempered_evidence() -> None:
    own = known(GOOD, [GOOD, near("Wall", "wall")])
    by = {one.families: one for one in own.explanations}
    ratio = by["leak",].probability / by["wall",].probability
    assert ratio == pytest.approx(
        math.exp(by["wall",].evidence / (2 * CRITERIA.evidence.temperature))
    )
    assert by[()].probability < 1e-6  # the base model leaves ten times the noise


def test_a_family_counts_once_by_its_best_member() -> None:
    twice = known(GOOD, [GOOD, near("Wall", "wall"), near("Other", "wall", 1.01)])
    once = known(GOOD, [GOOD, near("Wall", "wall")])
    assert twice.by_family == pytest.approx(once.by_family)


@pytest.mark.parametrize("doubt", DOUBTS)
def test_every_doubt_makes_something_else_more_probable(doubt: str) -> None:
    assert 0 < something_else(SURE) < something_else({doubt}) < 1


def test_an_unknown_verdict_is_something_else_as_a_rule() -> None:
    left = candidate("Leak", fitted(4.0, holdout=4.0, score=40.0), "leak")
    verdict = judged(BASE, [left], [], [left], {"Leak": "leak"}, 40)
    assert (
        verdict.kind == "unknown" and verdict.posterior.something_else > 0.5 > verdict.probability
    )
    assert "Otherwise: something else" in str(verdict)


def test_the_probability_of_a_verdict_is_that_of_what_it_names() -> None:
    rival, family = near("Wall", "wall", 1.0005), {"Leak": "leak", "Wall": "wall", "Gauge": "gauge"}
    tried = [GOOD, rival, near("Gauge", "gauge", 1.02)]
    both = judged(BASE, [GOOD], [rival], tried, family, 40)
    own = {one.families: one.probability for one in both.posterior.explanations}
    assert both.kind == "ambiguous" and both.probability == pytest.approx(
        own["leak",] + own["wall",]
    )
    one = judged(BASE, [GOOD], [], tried, family, 40)
    assert one.probability == pytest.approx(own["leak",])
    content = one.as_dict()["posterior"]
    assert isinstance(content, dict) and set(content["families"]) == {"leak", "wall", "gauge"}
