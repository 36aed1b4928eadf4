"""Families contain their causes: random members drawn by the rig, and how much of them the catalogue takes away."""

from __future__ import annotations

import numpy as np
import pytest

from rig.family_members import FAMILIES, PLACES, draw
from tests.library.family_shares import (
    BEGIN,
    END,
    ENOUGH,
    PAGE,
    Share,
    read_results,
    shares,
    table,
)
from tests.library.shelf import effects

GENERAL = {e.name for e in effects() if e.general}
HARDEST = {
    s.family: s
    for s in sorted(read_results(), key=lambda s: s.left)
    if s.effect in GENERAL and s.number < len(PLACES[s.family])
}
"""Of each family the random member of which its general one leaves most."""


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
@pytest.mark.parametrize("known", HARDEST.values(), ids=lambda known: known.family)
def test_a_general_member_takes_away_what_it_takes_least_of(known: Share) -> None:
    """At least 98 % of its squared error, or as much as the page says."""
    (share,) = shares(known.family, known.number, [known.effect], thorough=True)
    assert share.left < max(ENOUGH, 1.2 * known.left) and np.isfinite(share.size)
