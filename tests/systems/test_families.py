"""One effect is hidden in the independent rig's data: the diagnosis names its family, and its strength."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

import pytest

from pam_cosim import Diagnosis, study
from rig.named import UNLISTED, effect_of
from rig.short import write_light_data

_FILM = 2 / (1 / 20.0 - 0.254e-3 / 0.14)  # two films and the wall make 20 W/(m2 K)

# hidden effect: the same law in the catalogue with its parameter and true value
HIDDEN = {
    "elasticity:linear": ("LinearBladder", "k", 250.0),
    "dry_friction:coulomb": ("CoulombFriction", "F_c", 8.0),
    "valve_dynamics:lag": ("ValveLag", "tau", 0.08),
    "gas_energy:film": ("EnergyGas", "h", _FILM),
}


def but_first_in_full(cases: Iterable[Any]) -> list[Any]:
    """The first case at every change, the others in the full tier."""
    first, *others = cases
    return [first, *(pytest.param(case, marks=pytest.mark.full) for case in others)]


@pytest.mark.parametrize("hidden", but_first_in_full(HIDDEN))
def test_hidden_effect_is_found(tmp_path: Path, workers: int | None, hidden: str) -> None:
    family = hidden.partition(":")[0]
    data = study.read(write_light_data(tmp_path / "d", [effect_of(hidden)], seed=1))
    diagnosis = study.diagnose(data, explain=False, workers=workers)
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
        explain=False,
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


@pytest.mark.parametrize("seed", but_first_in_full(range(3)))
def test_muscle_that_lacks_nothing(tmp_path: Path, workers: int | None, seed: int) -> None:
    _nothing(
        study.diagnose(
            study.read(write_light_data(tmp_path / "d", seed=seed)), explain=False, workers=workers
        )
    )


def _nothing(diagnosis: Diagnosis) -> None:
    assert diagnosis.verdict.kind == "none_missing", diagnosis.verdict
    assert (diagnosis.verdict.families, diagnosis.path, diagnosis.next_experiment) == ((), (), None)
    assert diagnosis.final is diagnosis.base
