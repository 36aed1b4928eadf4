"""What linear algebra expects of models, against fits of linear models, which it must meet exactly."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from pam_cosim.diagnosis.search.expectation import (
    Additions,
    LinearisedNeighbourhood,
    addition,
)
from pam_cosim.fitting import Linear, bounded_step, reduction_by
from pam_cosim.measurement import Prior
from tests.diagnosis.linear_world import CATALOGUE, ROWS, moves, world

WORLD = world({"LinearBladder": 5.0, "ThermocoupleLag": 3.0})
BASE = WORLD.fitted(())
FAMILY = {e.name: e.family for e in CATALOGUE}
NAMES = {"LinearBladder", "ThermocoupleLag", "OrificeLeak"}


def additions() -> Additions:
    assert BASE.linear is not None
    made = [
        addition(BASE.linear, p)
        for p in WORLD.probe(BASE, (), [e.name for e in CATALOGUE])
        if p.effect in NAMES
    ]
    return Additions([a for a in made if a is not None], ROWS)


def reduction(linear: Linear) -> float:
    """By how much the sum of squares falls, to first order, as far as bounds and priors let the parameters go."""
    return reduction_by(linear, bounded_step(linear))


def test_one_further_effect() -> None:
    assert BASE.linear is not None
    beside = LinearisedNeighbourhood((), BASE.linear, FAMILY, additions())
    results = beside.with_one
    assert len(results) == 3
    for e in results:
        taken = BASE.residuals["fit"].chi2 - WORLD.fitted(e.effects).residuals["fit"].chi2
        assert e.reduction == pytest.approx(taken, rel=1e-3)


def test_effects_on_top_of_one_that_was_fitted() -> None:
    one = WORLD.fitted(("LinearBladder",))
    assert one.linear is not None
    results = LinearisedNeighbourhood(("LinearBladder",), one.linear, FAMILY, additions()).with_one
    assert {e.effects for e in results} == {("LinearBladder", n) for n in NAMES - {"LinearBladder"}}
    for e in results:
        taken = one.residuals["fit"].chi2 - WORLD.fitted(e.effects).residuals["fit"].chi2
        assert e.reduction == pytest.approx(taken, rel=1e-3, abs=0.1)


def test_an_added_effect_is_expected_where_samples_and_prior_balance() -> None:
    """The squares of both are least where their derivatives cancel, here by hand for one parameter."""
    (probe,) = [p for p in WORLD.probe(BASE, (), ["LinearBladder"])]
    prior = {"LinearBladder.strength": Prior(0.0, 0.05)}
    made = addition(BASE.linear, replace(probe, linear=replace(probe.linear, priors=prior)))  # type: ignore[arg-type]
    assert made is not None and BASE.linear is not None
    (one,) = LinearisedNeighbourhood((), BASE.linear, FAMILY, Additions([made], ROWS)).with_one
    expected, rows = (
        one.within_bounds,
        np.hstack([BASE.linear.slopes, moves("LinearBladder", "fit")]),
    )
    assert expected is not None
    both = np.vstack([rows, [0.0, 0.0, 20.0]])
    values = np.linalg.lstsq(both, np.append(WORLD.samples("fit"), 0.0), rcond=None)[0]
    left = WORLD.samples("fit") - rows @ values
    assert expected.values["LinearBladder.strength"] == pytest.approx(values[2], rel=1e-3)
    assert expected.chi2_priors == pytest.approx((20 * values[2]) ** 2, rel=1e-2)
    assert expected.reduction == pytest.approx(BASE.residuals["fit"].chi2 - left @ left, rel=1e-3)
