"""Benches without an independent rig, against another way to their solution: the exponential of a matrix, another
form of the equations in strain and angles."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from pam_cosim.fmu import build_model
from pam_cosim.simulation import Inputs, Simulator, Trajectory

G = 9.80665


def run(model: str, times: np.ndarray, course: Inputs, parameters: dict[str, float]) -> Trajectory:
    with Simulator(build_model(model, brief=True)) as simulator:
        return simulator.run(times, parameters=parameters, inputs=course, tolerance=1e-9)


def test_linear_model_is_the_exponential_of_its_matrix() -> None:
    """AM, dynamic model: d/dt [P, L, L_dot] = A [P, L, L_dot] + B P_in about (p_0, 0), F = F_0 + C_1 dP + C_2 dL."""
    tau, c_1, c_2, k, b, m, p_0, f_0, p_in = (
        0.03,
        4.28e-4,
        5706.0,
        900.0,
        25.0,
        1.3,
        3e5,
        40.0,
        4.1e5,
    )
    parameters = {
        "tau": tau,
        "C_1": c_1,
        "C_2": c_2,
        "k": k,
        "b": b,
        "m": m,
        "p_0": p_0,
        "F_0": f_0,
    }
    # about the place that a constant P_in leads to, what is left is exp(A t) of what there was
    matrix = np.array([[-1 / tau, 0, 0], [0, 0, 1], [-c_1 / m, -(c_2 + k) / m, -b / m]])
    end = np.array([p_in - p_0, -c_1 * (p_in - p_0) / (c_2 + k), 0.0])
    times = np.linspace(0, 0.8, 41)
    pressure, length = np.array([end - expm(matrix * t) @ end for t in times]).T[:2]
    trajectory = run("LumpedLinear", times, Inputs([0.0, 0.8], {"p_in": [p_in, p_in]}), parameters)
    assert trajectory["p"] == pytest.approx(p_0 + pressure, abs=1e-3)
    assert trajectory["L"] == pytest.approx(length, abs=1e-7 * np.ptp(length))
    assert trajectory["F"] == pytest.approx(f_0 + c_1 * pressure + c_2 * length, abs=1e-5)
    assert np.ptp(length) > 4e-3 and np.abs(np.diff(np.sign(np.diff(length)))).sum() > 4  # it rings


LENGTH, DIAMETER, ANGLE = 0.28, 0.018, np.radians(24.0)
MASS = 12.0
C_1, C_2, C_3, C_4, C_5 = 2.5, -1.8e-6, 0.25, -12.0, 0.9
COULOMB, ROUND, A, B, STIFFNESS = 6.0, 4e-3, 0.6, 0.25, 2e10
TAU = 0.02


def static_force(p: float, eps: float) -> float:
    """DY (5)-(7), as printed."""
    q = 1 + C_1 * np.exp(C_2 * p)
    mu = C_3 * np.exp(C_4 * eps) + C_5
    bracket = 3 * (1 - q * eps) ** 2 / np.tan(ANGLE) ** 2 - 1 / np.sin(ANGLE) ** 2
    return float(mu * np.pi * DIAMETER**2 * p / 4 * bracket)


def slope(t: float, state: np.ndarray, frequency: float) -> list[float]:
    """DY (13)-(16) in pressure, strain and rate of strain; the regulator follows its command with a lag."""
    p, eps, rate = state
    wanted = 150e3 * (1 - np.cos(2 * np.pi * t))
    friction = (
        COULOMB * np.tanh(rate / ROUND) + A * MASS * G * B * frequency * rate
    )  # DY (10)-(11), sign rounded
    elastic = (
        STIFFNESS * max(0.0, -LENGTH * eps) ** 3
    )  # DY (12), L_o = L, the bracket where the force is continuous
    return [
        (wanted - p) / TAU,
        rate,
        (static_force(p, eps) + elastic - friction - MASS * G) / (MASS * LENGTH),
    ]


@pytest.mark.parametrize("frequency", [0.5, 1.6])
def test_vertical_load_in_strain_and_angles(frequency: float) -> None:
    """The pressure swings at 1 Hz; the run's frequency is a number of its own, and any power of 1 would be 1."""
    times = np.linspace(0, 2.0, 101)
    start = [0.0, -((MASS * G / STIFFNESS) ** (1 / 3)) / LENGTH, 0.0]
    exact = solve_ivp(
        slope,
        (0, 2.0),
        start,
        method="LSODA",
        t_eval=times,
        args=(frequency,),
        rtol=1e-10,
        atol=[1e-3, 1e-12, 1e-10],
    )
    fine = np.linspace(0, 2.0, 8001)
    course = Inputs(fine, {"p": 150e3 * (1 - np.cos(2 * np.pi * fine))})
    parameters = {
        "frequency": frequency, "load.m": MASS, "regulator.tau": TAU, "muscle.L0": LENGTH, "muscle.D0": DIAMETER,
        "muscle.alpha_0": ANGLE, "muscle.braid.c_1": C_1, "muscle.braid.c_2": C_2, "muscle.braid.c_3": C_3,
        "muscle.braid.c_4": C_4, "muscle.braid.c_5": C_5, "muscle.friction.c_c": COULOMB,
        "muscle.friction.rate_smooth": ROUND, "muscle.friction.a": A, "muscle.friction.b_f": B,
        "muscle.elasticity.K": STIFFNESS,
    }  # fmt: skip
    trajectory = run("VerticalLoad", times, course, parameters)
    p, eps, _ = exact.y
    assert np.ptp(eps) > 0.1 and trajectory["eps"] == pytest.approx(eps, abs=1e-6)
    assert trajectory["x"] == pytest.approx(LENGTH * eps, abs=1e-6 * LENGTH)
