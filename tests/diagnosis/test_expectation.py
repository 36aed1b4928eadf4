"""What linear algebra expects of models, against fits of linear models, which it must meet exactly."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from pam_cosim.diagnosis.search.expectation import effect_alone, expected
from pam_cosim.diagnosis.search.probing import EffectProbe
from pam_cosim.measurement import Prior
from tests.diagnosis.linear_world import moves, world

WORLD = world({"LinearBladder": 5.0, "ThermocoupleLag": 3.0})
BASE = WORLD.fitted(())


def probed(name: str) -> EffectProbe:
    (probe,) = WORLD.probe(BASE, (), [name])
    return probe


@pytest.mark.parametrize("before", [(), ("LinearBladder",)])
@pytest.mark.parametrize("name", ["ThermocoupleLag", "OrificeLeak"])
def test_one_further_effect_is_expected_as_it_is_fitted(before: tuple[str, ...], name: str) -> None:
    model, probe = WORLD.fitted(before), probed(name)
    assert BASE.linear is not None and model.linear is not None
    alone = effect_alone(BASE.linear, probe.linear)
    taken = model.residuals["fit"].chi2 - WORLD.fitted((*before, name)).residuals["fit"].chi2
    assert expected(model.linear, alone).reduction == pytest.approx(taken, rel=1e-3, abs=0.1)


def test_an_added_effect_is_expected_where_samples_and_prior_balance() -> None:
    """The squares of both are least where their derivatives cancel, here by hand for one parameter."""
    probe, prior = probed("LinearBladder"), {"LinearBladder.strength": Prior(0.0, 0.05)}
    assert BASE.linear is not None
    alone = effect_alone(BASE.linear, replace(probe.linear, priors=prior))
    result = expected(BASE.linear, alone)
    rows = np.hstack([BASE.linear.slopes, moves("LinearBladder", "fit")])
    both = np.vstack([rows, [0.0, 0.0, 20.0]])
    values = np.linalg.lstsq(both, np.append(WORLD.samples("fit"), 0.0), rcond=None)[0]
    left = WORLD.samples("fit") - rows @ values
    assert result.values["LinearBladder.strength"] == pytest.approx(values[2], rel=1e-3)
    assert result.chi2_priors == pytest.approx((20 * values[2]) ** 2, rel=1e-2)
    assert result.reduction == pytest.approx(BASE.residuals["fit"].chi2 - left @ left, rel=1e-3)
    np.testing.assert_allclose(result.residual, left, atol=1e-6)
