"""Families contain their causes: random members drawn by the rig, and how much of them the catalogue takes away."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim.fitting import FitOptions
from rig.effect import Effect
from rig.family_members import FAMILIES, PLACES, draw
from rig.plan import Run
from rig.schedule import Phase
from tests.library.family_shares import (
    BEGIN,
    END,
    ENOUGH,
    PAGE,
    data_of,
    fitted_base,
    fitted_with,
    read_results,
    shares,
    table,
)
from tests.library.shelf import effects

PHASES = (
    Phase(0.4, 0.35),
    Phase(0.3),
    Phase(0.4, 0.25),
    Phase(0.5),
    Phase(0.4, 0.0, 0.3),
    Phase(0.4),
)
SHORT = (Run(2.27, 207e3, PHASES),)
EVERY = [(family, number) for family in FAMILIES for number in range(len(PLACES[family]))]


ONE_DESCENT = FitOptions(screened_starts=0, precision=1e-3)


def left(effect: str, member: Effect) -> float:
    data = data_of(member, SHORT)
    return (
        fitted_with(effect, data, ONE_DESCENT).residuals["fit"].chi2
        / fitted_base(data).residuals["fit"].chi2
    )


def test_every_family_of_physics_is_drawn() -> None:
    assert (
        {e.family for e in effects() if e.balance != "sensor"}
        <= set(FAMILIES)
        <= {e.family for e in effects()}
    )
    for family in FAMILIES:
        for number, place in enumerate(PLACES[family]):
            assert draw(family, number)[0] == place
            assert (
                draw(family, number)
                == draw(family, number)
                != draw(family, number + len(PLACES[family]))
            )


def test_the_page_shows_what_was_measured() -> None:
    shown = PAGE.read_text().partition(BEGIN)[2].partition(END)[0].strip()
    assert shown == table(read_results())


def test_every_place_is_reached_by_some_member() -> None:
    best: dict[tuple[str, str], float] = {}
    for s in read_results():
        best[s.family, s.place] = min(s.left, best.get((s.family, s.place), 1.0))
    assert set(best) == {(family, place) for family in FAMILIES for place in PLACES[family]}
    assert max(best.values()) < ENOUGH


@pytest.mark.full
@pytest.mark.parametrize(("family", "number"), EVERY)
def test_a_general_member_takes_a_random_member_away(family: str, number: int) -> None:
    """At least 98 % of its squared error, or as much as the page says."""
    general = {e.name for e in effects() if e.general}
    measured = {
        s.effect: s.left
        for s in read_results()
        if (s.family, s.number) == (family, number) and s.effect in general
    }
    assert measured
    for share in shares(family, number, list(measured), thorough=True):
        assert share.left < max(ENOUGH, 1.2 * measured[share.effect])
        assert np.isfinite(share.size)
