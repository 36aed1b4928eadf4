"""What the examples conclude from measurements of others, with the examples' own functions, without a diagnosis."""

from __future__ import annotations

import importlib.util
import sys
from dataclasses import replace
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"


def script(name: str) -> ModuleType:
    """The run.py of an example, which its main() alone starts."""
    spec = importlib.util.spec_from_file_location(
        f"example_{name.replace('-', '_')}", EXAMPLES / name / "run.py"
    )
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture(scope="module")
def robot() -> ModuleType:
    return script("jumping-robot")


@pytest.fixture(scope="module")
def chamber() -> ModuleType:
    return script("chamber-leak")


@pytest.fixture(scope="module")
def vessel() -> ModuleType:
    return script("tank-discharge")


def kilopascals(fit, role):  # type: ignore[no-untyped-def]
    return fit.comparison.scores[role]["p"].rmse / 1e3


@pytest.mark.full
def test_tube_dead_time_and_dead_volume_explain_most_of_the_jump(
    robot: ModuleType, tmp_path: Path
) -> None:
    bare, full = (robot.fitted(stage, tmp_path) for stage in (robot.STAGES[0], robot.FINAL))
    assert kilopascals(bare, "fit") > 80 and kilopascals(bare, "holdout") > 75
    assert kilopascals(full, "fit") < 8.5 and kilopascals(full, "holdout") < 9.5
    slenderness = 74 * 0.0254 / 0.004
    friction = (np.pi / 4 * 0.004**2 / full.parameters["line.A"].value) ** 2 / slenderness
    assert 0.018 < friction < 0.035  # Darcy, tube of 10 um roughness at Re = 4e4: 0.027
    assert 0.012 < full.parameters["valve.drive.dead_time"].value < 0.022


@pytest.mark.full
def test_droop_and_contraction_cannot_be_left_out(robot: ModuleType, tmp_path: Path) -> None:
    droop, held = (robot.fitted(replace(stage), tmp_path) for stage in robot.COUNTER[:2])
    assert kilopascals(droop, "holdout") > 15
    assert kilopascals(held, "holdout") > 14


def test_chamber_that_empties_itself_leaks_through_narrow_pores(
    chamber: ModuleType, tmp_path: Path
) -> None:
    folder = EXAMPLES / "chamber-leak" / "chambers" / "Ultimaker_020"
    laminar, orifice = (
        chamber.rms(chamber.fitted(folder, law, tmp_path)) for law in ("LaminarLeak", "OrificeLeak")
    )
    assert laminar < 1e3
    assert orifice > 15 * laminar


def test_tight_chamber_does_not_tell_the_laws_apart(chamber: ModuleType, tmp_path: Path) -> None:
    folder = EXAMPLES / "chamber-leak" / "chambers" / "Prusa"
    laminar, orifice = (
        chamber.rms(chamber.fitted(folder, law, tmp_path)) for law in ("LaminarLeak", "OrificeLeak")
    )
    assert orifice == pytest.approx(laminar, rel=0.02)


def test_friction_of_the_ring_grows_with_pressure(chamber: ModuleType) -> None:
    slope, base = chamber.friction.line(
        chamber.friction.read_strokes(EXAMPLES / "chamber-leak" / "friction.csv")
    )
    assert slope == pytest.approx(0.67, abs=0.02)
    assert base == pytest.approx(3.5, abs=0.1)


def test_discharge_predicts_the_filling(vessel: ModuleType, tmp_path: Path) -> None:
    """The energy balance, fitted to the pressure of the discharge, meets a filling that it has not seen."""
    old, new = (
        vessel.fitted("both-ways", effects, ("p",), tmp_path) for effects in ((), ("EnergyGas",))
    )
    assert kilopascals(old, "holdout") > 18
    assert kilopascals(new, "holdout") < 2.5
    c_d = new.parameters["orifice.C_d"]
    assert c_d.low <= 0.84 <= c_d.high


@pytest.mark.full
def test_nitrogen_is_cooled_and_warmed_by_free_convection(
    vessel: ModuleType, tmp_path: Path
) -> None:
    fit = vessel.fitted("nitrogen", ("FreeConvectionGas",), ("p", "T"), tmp_path)
    c, c_d = fit.parameters["tank.gas.c"], fit.parameters["orifice.C_d"]
    assert c.low <= 0.13 <= c.high and c.value == pytest.approx(0.13, abs=0.01)
    assert c_d.low <= 0.80 <= c_d.high
    assert fit.comparison.scores["fit"]["T"].rmse < 3.0
