"""Data of the independent simulator, as data sets in memory."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from pam_cosim.measurement import DataSet, FreeParameter, Run, Signal
from rig.flow import P_ATM
from rig.tank import Vessel, orifice_port, simulate_vessel

Array = NDArray[np.float64]

UNITS = {"p": "Pa", "T": "K", "x": "m", "y": "1", "pressure": "Pa", "temperature": "K"}

DIAMETER, VOLUME, P_START, T_START = 2.71e-3, 16.2e-3, 690e3, 293.15
TRUE_C_D, TRUE_N = 0.84, 1.25
TIMES = np.linspace(0.0, 60.0, 61)


def data_set(
    model: str,
    runs: Sequence[Run],
    sigma: Mapping[str, float],
    fit: Sequence[FreeParameter] = (),
    parameters: Mapping[str, float] | None = None,
) -> DataSet:
    signals = {n: Signal(n, UNITS[n], s) for n, s in sigma.items()}
    return DataSet(
        Path("rig"),
        "a rig",
        model,
        signals,
        dict(parameters or {}),
        {f.name: f for f in fit},
        tuple(runs),
    )


def recording(
    time: Array,
    measurements: Mapping[str, Array],
    role: str = "fit",
    inputs: Mapping[str, Array] | None = None,
) -> Run:
    return Run(
        "run", Path("run.csv"), role, "linear", {}, time, dict(inputs or {}), dict(measurements)
    )  # type: ignore[arg-type]


def discharge(
    c_d: float = TRUE_C_D, n: float = TRUE_N, times: Array = TIMES
) -> tuple[Array, Array]:
    """Pressure [Pa gauge] and temperature [K] of the reference vessel that empties."""
    vessel = Vessel(VOLUME, n, P_START + P_ATM, T_START)
    trajectory = simulate_vessel(vessel, orifice_port(DIAMETER, c_d, 0.0), times, P_START)
    return trajectory.p, trajectory.temperature


C_D = FreeParameter("orifice.C_d", 0.5, 1.1, 0.7, "1")
N = FreeParameter("tank.n", 1.0, 1.4, 1.1, "1")
KNOWN = {"tank.V": VOLUME, "tank.p_start": P_START, "tank.T_start": T_START, "orifice.d": DIAMETER}


def vessel_data(
    seed: int | None = 0,
    sigma: float = 1000.0,
    fit: Sequence[FreeParameter] = (C_D, N),
    clean: Array | None = None,
    times: Array = TIMES,
) -> DataSet:
    """The discharge with noise on the pressure; ``seed`` None: without."""
    p = discharge(times=times)[0] if clean is None else clean
    if seed is not None:
        p = p + sigma * np.random.default_rng([seed, 3]).standard_normal(len(p))
    run = replace(recording(times, {"p": p}), parameters=dict(KNOWN))
    return data_set("PneumaticMuscle.Benches.VesselOrifice", [run], {"p": sigma}, fit, KNOWN)
