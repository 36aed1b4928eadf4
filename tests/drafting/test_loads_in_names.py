"""Loads that the names of the files tell."""

from __future__ import annotations

from pathlib import Path

import pytest

from pam_cosim.drafting.values import in_names
from pam_cosim.model.interface import Interface, Variable

MASS = {"load.m": Variable("load.m", "kg", min=1e-3, description="Mass of the load")}
HANGING = Interface("Hanging", {"p": Variable("p", "Pa")}, {}, MASS)
PULLED = Interface("Pulled", {"F": Variable("F", "N")}, {}, MASS)


@pytest.mark.parametrize(
    ("stems", "masses"),
    [
        (["run_2.5kg", "run_5kg"], [2.5, 5.0]),
        (["test-2000g", "test-5000g"], [2.0, 5.0]),
        (["run_20N", "run_1,5kN"], [20 / 9.80665, 1500 / 9.80665]),
        (["w2_lb4.4", "w5_lb11"], [1.99580642, 4.98951607]),
        (["5 lbs", "11lb"], [2.26796185, 4.98951607]),
        (["run_5lbf"], [2.26796185]),
        (["run_20N", "run_3"], None),
        (["run_0N", "run_20N"], None),
        (["m2", "12N5"], None),
    ],
)
def test_a_mass_or_a_weight(stems: list[str], masses: list[float] | None) -> None:
    told = in_names([Path(f"{stem}.csv") for stem in stems], HANGING)
    expected = [{}] * len(stems) if masses is None else [{"load.m": one} for one in masses]
    assert [{n: one.number for n, one in run.items()} for run in told] == [
        pytest.approx(one) for one in expected
    ]


def test_a_weight_is_no_mass_where_a_force_is_imposed() -> None:
    assert in_names([Path("run_20N.csv")], PULLED) == [{}]
    assert in_names([Path("run_2kg.csv")], PULLED)[0]["load.m"].number == pytest.approx(2.0)
