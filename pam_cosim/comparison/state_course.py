"""The states of a model along one run of the rig, from where its simulation begins."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import ArrayLike

from pam_cosim.arrays import Array
from pam_cosim.comparison.initial_state import initial_state
from pam_cosim.comparison.run_start import inputs_of_run, start_time
from pam_cosim.measurement import DataSet, Run
from pam_cosim.simulation import AnySimulator


def state_course(
    simulator: AnySimulator,
    data: DataSet,
    run: Run,
    parameters: Mapping[str, float],
    times: ArrayLike | None = None,
) -> dict[str, Array]:
    """(n + 1,) each [SI], by name: where the simulation begins, and at n times after that.

    Args:
        simulator: the model.
        data: the data set the run belongs to.
        run: a recording over time.
        parameters: values by name [SI], start values by "state@run" among them.
        times: (n,) [s]; default: those of the samples.

    Raises:
        SimulationFailure: the run did not reach its end.
    """
    own = data.parameters_of(run, parameters)
    start = initial_state(simulator, data, run, own)
    begins = start_time(run)
    course = simulator.run(
        np.append(begins, np.maximum(run.time if times is None else times, begins)),
        parameters={**own, **start.values},
        inputs=inputs_of_run(run),
        outputs=list(simulator.interface.states),
        start_time=begins,
        settle=start.settle,
    )
    return dict(course.values)
