"""The empirical muscle of Dzahir and Yamamoto against a second implementation, its sleeves, and their Table 3."""

from __future__ import annotations

import importlib.util
import sys
from functools import cache
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from pam_cosim.catalogue import compose
from pam_cosim.fmu import build_model, build_source
from pam_cosim.simulation import Inputs, Simulator
from tests.library.catalogue import tree

EXAMPLE = Path(__file__).parents[2] / "examples" / "dzahir-yamamoto"
BASE = "PneumaticMuscle.Examples.ConstantFrictionLoad"
EFFECT = "LoadFrequencyFriction"


@cache
def rig() -> ModuleType:
    spec = importlib.util.spec_from_file_location(
        "dzahir_yamamoto_rig", EXAMPLE / "vertical_rig.py"
    )
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


def proposed() -> Path:
    composition = compose(tree(), BASE, [EFFECT])
    return build_source(composition.name, composition.text, brief=True)


@pytest.mark.parametrize(
    ("load", "frequency"),
    [
        (5.0, 0.5),
        *(
            pytest.param(*c, marks=pytest.mark.full)
            for c in ((15.0, 1.0), (20.0, 2.0), (30.0, 1.5))
        ),
    ],
)
def test_muscle_agrees_with_an_independent_integration(load: float, frequency: float) -> None:
    """Length and momentum by LSODA, the force by the braid's angle: apart by micrometres of some 50 mm."""
    alike = rig().Muscle(slenderness=(0.3, -15.0, 0.95), rounded_sign=np.tanh, sign_width=2e-3)
    truth = rig().Rig(alike, noise=0.0).run(load, frequency)
    own = {"load.m": load, "frequency": frequency, "damper.ab": 0.12}
    own |= {"muscle.friction.c_c": 6.0, "muscle.friction.c_v": 0.0}
    with Simulator(proposed()) as simulator:
        run = simulator.run(
            truth.time,
            parameters=own,
            inputs=Inputs(truth.time, {"p": truth.p}, "linear"),
            tolerance=1e-8,
        )
    assert np.ptp(truth.x) > 0.02
    assert np.abs(run.values["x"] - truth.x).max() < 3e-6


def test_constant_coefficient_and_effect_together_are_the_proposed_model() -> None:
    """DY (10): gamma_F gamma_f in the place of c_v is the bench VerticalLoad, whose a b is 0.15 s2."""
    times = np.linspace(0, 4, 401)
    course = Inputs(times, {"p": 2e5 * (1 - np.cos(2 * np.pi * times))}, "linear")
    own = {"load.m": 20.0, "frequency": 1.0}
    with Simulator(proposed()) as simulator:
        lone = simulator.run(
            times, parameters=own | {"damper.ab": 0.15, "muscle.friction.c_v": 0.0}, inputs=course
        )
    with Simulator(build_model("VerticalLoad", brief=True)) as simulator:
        whole = simulator.run(times, parameters=own, inputs=course)
    assert np.abs(lone.values["x"] - whole.values["x"]).max() < 2e-6


TABLE_3 = {
    0.5: (0.929, 0.937, 0.952, 0.955, 0.941, 0.948),
    1.0: (0.894, 0.903, 0.883, 0.898, 0.895, 0.904),
    1.5: (0.815, 0.825, 0.847, 0.839, 0.853, 0.861),
    2.0: (0.732, 0.739, 0.763, 0.741, 0.797, 0.799),
}
"""DY Table 3, as printed: correlation for 5, 10, ... 30 kg by frequency [Hz]."""


@pytest.mark.parametrize(
    ("frequency", "printed_mean", "printed_deviation", "mean"),
    [
        (0.5, 0.944, 0.009, 0.944),
        (1.0, 0.897, 0.007, 0.896),
        (1.5, 0.843, 0.016, 0.840),
        (2.0, 0.752, 0.027, 0.762),
    ],
)
def test_means_of_table_3(
    frequency: float, printed_mean: float, printed_deviation: float, mean: float
) -> None:
    """The last line's deviations follow from the entries above it; of the means only the one at 0.5 Hz does."""
    entries = np.array(TABLE_3[frequency])
    assert round(float(entries.std()), 3) == printed_deviation
    assert round(float(entries.mean()), 3) == mean
    assert (mean == printed_mean) == (frequency == 0.5)
