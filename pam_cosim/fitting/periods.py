"""Periodic runs: the number of periods that are simulated before the first sample."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from pam_cosim.comparison.initial_state import initial_state
from pam_cosim.comparison.run_start import inputs_of_run, start_time
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement import DataSet, Run
from pam_cosim.simulation import AnySimulator
from pam_cosim.units import format_quantity


def with_periods(
    simulator: AnySimulator, data: DataSet, run: Run, parameters: Mapping[str, float]
) -> Run:
    """A periodic run with so many periods before it that one more would change no measured signal.

    Raises:
        SimulationFailure: the run does not reach its end.
    """
    most = CRITERIA.starts.periods
    fitted = {n: s.sigma for n, s in data.signals.items() if s.fitted and run.sample_count(n)}
    longest = replace(run, start=replace(run.start, periods=most))
    begin = initial_state(simulator, data, longest, parameters)
    first = start_time(longest)
    period = (float(run.time[0]) - first) / most
    course = simulator.run(
        first + period * np.arange(most + 1),
        parameters={**parameters, **begin.values},
        inputs=inputs_of_run(longest),
        outputs=list(fitted),
        start_time=first,
        settle=begin.settle,
    )
    from_last = [np.abs(course[n] - course[n][-1]) / sigma for n, sigma in fitted.items()]
    differing = np.flatnonzero(np.max(from_last, axis=0, initial=0.0) > CRITERIA.starts.round)
    count = max(int(differing[-1]) + 1 if differing.size else 0, 1)
    length = format_quantity(period, "s", 4)
    reason = f"{run.name} is periodic: {count} periods of {length} are simulated before it"
    if count >= most:
        reason += ", and it is not periodic by then"
    return replace(run, start=replace(run.start, periods=count, reason=reason, chosen=True))
