"""Evidence and rank against numbers computed by hand."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from pam_cosim.diagnosis.judgement.evidence import (
    NoiseScale,
    evidence_without_choice,
    information_criterion,
    rank,
    refuted_by_unfitted_signals,
)
from pam_cosim.diagnosis.judgement.model_space import ModelSpace
from pam_cosim.fitting import Estimate, Fit
from pam_cosim.measurement import Prior
from tests.diagnosis.synthetic import KNOWN, LOST, candidate, fitted

LOG = math.log(1000)


WHITE, LOUD = NoiseScale(1.0, 1.0), NoiseScale(2.0, 10.0)  # twice the variance, ten samples for one


def _criterion(fit: Fit, scale: NoiseScale = WHITE) -> float:
    return evidence_without_choice(fit, scale, None)


def test_criterion_by_hand() -> None:
    assert _criterion(fitted(1.5, parameters=3)) == pytest.approx(1500 + 3 * LOG)
    assert _criterion(fitted(1.5, parameters=3), LOUD) == pytest.approx(75 + 3 * math.log(100))


def test_parameters_pay_for_being_where_nobody_expects_them() -> None:
    """Three standard deviations off what is known of it are nine, whatever the noise."""
    gain = {"gauge.gain": Estimate(1.3, 1.2, 1.4, prior=Prior(1.0, 0.1))}
    for scale in (WHITE, LOUD):
        with_prior, without = fitted(1.5, own=gain), fitted(1.5, parameters=3)
        assert _criterion(with_prior, scale) - _criterion(without, scale) == pytest.approx(9.0)


def test_undetermined_parameters_cost_nothing() -> None:
    dead = Estimate(1.0, 0.0, 2.0, determined=False)
    assert _criterion(fitted(1.0, parameters=2, own={"n": dead})) == _criterion(
        fitted(1.0, parameters=2)
    )


def test_what_an_effect_brings_costs_the_same_whichever_was_added_last() -> None:
    """Creep so slow that the data tell its stiffness alone pays for its time constant beside any other effect."""
    volume, stiffness = Estimate(2e-5, 1e-5, 3e-5, "m3"), KNOWN
    both = fitted(1.0, own={"creep.k": stiffness, "creep.tau": LOST, "volume.V": volume})
    creep = {"creep.k": stiffness, "creep.tau": LOST}
    last = replace(
        candidate("volume", both, own={"volume.V": volume}, before=("creep",)),
        parameters_before=tuple(creep),
    )
    first = replace(
        candidate("creep", both, own=creep, before=("volume",)), parameters_before=("volume.V",)
    )
    space, scale = ModelSpace(10), WHITE
    costs = [information_criterion(both, scale, c.effects, space, c) for c in (last, first)]
    assert costs[0] == costs[1]
    without = information_criterion(both, scale, last.effects, space)
    assert costs[0] == pytest.approx(without + LOG)
    base = fitted(1.02, parameters=2)
    (a,), (b,) = rank(base, [last]), rank(base, [first])
    assert a.delta_bic == b.delta_bic


def test_rank_and_probabilities() -> None:
    """Noise of the size that each leaves: 1000 ln(1.02) less for 1.00, one parameter more costs ln 1000."""
    base = fitted(1.02, parameters=2)
    a, b = candidate("a", fitted(1.0, parameters=3)), candidate("b", fitted(1.01, parameters=3))
    first, second = rank(base, [b, a])
    assert (first.effect, second.effect) == ("a", "b")
    gains = [1000 * math.log(1.02), 1000 * math.log(1.02 / 1.01)]
    assert [first.delta_bic, second.delta_bic] == pytest.approx([LOG - gain for gain in gains])
    weights = [math.exp((gain - LOG) / 2) for gain in gains]
    expected = [weight / (1 + sum(weights)) for weight in weights]
    assert [first.probability, second.probability] == pytest.approx(expected)


def test_correlated_residuals_count_for_fewer_samples() -> None:
    """The best model leaves residuals of which ten make one: the evidence shrinks to a tenth."""
    base = fitted(1.2, parameters=2, score=20.0, time=10.0)
    (only,) = rank(base, [candidate("a", fitted(1.0, parameters=3, score=20.0, time=10.0))])
    assert only.delta_bic == pytest.approx(math.log(100) - 100 * math.log(1.2))


def test_evidence_of_all_runs_and_what_it_pays_for() -> None:
    """Chi-square of both roles, a parameter's logarithm, and the number of sets of two among ten effects."""
    fit = fitted(1.0, holdout=1.5, parameters=3)
    assert information_criterion(
        fit, NoiseScale(1.0, 1.0), ("a", "b"), ModelSpace(10)
    ) == pytest.approx(1000 + 3 * LOG + 1500 + 2 * math.log(45))
    assert information_criterion(fit, NoiseScale(2.0, 5.0), (), ModelSpace(10)) == pytest.approx(
        100 + 3 * math.log(200) + 150
    )


@pytest.mark.parametrize(("ratios", "refuted"), [((9.0, 0.4), False), ((9.0, 0.5), True)])
def test_signals_nobody_fitted_refute_by_their_geometric_mean(
    ratios: tuple[float, float], refuted: bool
) -> None:
    """sqrt(9 * 0.4) is less than two, sqrt(9 * 0.5) more."""
    best = fitted(1.0, shown={"T": 10.0, "F": 3.0})
    rival = fitted(1.0, shown={"T": 10.0 * ratios[0], "F": 3.0 * ratios[1]})
    assert refuted_by_unfitted_signals(rival, best) is refuted
