"""One number of a run, against curves whose numbers are known."""

from __future__ import annotations

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.sweeps import read_scalars

FACE = Interface(
    "Test",
    outputs={"p": Variable("p", "Pa"), "T": Variable("T", "K")},
    locals={"der(x,2)": Variable("der(x,2)", "m/s2"), "flow": Variable("flow", "kg/s")},
)
TIME = np.linspace(0.0, 10.0, 2001)
TAU = 1.25
RUN = pam.Trajectory(
    TIME,
    {
        "p": 1e5 * (1 - np.exp(-TIME / TAU)),
        "T": 293.0 + 5.0 * np.sin(np.pi * TIME / 10.0) ** 2,
        "der(x,2)": np.full(TIME.shape, 3.0),
        "flow": 2.0 * TIME,
    },
    {"p": "Pa", "T": "K", "der(x,2)": "m/s2", "flow": "kg/s"},
)
END = 1 - np.exp(-10.0 / TAU)


@pytest.mark.parametrize(
    ("text", "value", "unit"),
    [
        ("time_to(p, 90 %)", -TAU * np.log(1 - 0.9 * END), "s"),
        ("time_to(p)", -TAU * np.log(1 - 0.9 * END), "s"),
        ("time_to( p , 0.5 )", -TAU * np.log(1 - 0.5 * END), "s"),
        ("initial(p)", 0.0, "Pa"),
        ("final(p)", 1e5 * END, "Pa"),
        ("max(T)", 298.0, "K"),
        ("min(T)", 293.0, "K"),
        ("range(T)", 5.0, "K"),
        ("time_of_max(T)", 5.0, "s"),
        ("time_of_min(p)", 0.0, "s"),
        ("mean(flow)", 10.0, "kg/s"),
        ("integral(flow)", 100.0, "kg"),
        ("max(der(x,2))", 3.0, "m/s2"),
        ("steady(flow, 20 %)", 18.0, "kg/s"),
        ("steady(flow)", 19.0, "kg/s"),
    ],
)
def test_values(text: str, value: float, unit: str) -> None:
    (scalar,) = read_scalars([text], FACE)
    assert scalar.of(RUN) == pytest.approx(value, rel=1e-4, abs=1e-9)
    assert scalar.unit == unit


def test_a_course_that_falls_has_a_time_too() -> None:
    falling = pam.Trajectory(TIME, {"p": 1e5 - RUN["p"]}, {"p": "Pa"})
    (scalar,) = read_scalars(["time_to(p, 90 %)"], FACE)
    assert scalar.of(falling) == pytest.approx(-TAU * np.log(1 - 0.9 * END), rel=1e-4)


def test_a_run_that_has_not_settled_has_no_time() -> None:
    """Of a tank that is still filling nobody knows the whole change, nor when nine tenths of it are done."""
    (scalar,) = read_scalars(["time_to(p, 90 %)"], FACE)
    short = TIME < 4.5 * TAU
    filling = pam.Trajectory(TIME[short], {"p": RUN["p"][short]}, {"p": "Pa"})
    assert np.isnan(scalar.of(filling))


@pytest.mark.parametrize(
    ("asked", "words"),
    [
        (["p"], "write FUNCTION(VARIABLE)"),
        (["__import__('os')"], "there is no function of that name"),
        (["maxx(p)"], "did you mean 'max'"),
        (["max(q)"], "Test has no variable 'q'"),
        (["max(p, 3)"], "no variable 'p, 3'"),
        (["time_to(p, 3 m)"], "3 m"),
        (["time_to(p, 0)"], "above 0 and at most 1"),
        (["time_to(p, 120 %)"], "above 0 and at most 1"),
        (["max(p)", " max(p) "], "asked for twice"),
    ],
)
def test_what_is_no_scalar_is_refused(asked: list[str], words: str) -> None:
    with pytest.raises(pam.InputError) as refused:
        read_scalars(asked, FACE)
    assert words in str(refused.value)
