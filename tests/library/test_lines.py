"""Lines between valve and tank against two volumes in a row, written down anew with the rig's orifice."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pam_cosim.simulation import Inputs, Simulator
from rig.flow import GAMMA, P_ATM, T_ATM, R, mass_flow, valve_area
from tests.library.shelf import built, effects, on_bench, values

BENCH = "PneumaticMuscle.Benches.TankFilling"
TIMES = np.linspace(0, 30, 301)
V_TANK, N, P_SUPPLY = 1e-3, 1.2, 207e3


def laminar(p_a: float, p_b: float) -> float:
    return 3e-9 * (p_a**2 - p_b**2) / (2 * P_ATM)


def turbulent(p_a: float, p_b: float) -> float:
    return float(2e-7 * np.sign(p_a - p_b) * np.sqrt(abs(p_a**2 - p_b**2) / (R * T_ATM)))


ISOTHERMAL = "FrictionLine"

LINES = {
    "OrificeLine": (
        {"A": 2e-7},
        2e-7,
        lambda p_a, t_a, p_b, t_b: mass_flow(2e-7, p_a, t_a, p_b, t_b),
    ),
    "LongLine": (
        {"A": 2e-7, "V": 5e-5},
        5e-5,
        lambda p_a, t_a, p_b, t_b: mass_flow(2e-7, p_a, t_a, p_b, t_b),
    ),
    "LaminarLine": ({"G": 3e-9}, 2e-7, lambda p_a, t_a, p_b, t_b: laminar(p_a, p_b)),
    "FrictionLine": ({"A": 2e-7, "V": 5e-5}, 5e-5, lambda p_a, t_a, p_b, t_b: turbulent(p_a, p_b)),
}


def by_hand(volume, flow, isothermal):  # type: ignore[no-untyped-def]
    """Gauge pressure in the tank: filled for 20 s, then vented; the line adiabatic or as warm as its surroundings."""

    def rates(t, y, filling):  # type: ignore[no-untyped-def]
        p_line, m_line, p = y
        t_line = T_ATM if isothermal else p_line * volume / (m_line * R)
        t_tank = T_ATM * (p / P_ATM) ** ((N - 1) / N)
        area = valve_area(0.35, 0.699)
        outside = P_SUPPLY + P_ATM if filling else P_ATM
        into = mass_flow(area, outside, T_ATM, p_line, t_line)
        on = flow(p_line, t_line, p, t_tank)
        heat = into * (T_ATM if into > 0 else t_line) - on * (t_line if on > 0 else t_tank)
        p_line_rate = R * T_ATM * (into - on) / volume if isothermal else GAMMA * R * heat / volume
        return [p_line_rate, into - on, N * R * t_tank * on / V_TANK]

    y, pressures = np.array([P_ATM, P_ATM * volume / (R * T_ATM), P_ATM]), []
    for filling, part in ((True, TIMES[TIMES <= 20]), (False, TIMES[TIMES >= 20])):
        piece = solve_ivp(
            rates, part[[0, -1]], y, "BDF", part, args=(filling,), rtol=1e-8, atol=[1e-2, 1e-13, 1e-2]
        ).y  # fmt: skip
        y = piece[:, -1]
        pressures.append(piece[2])
    return np.concatenate([pressures[0], pressures[1][1:]]) - P_ATM


@pytest.mark.parametrize("name", LINES)
def test_tank_behind_a_line(name: str) -> None:
    own, volume, flow = LINES[name]
    effect = next(e for e in effects() if e.name == name)
    parameters = values(effect, on_bench(name, BENCH), own)
    drive = {
        "u_in": np.array([0.35, 0.0]),
        "u_out": np.array([0.0, 0.35]),
        "p_supply": np.array([P_SUPPLY, P_SUPPLY]),
    }
    with Simulator(built(BENCH, name)) as simulator:
        simulated = simulator.run(
            TIMES,
            parameters=parameters | {"tank.V": V_TANK, "tank.n": N},
            inputs=Inputs(np.array([0.0, 20.0]), drive, "previous"),
            tolerance=1e-7,
        ).values["p"]
    expected = by_hand(volume, flow, name == ISOTHERMAL)
    assert np.abs(simulated - expected).max() < 100
    assert np.abs(simulated - expected).mean() < 20
    assert expected.max() > 50e3
