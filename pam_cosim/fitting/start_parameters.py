"""Whether parameters determine where a run begins, so that its start values need no estimate."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping

import numpy as np

from pam_cosim.comparison.start_probe import STEP, StartProbe
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement import FreeParameter

_SAME_SLOPE = 1e-6  # difference of slopes, up to which a state is what a parameter sets


def start_is_stated(
    probe: StartProbe, shown: Collection[str], parameters: Mapping[str, float]
) -> bool:
    """Whether stated parameters are the start values of all these states, as ``tank.p_start``.

    Such a parameter has the unit of its state, which begins higher by as much as the parameter is raised.

    Args:
        probe: of the run.
        shown: states that the run's signals show.
        parameters: of the run [SI].

    Raises:
        SimulationFailure: the model breaks down at the start.
    """
    interface = probe.simulator.interface
    states = probe.at({})[1]
    left = set(shown)
    for name in probe.run.parameters.keys() & interface.parameters.keys():
        parameter, value = interface.parameters[name], parameters[name]
        step = STEP * max(abs(value), abs(parameter.nominal or 0.0), 1.0)
        slopes = (probe.changed({name: value + step}).at({})[1] - states) / step
        follows = np.abs(slopes - 1.0) < _SAME_SLOPE
        following = {interface.states[i] for i in np.flatnonzero(follows)}
        left -= {s for s in following if interface.start_values[s].unit == parameter.unit}
    return not left


def start_is_fitted(probe: StartProbe, free: Iterable[FreeParameter]) -> bool:
    """Whether one of the free parameters determines where the run begins.

    Raises:
        SimulationFailure: the model breaks down at the start.
    """
    return any(_moves_start(probe, one) for one in free if not one.run or one.run == probe.run.name)


def _moves_start(probe: StartProbe, free: FreeParameter) -> bool:
    low, high = (probe.changed({free.parameter: v}).at({})[1] for v in (free.min, free.max))
    size = np.maximum(np.maximum(np.abs(low), np.abs(high)), 1.0)
    largest = float(np.max(np.abs(high - low) / size, initial=0.0))
    return largest > CRITERIA.starts.own_parameter
