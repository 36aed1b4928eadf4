"""Are neighbouring residuals related, as those of a wrong model are and those of white noise are not?"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pam_cosim.arrays import Array


def lag_one(series: Sequence[Array]) -> tuple[float, float]:
    """Correlation of neighbours about zero over all series, and how many standard deviations of white noise that is.

    Args:
        series: residuals in time order, missing samples left out; each series has a scale of its own.
    """
    weighted, pairs = 0.0, 0
    for e in series:
        power = float(np.sum(e**2))
        if len(e) > 2 and power > 0:
            n = len(e) - 1
            weighted += n * float(np.sum(e[1:] * e[:-1])) / power
            pairs += n
    return (weighted / pairs, weighted / float(np.sqrt(pairs))) if pairs else (0.0, 0.0)
