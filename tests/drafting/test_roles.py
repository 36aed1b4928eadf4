"""Which recordings are held out."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim.drafting.entries import MappedRun
from pam_cosim.drafting.roles import roles
from pam_cosim.model.interface import Interface, Variable

BENCH = Interface("Bench", {"p": Variable("p", "Pa")}, {"x": Variable("x", "m")})


def course(level: float) -> MappedRun:
    time = 0.01 * np.arange(200)
    p = np.where(time > 0.5, level, 0.0)
    return MappedRun(time, {"p": p}, {"x": 1e-7 * p}, ())


@pytest.mark.parametrize(("count", "held_out"), [(1, 0), (2, 0), (3, 1), (4, 1), (8, 2), (20, 5)])
def test_how_many(count: int, held_out: int) -> None:
    told = roles([course(1e5 * (i + 1)) for i in range(count)], BENCH)
    assert sum(role.role == "holdout" for role in told) == held_out


def test_never_the_outermost() -> None:
    levels = [4e5, 1e5, 2.6e5, 6e5, 2e5, 5e5, 1.5e5]
    told = roles([course(level) for level in levels], BENCH)
    held = [level for level, role in zip(levels, told, strict=True) if role.role == "holdout"]
    assert held and min(levels) not in held and max(levels) not in held
    assert all(
        "within" in role.why and " to " in role.why for role in told if role.role == "holdout"
    )


def test_the_order_of_the_files_does_not_matter() -> None:
    levels = [1e5, 2e5, 3.3e5, 4e5, 6e5]
    one = roles([course(level) for level in levels], BENCH)
    other = roles([course(level) for level in levels[::-1]], BENCH)[::-1]
    assert [role.role for role in one] == [role.role for role in other]


def test_what_is_known_of_a_run_counts() -> None:
    told = roles([course(2e5)] * 5, Interface("B", BENCH.inputs, BENCH.outputs, {"m": Variable("m", "kg")}),
                 [{"m": mass} for mass in (2.0, 9.0, 5.0, 2.1, 8.9)])  # fmt: skip
    assert [role.role for role in told].index("holdout") == 2
