"""A noise level for every signal, so that residuals of different units can be weighed."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement import DataSet, with_noise


def complete_noise(data: DataSet) -> DataSet:
    """Keeps stated noise levels, estimates the others from the samples, and assumes 1 % of range where that fails.

    Sparse samples, such as points read off a printed figure, show no noise to estimate.
    """
    data = with_noise(data)
    signals = {}
    for name, signal in data.signals.items():
        if signal.sigma is None or not np.isfinite(signal.sigma) or signal.sigma <= 0:
            values = np.concatenate([r.measurements[name] for r in data.runs if r.sample_count(name)])
            span = float(np.nanmax(values) - np.nanmin(values))
            level = CRITERIA.noise.assumed_share * span or max(abs(float(np.nanmean(values))), 1.0) * 1e-6
            signal = replace(signal, sigma=level, estimated=True)
        signals[name] = signal
    return replace(data, signals=signals)
