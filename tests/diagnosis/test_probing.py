"""At which strength an effect is looked at, in worlds whose answer is known."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from pam_cosim.diagnosis.search import probing
from pam_cosim.diagnosis.search.probing import Strengths
from pam_cosim.diagnosis.search.trial import values_where_absent
from pam_cosim.fitting import Free, Linear

ROWS = 200
RNG = np.random.default_rng(4)
BASE, SHAPE = RNG.standard_normal((ROWS, 2)), RNG.standard_normal(ROWS)


def looked(
    does: Callable[[float], np.ndarray], hidden: np.ndarray, signed: bool = False
) -> list[tuple[float, float]]:
    """Strengths that are looked at, and the share of the sum of squares that each leaves."""
    left = hidden + 1e-5 * RNG.standard_normal(ROWS)
    limits = np.full(2, 1e3)
    base = Linear(("a", "b"), np.zeros(2), -limits, limits, left, BASE)
    own = np.linalg.qr(BASE)[0]
    goal = left - own @ (own.T @ left)
    return [
        (look.strength, look.remaining / float(goal @ goal))
        for look in probing._strength_trials(lambda s: left - does(s), base, signed)
    ]


@pytest.mark.parametrize("true", [0.003, 0.2, 1.0, 7.0, 300.0])
def test_an_effect_in_proportion_is_looked_at_where_it_does_most_good(true: float) -> None:
    looks = looked(lambda s: s * SHAPE, true * SHAPE)
    assert len(looks) <= 4
    strength, left = min(looks, key=lambda look: look[1])
    assert strength == pytest.approx(true, rel=0.2)
    assert left < 0.05


def test_a_limit_is_found_between_where_it_does_harm_and_where_it_does_nothing() -> None:
    course = 0.13 * np.abs(np.sin(np.linspace(0, 9, ROWS)))

    def ceiling(strength: float) -> np.ndarray:
        high = 0.005 / strength
        return 100 * (np.minimum(course, high) - course)

    looks = looked(ceiling, ceiling(0.005 / 0.12))
    assert min(left for _, left in looks) < 0.5
    assert len(looks) <= 8


@pytest.mark.parametrize("name", ["m/stated", "load.m/stated"])
def test_a_stated_parameter_that_is_off_vanishes_where_it_is_right(name: str) -> None:
    """The name of a parameter in a component was cut, so that its ratio was looked at as a size: 0.5 at no strength."""
    absent = values_where_absent([name], {name: 1.0})
    strengths = Strengths((Free(name, 0.5, 2.0, 1.05),), absent)
    assert strengths.signed
    for strength, ratio in ((1.0, 1.05), (0.1, 1.005), (0.0, 1.0), (-1.0, 0.95)):
        assert strengths.at(strength) == pytest.approx({name: ratio})
    assert values_where_absent(["leak.k", "leak.p"], {"k": 0.0}) == {"leak.k": 0.0}
