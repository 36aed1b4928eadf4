"""Single samples that no smooth signal explains.

A sample whose residual is far from the median of its neighbours' residuals is an outlier (Hampel, Journal of the
American Statistical Association 69, 1974). It is the residual that is looked at, so that a fast but modelled change of
the signal is not taken for one; and single samples, so that what lasts longer stays in the data and is judged.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import median_filter

from pam_cosim.arrays import Array
from pam_cosim.comparison.residuals import RunComparison
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement import DataSet, Run
from pam_cosim.measurement.white_noise import MEDIAN_TO_SIGMA


def outliers(residual: Array, together: int = 1) -> NDArray[np.bool_]:
    """(n,) which samples are outliers; ``residual`` has NaN where a sample is missing.

    So many neighbours may be off together. A quick change of the signal takes its neighbours along, less and less;
    against a model that follows it, two outliers may be neighbours by chance.
    """
    far_off = np.zeros(len(residual), dtype=bool)
    sample_rows = np.flatnonzero(np.isfinite(residual))
    if len(sample_rows) < CRITERIA.noise.outlier_fewest:
        return far_off
    e = residual[sample_rows]
    off = e - median_filter(e, CRITERIA.noise.outlier_window, mode="nearest")
    far = np.abs(off) > CRITERIA.noise.outlier_far * MEDIAN_TO_SIGMA * float(np.median(np.abs(off)))
    size = np.abs(np.concatenate([[0.0], off, [0.0]]))
    for begin, end in _groups(far):
        neighbour_size = max(size[begin], size[end + 1])
        if (
            end - begin > together
            or neighbour_size >= CRITERIA.noise.outlier_alone * size[begin + 1 : end + 1].min()
        ):
            far[begin:end] = False
    if far.mean() <= CRITERIA.noise.outlier_most:
        far_off[sample_rows[far]] = True
    return far_off


def _groups(flags: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Where neighbours that are true begin, and where they have ended."""
    steps = np.diff(np.concatenate([[0], flags.astype(int), [0]]))
    return list(
        zip(np.flatnonzero(steps > 0).tolist(), np.flatnonzero(steps < 0).tolist(), strict=True)
    )


def without_outliers(
    data: DataSet, compared: Sequence[RunComparison], together: int = 1
) -> tuple[DataSet, dict[str, int]]:
    """The data set with outliers marked as missing, and how many there were, by signal.

    Args:
        data: the measurement.
        compared: its runs with a fitted model.
        together: how many neighbours may be off together.
    """
    counts: dict[str, int] = {}
    runs: list[Run] = []
    for c in compared:
        measurements = dict(c.run.measurements)
        for name in data.signals:
            if name in measurements and c.run.sample_count(name):
                far = outliers(c.residual(name), together)
                if far.any():
                    measurements[name] = np.where(far, np.nan, measurements[name])
                    counts[name] = counts.get(name, 0) + int(far.sum())
        runs.append(replace(c.run, measurements=measurements))
    return replace(data, runs=tuple(runs)), counts
