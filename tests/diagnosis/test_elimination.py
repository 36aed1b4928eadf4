"""Effects that a linearised model does not need, and the priors that hold effects near their absence."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim.diagnosis.search.elimination import needed_effects
from pam_cosim.diagnosis.search.full_model import near_absence
from pam_cosim.fitting import Free, Linear

ROWS = 400
PARAMETERS = {"Leak": ("leak.G",), "Spring": ("spring.k", "spring.a"), "Lag": ("lag.tau",)}
ABSENT = {"leak.G": 0.0, "spring.k": 0.0, "lag.tau": 1e-6}


def linear(strengths: dict[str, float]) -> Linear:
    """A model fitted to samples that these parameters move, and one of the base model."""
    rng = np.random.default_rng(7)
    names = ("base", *(n for own in PARAMETERS.values() for n in own))
    values = np.array([1.0, *(strengths.get(n, ABSENT.get(n, 0.5)) for n in names[1:])])
    slopes = rng.standard_normal((ROWS, len(names)))
    slopes[:, names.index("spring.a")] *= 0.0  # a shape of an effect that is away moves nothing
    limits = np.full(len(names), 1e3)
    return Linear(names, values, -limits, limits, rng.standard_normal(ROWS), slopes)


@pytest.mark.parametrize(
    ("strengths", "needed"),
    [
        ({}, ()),
        ({"leak.G": 2.0}, ("Leak",)),
        ({"leak.G": 2.0, "spring.k": -3.0, "lag.tau": 0.02}, ("Leak", "Spring")),
    ],
    ids=["none", "one", "two and a small one"],
)
def test_effects_whose_absence_costs_more_than_they_do_stay(
    strengths: dict[str, float], needed: tuple[str, ...]
) -> None:
    assert needed_effects(linear(strengths), PARAMETERS, ABSENT, 1.0, 9.0) == needed


def test_a_large_misfit_hides_small_effects_and_a_limit_keeps_the_largest() -> None:
    both = linear({"leak.G": 2.0, "spring.k": -3.0})
    assert needed_effects(both, PARAMETERS, ABSENT, 1000.0, 9.0) == ()
    assert needed_effects(both, PARAMETERS, ABSENT, 1.0, 9.0, most=1) == ("Spring",)


@pytest.mark.parametrize(
    ("free", "absent", "starts_near", "logarithmic"),
    [
        (Free("k", 0.0, 2e4, 300.0), 0.0, 30.0, False),
        (Free("gain", 0.5, 1.5, 1.05), 1.0, 1.005, False),
        (Free("A", 2e-8, 5e-6, 3e-7), 5e-6, 3.77e-6, True),
        (Free("tau", 0.1, 1e4, 2.0), None, 2.0, True),
    ],
    ids=["strength", "about one", "conductance in series", "shape"],
)
def test_an_effect_begins_near_its_absence(
    free: Free, absent: float | None, starts_near: float, logarithmic: bool
) -> None:
    near = near_absence(free, absent)
    assert near.start == pytest.approx(starts_near, rel=0.01)
    assert near.prior is not None and near.prior.logarithmic == logarithmic == near.logarithmic
    if absent is not None:
        assert near.prior.mean == absent and near.low <= absent <= near.high
