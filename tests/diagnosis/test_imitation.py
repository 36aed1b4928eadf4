"""Which effects do nearly the same to the samples as one."""

from __future__ import annotations

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.diagnosis.search.imitation import likest_members
from pam_cosim.diagnosis.search.probing import EffectProbe
from pam_cosim.fitting import Linear

ROWS = 50
RANDOM = np.random.default_rng(3)
FREE, MOVES, OTHER = (RANDOM.standard_normal(ROWS) for _ in range(3))


def linear(residual: Array, **slopes: Array) -> Linear:
    names, columns = tuple(slopes), np.column_stack(list(slopes.values()))
    limits = np.ones(len(names))
    return Linear(names, np.zeros(len(names)), -limits, limits, residual, columns)


BASE = linear(np.ones(ROWS), free=FREE)


def probe(effect: str, *moves: Array) -> EffectProbe:
    own = {f"{effect}.{k}": move for k, move in enumerate(moves)}
    return EffectProbe(
        effect, effect.lower(), tuple(own), linear(BASE.residual - moves[0], free=FREE, **own)
    )


def test_the_likest_first_whatever_its_size_and_sign_and_what_the_base_model_can_do() -> None:
    probes = [
        probe("Asked", MOVES),
        probe("Same", -7.0 * MOVES + 30.0 * FREE),
        probe("Near", MOVES + 0.3 * OTHER),
        probe("Rich", OTHER, MOVES + 0.1 * RANDOM.standard_normal(ROWS)),
        probe("Far", OTHER),
        probe("Silent", np.zeros(ROWS)),
    ]
    others = ["far", "near", "rich", "same", "silent"]
    likest = likest_members(["Asked"], probes, BASE, others)["Asked"]
    assert likest[:3] == ["Same", "Rich", "Near"] and likest[-1] == "Silent"
    assert likest_members(["Asked"], probes, BASE, ["near"])["Asked"] == ["Near"]
