"""Laws that DP review, each against its equation as printed, along a run of the example that uses it."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from pam_cosim.fmu import build_model
from pam_cosim.simulation import Inputs, Simulator, Trajectory
from rig.flow import P_ATM, T_ATM, G, R, mass_flow

L0, D0, TURNS = 0.24, 0.02, 2.0
FIBRE2 = L0**2 + (TURNS * np.pi * D0) ** 2
N, MASS = 1.3, 3.1
TIMES = np.linspace(0, 6, 1201)
BLEND = 0.13 / 0.35  # of the inlet, by the one command of Itto and Kogiso's valve while it fills

_STATES = [
    "p",
    "x",
    "load.v",
    "der(load.v)",
    "muscle.force.F",
    "muscle.force.V",
    "muscle.gas.T",
    "muscle.port.m_flow",
]
_FLOWS = ["valve.inlet.m_flow", "valve.outlet.m_flow"]


@cache
def run(example: str, **force: float) -> Trajectory:
    """Filled, held and vented; at last the supply is below the muscle, whose inlet is open."""
    knots = np.array([0, 2, 2, 2.5, 2.5, 4, 4, 6.0])
    drive = {
        "u_in": [0.35, 0.35, 0, 0, 0, 0, 0.3, 0.3],
        "u_out": [0, 0, 0, 0, 0.25, 0.25, 0, 0],
        "p_supply": [280e3, 280e3, 280e3, 280e3, 280e3, 280e3, 10e3, 10e3],
    }
    if example == "BlendedValveMuscle":
        drive["u_in"] = [0.13] * 6 + [0.05] * 2
    parameters = {"muscle.n": N, "load.m": MASS} | {
        f"muscle.force.{n}": v for n, v in force.items()
    }
    with Simulator(build_model(f"PneumaticMuscle.Examples.{example}", brief=True)) as simulator:
        inputs = Inputs(knots, {n: np.array(v) for n, v in drive.items()})
        return simulator.run(
            TIMES, parameters=parameters, inputs=inputs, outputs=[*_STATES, *_FLOWS], tolerance=1e-9
        )


def lifted(trajectory: Trajectory) -> np.ndarray:
    """Where the load hangs on the muscle alone, and moves fast enough for a sign that is rounded over 0.1 mm/s."""
    chosen = (trajectory["x"] > 1e-4) & (np.abs(trajectory["load.v"]) > 1e-3)
    assert (chosen & (trajectory["load.v"] > 0)).sum() > 50 and (
        chosen & (trajectory["load.v"] < 0)
    ).sum() > 50
    return chosen


def test_reynolds() -> None:
    """M y_ddot + B y_dot + K y = F_ce - M g, DP (6); B is another one in relaxation."""
    law = {"F_0": 4.0, "F_1": 5e-4, "K_0": 450.0, "K_1": 3e-3, "B_0": 60.0, "B_1": 1e-4, "r": 0.5}
    trajectory = run("ReynoldsMuscle", **law)
    at = lifted(trajectory)
    p, y, v, a = (trajectory[n][at] for n in ("p", "x", "load.v", "der(load.v)"))
    damping = np.where(v > 0, 60 + 1e-4 * p, 0.5 * (60 + 1e-4 * p))
    left = MASS * a + damping * v + (450 + 3e-3 * p) * y
    assert left == pytest.approx(4 + 5e-4 * p - MASS * G, abs=1e-6 * np.abs(left).max())


def test_cao_quadratic() -> None:
    """F(P) + B1(P) v + K1(P) x + K2(P) x^2 + B2(P) x v = L + M x_ddot, DP (7), with the weight as load L."""
    law = {"F_0": 3.0, "F_1": 5e-4, "B1_0": -45.0, "B1_1": -2e-4, "K1_0": -420.0, "K1_1": -5e-3}
    law |= {"K2_0": 900.0, "K2_1": 0.012, "B2_0": -80.0, "B2_1": -1e-3}
    trajectory = run("CaoQuadraticMuscle", **law)
    at = lifted(trajectory)
    p, x, v, a = (trajectory[n][at] for n in ("p", "x", "load.v", "der(load.v)"))
    linear = 3 + 5e-4 * p + (-45 - 2e-4 * p) * v + (-420 - 5e-3 * p) * x
    quadratic = (900 + 0.012 * p) * x**2 + (-80 - 1e-3 * p) * x * v
    assert linear + quadratic == pytest.approx(MASS * (G + a), abs=1e-6 * MASS * G)


def test_cao_piecewise() -> None:
    """One linear model below 200 kPa and another above, text after DP (7); the corner is rounded over 1 kPa."""
    law = {"F_0": 3.0, "F_1": 5e-4, "F_2": 2e-4, "K_0": 450.0, "K_1": 3e-3, "K_2": 1e-3}
    law |= {"B_0": 60.0, "B_1": 1e-4, "B_2": 3e-4}
    trajectory = run("CaoPiecewiseMuscle", **law)
    p, x, v, a = (trajectory[n] for n in ("p", "x", "load.v", "der(load.v)"))
    below, above = (lifted(trajectory) & chosen for chosen in (p < 180e3, p > 220e3))
    assert below.sum() > 50 and above.sum() > 50

    def force(at: np.ndarray, base: float, low: float, high: float) -> np.ndarray:
        beyond = base + low * 200e3 + high * (p[at] - 200e3)
        return np.where(p[at] < 200e3, base + low * p[at], beyond)

    for at in (below, above):
        pull = (
            force(at, 3, 5e-4, 2e-4)
            - force(at, 450, 3e-3, 1e-3) * x[at]
            - force(at, 60, 1e-4, 3e-4) * v[at]
        )
        # 1 kPa^2/(4 * 20 kPa) = 12.5 Pa times the change of a slope is what the rounded corner leaves at most
        rounded = 12.5 * (3e-4 + 2e-3 * x[at] + 2e-4 * np.abs(v[at]))
        assert (np.abs(pull - MASS * (G + a[at])) < rounded + 1e-6 * MASS * G).all()


def test_bernoulli() -> None:
    """Q = f_v C_q A_v sqrt(2/rho) sqrt(|P_in - P_out|), DP (10), both ways; mass by the density upstream."""
    trajectory = run("BarrelMuscle")
    inside, supply = trajectory["p"] + P_ATM, np.where(TIMES < 4, 280e3, 10e3) + P_ATM
    area = 0.699 * np.where(TIMES < 2, 1.80e-6 * 0.35 - 2.61e-7, 1.80e-6 * 0.30 - 2.61e-7)
    rho = np.where(supply > inside, supply / (R * T_ATM), inside / (R * trajectory["muscle.gas.T"]))
    flow = (
        np.sign(supply - inside) * rho * area * np.sqrt(2 / rho) * np.sqrt(np.abs(supply - inside))
    )
    apart = np.abs(supply - inside) > 2e4
    filling, backwards = apart & (TIMES < 2), apart & (TIMES > 4)
    assert filling.sum() > 100 and backwards.sum() > 100
    assert (flow[filling] > 0).all() and (flow[backwards] < 0).all()
    for at in (
        filling,
        backwards,
    ):  # the temperature upstream and the laminar flow below 20 Pa are rounded near zero
        assert trajectory["valve.inlet.m_flow"][at] == pytest.approx(flow[at], rel=1e-5)


def test_itto_kogiso() -> None:
    """m = phi m_i - (1 - phi) m_o, DP (8), with m_i and m_o those of valves opened by 0.35 A, DP (62)."""
    trajectory = run("BlendedValveMuscle")
    full = 0.699 * (1.80e-6 * 0.35 - 2.61e-7)
    for chosen, phi, supply in ((TIMES < 4, BLEND, 280e3), (TIMES > 4, 0.05 / 0.35, 10e3)):
        at = np.flatnonzero(chosen)[::20]
        net = []
        for p, t in zip(trajectory["p"][at] + P_ATM, trajectory["muscle.gas.T"][at], strict=True):
            inward = mass_flow(full, supply + P_ATM, T_ATM, p, t)
            outward = mass_flow(full, p, t, P_ATM, T_ATM)
            net.append(phi * inward - (1 - phi) * outward)
        largest = np.abs(net).max()
        assert largest > 1e-6
        assert trajectory["muscle.port.m_flow"][at] == pytest.approx(net, abs=1e-3 * largest)


@pytest.mark.parametrize("example", ["GaylordMuscle", "BlendedValveMuscle"])
def test_sorge(example: str) -> None:
    """DP (11) integrated: m = rho_0 (p/p_0)^(1/n) V is the gas that flowed in; the volume by the fibres' geometry."""
    trajectory = run(example)
    length = L0 - trajectory["x"]
    volume = length * (FIBRE2 - length**2) / (4 * np.pi * TURNS**2)
    mass = P_ATM / (R * T_ATM) * ((trajectory["p"] + P_ATM) / P_ATM) ** (1 / N) * volume
    flow = trajectory["muscle.port.m_flow"]
    smooth = (TIMES > 0.2) & (TIMES < 1.95)
    t, g = TIMES[smooth], flow[smooth]
    inward = np.concatenate([[0.0], np.cumsum((g[1:] + g[:-1]) / 2 * np.diff(t))])
    assert mass[smooth] - mass[smooth][0] == pytest.approx(inward, abs=2e-4 * inward.max())
    assert (
        np.ptp(volume[smooth]) > 0.1 * volume.max() or example != "GaylordMuscle"
    )  # the wall does move
