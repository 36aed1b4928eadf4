"""Effects that a linearised model does not need, and the priors that hold effects near their absence."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim.diagnosis.search.elimination import needed_effects
from pam_cosim.fitting import Linear

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
