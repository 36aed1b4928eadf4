"""A vessel whose gas exchanges heat by free convection, against the same balances written down anew."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pam_cosim.simulation import Simulator
from rig.flow import GAMMA, P_ATM, T_ATM, R, mass_flow
from tests.library.catalogue import built, effects, on_bench, values

BENCH = "PneumaticMuscle.Benches.VesselOrifice"
TIMES = np.linspace(0, 60, 121)
VOLUME, DIAMETER, C_D, P_START = 16.2e-3, 2.71e-3, 0.84, 690e3
SURFACE = 2.5 * np.pi * (2 * VOLUME / np.pi) ** (2 / 3)
K_AIR, MU_AIR, PRANDTL, GRAVITY = 0.026, 1.85e-5, 0.71, 9.80665
C_P = GAMMA * R / (GAMMA - 1)


def film(c: float, p: float, t: float) -> float:
    """h by Nu = c Ra^(1/3), whose length cancels; here with a length of 0.3 m."""
    length, rho = 0.3, p / (R * t)
    rayleigh = GRAVITY / T_ATM * abs(t - T_ATM) * length**3 * rho**2 * PRANDTL / MU_AIR**2
    return float(c * rayleigh ** (1 / 3) * K_AIR / length)


def by_hand(c: float) -> np.ndarray:
    area = C_D * np.pi / 4 * DIAMETER**2

    def rates(_: float, y: np.ndarray) -> list[float]:
        mass, energy = y
        t = energy * (GAMMA - 1) / (R * mass)
        p = mass * R * t / VOLUME
        out = mass_flow(area, p, t, P_ATM, T_ATM)
        heat = film(c, p, t) * SURFACE * (T_ATM - t)
        return [-out, heat - out * C_P * (t if out > 0 else T_ATM)]

    p = P_START + P_ATM
    start = [p * VOLUME / (R * T_ATM), p * VOLUME / (GAMMA - 1)]
    mass, energy = solve_ivp(rates, TIMES[[0, -1]], start, "LSODA", TIMES, rtol=1e-9, atol=1e-9).y
    return np.stack([energy * (GAMMA - 1) / VOLUME - P_ATM, energy * (GAMMA - 1) / (R * mass)])


@pytest.mark.parametrize("c", [0.02, 0.13])
def test_discharge(c: float) -> None:
    effect = next(e for e in effects() if e.name == "FreeConvectionGas")
    parameters = values(effect, on_bench(effect.name, BENCH), {"c": c})
    known = {"tank.V": VOLUME, "tank.p_start": P_START, "orifice.d": DIAMETER, "orifice.C_d": C_D}
    with Simulator(built(BENCH, effect.name)) as simulator:
        simulated = simulator.run(TIMES, parameters=parameters | known, tolerance=1e-8).values
    p, t = by_hand(c)
    assert np.abs(simulated["p"] - p).max() < 300
    assert np.abs(simulated["T"] - t).max() < 0.3
    assert t.min() < T_ATM - 20
