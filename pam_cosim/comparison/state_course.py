"""The states of a model along one run of the rig, from where its simulation begins."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison.beginning import beginning, inputs_of_run, start_time
from pam_cosim.measurement import DataSet, Run
from pam_cosim.simulation import AnySimulator


def state_course(simulator: AnySimulator, data: DataSet, run: Run, parameters: Mapping[str, float]) -> dict[str, Array]:
    """(n + 1,) each [SI], by name: where the simulation begins, and from there on at the times of the samples.

    Args:
        simulator: the model.
        data: the data set the run belongs to.
        run: a recording over time.
        parameters: values by name [SI], start values by "state@run" among them.

    Raises:
        SimulationFailure: the run did not reach its end.
    """
    own = data.parameters_of(run, parameters)
    start = beginning(simulator, data, run, own)
    begins = start_time(run)
    course = simulator.run(
        np.append(begins, np.maximum(run.time, begins)),
        parameters={**own, **start.values},
        inputs=inputs_of_run(run),
        outputs=list(simulator.interface.states),
        start_time=begins,
        settle=start.settle,
    )
    return dict(course.values)
