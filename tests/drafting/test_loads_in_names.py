"""Loads that the names of the files tell."""

from __future__ import annotations

import pytest

from pam_cosim.drafting.headings import load_in


@pytest.mark.parametrize(
    ("stem", "weights", "mass"),
    [
        ("run_2.5kg", True, 2.5), ("test-2000g", True, 2.0), ("run_20N", True, 20 / 9.80665),
        ("run_1,5kN", True, 1500 / 9.80665),
        ("w2_lb4.4", True, 1.99580642), ("5 lbs", True, 2.26796185), ("run_5lbf", True, 2.26796185),
        ("run_3", True, None),
        ("m2", True, None), ("12N5", True, None), ("run_20N", False, None), ("run_2kg", False, 2.0),
    ],
)  # fmt: skip
def test_a_mass_or_a_weight(stem: str, weights: bool, mass: float | None) -> None:
    told = load_in(stem, weights)
    assert (told and told[1]) == (mass and pytest.approx(mass))
