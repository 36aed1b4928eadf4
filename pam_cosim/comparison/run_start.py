"""Where the simulation of a run begins, what drives it from there, and the first samples of its signals."""

from __future__ import annotations

import numpy as np

from pam_cosim.measurement import FirstSamples, Run, first_samples
from pam_cosim.simulation import Inputs


def start_time(run: Run) -> float:
    """When the simulation of a run begins [s].

    A run that records inputs begins with its first row, or as long before as something is known of them. A run without
    inputs is a free course from the state at time zero, which the first sample may come after.
    """
    first = float(run.time[0])
    if run.start.periodic:
        return first - run.start.periods * _period(run)
    if run.start.seconds:
        return first - run.start.seconds
    return first if run.inputs or run.start.is_found else min(0.0, first)


def _period(run: Run) -> float:
    """Of a run that is one: the row that would follow the last is the first again."""
    return float(run.time[-1] - run.time[0] + np.median(np.diff(run.time)))


def inputs_of_run(run: Run) -> Inputs | None:
    """What drives the model, from the start of the simulation on."""
    start, time, values = run.start, run.time, run.inputs
    if start.seconds and values:
        # a step at the first row: what was before, and what the row says
        time = np.concatenate([[time[0] - start.seconds, time[0]], time])
        values = {
            n: np.concatenate([np.full(2, start.before.get(n, v[0])), v]) for n, v in values.items()
        }
    elif start.periodic and values:
        shifts = _period(run) * np.arange(-start.periods, 1)
        time = (shifts[:, None] + time).ravel()
        values = {n: np.tile(v, len(shifts)) for n, v in values.items()}
    return Inputs(time, values, run.interpolation) if values else None


def first_of_run(run: Run, signal: str, sigma: float, skipped: int = 0) -> FirstSamples | None:
    """A signal at the first row of a run; None where it has no sample, or the first comes after a pause.

    Args:
        run: what was recorded.
        signal: its name.
        sigma: standard deviation of the noise [SI].
        skipped: so many samples at the beginning are not asked.
    """
    time, values = run.time, run.measurements[signal]
    if signal in run.start.leading:
        early, recorded = run.start.leading[signal]
        later = time >= run.time[0] + run.start.lead
        time, values = np.append(early, time[later]), np.append(recorded, values[later])
    if skipped:
        values = np.array(values)
        values[np.flatnonzero(np.isfinite(values))[:skipped]] = np.nan
    return first_samples(time, values, sigma, float(run.time[0]))
