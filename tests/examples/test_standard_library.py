"""Muscles among parts of the Modelica Standard Library, where its folder is in ``MODELICAPATH``."""

from __future__ import annotations

import os
from functools import cache
from pathlib import Path

import pytest

import pam_cosim as pam

EXAMPLE = Path(__file__).parents[2] / "examples" / "standard-library" / "StandardParts.mo"


@cache
def library() -> Path:
    """The folder of the package Modelica, as other tools find it (Modelica 3.6, section 13.3.1)."""
    places = [
        Path(place) for place in os.environ.get("MODELICAPATH", "").split(os.pathsep) if place
    ]
    found = [one for place in places for one in (place / "Modelica", *place.glob("Modelica 4*"))]
    there = [one for one in found if (one / "package.mo").is_file()]
    if not there:
        pytest.skip("the Modelica Standard Library is not in MODELICAPATH")
    return there[0]


def run(model: str, *names: str) -> pam.Trajectory:
    """A model of the example, with further variables."""
    outputs = ["x", *names] if model != "Joint" else ["phi", *names]
    return pam.simulate(f"StandardParts.{model}", files=[library(), EXAMPLE], outputs=outputs)


def test_a_spring_and_a_muscle_balance() -> None:
    made = run("SpringDamper", "muscle.flange_a.f", "mass.a")
    assert 0.02 < made["x"][-1] < 0.06
    net = -made["muscle.flange_a.f"] - 4000 * made["x"]
    moving = 2 * made["mass.a"] + 60 * pam_rate(made)
    assert abs(net - moving)[5:-5].max() < 0.02 * 4000 * made["x"][-1]


def pam_rate(made: pam.Trajectory) -> object:
    """Speed of the contraction [m/s], by differences."""
    import numpy as np

    return np.gradient(made["x"], made.time)


def test_a_controller_of_standard_blocks_holds_the_contraction() -> None:
    made = run("Controlled", "fill.y")
    assert made["x"][-1] == pytest.approx(0.02, abs=5e-4)
    assert made["fill.y"].min() >= 0 and made["fill.y"].max() <= 0.35
