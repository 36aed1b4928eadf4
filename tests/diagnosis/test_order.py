"""Which model is best, and what a further one must come to: statistics written down, names of the catalogue."""

from __future__ import annotations

from dataclasses import replace

import pytest

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis import Candidate
from pam_cosim.diagnosis.search.predicted_evidence import PredictedEvidence
from pam_cosim.diagnosis.search.ranking import Ranking
from pam_cosim.diagnosis.search.search import FitRequest, Search
from pam_cosim.fitting import Estimate, Fit
from tests.diagnosis.linear_world import KNOWN, TREE, world
from tests.diagnosis.synthetic import fitted

KNOWN_PARAMETERS = {name: len(e.parameters) for name, e in KNOWN.items()}
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


def test_it_leads_by_what_is_possible_where_what_is_left_says_next_to_nothing() -> None:
    """Of two effects that only explain the data together, each alone gains less than a parameter costs."""
    little = _model("OrificeLeak", 48.0, 1)
    slow = replace(
        little, fit=fitted(48.0, None, STRUCTURE, time=200.0, own=little.effect_parameters)
    )
    order = _order(slow)
    assert order.information_criterion(slow) > order.information_criterion(None)
    assert order.leader() is slow and order.parents() == [slow]
    assert order.best() is None


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


@pytest.mark.parametrize(
    ("chi2", "best"), [(1.02, "OrificeLeak"), (0.95, "OrificeLeak+DahlFriction")]
)
def test_a_further_effect_needs_very_strong_evidence(chi2: float, best: str) -> None:
    """A better criterion is not enough: what follows the noise more closely has that too."""
    one, two = _model("OrificeLeak", 1.05, 1), _model("OrificeLeak+DahlFriction", chi2, 3)
    assert _order(one, two).information_criterion(two) < _order(one, two).information_criterion(one)
    assert _best(one, two) == best


def test_two_laws_are_better_than_one_effect_that_takes_many_more_parameters() -> None:
    assert (
        _best(_model("GeneralLeak", 1.1, 8), _model("OrificeLeak+LinearBladder", 1.0, 2))
        == "OrificeLeak+LinearBladder"
    )


def test_not_where_they_explain_less() -> None:
    assert (
        _best(_model("GeneralLeak", 1.0, 8), _model("OrificeLeak+LinearBladder", 1.2, 2))
        == "GeneralLeak"
    )


def test_not_where_they_take_about_as_many_and_explain_little_more() -> None:
    assert (
        _best(_model("FlexibleBladder", 1.005, 3), _model("OrificeLeak+DahlFriction", 1.0, 2))
        == "FlexibleBladder"
    )


def test_laws_are_carried_on_beside_what_says_whatever_its_family_can() -> None:
    general, laws = (
        _model("GeneralLeak", 5.0, 8, STRUCTURE),
        _model("OrificeLeak+LinearBladder", 9.0, 2, STRUCTURE),
    )
    order = _order(general, laws)
    assert order.parents() == [general, laws]
    of_all, of_laws = order.acceptance_thresholds(3, order.scale)
    assert (of_all.specific, of_laws.specific) == (False, True)
    assert (of_all.reference, of_laws.reference) == (general, laws)
    assert (
        of_all.criterion
        == order.information_criterion(general)
        < of_laws.criterion
        == order.information_criterion(laws)
    )


def test_not_where_the_best_is_made_of_laws_or_leaves_noise() -> None:
    laws = _model("OrificeLeak", 5.0, 1, STRUCTURE)
    assert (
        len(
            _order(laws, _model("GeneralLeak", 9.0, 8, STRUCTURE)).acceptance_thresholds(
                2, _order(laws).scale
            )
        )
        == 1
    )
    solved = _order(_model("GeneralLeak", 1.0, 8), _model("OrificeLeak", 5.0, 1, STRUCTURE))
    assert not any(bar.specific for bar in solved.acceptance_thresholds(1, solved.scale))


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


def test_what_leaves_noise_by_many_parameters_is_challenged_from_a_plainer_model() -> None:
    rich, plain = _model("GeneralLeak", 1.0, 8), _model("OrificeLeak", 5.0, 1, STRUCTURE)
    order = _order(rich, plain, _model("FlexibleBladder", 20.0, 3, STRUCTURE))
    assert order.parents() == [plain]
    (bar,) = order.acceptance_thresholds(2, order.scale)
    worth = CRITERIA.evidence.very_strong
    assert (bar.reference, bar.cost) == (plain, order.cost(rich.effects))
    assert bar.criterion == order.information_criterion(plain) - worth
    assert bar.fitted == order.information_criterion(rich) - worth


def test_sets_of_which_an_effect_finds_no_place_are_not_proposed_again() -> None:
    """Both are the law of one manometer."""
    search = Search(TREE, "PneumaticMuscle.Benches.Isotonic", tuple(KNOWN.values()), world({}).data)
    wanted = [FitRequest(("PressureOffset", "PressureGain"), {})]
    assert search.fit_briefly(wanted) == [] == search.failed
    assert search.displaced == {frozenset(wanted[0].effects)}
    linear = world({"LinearBladder": 5.0})
    base = linear.fitted(())
    predicted = PredictedEvidence(Ranking(linear, base, {}))
    predicted.note_probes(linear.probe(base, (), ["LinearBladder", "OrificeLeak"]))
    proposed = {p.prediction.effects for p in predicted.proposals(1)}
    linear.displaced.add(frozenset({"LinearBladder"}))
    assert {p.prediction.effects for p in predicted.proposals(1)} == proposed - {("LinearBladder",)}
    assert ("LinearBladder",) in proposed


def test_a_further_effect_costs_as_much_as_one_that_is_expected() -> None:
    last = list(KNOWN)[-1]
    order = _order(_model("OrificeLeak", 1.0, 1))
    assert order.search.likeliest_first == list(KNOWN)
    order.search = replace(order.search, expected=frozenset({last}))
    assert order.search.likeliest_first[0] == last != "OrificeLeak"
    assert order.cost((last,)) < order.cost((list(KNOWN)[0],))
