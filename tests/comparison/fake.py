"""A model whose outputs are written down, for scores that can be computed by hand."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pam_cosim.measurement import DataSet, Run, Signal
from pam_cosim.model.interface import Interface, Variable
from pam_cosim.simulation import Inputs, Settle, Trajectory

Array = NDArray[np.float64]
Model = Callable[[Array, Mapping[str, float]], dict[str, Array]]

OUTPUTS = {"p": Variable("p", "Pa"), "x": Variable("x", "m")}


class FakeSimulator:
    """Stands where ``Simulator`` would; remembers how it was called."""

    def __init__(self, model: Model, outputs: Mapping[str, Variable] = OUTPUTS) -> None:
        self.model = model
        self.interface = Interface("Test.Fake", outputs=dict(outputs))
        self.calls: list[dict[str, object]] = []

    def run(
        self,
        times: Array,
        *,
        parameters: Mapping[str, float],
        inputs: Inputs | None,
        outputs: Sequence[str] | None,
        start_time: float,
        tolerance: float | None,
        settle: Settle = "none",
    ) -> Trajectory:
        self.calls.append(
            {"parameters": dict(parameters), "inputs": inputs, "start_time": start_time}
        )
        values = self.model(times, parameters)
        kept = list(values) if outputs is None else list(outputs)
        return Trajectory(times, {n: values[n] for n in kept}, {n: OUTPUTS[n].unit for n in kept})


def run(
    name: str,
    time: ArrayLike,
    role: str = "fit",
    inputs: Mapping[str, ArrayLike] | None = None,
    parameters: Mapping[str, float] | None = None,
    **measurements: ArrayLike,
) -> Run:
    """A recording of plain numbers [SI]."""
    return Run(
        name,
        Path(f"{name}.csv"),
        role,  # type: ignore[arg-type]
        "linear",
        dict(parameters or {}),
        np.asarray(time, dtype=float),
        {n: np.asarray(v, dtype=float) for n, v in (inputs or {}).items()},
        {n: np.asarray(v, dtype=float) for n, v in measurements.items()},
    )


def data_set(
    runs: Sequence[Run], signals: Mapping[str, float], fitted: Sequence[str] | None = None
) -> DataSet:
    """Signals by name with their noise [SI]."""
    named = {
        n: Signal(n, OUTPUTS[n].unit, s, fitted=fitted is None or n in fitted)
        for n, s in signals.items()
    }
    return DataSet(Path("rig"), "a rig", "Test.Fake", named, {}, {}, tuple(runs))
