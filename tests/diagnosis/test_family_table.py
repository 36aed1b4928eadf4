"""The table of families: probabilities of families, whatever else is missing, and rows of those that exchange."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from pam_cosim.diagnosis.judgement.family_table import family_table
from pam_cosim.diagnosis.judgement.posterior import Explanation, Posterior
from pam_cosim.diagnosis.judgement.size import EffectSize, size_of_effect
from pam_cosim.diagnosis.judgement.verdict_sentences import table_lines
from pam_cosim.fitting import Fit
from tests.diagnosis.synthetic import candidate, fitted, judged, models_of

BASE = fitted(100.0, score=50.0)


def posterior(**probabilities: float) -> Posterior:
    """Sets of families, by their names with "_and_" between them."""
    made = [Explanation(tuple(n.split("_and_")), 0.0, share) for n, share in probabilities.items()]
    return Posterior(tuple(made), something_else=0.1)


def test_families_that_stand_for_one_another_are_one_row() -> None:
    known = posterior(leak_and_spring=0.5, leak_and_ends=0.4)
    answer = candidate("Leak", fitted(1.0), "leak")
    rows = family_table(models_of(BASE, [answer], [answer]), known).rows
    assert [row.families for row in rows] == [("leak",), ("spring", "ends")]
    assert [row.probability for row in rows] == [pytest.approx(1.0)] * 2


def test_something_unlisted_makes_no_family_less_probable() -> None:
    known = posterior(leak=0.09, leak_and_spring=0.01)
    assert known.by_family == {"leak": pytest.approx(1.0), "spring": pytest.approx(0.1)}


def test_the_verdict_lists_them_with_what_they_remove() -> None:
    best = candidate("Leak", fitted(1.0), "leak")
    (line, *_) = table_lines(judged(BASE, [best], tried=[best]))
    assert line.startswith("leak") and line.endswith("100 % of the error")


@pytest.mark.parametrize(
    ("size", "matters"),
    [
        (EffectSize({"p": 0.4, "x": 0.1}, 0.01), False),
        (EffectSize({"p": 0.4, "x": 0.6}, 0.01), True),
        (EffectSize({"p": 0.1}, 0.06), True),
        (EffectSize({"p": 0.8}, 0.06, credibility=0.04), False),
    ],
)
def test_an_effect_matters_by_its_size_in_a_signal_or_by_its_share_if_it_is_believed(
    size: EffectSize, matters: bool
) -> None:
    assert size.matters() is matters


def test_a_family_is_believed_by_what_it_is_worth_beside_what_remains() -> None:
    def left(chi2: float) -> Fit:
        scores = {"all": {"p": SimpleNamespace(chi2_reduced=chi2)}}
        data = SimpleNamespace(fitted_signals={"p": None})
        comparison: Any = SimpleNamespace(scores=scores, data=data)
        return replace(fitted(chi2), comparison=comparison)

    def believed(without: float, with_it: float) -> float:
        return size_of_effect(left(100.0), left(without), left(with_it)).credibility

    assert believed(5.0, 2.0) == pytest.approx(3.0 / 4.0)
    assert believed(5.0, 1.0) == 1.0 and believed(5.0, 5.0) == 0.0


def test_what_remains_makes_a_small_family_less_probable() -> None:
    known = Posterior(posterior(leak_and_spring=0.1).explanations, 0.9, credibility={"spring": 0.3})
    assert known.by_family == {"leak": pytest.approx(1.0), "spring": pytest.approx(0.3)}
    answer = candidate("Leak", fitted(1.0), "leak")
    rows = family_table(models_of(BASE, [answer], [answer]), known).rows
    assert {row.families: row.probability for row in rows} == {
        ("leak",): pytest.approx(1.0),
        ("spring",): pytest.approx(0.3),
    }
