"""Rigs put together from parts, built and driven for tests."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from tempfile import mkdtemp

import numpy as np

from pam_cosim.catalogue import ComposedBench, compose_bench, rig_parts
from pam_cosim.fmu import build_source
from pam_cosim.simulation import Inputs, Simulator, Trajectory
from tests.library.catalogue import tree


@cache
def choices(role: str) -> tuple[str, ...]:
    return tuple(part.name for part in rig_parts(tree()) if part.role == role)


@cache
def rig(
    pneumatics: str, mechanics: str, muscle: str | None = None, measure: str | None = None
) -> ComposedBench:
    return compose_bench(tree(), pneumatics, mechanics, muscle, measure)


@cache
def written(of: ComposedBench) -> Path:
    """The file of a rig."""
    file = Path(mkdtemp()) / f"{of.name}.mo"
    file.write_text(of.text)
    return file


def run(
    of: ComposedBench,
    times: np.ndarray,
    parameters: dict[str, float] | None = None,
    inputs: Inputs | None = None,
    outputs: list[str] | None = None,
    tolerance: float | None = None,
) -> Trajectory:
    with Simulator(build_source(of.name, of.text, brief=True)) as simulator:
        kept = [*simulator.interface.outputs, *(outputs or [])]
        options = {} if tolerance is None else {"tolerance": tolerance}
        return simulator.run(
            times,
            parameters=parameters or {},
            inputs=inputs,
            outputs=kept,
            max_seconds=30,
            **options,
        )


def held(end: float, **values: float) -> Inputs:
    """Inputs that do not change."""
    return Inputs(
        np.array([0.0, end]), {name: np.full(2, value) for name, value in values.items()}, "linear"
    )
