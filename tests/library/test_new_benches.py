"""Benches for rigs of others: what they do at once can be written down."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.simulation import Inputs, Simulator
from rig.flow import P_ATM, T_ATM, R, mass_flow

L0, D0, TURNS = 0.24, 0.02, 2.0
SWITCHED = "PneumaticMuscle.Benches.SwitchedMuscle"


def switched(times: np.ndarray, **inputs: float) -> dict[str, np.ndarray]:
    drive = {"u_in": 0.0, "u_out": 0.0, "p_supply": 500e3, "s": 0.0} | inputs
    with Simulator(study.build(SWITCHED)) as simulator:
        held = Inputs(
            np.array([0.0, times[-1]]), {n: np.full(2, v) for n, v in drive.items()}, "linear"
        )
        return simulator.run(
            times, parameters={"valve.C_A": 0.2}, inputs=held, tolerance=1e-8
        ).values


def test_open_valve_has_ten_times_its_calibration_in_square_millimetres() -> None:
    times = np.linspace(0, 1e-4, 11)
    rate = np.gradient(switched(times, u_in=1.0)["p"], times)[1]
    volume = np.pi / 4 * D0**2 * L0
    expected = 1.4 * R * T_ATM * mass_flow(2e-6, 500e3 + P_ATM, T_ATM, P_ATM, T_ATM) / volume
    assert rate == pytest.approx(expected, rel=0.02)


def test_shut_valves_hold_what_contraction_leaves() -> None:
    """Shut up at rest and contracted by 20 mm, the gas is drawn out: V = L (b^2 - L^2)/(4 pi n^2)."""
    times = np.linspace(0, 0.05, 51)
    p = switched(times, s=0.02)["p"] + P_ATM
    b2 = L0**2 + (TURNS * np.pi * D0) ** 2
    before, after = (x * (b2 - x**2) for x in (L0, L0 - 0.02))
    assert p[-1] == pytest.approx(P_ATM * (before / after) ** 1.4, rel=0.02)
