"""Start values that were estimated, with what is known of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from pam_cosim.comparison import RunComparison, simulate_run
from pam_cosim.fitting.estimate import Estimate
from pam_cosim.fitting.objective import Objective
from pam_cosim.measurement import DataSet, Run
from pam_cosim.measurement.free_parameter import INTERVAL
from pam_cosim.model.interface import Interface
from pam_cosim.simulation import AnySimulator


def start_estimates(objective: Objective) -> dict[str, Estimate]:
    """Estimated start values of the runs of an objective with 95 % intervals, by "state@run"."""
    variables = objective.simulator.interface.start_values
    estimates = {}
    for start in objective.starts.by_run.values():
        if not len(start.slopes):  # its run could not be simulated
            continue
        reach = (INTERVAL * start.deviations()).tolist()
        values, determined = start.values.tolist(), start.determined().tolist()
        still = [(name, value, 0.0, False) for name, value in start.still.items()]
        for name, value, half, is_told in [
            *still, *zip(start.names, values, reach, determined, strict=True)
        ]:  # fmt: skip
            estimates[f"{name}@{start.run.name}"] = Estimate(
                value,
                value - half,
                value + half,
                variables[name].unit,
                determined=is_told,
                run=start.run.name,
            )
    return estimates


def estimated_starts(
    simulator: AnySimulator,
    data: DataSet,
    runs: Sequence[Run],
    values: Mapping[str, float],
    tolerance: float | None = None,
    second_look: bool = True,
    state_ranges: Mapping[str, float] | None = None,
) -> dict[str, Estimate]:
    """Estimates the start values of the runs whose start is to be estimated, by "state@run" [SI].

    Args:
        simulator: of the model.
        data: the data set.
        runs: those with another start are skipped.
        values: parameters [SI]; start values among them are the initial guesses.
        tolerance: of the solver, relative; None: the default.
        second_look: above the noise, the search starts again with the first samples of each run.
        state_ranges: ranges of states in other runs [SI], for the priors.

    Returns:
        the estimates; empty if the runs cannot be simulated.
    """
    chosen = [run for run in runs if run.start.mode == "estimated"]
    if not chosen:
        return {}
    objective = Objective(simulator, data, chosen, (), values, tolerance)
    objective.starts.state_ranges = state_ranges or {}
    no_parameters = np.zeros(0)
    if second_look and not objective.is_at_noise(objective.squares(no_parameters)):
        objective.found_other_starts(no_parameters)
    objective.residuals(no_parameters)
    return start_estimates(objective)


def runs_without_start(
    data: DataSet, values: Mapping[str, float], interface: Interface
) -> list[Run]:
    """The runs without given start values: a start value is named "state@run"."""
    runs_with_start = {
        name.rpartition("@")[2] for name in values if name.rpartition("@")[0] in interface.states
    }
    return [run for run in data.runs if run.name not in runs_with_start]


def simulated(
    simulator: AnySimulator,
    data: DataSet,
    values: Mapping[str, float],
    runs: Sequence[Run] | None = None,
) -> tuple[tuple[RunComparison, ...], dict[str, Estimate]]:
    """Runs (default: all) compared with their samples at given parameters [SI], and the estimated starts.

    Raises:
        SimulationFailure: a run did not reach its end.
    """
    chosen = data.runs if runs is None else runs
    free = {run.name for run in runs_without_start(data, values, simulator.interface)}
    starts = estimated_starts(simulator, data, [run for run in chosen if run.name in free], values)
    values_with_starts = {**values, **{name: e.value for name, e in starts.items()}}
    return tuple(simulate_run(simulator, data, run, values_with_starts) for run in chosen), starts
