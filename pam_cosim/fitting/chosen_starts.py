"""Chooses the starts of runs that state none, with the free parameters where first samples do not decide."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting.free import base_parameters
from pam_cosim.fitting.linear import bounded_step, linearised, reduction_by, rows_of_series
from pam_cosim.fitting.objective import Objective
from pam_cosim.measurement import DataSet, Run, StartMode
from pam_cosim.simulation import AnySimulator
from pam_cosim.starts import StartChoice, starts_are_open


def with_starts(
    simulator: AnySimulator, data: DataSet, parameters: Mapping[str, float] | None = None
) -> DataSet:
    """The same where every run states how it begins.

    Args:
        simulator: the model.
        data: the measurement with its noise.
        parameters: values to simulate with [SI].

    Raises:
        InputError: a parameter that the model does not have.
    """
    if not starts_are_open(data):
        return data
    stated = parameters or {}

    def estimate_pays(runs: Sequence[Run]) -> bool:
        """Either with the free parameters, to first order: these have not been fitted yet."""
        try:
            resting, estimated = (
                _remaining_squares(simulator, data, runs, mode, stated)
                for mode in ("rest", "estimated")
            )
        except SimulationFailure:
            return False
        return resting > CRITERIA.starts.worth * estimated

    return StartChoice(simulator, data, stated, estimate_pays).completed()


def _remaining_squares(
    simulator: AnySimulator,
    data: DataSet,
    runs: Sequence[Run],
    mode: StartMode,
    stated: Mapping[str, float],
) -> float:
    """What the free parameters leave within their bounds, and an offset of each signal where runs begin at rest."""
    begun = [replace(run, start=replace(run.start, mode=mode)) for run in runs]
    declared = base_parameters(data, simulator.interface)
    free = [state for state in declared if state.name not in stated]
    objective = Objective(simulator, data, begun, free, stated)
    z = np.array([state.to_z(state.start) for state in free])
    linear = linearised(objective, z, _every_row(objective))
    if linear is None:
        raise SimulationFailure(objective.first_failure)
    if mode == "rest":
        offsets = _offset_slopes(objective)
        count = offsets.shape[1]
        linear = replace(
            linear,
            names=(*linear.names, *(f"offset {i}" for i in range(count))),
            values=np.append(linear.values, np.zeros(count)),
            low=np.append(linear.low, np.full(count, -np.inf)),
            high=np.append(linear.high, np.full(count, np.inf)),
            slopes=np.column_stack([linear.slopes, offsets]),
        )
    return float(linear.residual @ linear.residual) - reduction_by(linear, bounded_step(linear))


def _every_row(objective: Objective) -> int:
    """A row for each sample, also for those that are missing."""
    return sum(map(len, objective.kept))


def _offset_slopes(objective: Objective) -> Array:
    """(m, signals) ones at the samples of each signal: an offset that is the same in all runs."""
    signals = np.array([signal for _, signal in objective.series])[
        rows_of_series(objective, _every_row(objective))
    ]
    is_present = np.concatenate(objective.kept)
    return np.asarray((signals[:, None] == np.unique(signals)) & is_present[:, None], dtype=float)
