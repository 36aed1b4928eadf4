"""Evidence and rank against numbers computed by hand."""

from __future__ import annotations

import math

import pytest

from pam_cosim.diagnosis.evidence import (
    as_good,
    bic,
    convincing,
    degenerate,
    leading,
    leaves_structure,
    rank,
    structured,
)
from pam_cosim.fitting import Estimate
from tests.diagnosis.synthetic import EMPTY, KNOWN, LOST, candidate, fitted, statistics

LOG = math.log(1000)


def test_criterion_by_hand() -> None:
    assert bic(fitted(1.5, parameters=3), 1.0, 1.0) == pytest.approx(1500 + 3 * LOG)
    # noise of twice the variance, ten samples for one
    assert bic(fitted(1.5, parameters=3), 2.0, 10.0) == pytest.approx(75 + 3 * math.log(100))


def test_undetermined_parameters_cost_nothing() -> None:
    dead = Estimate(1.0, 0.0, 2.0, determined=False)
    assert bic(fitted(1.0, parameters=2, own={"n": dead}), 1.0, 1.0) == bic(fitted(1.0, parameters=2), 1.0, 1.0)


def test_rank_and_probabilities() -> None:
    """Relative to a base with chi2 1.02: 20 less for 1.00, one parameter more costs ln 1000."""
    base = fitted(1.02, parameters=2)
    a, b = candidate("a", fitted(1.0, parameters=3)), candidate("b", fitted(1.01, parameters=3))
    first, second = rank(base, [b, a])
    assert (first.effect, second.effect) == ("a", "b")
    assert first.delta_bic == pytest.approx(-20 + LOG)
    assert second.delta_bic == pytest.approx(-10 + LOG)
    total = 1 + math.exp((20 - LOG) / 2) + math.exp((10 - LOG) / 2)
    assert first.probability == pytest.approx(math.exp((20 - LOG) / 2) / total)
    assert second.probability == pytest.approx(math.exp((10 - LOG) / 2) / total)


def test_probabilities_of_overwhelming_evidence_do_not_overflow() -> None:
    ranked = rank(fitted(1e6), [candidate("a", fitted(1.0)), candidate("b", fitted(1e5))])
    assert [c.probability for c in ranked] == pytest.approx([1.0, 0.0])


def test_correlated_residuals_count_for_fewer_samples() -> None:
    """The best model leaves residuals of which ten make one: the evidence shrinks to a tenth."""
    base = fitted(1.2, parameters=2, score=20.0, time=10.0)
    (only,) = rank(base, [candidate("a", fitted(1.0, parameters=3, score=20.0, time=10.0))])
    assert only.delta_bic == pytest.approx(-20 + math.log(100))


def test_evidence_is_weighed_by_the_noise_that_is_left() -> None:
    """Noise of four times the stated variance makes the same gain a quarter of the evidence."""
    (only,) = rank(fitted(4.4), [candidate("a", fitted(4.0))])
    assert only.delta_bic == pytest.approx(-100.0)


def test_nothing_tried_is_no_rank() -> None:
    assert rank(fitted(1.0), []) == []


def test_convincing_needs_evidence_and_the_holdout_runs() -> None:
    base = fitted(2.0, holdout=2.0)
    (better,) = rank(base, [candidate("a", fitted(1.0, holdout=1.1))])
    (overfitted,) = rank(base, [candidate("a", fitted(1.0, holdout=2.1))])
    (chance,) = rank(base, [candidate("a", fitted(1.995, holdout=1.9, parameters=3))])
    assert [convincing(base, c) for c in (better, overfitted, chance)] == [True, False, False]
    (no_holdout,) = rank(fitted(2.0), [candidate("a", fitted(1.0))])
    assert convincing(fitted(2.0), no_holdout)


def test_a_law_at_its_limit_pays_for_the_parameter_and_does_not_lead() -> None:
    """Creep without end fits as well as a spring, which is what it then is."""
    spring = candidate("Spring", fitted(1.0, own={"k": KNOWN}), "elasticity", {"k": KNOWN})
    creep = candidate("Creep", fitted(0.9999, own={"k": KNOWN, "tau": LOST}), "creep", {"k": KNOWN, "tau": LOST})
    ranked = rank(fitted(5.0), [creep, spring])
    assert [c.effect for c in ranked] == ["Spring", "Creep"]
    assert ranked[1].delta_bic - ranked[0].delta_bic == pytest.approx(LOG - 0.1, abs=0.05)
    lucky = candidate("Creep", fitted(0.992, own={"k": KNOWN, "tau": LOST}), "creep", {"k": KNOWN, "tau": LOST})
    ranked = rank(fitted(5.0), [lucky, spring])
    assert ranked[0].effect == "Creep"
    assert leading(ranked).effect == "Spring"
    better = candidate("Creep", fitted(0.9, own={"k": KNOWN, "tau": LOST}), "creep", {"k": KNOWN, "tau": LOST})
    assert leading(rank(fitted(5.0), [better, spring])).effect == "Creep"
    assert degenerate(creep) and not degenerate(spring)


def test_base_parameters_that_an_effect_makes_idle_do_not_count_against_it() -> None:
    """The polytropic exponent has no say beside an energy balance: that is no fault of the effect."""
    idle = Estimate(1.2, 1.0, 1.4, determined=False)
    assert not degenerate(candidate("Gas", fitted(1.0, own={"n": idle, "h": KNOWN}), "gas", {"h": KNOWN}))


@pytest.mark.parametrize(
    ("chi2", "score", "samples", "expected"),
    [
        (1.0, 0.0, 1000, False),
        (1.2, 5.0, 1000, True),
        (1.2, 3.0, 1000, False),  # chance
        (1.04, 8.0, 1000, False),  # too small to be worth a name
        (3.0, 0.0, 1000, False),  # louder than stated, but white
        (3.0, 0.0, 15, True),  # few samples show it by their level: 1 + 4 sqrt(2/15) = 2.46
        (2.3, 0.0, 15, False),
    ],
)
def test_structured(chi2: float, score: float, samples: int, expected: bool) -> None:
    assert structured(statistics(chi2, score, samples=samples)) is expected


def test_nothing_measured_has_no_structure() -> None:
    assert not structured(EMPTY) and not leaves_structure(EMPTY)


def test_leftovers_count_from_a_fifth_of_the_noise() -> None:
    assert leaves_structure(statistics(1.3, 10.0))
    assert not leaves_structure(statistics(1.15, 10.0))
    assert not leaves_structure(statistics(1.3, 3.0))


def test_fewer_effects_do_as_well_only_where_held_out_runs_agree() -> None:
    full = candidate("Two", fitted(1.0, holdout=1.0, parameters=4))
    assert as_good(fitted(1.001, holdout=1.1), full)
    assert not as_good(fitted(1.001, holdout=1.5), full)
    assert not as_good(fitted(1.5, holdout=1.1), full)
