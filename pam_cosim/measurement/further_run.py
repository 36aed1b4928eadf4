"""A run that was not made yet, as one of a data set."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.measurement.data_set import DataSet, Run
from pam_cosim.measurement.start import Start, StartMode
from pam_cosim.simulation.inputs import Inputs


def further_run(
    data: DataSet,
    time: Array,
    inputs: Mapping[str, Array],
    parameters: Mapping[str, float],
    name: str = "planned run",
) -> Run:
    """A run without measurements; it begins as the model does by itself, or steady where the first run does.

    Args:
        data: what was measured; what the first run states of parameters holds, but for those that are given.
        time: (n,) [s], a step at two rows of one time.
        inputs: (n,) each [SI], joined by lines.
        parameters: what is set before the run [SI].
        name: of the run.
    """
    template = next(run for run in data.runs if not run.is_static)
    mode: StartMode = "steady" if template.start.mode == "steady" else "rest"
    return replace(
        template,
        name=name,
        role="fit",
        interpolation="linear",
        parameters={**template.parameters, **parameters},
        time=time,
        inputs=dict(inputs),
        measurements={name: np.full(len(time), np.nan) for name in data.signals},
        averaged={},
        notes=(),
        start=Start(mode=mode),
        recorded=None,
    )


def rows_of(inputs: Inputs, time: Array) -> tuple[Array, dict[str, Array]]:
    """Inputs at further times as well, joined by lines: (n,) times [s] and values; a step is two rows at one time.

    Args:
        inputs: over time, joined by lines or held.
        time: (m,) at which there are to be rows, not decreasing [s]; after the last of them there are none.
    """
    at, values = inputs.time, dict(inputs.values)
    if inputs.interpolation == "previous":
        steps = np.flatnonzero(np.any([np.diff(v) != 0 for v in values.values()], axis=0)) + 1
        before = {name: np.insert(v, steps, v[steps - 1]) for name, v in values.items()}
        at, values = np.insert(at, steps, at[steps]), before
    extra_times = time[~np.isin(time, at)]
    places = np.searchsorted(at, extra_times)
    rows = np.insert(at, places, extra_times)
    columns = {
        name: np.insert(v, places, np.interp(extra_times, at, v)) for name, v in values.items()
    }
    within = rows <= time[-1]
    return rows[within], {name: v[within] for name, v in columns.items()}
