"""Flexible and general members: no values within their bounds break a run, and the general ones contain others."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

import numpy as np
import pytest

from pam_cosim.catalogue import EffectClass
from pam_cosim.model.interface import Interface
from tests.library.catalogue import (
    BENCH,
    base,
    built,
    effects,
    homes,
    law_bench,
    noise,
    on_bench,
    run,
    without_numbers,
)

BESIDE = ("RealGas", "SideVolume", "ThermocoupleStem", "UnevenFriction")
FLEXIBLE = [e for e in effects() if e.name.startswith("Flexible") or e.name in BESIDE or e.general]
MOST_CORNERS = 16

every_flexible = pytest.mark.parametrize("effect", FLEXIBLE, ids=lambda e: e.name)


@every_flexible
def test_runs_at_the_corners_of_its_bounds(effect: EffectClass) -> None:
    assert without_numbers(effect.name, law_bench(effect.name), _corners) == []


@pytest.mark.full
@every_flexible
def test_runs_at_the_corners_of_its_bounds_on_other_benches(effect: EffectClass) -> None:
    for bench in homes(effect.name):
        assert without_numbers(effect.name, bench, _corners) == [], bench


def _corners(interface: Interface, names: Sequence[str]) -> Iterator[dict[str, float]]:
    """All corners, or some that are drawn where they are many.

    Where an effect has several places, the second takes the same corner as the first, and the opposite one.
    """
    places = [
        list(own) for _, own in itertools.groupby(names, lambda name: name.rpartition(".")[0])
    ]
    corners: Sequence[tuple[int, ...]] = list(itertools.product((0, 1), repeat=len(places[0])))
    if len(corners) > MOST_CORNERS:
        drawn = np.random.default_rng(1).choice(len(corners), MOST_CORNERS // 2, replace=False)
        corners = [corners[i] for i in sorted(drawn)]
    for corner in corners:
        for opposite in (0, 1)[: len(places)]:
            ends = [corner, *([side ^ opposite for side in corner] for _ in places[1:])]
            yield {
                name: (v.min, v.max)[side]
                for own, sides in zip(places, ends, strict=True)
                for name, side in zip(own, sides, strict=True)
                if (v := interface.parameters[name]).min is not None and v.max is not None
            }


# With these values it is a flexible member, or the law beside it; to a tenth of the noise, as some can only be small.
CONTAINED: dict[tuple[str, str], tuple[dict[str, float], dict[str, float]]] = {
    ("GeneralWall", "FlexibleWall"): ({"C": 0.5, "G": 0.05, "r": 2.0, "K": 0.2, "n": 0.25}, {"s": 1.0}),
    ("GeneralFrictionHeat", "FlexibleFrictionHeat"): (
        {"share_f": 0.8, "share_b": 0.6, "back_f": 0.5, "back_b": -0.5}, {"tau": 1e-3, "r": 0.01},
    ),
    ("GeneralCreep", "FlexibleCreep"): ({"k_1": 400.0, "k_2": 200.0, "k_3": 100.0, "tau": 0.2}, {}),
    ("GeneralThermocouple", "FlexibleThermocouple"): (
        {"tau": 0.5, "n": 0.3, "b": 2.0, "loss": 0.05}, {"stem": 0.0, "r": 1e-3},
    ),
    ("GeneralThermocouple", "ThermocoupleSheath"): (
        {"tau": 0.5, "r": 0.4}, {"n": 0.0, "b": 0.0, "loss": 0.0, "stem": 0.0},
    ),
}  # fmt: skip


@pytest.mark.parametrize("pair", CONTAINED, ids=lambda pair: " in ".join(reversed(pair)))
def test_general_member_contains_the_others(pair: tuple[str, str]) -> None:
    own, rest = CONTAINED[pair]
    both = []
    for name in pair:
        composition = on_bench(name, BENCH)
        chosen = own | rest
        named = {
            n: chosen[k]
            for n in composition.parameters[name]
            if (k := n.rpartition(".")[2]) in chosen
        }
        both.append(run(built(BENCH, name), named))
    (one, interface), (other, _) = both
    without, _ = base(BENCH)
    for name in one:
        assert one[name] == pytest.approx(other[name], abs=0.1 * noise(interface.outputs[name])), (
            name
        )
    assert any(np.max(np.abs(one[n] - without[n])) > noise(interface.outputs[n]) for n in one)
