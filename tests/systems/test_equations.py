"""Benches against the values and curves that two people who implement the equations must both get."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from pam_cosim.simulation import Inputs, Simulator, Trajectory
from rig.quadrature import Approach
from rig.tank import Vessel, valve_ports

Bench = Callable[[str], Path]
CALIBRATION = 0.699


@pytest.fixture(scope="module")
def muscle(bench: Bench) -> Trajectory:
    """Filled at 0.35 A for 5 s, then vented; the currents cross over within one sample, from 4.99 s to 5 s."""
    time = np.array([0.0, 4.99, 5.0, 10.0])
    u = 0.35 * np.array([1.0, 1.0, 0.0, 0.0])
    inputs = Inputs(time, {"u_in": u, "u_out": 0.35 - u, "p_supply": np.full(4, 207e3)})
    with Simulator(bench("Isotonic")) as simulator:
        return simulator.run(np.arange(1001) / 100, inputs=inputs, tolerance=1e-8)


@pytest.mark.parametrize(
    ("signal", "t", "printed"),
    [
        ("p", 1.0, 77.4e3),
        ("x", 1.0, 56.4e-3),
        ("p", 3.0, 206.8e3),
        ("x", 3.0, 67.88e-3),
        ("p", 6.0, 82.1e3),
        ("x", 7.0, 39.5e-3),
    ],
)
def test_muscle(muscle: Trajectory, signal: str, t: float, printed: float) -> None:
    full = {"p": 207e3, "x": 67.88e-3}[signal]
    assert muscle[signal][round(100 * t)] == pytest.approx(printed, abs=0.01 * full)


@pytest.mark.parametrize(
    ("volume", "n", "supply", "share", "printed"),
    [(2.1e-3, 1.0, 207e3, 0.5, 13.84), (2.1e-3, 1.2, 207e3, 0.5, 10.80), (2.1e-3, 1.4, 207e3, 0.5, 8.85),
     (0.35e-3, 1.2, 138e3, 0.9, 3.200)],
)  # fmt: skip
def test_tank_times(
    bench: Bench, volume: float, n: float, supply: float, share: float, printed: float
) -> None:
    times = np.linspace(0.0, 20.0, 4001)
    with Simulator(bench("TankFilling")) as simulator:
        held = Inputs([0.0], {"p_supply": [supply]})
        run = simulator.run(
            times, parameters={"tank.V": volume, "tank.n": n}, inputs=held, tolerance=1e-8
        )
    assert float(np.interp(share * supply, run["p"], times)) == pytest.approx(printed, rel=0.003)


VOLUMES = [2.1e-3, 1.85e-3, 1.6e-3, 1.35e-3, 1.1e-3, 0.85e-3, 0.6e-3, 0.35e-3]


@pytest.mark.parametrize("supply", [207e3, 138e3])
@pytest.mark.parametrize("volume", VOLUMES)
def test_sixteen_tank_curves(bench: Bench, volume: float, supply: float) -> None:
    """Inflation and deflation against quadrature of the separable equation: 0.3 % of the supply pressure."""
    times = np.linspace(0.0, 20.0, 41)
    vessel, ports = Vessel(volume, 1.2), valve_ports(supply, CALIBRATION)
    with Simulator(bench("TankFilling")) as simulator:
        fill = simulator.run(
            times,
            parameters={"tank.V": volume},
            inputs=Inputs([0.0], {"p_supply": [supply]}),
            tolerance=1e-8,
        )
        vent = simulator.run(
            times,
            parameters={"tank.V": volume, "tank.p_start": supply},
            inputs=Inputs([0.0], {"u_in": [0.0], "u_out": [0.35], "p_supply": [supply]}),
            tolerance=1e-8,
        )
    for run, start, end, currents in (
        (fill, 0.0, supply, (0.35, 0.0)),
        (vent, supply, 0.0, (0.0, 0.35)),
    ):
        exact = Approach(vessel, ports, start, end, currents).pressures(times)
        assert np.abs(run["p"] - exact).max() < 0.003 * supply
        assert abs(run["p"][1] - run["p"][0]) > 0.02 * supply  # the curve does move
