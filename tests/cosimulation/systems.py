"""Coupled systems whose solution is known."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import pam_cosim as pam
from pam_cosim.cosimulation import CoupledRun, System
from pam_cosim.simulation import Simulator

CUT = ["gas.p -> muscle.p", "muscle.V -> gas.V", "muscle.V_flow -> gas.V_flow", "muscle.A -> gas.A"]
CONTROL = ["muscle.x -> control.x", "control.u_in -> gas.u_in", "control.u_out -> gas.u_out"]


def halves(**parameters: Any) -> System:
    """The isotonic bench in two FMUs."""
    parts = {"gas": "CoSimulation.ValveAndGas", "muscle": "CoSimulation.MuscleAndLoad"}
    return pam.couple(
        parts, CUT, {name.replace("__", "."): value for name, value in parameters.items()}
    )


def thirds() -> System:
    """The same with its controller as a third FMU."""
    parts = {
        "gas": "CoSimulation.ValveAndGas",
        "muscle": "CoSimulation.MuscleAndLoad",
        "control": "CoSimulation.ContractionController",
    }
    return pam.couple(parts, [*CUT, *CONTROL])


def error(run: CoupledRun, signal: str, monolith: str, name: str) -> float:
    """Largest difference of a signal [SI] from the model in one piece, at the communication points."""
    time = run.trajectory.time
    with Simulator(pam.build(monolith)) as simulator:
        exact = simulator.run(time, tolerance=1e-10)[name]
    return float(np.max(np.abs(run.trajectory[signal] - exact)))


def written(folder: Path, name: str, body: str) -> str:
    """A Modelica model with this text in it, as a file."""
    file = folder / f"{name}.mo"
    file.write_text(f'model {name} "Model for a test"\n{body}\nend {name};\n')
    return str(file)


def gain(folder: Path, name: str, factor: float, offset: float = 0.0) -> str:
    """y = factor u + offset, at once."""
    return written(
        folder,
        name,
        f'input Real u "In";\noutput Real y "Out";\nequation\ny = {factor}*u + ({offset});',
    )
