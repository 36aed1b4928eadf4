"""What the papers themselves found, as far as their equations give it."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from pam_cosim.fmu import build_model, build_source
from pam_cosim.simulation import Simulator, Trajectory
from rig.flow import flow_function


@cache
def run(model: str, end: float, samples: int = 1001, **parameters: float) -> Trajectory:
    with Simulator(build_model(f"PneumaticMuscle.{model}", brief=True)) as simulator:
        return simulator.run(np.linspace(0, end, samples), parameters=parameters)


def at(trajectory: Trajectory, name: str, time: float) -> float:
    return float(np.interp(time, trajectory.time, trajectory.values[name]))


def test_temperature_by_the_polytropic_law_is_far_above_the_printed_four_degrees() -> None:
    trajectory = run("Examples.Validation.PolytropicExponent", 10)
    for i, n in ((1, 1.0), (2, 1.2), (3, 1.4)):
        rise = float(trajectory.values[f"T[{i}]"].max()) - 293.15
        ratio = 1 + float(trajectory.values[f"p[{i}]"].max()) / 101325
        assert rise == pytest.approx(293.15 * (ratio ** ((n - 1) / n) - 1), abs=1e-3)
    assert rise > 100


def test_friction_slows_only_fast_filling_and_a_bladder_every_filling() -> None:
    model = "Examples.Validation.ButylSlowRise"
    fast = run(model, 4.9)
    slow = run(model, 80, **{"inlet.height": 0.17, "inlet.stop": 1e3, "outlet.start": 1e3})

    def contraction(trajectory: Trajectory, i: int) -> float:
        return float(np.interp(1e5, trajectory.values[f"p[{i}]"], trajectory.values[f"x[{i}]"]))

    assert contraction(fast, 2) < 0.8 * contraction(fast, 1)
    assert contraction(slow, 2) > 0.97 * contraction(slow, 1)
    assert contraction(fast, 3) < 0.5 * contraction(fast, 1)
    assert contraction(slow, 3) < 0.5 * contraction(slow, 1)


def test_area_by_the_flow_is_one_for_all_supplies_and_other_conversions_are_not() -> None:
    trajectory = run("Examples.Validation.ValveCalibration", 10)
    area, choked, gauge = ([float(trajectory.values[f"{name}[{i}]"][-1]) for i in range(1, 16)]
                           for name in ("A", "A_choked", "A_gauge"))  # fmt: skip
    assert area == pytest.approx([2.580e-7] * 15, rel=1e-3)
    assert choked[0] < 0.87 * area[0] and choked[4:] == pytest.approx(area[4:], rel=1e-6)
    assert gauge[0] > 2.7 * gauge[-1]


def test_laminar_flow_near_equal_pressures_bends_the_law_as_little_as_its_class_says() -> None:
    """0.25 % at ten times the laminar pressure drop, 0.1 % at sixteen times."""
    supply = 308325.0
    for times, off in ((10, 2.5e-3), (16, 1.0e-3)):
        ratio = 1 - times * 3e-4
        source = f"""model Laminar{times} output Real m = PneumaticMuscle.Functions.isentropicFlow(
          {supply}, {supply * ratio!r}, 293.15, 1e-6); end Laminar{times};"""
        with Simulator(build_source(f"Laminar{times}", source, brief=True)) as simulator:
            flow = float(simulator.run(np.array([0.0, 1.0])).values["m"][0])
        exact = 0.0404154 * supply * 1e-6 / np.sqrt(293.15) * flow_function(ratio, 0.99999)
        assert 1 - flow / exact == pytest.approx(off, rel=0.05)
