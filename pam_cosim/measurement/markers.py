"""Numbers that are no readings, as loggers write them where a sample is missing: 9999, -999."""

from __future__ import annotations

import numpy as np

from pam_cosim.arrays import Array

FEWEST_SAMPLES = 20  # that are compared with each other


def marker_of(values: Array) -> float | None:
    """The one number that is farther from all others than these are apart; None: there is none."""
    finite = values[np.isfinite(values)]
    if len(finite) < FEWEST_SAMPLES:
        return None
    for value in (finite.min(), finite.max()):
        other_values = finite[finite != value]
        span = float(np.ptp(other_values)) if other_values.size else 0.0
        if span and float(np.min(np.abs(other_values - value))) > span:
            return float(value)
    return None


def input_marker_of(values: Array) -> float | None:
    """The same of an input; None also where it mostly keeps its value: the highest of three steps is no marker."""
    finite = values[np.isfinite(values)]
    is_read = len(finite) > 1 and float(np.median(np.abs(np.diff(finite)))) > 0.0
    return marker_of(finite) if is_read else None
