"""Compressible flow through an orifice, Doumit and Pardoel (2017) equations (40)-(42) and (62)."""

from __future__ import annotations

from math import pow, sqrt

R = 287.05  # J/(kg K)
GAMMA = 1.4
P_ATM = 101_325.0  # Pa
T_ATM = 293.15  # K
G = 9.80665  # m/s2

CP = GAMMA * R / (GAMMA - 1)  # J/(kg K)
CV = R / (GAMMA - 1)  # J/(kg K)
RHO = P_ATM / (R * T_ATM)  # kg/m3, near that of ISO 8778

R_CRITICAL = (2 / (GAMMA + 1)) ** (GAMMA / (GAMMA - 1))
FLOW_CONSTANT = sqrt(GAMMA / R * (2 / (GAMMA + 1)) ** ((GAMMA + 1) / (GAMMA - 1)))
R_LAMINAR = 0.999


def _head(r: float) -> float:
    return pow(r, 2 / GAMMA) - pow(r, (GAMMA + 1) / GAMMA)


_HEAD_CRITICAL = _head(R_CRITICAL)


def flow_function(r: float, r_laminar: float = R_LAMINAR) -> float:
    """N(r) [-] for r = p_down/p_up in (0, 1].

    Above `r_laminar` the root is replaced by the parabola a s + c s^2 in s = 1 - r that continues its value
    and its slope, so the flow stays once differentiable through r_laminar and has a finite slope at r = 1.
    """
    if r <= R_CRITICAL:
        return 1.0
    if r <= r_laminar:
        return sqrt(_head(r) / _HEAD_CRITICAL)
    edge = 1 - r_laminar
    value = sqrt(_head(r_laminar) / _HEAD_CRITICAL)
    head_slope = 2 / GAMMA * pow(r_laminar, 2 / GAMMA - 1) - (GAMMA + 1) / GAMMA * pow(
        r_laminar, 1 / GAMMA
    )
    slope = -head_slope / (2 * _HEAD_CRITICAL * value)
    c = (slope - value / edge) / edge
    s = 1 - r
    return s * (value / edge + c * (s - edge))


_COLDEST = 1.0  # K


def mass_flow(area: float, p_a: float, t_a: float, p_b: float, t_b: float) -> float:
    """Mass flow from a to b [kg/s], negative when b has the higher pressure.

    area: effective area [m2]; pressures absolute [Pa]; temperatures [K], which in a trial step of a solver may be
    below any that a gas has.
    """
    if p_a >= p_b:
        return FLOW_CONSTANT * p_a * area * flow_function(p_b / p_a) / sqrt(max(t_a, _COLDEST))
    return -FLOW_CONSTANT * p_b * area * flow_function(p_a / p_b) / sqrt(max(t_b, _COLDEST))


def valve_area(current: float, calibration: float) -> float:
    """Effective area of a valve [m2] at a current [A]: (62) times the calibration C_A."""
    return calibration * max(0.0, 1.80e-6 * current - 2.61e-7)
