"""How much of other forms the general and flexible members of their families take away, and that the page shows it."""

from __future__ import annotations

import pytest

from blind_cases.table_further import FORMS
from tests.library.family_shares import (
    BEGIN,
    END,
    ENOUGH,
    LEAST_SIZE,
    PAGE,
    Share,
    read_results,
    shares,
    table,
)

HARDEST = {
    s.family: s
    for s in sorted(read_results(), key=lambda s: s.left)
    if s.size > LEAST_SIZE and s.effect.startswith("General")
}
"""Of each family the form of which a general member leaves most."""


def test_the_page_shows_what_was_measured() -> None:
    shown = PAGE.read_text().partition(BEGIN)[2].partition(END)[0].strip()
    assert shown == table(read_results())


def test_every_form_is_reached_by_a_general_member() -> None:
    left = {f.name: [s for s in read_results() if s.form == f.name] for f in FORMS}
    unreached = [name for name, own in left.items() if min(s.left for s in own) > ENOUGH]
    assert unreached == [name for name, own in left.items() if own[0].size < LEAST_SIZE]
    assert len(unreached) == 1


@pytest.mark.full
@pytest.mark.parametrize("known", HARDEST.values(), ids=lambda known: known.family)
def test_a_general_member_takes_away_what_it_takes_least_of(known: Share) -> None:
    (form,) = [f for f in FORMS if f.name == known.form]
    (share,) = shares(form, [known.effect])
    assert share.left < ENOUGH
