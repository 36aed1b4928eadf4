"""Families contain their causes: random members drawn by the rig, and how much of them the catalogue takes away."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from rig.effect import Effect
from rig.family_members import FAMILIES, PLACES, draw
from rig.plan import Run
from rig.schedule import Phase
from tests.library.family_shares import (
    BEGIN,
    END,
    ENOUGH,
    PAGE,
    Share,
    data_of,
    fitted_base,
    fitted_with,
    read_results,
    shares,
    table,
)
from tests.library.shelf import effects

PHASES = (Phase(0.4, 0.35), Phase(0.3), Phase(0.4, 0.25), Phase(0.5), Phase(0.4, 0.0, 0.3), Phase(0.4))
SHORT = (Run(2.27, 207e3, PHASES),)
EVERY = [(family, number) for family in FAMILIES for number in range(len(PLACES[family]))]


def left(effect: str, member: Effect) -> float:
    data = data_of(member, SHORT)
    return fitted_with(effect, data).residuals["fit"].chi2 / fitted_base(data).residuals["fit"].chi2


def test_every_family_of_physics_is_drawn() -> None:
    assert {e.family for e in effects() if e.balance != "sensor"} <= set(FAMILIES) <= {e.family for e in effects()}
    for family in FAMILIES:
        for number, place in enumerate(PLACES[family]):
            assert draw(family, number)[0] == place
            assert draw(family, number) == draw(family, number) != draw(family, number + len(PLACES[family]))


def test_a_valve_whose_opening_lags_is_met_behind_the_law_of_its_area() -> None:
    """A lag of the current, which the base catalogue had alone, leaves some of it."""
    _, member = draw("valve_dynamics", list(PLACES["valve_dynamics"]).index("opening"))
    assert left("OpeningLag", member) < 1e-3
    assert left("ValveLag", member) > ENOUGH


def test_the_page_shows_what_was_measured() -> None:
    shown = PAGE.read_text().partition(BEGIN)[2].partition(END)[0].strip()
    assert shown == table(read_results())


def test_a_table_tells_the_median_and_the_worst() -> None:
    one = Share("leak", "gauge pressure", 0, 3.0, "GeneralLeak", 0.01, 1.0)
    other = replace(one, number=5, left=0.03)
    listed = replace(one, effect="LaminarLeak", left=0.5)
    assert "| gauge pressure | 2 | 3.0 | 2 % | 3 % | LaminarLeak 50 % |" in table([one, other, listed])


@pytest.mark.full
@pytest.mark.parametrize(("family", "number"), EVERY)
def test_a_general_member_takes_a_random_member_away(family: str, number: int) -> None:
    """At least 98 % of its squared error, or as much as the page says."""
    measured = {(s.family, s.number): s.left for s in read_results()}
    (share,) = shares(family, number, thorough=True)
    assert share.left < max(ENOUGH, 1.2 * measured[family, number])
    assert np.isfinite(share.size)
