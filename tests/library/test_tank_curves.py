"""The sixteen tank curves of Doumit and Pardoel, filled and emptied, against quadrature."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from pam_cosim.fmu import build_model
from pam_cosim.simulation import Inputs, Simulator
from rig.quadrature import Approach
from rig.tank import Vessel, valve_ports

VOLUMES = (2.1e-3, 1.85e-3, 1.6e-3, 1.35e-3, 1.1e-3, 0.85e-3, 0.6e-3, 0.35e-3)  # m3
SUPPLIES = (207e3, 138e3)  # Pa gauge
EXPONENTS = (1.0, 1.2, 1.4)
PARTS = np.arange(1, 10) / 10
CURRENT = 0.35  # A


@cache
def simulator() -> Simulator:
    return Simulator(build_model("TankFilling", brief=True))


def exact_times(vessel: Vessel, supply: float, filling: bool) -> np.ndarray:
    """Times [s] at 10 to 90 % of the supply on the way up, at 90 to 10 % on the way down."""
    ports = valve_ports(supply, 0.699)
    if filling:
        way = Approach(vessel, ports, 0.0, supply, (CURRENT, 0.0))
        return np.array([way.time_to(part * supply) for part in PARTS])
    way = Approach(vessel, ports, supply, 0.0, (0.0, CURRENT))
    return np.array([way.time_to(part * supply) for part in PARTS[::-1]])


def simulated_times(vessel: Vessel, supply: float, filling: bool, end: float) -> np.ndarray:
    """The same from the FMU, between samples 2000 to the course."""
    times = np.linspace(0.0, end, 2001)
    held = {"u_in": CURRENT * filling, "u_out": CURRENT * (not filling), "p_supply": supply}
    inputs = Inputs(np.array([0.0, end]), {name: np.full(2, value) for name, value in held.items()})
    parameters = {
        "tank.V": vessel.volume,
        "tank.n": vessel.n,
        "tank.p_start": 0.0 if filling else supply,
    }
    p = simulator().run(times, parameters=parameters, inputs=inputs).values["p"]
    if filling:
        return np.interp(PARTS * supply, p, times)
    return np.interp(-PARTS[::-1] * supply, -p, times)


@pytest.mark.parametrize("filling", (True, False), ids=("inflation", "deflation"))
@pytest.mark.parametrize("n", EXPONENTS)
@pytest.mark.parametrize("supply", SUPPLIES)
@pytest.mark.parametrize("volume", VOLUMES)
def test_times_agree_with_quadrature(volume: float, supply: float, n: float, filling: bool) -> None:
    vessel = Vessel(volume, n)
    exact = exact_times(vessel, supply, filling)
    simulated = simulated_times(vessel, supply, filling, 1.1 * exact[-1])
    assert simulated == pytest.approx(exact, rel=2e-4)
