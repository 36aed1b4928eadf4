"""Fibres that stretch: the class against the smallest potential energy of gas and fibres, found by SciPy alone."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from pam_cosim.fmu import build_source
from pam_cosim.simulation import Inputs, Simulator

L0, D0, TURNS = 0.24, 0.02, 2.0
FIBRE = float(np.hypot(L0, TURNS * np.pi * D0))
STRAIN = 0.012  # of the fibres at 1 kN


def energy(length: float, p: float, fibre: float, strain: float) -> float:
    """Elastic energy of all fibres together less the work of the gas [J]."""
    stiffness = 1e3 / strain  # N
    volume = length * (fibre**2 - length**2) / (4 * np.pi * TURNS**2)
    return 0.5 * stiffness * (fibre - FIBRE) ** 2 / FIBRE - p * volume


def least_energy(length: float, p: float, strain: float) -> float:
    """Of the fibre length that the braid takes."""
    bounds = (FIBRE, 2 * FIBRE)
    found = minimize_scalar(
        lambda b: energy(length, p, b, strain), bounds=bounds, options={"xatol": 1e-12}
    )
    return float(found.fun)


def pull(length: float, p: float, strain: float = STRAIN) -> float:
    """Derivative of the least energy by the length: what must be held [N]."""
    step = 1e-5
    return (least_energy(length + step, p, strain) - least_energy(length - step, p, strain)) / (
        2 * step
    )


def modelled(p: np.ndarray, eps: np.ndarray, strain: float) -> np.ndarray:
    text = f"""model Bench "Stretching fibres"
      extends PneumaticMuscle.Benches.StaticForce(muscle(L0={L0}, D0={D0}, alpha_0={float(np.arccos(L0 / FIBRE))!r},
        redeclare model Braid = PneumaticMuscle.Effects.EndShape.ElasticBraid(e_f={strain!r})));
    end Bench;"""
    times = np.arange(float(len(p)))
    with Simulator(build_source("Bench", text, brief=True)) as simulator:
        values: np.ndarray = simulator.run(
            times, inputs=Inputs(times, {"p": p, "eps": eps}, "linear")
        ).values["F"]
    return values


@pytest.mark.parametrize("strain", [STRAIN, 0.06])
def test_pull_is_the_derivative_of_the_least_energy(strain: float) -> None:
    p, eps = (a.ravel() for a in np.meshgrid([1e5, 3e5, 6e5], [0.0, 0.08, 0.16, 0.22]))
    expected = [pull(L0 * (1 - e), float(q), strain) for q, e in zip(p, eps, strict=True)]
    assert modelled(p, eps, strain) == pytest.approx(expected, rel=2e-4, abs=0.05)
    inelastic = p * (3 * (L0 * (1 - eps)) ** 2 - FIBRE**2) / (4 * np.pi * TURNS**2)
    assert np.max(inelastic / expected) > 1 + 5 * strain  # the stretch is no small matter
