"""Plain members against flows written down anew, and one plain member in every family."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from pam_cosim.simulation import Inputs, Simulator
from rig.flow import P_ATM, T_ATM, R, valve_area
from tests.library.catalogue import built, effects, on_bench, values

BENCH = "PneumaticMuscle.Benches.TankFilling"
TIMES = np.linspace(0, 40, 401)
VOLUME, N, SUPPLY = 1e-3, 1.2, 207e3 + P_ATM
AREA = valve_area(0.35, 0.699)
CHOKED = 0.0404184  # of air, kg K^0.5/(N s): sqrt(gamma/R) (2/(gamma + 1))^3
NO_PLAIN = {"gas_energy"}  # mass and energy take the place of a law that no value gives back


def iso(p_up: float, t_up: float, p_down: float, b: float) -> float:
    ratio = max(p_down / p_up - b, 0.0) / (1 - b)
    return CHOKED * AREA * p_up / t_up**0.5 * max(1 - ratio**2, 0.0) ** 0.5


def into(p: float, b: float, droop: float) -> float:
    """Flow from the supply: its pressure is lower by droop times the flow, found by halving."""
    low, high = 0.0, iso(SUPPLY, T_ATM, p, b)
    for _ in range(60):
        m = 0.5 * (low + high)
        behind = SUPPLY - droop * m / 1e-4
        low, high = (m, high) if behind > p and iso(behind, T_ATM, p, b) > m else (low, m)
    return m


def by_hand(b: float, droop: float) -> np.ndarray:
    """Gauge pressure in the tank, filled for 20 s, then vented."""

    def rate(filling, t, y):  # type: ignore[no-untyped-def]
        p = y[0]
        warm = T_ATM * (p / P_ATM) ** ((N - 1) / N)
        m = into(p, b, droop) if filling else -iso(p, warm, P_ATM, b) if p > P_ATM else 0.0
        return [N * R * warm * m / VOLUME]

    parts, p = [], P_ATM
    for filling, t in ((True, TIMES[TIMES <= 20]), (False, TIMES[TIMES >= 20])):
        part = solve_ivp(
            lambda t, y, on=filling: rate(on, t, y), t[[0, -1]], [p], "LSODA", t, rtol=1e-8
        ).y[0]
        p = part[-1]
        parts.append(part)
    return np.concatenate([parts[0], parts[1][1:]]) - P_ATM


@pytest.mark.parametrize(
    ("name", "own", "b", "droop"),
    [
        ("CriticalRatioArea", {"b": 0.2}, 0.2, 0.0),
        ("CriticalRatioArea", {"b": 0.5283}, 0.5283, 0.0),
        ("RegulatorDroop", {"D": 5e4}, 0.5283, 5e4),
    ],
)
def test_tank_is_filled_and_vented_as_written_down_anew(
    name: str, own: dict[str, float], b: float, droop: float
) -> None:
    effect = next(e for e in effects() if e.name == name)
    drive = {"u_in": [0.35, 0.0], "u_out": [0.0, 0.35], "p_supply": [SUPPLY - P_ATM] * 2}
    inputs = Inputs(np.array([0.0, 20.0]), {n: np.array(v) for n, v in drive.items()}, "previous")
    known = values(effect, on_bench(name, BENCH), own) | {"tank.V": VOLUME, "tank.n": N}
    with Simulator(built(BENCH, name)) as simulator:
        p = simulator.run(TIMES, parameters=known, inputs=inputs, tolerance=1e-8).values["p"]
    expected = by_hand(b, droop)
    assert np.abs(p - expected).max() < 300 and expected.max() > 150e3


def test_every_family_has_a_plain_member() -> None:
    plain = {e.family for e in effects() if e.absent and len(e.parameters) <= 2}
    assert {e.family for e in effects()} - plain == NO_PLAIN
