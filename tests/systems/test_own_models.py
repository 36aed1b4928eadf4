"""A user's own effect and own bench, each a Modelica file outside the library; and errors that no effect explains."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest

from pam_cosim import study
from pam_cosim.measurement import DataSet, FreeParameter
from rig.effect import Effect
from rig.flow import P_ATM
from rig.named import effect_of
from rig.tank import Vessel, orifice_port, simulate_vessel
from tests.fitting.models import (
    C_D,
    DIAMETER,
    KNOWN,
    P_START,
    T_START,
    TRUE_C_D,
    TRUE_N,
    VOLUME,
    N,
    data_set,
    discharge,
    recording,
    vessel_data,
)

HERE = Path(__file__).parent
TIMES = np.linspace(0.0, 60.0, 201)


@dataclass(frozen=True)
class Crack(Effect):
    """Flow to ambient in proportion to the square of the gauge pressure."""

    family = "leak"
    form = "crack"
    k: float = 3e-15  # kg/(s Pa2)

    def leak(self, p: float, temperature: float) -> float:
        return self.k * (p - P_ATM) * max(0.0, p - P_ATM)


def _emptied(effect: Effect, seed: int, n: float = TRUE_N) -> dict[str, np.ndarray]:
    rng = np.random.default_rng([seed, 4])
    vessel = Vessel(VOLUME, n, P_START + P_ATM, T_START)
    simulated = simulate_vessel(
        vessel, orifice_port(DIAMETER, TRUE_C_D, 0.0), TIMES, P_START, effects=[effect]
    )
    return {
        "p": simulated.p + 1000.0 * rng.standard_normal(len(TIMES)),
        "T": simulated.temperature + 0.3 * rng.standard_normal(len(TIMES)),
    }


def _cracked() -> DataSet:
    run = replace(recording(TIMES, _emptied(Crack(), 0)), parameters=dict(KNOWN))
    return data_set(
        "PneumaticMuscle.Benches.VesselOrifice", [run], {"p": 1000.0, "T": 0.3}, (C_D, N), KNOWN
    )


@pytest.mark.full
def test_own_effect_is_found_when_its_file_is_named(workers: int | None) -> None:
    diagnosis = study.diagnose(
        _cracked(), files=[HERE / "BurstLeak.mo"], explain=False, workers=workers
    )
    assert diagnosis.verdict.kind == "identified", diagnosis.verdict
    assert (diagnosis.verdict.families, diagnosis.verdict.effects) == (
        ("burst_leak",),
        ("BurstLeak",),
    )
    (estimate,) = diagnosis.path[0].parameters.values()
    assert estimate.low <= 3e-15 <= estimate.high and estimate.unit == "kg/(s.Pa2)"
    c_d = diagnosis.final.parameters["orifice.C_d"]
    assert c_d.low <= TRUE_C_D <= c_d.high


@pytest.mark.full
def test_own_bench(workers: int | None) -> None:
    measured = _emptied(effect_of("gas_energy:film:h=12"), 1)
    run = recording(TIMES, {"pressure": measured["p"], "temperature": measured["T"]})
    fit = (FreeParameter("hole.C_d", 0.5, 1.1), FreeParameter("bottle.n", 1.0, 1.4))
    data = data_set(
        str(HERE / "Reservoir.mo"), [run], {"pressure": 1000.0, "temperature": 0.3}, fit
    )
    diagnosis = study.diagnose(data, explain=False, workers=workers)
    assert diagnosis.verdict.kind == "identified", diagnosis.verdict
    assert diagnosis.verdict.families == ("gas_energy",)
    assert diagnosis.final.comparison.chi2_reduced("fit") == pytest.approx(1.0, abs=0.15)
    c_d = diagnosis.final.parameters["hole.C_d"]
    assert c_d.low <= TRUE_C_D <= c_d.high
    assert {"bottle.gas.h", "hole.C_d"} <= set(diagnosis.final.parameters)


@pytest.mark.full
def test_error_that_no_effect_explains_is_unknown(workers: int | None) -> None:
    """A compressor nearby makes the pressure gauge swing by 4 kPa every 7 s."""
    swing = 4e3 * np.sin(2 * np.pi * TIMES / 7)
    data = vessel_data(seed=2, clean=discharge(times=TIMES)[0] + swing, times=TIMES)
    diagnosis = study.diagnose(data, workers=workers)
    assert diagnosis.verdict.kind == "unknown", diagnosis.verdict
    term = diagnosis.missing_term
    assert term is not None and term.balance in ("mass", "energy", "sensor")
    # what is left is the swing, 4/sqrt(2) kPa, and the noise of 1 kPa
    assert term.signals["p"].rmse == pytest.approx(np.hypot(4e3 / np.sqrt(2), 1e3), rel=0.1)
    assert term.signals["p"].noise_standard_deviations == pytest.approx(3.0, rel=0.1)
    assert diagnosis.next_experiment is None
