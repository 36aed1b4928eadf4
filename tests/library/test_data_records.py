"""The records of ``Data`` hold what the papers' tables print, and the muscles take it from there."""

from __future__ import annotations

from math import degrees

import numpy as np
import pytest

from pam_cosim.fmu import build_source
from pam_cosim.resources import modelica_root
from pam_cosim.simulation import Simulator

SHARED = {
    "D0": 0.02, "d": 0.013, "L_z": 0.008, "L_y": 0.25, "turns": 2.0, "fibres": 216.0, "t_fibre": 0.254e-3,
    "mu_fb": 0.015, "mu_d": 0.8, "m": 2.27,
}  # fmt: skip
PRINTED: dict[str, dict[str, float]] = {
    "Latex": {**SHARED, "L0": 0.24, "t_wall": 0.254e-3, "k_wall": 0.14},  # DP Table 1
    "Butyl": {**SHARED, "L0": 0.23, "t_wall": 0.8e-3, "k_wall": 0.09},  # DP Table 2
    "AirMuscle": {"L0": 0.3, "D0": 0.01, "alpha_0": 23.0},  # AM, theoretical force equation 1
    "EmpiricalMuscle300": {"L0": 0.3},  # DY section 2
    "EmpiricalMuscle530": {"L0": 0.53},
    "DMSP10": {
        "L0": 0.25,
        "D0": 0.0136,
        "alpha_0": 28.6 - 0.1,
        "t_wall": 1.8e-3,
    },  # Martens and Boblan 2017
    "DMSP20": {"L0": 0.296, "D0": 0.0236, "alpha_0": 28.6 - 0.073, "t_wall": 1.8e-3},
    "DMSP40": {"L0": 0.4, "D0": 0.0472, "alpha_0": 28.6, "t_wall": 3.6e-3},
}
"""By record: lengths [m], angles [degrees], and so on; as printed, not as the library has them."""
BASES = {"MuscleData", "SleeveData", "EmpiricalMuscleData"}


def values(declared: str, names: list[str]) -> dict[str, float]:
    """What a component of some class has for its parameters."""
    outputs = " ".join(f"output Real y{i} = it.{name};" for i, name in enumerate(names))
    with Simulator(
        build_source("Pinned", f"model Pinned {declared} {outputs} end Pinned;", brief=True)
    ) as simulator:
        run = simulator.run(np.array([0.0, 1.0]))
    return {n: float(run.values[f"y{i}"][0]) for i, n in enumerate(names)}


def in_degrees(own: dict[str, float]) -> dict[str, float]:
    return {n: degrees(v) if n == "alpha_0" else v for n, v in own.items()}


def test_every_record_is_pinned() -> None:
    records = {
        file.stem
        for file in (modelica_root() / "PneumaticMuscle" / "Muscles" / "Data").glob("*.mo")
    }
    assert records - BASES - {"package"} == set(PRINTED)


@pytest.mark.parametrize("record", PRINTED)
def test_record_holds_what_is_printed(record: str) -> None:
    own = values(f"parameter PneumaticMuscle.Muscles.Data.{record} it;", list(PRINTED[record]))
    assert in_degrees(own) == pytest.approx(PRINTED[record], rel=1e-12)
