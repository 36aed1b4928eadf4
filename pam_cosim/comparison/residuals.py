"""One run of a model compared with one run of the rig."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.measurement import DataSet, Run
from pam_cosim.simulation import AnySimulator
from pam_cosim.starts import initial_state
from pam_cosim.wording import distinct_warnings


@dataclass(frozen=True)
class RunComparison:
    """Measured and modelled signals of one run at the times of the samples.

    Attributes:
        run: the measurement.
        model: (n,) each [SI], every output of the model at ``run.time``.
        solver: as ``Trajectory.solver``.
        warnings: as ``Trajectory.warnings``.
    """

    run: Run
    model: dict[str, Array]
    solver: str = ""
    warnings: tuple[str, ...] = ()

    def residual(self, signal: str) -> Array:
        """Measured minus modelled [SI], shape (n,), NaN where a sample is missing."""
        return self.run.measurements[signal] - self.model[signal]

    def at_samples(self, signal: str) -> tuple[NDArray[np.bool_], Array, Array]:
        """(n,) which samples of a signal there are, and the residuals and readings of these [SI]."""
        readings = self.run.measurements[signal]
        is_measured = np.isfinite(readings)
        return is_measured, self.residual(signal)[is_measured], readings[is_measured]


def warnings_of(runs: Iterable[RunComparison]) -> tuple[str, ...]:
    """The distinct warnings of the model, each with its runs."""
    return distinct_warnings({r.run.name: r.warnings for r in runs})


def simulate_runs(
    simulator: AnySimulator, data: DataSet, values: Mapping[str, float]
) -> list[RunComparison]:
    """Every run of a data set, as ``simulate_run``; start values of runs that it lacks are left out of ``values``."""
    names = {run.name for run in data.runs}
    values_of_runs = {
        n: v for n, v in values.items() if "@" not in n or n.partition("@")[2] in names
    }
    return [simulate_run(simulator, data, run, values_of_runs) for run in data.runs]


def simulate_run(
    simulator: AnySimulator,
    data: DataSet,
    run: Run,
    parameters: Mapping[str, float],
    tolerance: float | None = None,
    signals: Sequence[str] | None = None,
) -> RunComparison:
    """Drives the model with the inputs of ``run``, or takes it to rest under each row of them.

    Args:
        simulator: the model.
        data: the data set the run belongs to.
        run: inputs, known parameters and sample times.
        parameters: fitted values [SI]; what is known of the run overrules them.
        tolerance: of the solver.
        signals: outputs to keep; default all.

    Raises:
        SimulationFailure: the run did not reach its end.
        InputError: a parameter that the model does not have.
    """
    run_parameters = data.parameters_of(run, parameters)
    outputs = list(simulator.interface.outputs) if signals is None else signals
    if run.is_static:
        points = simulator.equilibria(run.inputs, parameters=run_parameters, outputs=outputs)
        return RunComparison(run, dict(points.values), warnings=points.warnings)
    start = initial_state(simulator, data, run, run_parameters)
    trajectory = start.trajectory(simulator, run, run_parameters, run.time, outputs, tolerance)
    return RunComparison(run, dict(trajectory.values), trajectory.solver, trajectory.warnings)
