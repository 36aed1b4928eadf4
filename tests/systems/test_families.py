"""One effect is hidden in the independent rig's data: the diagnosis names its family, and its strength."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from pam_cosim import Diagnosis, study
from pam_cosim.measurement import DataSet, FreeParameter
from rig.named import UNLISTED, effect_of
from rig.schedule import Phase, Schedule
from rig.short import write_light_data
from rig.tank import Vessel, simulate_vessel, valve_ports
from tests.fitting.models import data_set, recording

_FILM = 2 / (1 / 20.0 - 0.254e-3 / 0.14)  # two films and the wall make 20 W/(m2 K)

# hidden effect: its family, the same law in the catalogue with its parameter and true value
HIDDEN = {
    "elasticity:linear": ("LinearBladder", "k", 250.0),
    "dry_friction:coulomb": ("CoulombFriction", "F_c", 8.0),
    "rate_friction:viscous": ("ViscousFriction", "c", 300.0),
    "leak:orifice": ("OrificeLeak", "A", 0.7 * pi / 4 * 0.1e-3**2),
    "valve_dynamics:lag": ("ValveLag", "tau", 0.08),
    "gas_energy:film": ("EnergyGas", "h", _FILM),
    "thermocouple_lag:first_order": ("ThermocoupleLag", "tau", 0.15),
}


def but_first_in_full(cases: Iterable[Any]) -> list[Any]:
    """The first case at every change, the others in the full tier."""
    first, *others = cases
    return [first, *(pytest.param(case, marks=pytest.mark.full) for case in others)]


@pytest.mark.parametrize("hidden", but_first_in_full(HIDDEN))
def test_hidden_effect_is_found(tmp_path: Path, workers: int | None, hidden: str) -> None:
    family = hidden.partition(":")[0]
    data = study.read(write_light_data(tmp_path / "d", [effect_of(hidden)], seed=1))
    diagnosis = study.diagnose(data, workers=workers)
    assert diagnosis.verdict.kind == "identified", diagnosis.verdict
    assert diagnosis.verdict.families == (family,)
    assert diagnosis.candidates[0].family == family
    fit, holdout = (diagnosis.final.comparison.chi2_reduced(role) for role in ("fit", "holdout"))
    assert 0.9 < holdout < 1.2 and 0.85 < fit < 1.15
    assert diagnosis.base.comparison.chi2_reduced("holdout") > 2
    law, parameter, true = HIDDEN[hidden]
    (same,) = [c for c in diagnosis.candidates if c.effects == (law,)]
    (estimate,) = [e for name, e in same.parameters.items() if name.rpartition(".")[2] == parameter]
    assert estimate.low <= true <= estimate.high, (parameter, str(estimate))
    assert estimate.high - estimate.low < 0.1 * true
    assert sum(diagnosis.balance.values()) == pytest.approx(1.0)


@pytest.mark.full
def test_family_is_found_where_its_form_is_not_listed(tmp_path: Path, workers: int | None) -> None:
    diagnosis = study.diagnose(
        study.read(write_light_data(tmp_path / "d", [UNLISTED["inlet_jet"]], seed=1)),
        workers=workers,
    )
    assert (diagnosis.verdict.kind, diagnosis.verdict.families) == (
        "identified",
        ("gas_energy",),
    ), diagnosis.verdict
    assert diagnosis.path[-1].general and "Only the family (" in diagnosis.verdict.reason
    assert diagnosis.base.comparison.chi2_reduced("holdout") > 100
    assert 0.9 < diagnosis.final.comparison.chi2_reduced("holdout") < 1.1
    held = [e for e in diagnosis.path[-1].parameters.values() if e.value == 0]
    assert held and not any(e.determined for e in held)


@pytest.mark.full
def test_family_is_found_where_a_law_of_another_form_comes_near(
    tmp_path: Path, workers: int | None
) -> None:
    """A lip that pressure presses shut: what a seal's law leaves of it passes as noise beside the general member."""
    diagnosis = study.diagnose(
        study.read(write_light_data(tmp_path / "d", [UNLISTED["pressed_lip"]], seed=1)),
        workers=workers,
        explain=False,
    )
    assert (diagnosis.verdict.kind, diagnosis.verdict.families) == ("identified", ("leak",)), (
        diagnosis.verdict
    )
    assert diagnosis.base.comparison.chi2_reduced("holdout") > 100
    assert diagnosis.final.comparison.chi2_reduced("holdout") < 1.3


@pytest.mark.parametrize("seed", but_first_in_full(range(3)))
def test_muscle_that_lacks_nothing(tmp_path: Path, workers: int | None, seed: int) -> None:
    _nothing(
        study.diagnose(study.read(write_light_data(tmp_path / "d", seed=seed)), workers=workers)
    )


@pytest.mark.full
@pytest.mark.parametrize("seed", range(3, 10))
def test_tank_that_lacks_nothing(tmp_path: Path, workers: int | None, seed: int) -> None:
    _nothing(study.diagnose(_tank(seed), workers=workers))


def _nothing(diagnosis: Diagnosis) -> None:
    assert diagnosis.verdict.kind == "none_missing", diagnosis.verdict
    assert (diagnosis.verdict.families, diagnosis.path, diagnosis.next_experiment) == ((), (), None)
    assert diagnosis.final is diagnosis.base


def _tank(seed: int) -> DataSet:
    """The 0.35 L tank, filled, held and emptied in parts; a second run from another supply to judge."""
    times = np.arange(201) / 20
    rng = np.random.default_rng([seed, 9])
    runs = []
    for role, supply in (("fit", 207e3), ("holdout", 138e3)):
        schedule = Schedule.of(
            [
                Phase(2.5, u_in=0.35),
                Phase(1.5),
                Phase(2.0, u_in=0.3),
                Phase(1.5),
                Phase(2.5, u_out=0.3),
            ]
        )
        simulated = simulate_vessel(
            Vessel(0.35e-3), valve_ports(supply, 0.72), times, schedule=schedule
        )
        currents = np.array([schedule.at(t) for t in times.tolist()])
        inputs = {
            "u_in": currents[:, 0],
            "u_out": currents[:, 1],
            "p_supply": np.full(len(times), supply),
        }
        noisy = {
            "p": simulated.p + 500.0 * rng.standard_normal(len(times)),
            "T": simulated.temperature + 0.3 * rng.standard_normal(len(times)),
        }
        run = recording(times, noisy, role, inputs)
        runs.append(replace(run, interpolation="previous", parameters={"tank.V": 0.35e-3}))
    fit = [FreeParameter("valve.C_A", 0.5, 0.9), FreeParameter("tank.n", 1.0, 1.4)]
    return data_set(
        "PneumaticMuscle.Benches.TankFilling",
        runs,
        {"p": 500.0, "T": 0.3},
        fit,
        {"tank.V": 0.35e-3},
    )
