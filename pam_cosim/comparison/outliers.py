"""Single samples that no smooth course of a signal explains.

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


def outliers(residual: Array) -> NDArray[np.bool_]:
    """(n,) which samples are outliers; ``residual`` has NaN where a sample is missing."""
    far_off = np.zeros(len(residual), dtype=bool)
    kept = np.flatnonzero(np.isfinite(residual))
    if len(kept) < CRITERIA.noise.outlier_fewest:
        return far_off
    e = residual[kept]
    off = e - median_filter(e, CRITERIA.noise.outlier_window, mode="nearest")
    far = np.abs(off) > CRITERIA.noise.outlier_far * CRITERIA.noise.median_to_sigma * float(np.median(np.abs(off)))
    beside = np.maximum(np.abs(np.append(off[1:], 0.0)), np.abs(np.insert(off[:-1], 0, 0.0)))
    far &= beside < CRITERIA.noise.outlier_alone * np.abs(
        off
    )  # a quick change of the signal takes its neighbours along
    if far.mean() <= CRITERIA.noise.outlier_most:
        far_off[kept[far]] = True
    return far_off


def without_outliers(data: DataSet, compared: Sequence[RunComparison]) -> tuple[DataSet, dict[str, int]]:
    """The data set with outliers marked as missing, and how many there were, by signal.

    Args:
        data: the measurement.
        compared: its runs beside a fitted model.
    """
    counts: dict[str, int] = {}
    runs: list[Run] = []
    for c in compared:
        measurements = dict(c.run.measurements)
        for name in data.signals:
            if name in measurements and c.run.sample_count(name):
                far = outliers(c.residual(name))
                if far.any():
                    measurements[name] = np.where(far, np.nan, measurements[name])
                    counts[name] = counts.get(name, 0) + int(far.sum())
        runs.append(replace(c.run, measurements=measurements))
    return replace(data, runs=tuple(runs)), counts
