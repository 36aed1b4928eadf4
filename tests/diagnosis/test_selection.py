"""Which effects a search comes to, in a world where models are linear."""

from __future__ import annotations

import time
from dataclasses import replace

import pytest

from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.search.selection import select_effects
from tests.diagnosis.linear_world import CATALOGUE, KNOWN, LinearWorld, world
from tests.tiers import quick


def families(searched: LinearWorld) -> set[str]:
    family = {e.name: e.family for e in CATALOGUE}
    path = select_effects(searched, searched.fitted(())).path
    return {family[e] for e in path[-1].effects} if path else set()


def test_nothing_is_tried_where_nothing_is_missing() -> None:
    nothing = world({})
    selection = select_effects(nothing, nothing.fitted(()))
    assert selection.path == selection.tried == ()


@pytest.mark.parametrize("effects", [(), ("OrificeLeak",)])
def test_what_cannot_be_explained_with_the_effects_there_are_stays(
    effects: tuple[str, ...],
) -> None:
    strange = replace(
        world({"LinearBladder": 5.0}), available_effects=[KNOWN[name] for name in effects]
    )
    selection = select_effects(strange, strange.fitted(()))
    assert selection.path == () and {c.effects for c in selection.tried} <= {effects}


@pytest.mark.parametrize(
    "effect",
    quick(
        ["LinearBladder", "OrificeLeak", "ThermocoupleLag", "GeneralWall"],
        "OrificeLeak",
        "ThermocoupleLag",
    ),
)
@pytest.mark.parametrize("strength", [1.5, 30.0])
def test_one_effect_weak_and_strong(effect: str, strength: float) -> None:
    one = world({effect: strength})
    (only,) = select_effects(one, one.fitted(())).path
    assert only.effect == effect


@pytest.mark.parametrize(
    "hidden",
    [
        {"LinearBladder": 5.0, "ThermocoupleLag": 5.0},
        {"OrificeLeak": 30.0, "HangingMass": 3.0},
        {"LinearBladder": 8.0, "ThermocoupleLag": 5.0, "OrificeLeak": 3.0},
    ],
)
def test_two_and_three_effects(hidden: dict[str, float]) -> None:
    several = world(hidden)
    path = select_effects(several, several.fitted(())).path
    assert set(path[-1].effects) == set(hidden)
    assert [len(c.effects) for c in path] == list(range(1, len(hidden) + 1))


def test_a_third_effect_is_found_that_acts_in_another_way_beside_the_base_model() -> None:
    hidden = {"LinearBladder": 20.0, "ThermocoupleLag": 20.0, "GeneralLeak": 3.0}
    several = world(hidden, masked="leak")
    assert families(several) == {KNOWN[name].family for name in hidden}
    assert several.looks[0] == ((), len(CATALOGUE))
    assert all(count < len(CATALOGUE) / 2 for _, count in several.looks[1:])


@pytest.mark.parametrize(
    ("weak", "named"), [(0.4, False), (0.8, True)], ids=["measurable", "large enough"]
)
def test_a_further_effect_is_named_if_it_is_large_enough(weak: float, named: bool) -> None:
    searched = world({"LinearBladder": 5.0, "ThermocoupleLag": weak}, coloured=1.1)
    assert families(searched) == {"elasticity", *["thermocouple_lag"] * named}


def test_six_effects_that_one_after_another_cannot_find() -> None:
    hidden = {
        "LinearBladder": 8.0, "ThermocoupleLag": 5.0, "OrificeLeak": 7.0, "HangingMass": 4.0, "PositionOffset": 6.0,
        "CoulombFriction": 3.0,
    }  # fmt: skip
    assert families(world(hidden)) == {KNOWN[name].family for name in hidden}


def test_the_time_limit_ends_the_search_and_says_what_was_not_tried() -> None:
    pair = world({"LinearBladder": 5.0, "ThermocoupleLag": 5.0})
    pair.effort.deadline = time.monotonic()
    selection = select_effects(pair, pair.fitted(()))
    assert selection.untried
    assert not pair.tried
    assert len(selection.tried) == CRITERIA.search.first_tried
