"""The effects of a model one after another: what was fitted is taken as it is, in whichever order it was found."""

from __future__ import annotations

from dataclasses import replace

import pytest

from pam_cosim.diagnosis.search.search import FitRequest, Search
from pam_cosim.diagnosis.search.searches import one_by_one
from pam_cosim.fitting import Fit
from tests.diagnosis.test_reach import at_rest

__all__ = ["at_rest"]


def test_a_model_is_not_fitted_again_for_another_order_of_its_effects(
    at_rest: tuple[Search, Fit],
) -> None:
    search, base = at_rest
    found = ("LinearBladder", "ForceOffset")
    (brief,) = search.fit_briefly([FitRequest(found, base.values)])
    (complete,) = search.fit_completely([brief], base)
    said: list[str] = []
    telling = replace(search, say=said.append)
    first, last = one_by_one(telling, base, found[::-1], base.values, {found: complete})
    assert first.effects == ("ForceOffset",)
    assert [line for line in said if line.startswith("fitting")] == [
        "fitting in a few steps: 1 model"
    ]
    assert last.effects == ("ForceOffset", "LinearBladder") and last.effect == "LinearBladder"
    assert all("bladder" in name for name in last.own_parameters)
    assert last.fit is complete.fit


@pytest.mark.parametrize("kept", ["LinearBladder", "ForceOffset"])
def test_a_model_with_fewer_effects_begins_where_the_others_vanish(
    at_rest: tuple[Search, Fit], kept: str
) -> None:
    search, base = at_rest
    (c,) = search.fit_briefly([FitRequest(("LinearBladder", "ForceOffset"), base.values)])
    request = search.without_others(c, [kept])
    assert request.effects == (kept,)
    assert 0.0 in [v for n, v in request.second_start.items() if n in c.effect_parameters]
