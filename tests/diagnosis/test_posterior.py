"""The probabilities of what may be missing: of sets of families, of nothing, of what no effect describes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import pytest

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis import Candidate, Verdict
from pam_cosim.diagnosis.judgement.posterior import (
    DOUBTS,
    Posterior,
    doubts_of,
    posterior,
    something_else,
)
from pam_cosim.reporting.account import probability_rows
from tests.diagnosis.synthetic import candidate, fitted, judged, models_of

BASE = fitted(10.0, holdout=9.0, score=50.0)
GOOD = candidate("Leak", fitted(1.0, holdout=1.0), "leak")
FAR = candidate("Wall", fitted(3.0, holdout=3.0), "wall")
SURE = frozenset[str]()
FAMILY = {"Leak": "leak", "Wall": "wall", "Gauge": "gauge"}


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


def test_brief_fits_and_larger_sets_do_not_count() -> None:
    brief = replace(near("Wall", "wall"), brief=True)
    pair = candidate("Gauge", fitted(0.99, holdout=1.0), "gauge", before=("Leak",))
    own = posterior(
        models_of(
            BASE,
            [GOOD],
            [GOOD, brief, pair],
            {"Leak": "leak", "Wall": "wall", "Gauge": "gauge"},
            40,
        ),
        SURE,
    )
    assert set(own.by_family) == {"leak"}


def test_a_family_that_is_in_several_sets_is_counted_with_all_of_them() -> None:
    pair = candidate("Gauge", fitted(1.0, holdout=1.0), "gauge", before=("Leak",))
    other = candidate("Wall", fitted(1.001, holdout=1.0), "wall", before=("Leak",))
    own = posterior(
        models_of(
            BASE, [pair], [pair, other], {"Leak": "leak", "Wall": "wall", "Gauge": "gauge"}, 40
        ),
        SURE,
    )
    assert own.by_family["leak"] == pytest.approx(own.by_family["gauge"] + own.by_family["wall"])
    assert next(iter(own.by_family)) == "leak"


@pytest.mark.parametrize("doubt", DOUBTS)
def test_every_doubt_makes_something_else_more_probable(doubt: str) -> None:
    assert 0 < something_else(SURE) < something_else({doubt}) < 1


def test_doubts_of_answers() -> None:
    assert doubts_of([GOOD], structure=False, form_open=False) == SURE
    alone = candidate("Leak", fitted(1.0), "leak")  # nothing was held out
    assert doubts_of([alone], structure=False, form_open=False) == {"unchecked"}
    assert doubts_of([], structure=False, form_open=False) == {"nothing"}
    assert doubts_of([GOOD], structure=True, form_open=True) == {"form_open"}
    pair = replace(candidate("Gauge", GOOD.fit, "gauge", before=("Leak",)), general=True)
    assert doubts_of([pair], structure=False, form_open=False) == {"several", "general"}
    assert doubts_of([pair], structure=True, form_open=False) == {"structure"}


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


def test_the_bar_of_a_verdict() -> None:
    tried = [GOOD, near("Wall", "wall", 1.0005), FAR]
    family = {"Leak": "leak", "Wall": "wall"}
    verdict = judged(BASE, [GOOD], [], tried, family, 40)
    rows = probability_rows(verdict)
    assert [row.what for row in rows] == ["leak", "wall", "something no effect describes"]
    assert [row.named for row in rows] == [True, False, False]
    assert sum(row.probability for row in rows) == pytest.approx(1.0, abs=0.006)


def test_a_verdict_of_before_states_none() -> None:
    """One that was saved without them."""
    verdict = Verdict("identified", ("leak",), ("Leak",), probability=0.93)
    assert "Otherwise" not in str(verdict) and probability_rows(verdict) == []
    content = verdict.as_dict()["posterior"]
    assert content == {"explanations": [], "families": {}, "something_else": None, "doubts": []}
