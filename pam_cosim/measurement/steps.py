"""Commands that step between two samples: a logger tells that they came, not when within the interval."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement.data_set import Run


def jumps(inputs: Mapping[str, Array], most: int) -> NDArray[np.int64]:
    """Rows after which an input steps: differences far beyond the others, the largest ``most`` left out of these."""
    steps = np.zeros(max((len(v) for v in inputs.values()), default=1) - 1, dtype=bool)
    for values in inputs.values():
        size = np.abs(np.diff(values))
        usual = np.partition(size, len(size) - most)[: len(size) - most]
        steps |= size > CRITERIA.noise.outlier_far * np.sqrt(float(np.mean(usual**2)))
    return np.flatnonzero(steps)


def between_samples(run: Run) -> NDArray[np.int64]:
    """Rows after which an input steps while as much time passes as usual; a step that stands in two rows is none.

    Where steps follow each other at once, it is a time series, and its bends are at the samples.
    """
    count = len(run.time)
    if run.is_static or not run.inputs or count < CRITERIA.noise.fewest_samples:
        return np.empty(0, dtype=np.int64)
    rows = jumps(run.inputs, count // CRITERIA.noise.fewest_samples)
    interval = np.diff(run.time)
    alone = np.diff(rows, prepend=-2) > 1
    alone &= np.append(alone[1:], True)
    return rows[alone & (interval[rows] > np.median(interval) / 2)]


def with_step_times(run: Run, rows: NDArray[np.int64], times: Array) -> Run:
    """The run with each step after one of ``rows`` as two rows of inputs alone, at the times given [s]."""
    at = np.repeat(rows + 1, 2)
    source = np.stack([rows, rows + 1], axis=1).ravel()
    return replace(
        run,
        time=np.insert(run.time, at, np.repeat(times, 2)),
        inputs={name: np.insert(v, at, v[source]) for name, v in run.inputs.items()},
        measurements={name: np.insert(v, at, np.nan) for name, v in run.measurements.items()},
    )
