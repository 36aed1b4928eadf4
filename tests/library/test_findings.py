"""What the papers themselves found, as far as their equations give it."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from pam_cosim.fmu import build_model
from pam_cosim.simulation import Inputs, Simulator, Trajectory


@cache
def run(model: str, end: float, **parameters: float) -> Trajectory:
    with Simulator(build_model(f"PneumaticMuscle.{model}")) as simulator:
        return simulator.run(np.linspace(0, end, 1001), parameters=parameters)


def at(found: Trajectory, name: str, time: float) -> float:
    return float(np.interp(time, found.time, found.values[name]))


def static_force(p: float, eps: float) -> float:
    course = np.array([0.0, 1.0])
    inputs = Inputs(course, {"p": np.full(2, p), "eps": np.full(2, eps)})
    with Simulator(build_model("StaticForce")) as simulator:
        return float(simulator.run(course, inputs=inputs).values["F"][0])


def test_exponent_matters_for_the_steady_state_only_with_the_printed_wall() -> None:
    found = run("Validation.PolytropicExponent", 10)
    x, printed = ([at(found, f"{name}[{i}]", 4.9) for i in (1, 2, 3)] for name in ("x", "x_printed"))
    assert x == pytest.approx([67.88e-3] * 3, rel=1e-3)
    assert printed[0] > 1.25 * printed[1] > 1.25 * printed[2]


def test_temperature_by_the_polytropic_law_is_far_above_the_printed_four_degrees() -> None:
    found = run("Validation.PolytropicExponent", 10)
    for i, n in ((1, 1.0), (2, 1.2), (3, 1.4)):
        rise = float(found.values[f"T[{i}]"].max()) - 293.15
        ratio = 1 + float(found.values[f"p[{i}]"].max()) / 101325
        assert rise == pytest.approx(293.15 * (ratio ** ((n - 1) / n) - 1), abs=1e-3)
    assert rise > 100


def test_bladder_friction_moves_the_steady_contraction() -> None:
    found = run("Validation.BladderFriction", 10)
    assert at(found, "x[1]", 4.9) == pytest.approx(62.86e-3, abs=5e-5)
    assert at(found, "x[2]", 4.9) == pytest.approx(47.43e-3, abs=5e-5)


def test_friction_slows_only_fast_filling_and_a_bladder_every_filling() -> None:
    fast = run("Validation.ButylSlowRise", 4.9)
    slow = run("Validation.ButylSlowRise", 80, **{"inlet.height": 0.17, "inlet.stop": 1e3, "outlet.start": 1e3})

    def contraction(found: Trajectory, i: int) -> float:
        return float(np.interp(1e5, found.values[f"p[{i}]"], found.values[f"x[{i}]"]))

    assert contraction(fast, 2) < 0.8 * contraction(fast, 1)
    assert contraction(slow, 2) > 0.97 * contraction(slow, 1)
    assert contraction(fast, 3) < 0.5 * contraction(fast, 1)
    assert contraction(slow, 3) < 0.5 * contraction(slow, 1)


def test_slides_linearisation_holds_but_for_a_power_of_ten() -> None:
    slope = (static_force(6e5 + 50, 0.1) - static_force(6e5 - 50, 0.1)) / 100
    stiffness = (static_force(6e5, 0.1 - 1e-4) - static_force(6e5, 0.1 + 1e-4)) / (2e-4 * 0.3)
    assert slope == pytest.approx(10 * 5.7238e-5, rel=1e-4)
    assert stiffness == pytest.approx(8061.8, rel=1e-5)


def test_loops_of_the_empirical_muscle_widen_with_load_and_rate() -> None:
    found = run("Validation.LoadsAndRates", 20)

    def width(i: int) -> float:
        near = (np.abs(found.values[f"p[{i}]"] - 2e5) < 5e3) & (found.time > 2)
        return float(np.ptp(found.values[f"eps[{i}]"][near]))

    assert width(2) > 1.3 * width(1) and width(4) > 2 * width(3) and width(4) > 1.5 * width(2)
