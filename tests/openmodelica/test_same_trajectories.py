"""Another compiler's answers: OpenModelica's trajectories of the library's classes and effects (README.md)."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest

from pam_cosim.fmu import build_model
from pam_cosim.simulation import Simulator
from tests.library.catalogue import BENCH, built

HERE = Path(__file__).parent
CLASSES = sorted(p.stem for p in (HERE / "classes").glob("*.csv"))
EFFECTS = sorted(p.stem for p in (HERE / "isotonic-with-effect").glob("*.csv"))

# Of the range of a signal, in tolerances of the reference, which bound the error of one step: what hundreds of steps
# may add up to. The largest differences are 260 (classes) and 88 (effects).
ADDED_UP = 500
OURS = 1e-9


def differences(
    fmu: Path, file: Path, parameters: Mapping[str, float] | None = None
) -> dict[str, float]:
    """The largest difference of each output, of its range over the run."""
    names = file.read_text().split("\n", 1)[0].split(",")
    time, *columns = np.loadtxt(file, delimiter=",", skiprows=1).T
    with Simulator(fmu) as simulator:
        assert set(simulator.interface.outputs) == set(names[1:])
        run = simulator.run(time, parameters=parameters, tolerance=OURS)
    return {
        name: float(np.abs(run[name] - theirs).max() / (np.ptp(theirs) or np.abs(theirs).max()))
        for name, theirs in zip(names[1:], columns, strict=True)
    }


def test_nothing_is_left_out() -> None:
    assert (len(CLASSES), len(EFFECTS), len(RESTING)) == (38, 78, 6)


@pytest.mark.parametrize("name", CLASSES)
def test_class(name: str) -> None:
    apart = differences(
        build_model(f"PneumaticMuscle.{name}", brief=True), HERE / "classes" / f"{name}.csv"
    )
    assert max(apart.values()) < ADDED_UP * 1e-9, apart


@pytest.mark.parametrize("effect", EFFECTS)
def test_effect(effect: str) -> None:
    apart = differences(built(BENCH, effect), HERE / "isotonic-with-effect" / f"{effect}.csv")
    assert max(apart.values()) < ADDED_UP * 1e-8, apart


STARTED = sorted(p.stem for p in (HERE / "started").glob("*.csv"))


@pytest.mark.parametrize("name", STARTED)
def test_start_values_in_modelica(name: str) -> None:
    """Fixed starts, and the initial equations of effects, which lean on them and on the inputs."""
    fmu = build_model(f"Started.{name}", files=[HERE / "started" / "Started.mo"], brief=True)
    apart = differences(fmu, HERE / "started" / f"{name}.csv")
    assert max(apart.values()) < ADDED_UP * 1e-9, apart


def test_start_values_of_an_fmu() -> None:
    """What another compiler makes of start values in a model is what the bench's FMU makes of those that are set."""
    values = {"muscle.gas.p": 219325.0, "load.s": 0.031, "load.v": 0.02, "u_in": 0.3}
    apart = differences(build_model(BENCH), HERE / "started" / "Muscle.csv", values)
    assert max(apart.values()) < ADDED_UP * 1e-9, apart


RESTING = sorted(p.stem for p in (HERE / "resting").glob("*.csv"))


@pytest.mark.parametrize("name", RESTING)
def test_where_models_begin_at_rest(name: str) -> None:
    """All states and outputs of what begins at rest under open valves, from the same guess."""
    fmu = build_model(f"Resting.{name}", files=[HERE / "resting" / "Resting.mo"], brief=True)
    header, values = (HERE / "resting" / f"{name}.csv").read_text().split()
    theirs = dict(zip(header.split(","), map(float, values.split(",")), strict=True))
    with Simulator(fmu) as simulator:
        assert set(theirs) == {*simulator.interface.states, *simulator.interface.outputs}
        ours = simulator.run([0.0], outputs=list(theirs))
    for variable, value in theirs.items():
        assert ours[variable][0] == pytest.approx(value, rel=1e-9, abs=1e-12), variable
