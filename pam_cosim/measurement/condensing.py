"""A data set of very many rows as means, so that a search over many models takes the time that it takes of few rows."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from pam_cosim.measurement.data_set import DataSet, Run
from pam_cosim.measurement.noise import complete_noise
from pam_cosim.measurement.resampling import resampled, with_noise_of_means
from pam_cosim.units import format_quantity

MOST_ROWS = 30_000  # of all runs: five times six runs of 10 s at 100 Hz
PULSES = 0.2  # of an input's range, standard deviation: pulses of 5 %; normal noise alone has 0.12 and less


def condensed(data: DataSet) -> tuple[DataSet, str]:
    """Means over the interval that leaves some ``MOST_ROWS`` rows, and a sentence on it; empty where it is as it was.

    Runs that hold means already, and points at rest, stay as they are: somebody chose their rows. So does a run whose
    inputs lose much of their range, such as pulses of a valve: no mean represents them.
    """
    dense = [run for run in data.runs if not run.is_static and not run.averaged]
    rows = sum(len(run.time) for run in dense)
    if rows <= MOST_ROWS:
        return data, ""
    interval = _rounded(sum(float(run.time[-1] - run.time[0]) for run in dense) / MOST_ROWS)
    means = {run.name: averaged for run in dense if (averaged := _means(run, interval))}
    if not means:
        return data, ""
    runs = tuple(means.get(run.name, run) for run in data.runs)
    stated = {
        name: signal.as_stated()
        for name, signal in data.signals.items()
        if any(name in r.measurements for r in dense)
    }
    changed = complete_noise(with_noise_of_means(stated, runs), runs)
    result = replace(data, runs=runs, signals=data.signals | changed)
    over = format_quantity(interval, "s")
    note = f"{rows} rows are more than a search needs: means over {over} are used"
    return result, f'{note}; state resample = "..." under [recording] for another interval'


def _lost(recording: Run, means: Run, name: str) -> float:
    """Variation of an input about its means: standard deviation over the samples."""
    at = np.interp(recording.time, means.time, means.inputs[name])
    return float(np.std(recording.inputs[name] - at))


def _rounded(interval: float) -> float:
    """Up to a length of two digits, which a person can state."""
    digit = 10.0 ** (math.floor(math.log10(interval)) - 1)
    return math.ceil(round(interval / digit, 6)) * digit


def _means(run: Run, interval: float) -> Run | None:
    means = resampled(run, interval, run.interpolation)
    lost = {name: _lost(run, means, name) for name in run.inputs}
    return (
        None
        if any(lost[name] > PULSES * float(np.ptp(values)) for name, values in run.inputs.items())
        else means
    )
