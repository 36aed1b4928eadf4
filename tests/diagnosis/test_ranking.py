"""Which model is best, and what a further one must come to: statistics written down, names of the catalogue."""

from __future__ import annotations

from dataclasses import replace

import pytest

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis import Candidate
from pam_cosim.diagnosis.search.ranking import Ranking
from pam_cosim.fitting import Estimate, Fit
from tests.diagnosis.linear_world import KNOWN, world
from tests.diagnosis.synthetic import fitted

STRUCTURE = 30.0  # whiteness score of residuals that are correlated


def _model(
    effects: str, chi2: float, parameters: int, score: float = 0.0, holdout: float | None = None
) -> Candidate:
    names = tuple(effects.split("+"))
    own = {f"own.{i}": Estimate(1.0, 0.9, 1.1) for i in range(parameters)}
    last = KNOWN[names[-1]]
    fit = fitted(chi2, holdout, score, own=own)
    return Candidate(last.name, last.family, last.balance, names, (), fit, general=last.general)


def _order(*models: Candidate) -> Ranking:
    order = Ranking(world({}), fitted(50.0, score=STRUCTURE), {c.effects: c for c in models})
    order.update_scale()
    return order


def _best(*models: Candidate) -> str:
    best = _order(*models).best()
    assert best is not None
    return "+".join(best.effects)


def test_nothing_is_best_where_nothing_beats_the_base_model() -> None:
    assert _order(_model("OrificeLeak", 50.0, 1, STRUCTURE)).best() is None
    assert _order().parents() == []


def test_the_model_that_leaves_least_leads_where_none_beats_the_base_model() -> None:
    """What is left is so slow that five of a thousand samples are independent."""
    far, near = _model("DahlFriction", 30.0, 1), _model("OrificeLeak", 16.0, 1)
    slow = [
        replace(c, fit=fitted(x, None, STRUCTURE, time=200.0, own=c.effect_parameters))
        for c, x in ((far, 30.0), (near, 16.0))
    ]
    order = _order(*slow)
    assert order.best() is None
    assert order.leader() is slow[1] and order.parents() == [slow[1], slow[0]]
    (bar,) = order.acceptance_thresholds(1, order.scale)
    assert (bar.reference, bar.criterion) == (slow[1], order.information_criterion(slow[1]))


def test_noise_that_nobody_stated_is_what_the_best_model_leaves() -> None:
    """What a model leaves may look like red noise by itself, until another leaves a fifth of it."""

    def red(fit: Fit) -> Fit:
        own = fit.residuals["fit"]
        residuals = {**fit.residuals, "fit": replace(own, noise_floor=own.chi2_reduced)}
        return replace(fit, residuals=residuals)

    half, whole = (
        _model("DahlFriction", 50.0, 1, STRUCTURE),
        _model("OrificeLeak", 10.0, 1, STRUCTURE),
    )
    half, whole = (replace(c, fit=red(c.fit)) for c in (half, whole))
    base = red(fitted(90.0, score=STRUCTURE))
    assert not Ranking(world({}), base, {half.effects: half}).has_structure(half)
    both = Ranking(world({}), base, {c.effects: c for c in (half, whole)})
    assert both.has_structure(half) and not both.has_structure(whole)


def test_what_leaves_noise_is_better_than_what_does_not_however_many_parameters_it_takes() -> None:
    assert (
        _best(_model("GeneralLeak", 1.0, 9), _model("OrificeLeak", 1.2, 1, STRUCTURE))
        == "GeneralLeak"
    )


def test_two_laws_are_better_than_one_effect_that_takes_many_more_parameters() -> None:
    assert (
        _best(_model("GeneralLeak", 1.1, 8), _model("OrificeLeak+LinearBladder", 1.0, 2))
        == "OrificeLeak+LinearBladder"
    )


def test_other_families_may_be_as_good_as_what_leaves_noise_and_the_same_ones_must_be_better() -> (
    None
):
    best = _model("OrificeLeak", 1.0, 1)
    order = _order(best, _model("LinearBladder", 9.0, 1, STRUCTURE))

    def reached(effects: str) -> list[float]:
        bars = order.acceptance_thresholds(1, order.scale)
        own = order.information_criterion(best)
        return [b.criterion - own for b in bars if order.may_be(b, effects.split("+"))]

    worth = pytest.approx(CRITERIA.evidence.very_strong)
    assert reached("LinearBladder") == [0.0, worth]
    assert reached("LaminarLeak") == reached("LaminarLeak+LinearBladder") == [0.0]
