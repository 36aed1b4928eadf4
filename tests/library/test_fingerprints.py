"""What classes say of the traces of their effects, where it was not plain: by simulation, against no effect."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq

from pam_cosim.fmu import build_model
from pam_cosim.simulation import Inputs, Simulator
from rig.flow import P_ATM, T_ATM, mass_flow
from tests.library.shelf import BENCH, built

TANK = "PneumaticMuscle.Benches.TankFilling"
FILLED, VENTED, END = 3.0, 63.0, 70.0
NOISE = 500.0
"""[Pa] What a sensor shows."""


def courses(effect: str, times: np.ndarray) -> dict[str, np.ndarray]:
    """Filled for 3 s, held for a minute, vented for a second and shut."""
    shut = VENTED + 1
    edges = np.array([0, FILLED, FILLED + 1e-3, VENTED, VENTED + 1e-3, shut, shut + 1e-3, END])
    drive = {"u_in": [0.35, 0.35, 0, 0, 0, 0, 0, 0], "u_out": [0, 0, 0, 0, 0.35, 0.35, 0, 0]}
    inputs = Inputs(edges, {n: np.array(v, dtype=float) for n, v in drive.items()}, "linear")
    with Simulator(built(BENCH, effect) if effect else build_model(BENCH, brief=True)) as simulator:
        run = simulator.run(np.r_[0.0, times], inputs=inputs, tolerance=1e-8)
        return {name: course[1:] for name, course in run.values.items()}


def test_a_wall_that_warms_up_keeps_the_gas_warm_in_the_hold_and_in_the_venting_after_it() -> None:
    times = np.array([FILLED + 30, VENTED, VENTED + 0.5, END])
    cold, warm = courses("", times), courses("WarmWall", times)
    assert (warm["T"] - cold["T"] > 0.3).all()
    assert (warm["p"] - cold["p"] > NOISE).all()


def test_a_wall_that_stores_heat_cools_a_filling_more_and_is_warm_after_a_hold() -> None:
    times = np.array([1.0, FILLED + 1, VENTED])
    plain, stored = courses("", times), courses("StorageWall", times)
    filling, held, end = stored["p"] - plain["p"]
    assert max(filling, held) < -NOISE and end > NOISE


@pytest.mark.parametrize(("seat", "stated"), [(5e-9, 0.1e3), (1e-8, 0.3e3)])
def test_venting_ends_where_the_exhaust_lets_out_what_the_seat_lets_in(
    seat: float, stated: float
) -> None:
    supply, exhaust = 207e3 + P_ATM, 0.699 * (1.80e-6 * 0.35 - 2.61e-7)
    enters = mass_flow(seat, supply, T_ATM, P_ATM, T_ATM)

    def too_much(p: float) -> float:
        return float(mass_flow(exhaust, p + P_ATM, T_ATM, P_ATM, T_ATM) - enters)

    expected = brentq(too_much, 1.0, 1e4)
    with Simulator(built(TANK, "LeakingSeat")) as simulator:
        (own,) = (n for n in simulator.interface.parameters if n.endswith(".A_seat"))
        shown = simulator.run(
            [0.0, 200.0], parameters={own: seat, "u_in": 0.0, "u_out": 0.35, "tank.V": 0.35e-3}
        ).values["p"]
    assert shown[-1] == pytest.approx(expected, rel=0.1)
    assert shown[-1] == pytest.approx(stated, rel=0.25)
