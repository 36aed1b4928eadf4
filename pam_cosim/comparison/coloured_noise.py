"""How likely residuals are as noise of any colour: white, and a slow course besides, of unknown size and memory.

The slow course of each signal is a stationary first-order autoregressive process (Ornstein and Uhlenbeck) beside white
noise: drifts of instruments, filters of loggers. Size and memory of both are those that make the residuals most likely.
The precision of such a process is tridiagonal (Rue and Held, Gaussian Markov Random Fields, 2005, sec. 1.1), so that a
series of n samples takes of the order of n operations.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.linalg import cho_solve_banded, cholesky_banded
from scipy.optimize import minimize_scalar

from pam_cosim.arrays import Array
from pam_cosim.comparison.residual_statistics import Series

_MEMORIES = 8  # between a sample and the longest series, in equal ratios: a likelihood hardly changes between two
_RATIOS = np.log(1e-3), np.log(1e3)  # of the variance of the slow course to that of the white noise
_SEARCH = {"xatol": 0.05}  # of the logarithm of that ratio
_TINY = 1e-300


def coloured_log_likelihood(series: Sequence[Series]) -> float:
    """The largest log-likelihood of residuals as noise, white and coloured, of each signal, but for a constant.

    Args:
        series: one for each run and signal; a distance is a number of samples.
    """
    of_signal: dict[str, list[Array]] = {}
    for one in series:
        if one.values.size:
            of_signal.setdefault(one.signal, []).append(one.values)
    return sum(_most_likely(values) for values in of_signal.values())


def _most_likely(values: Sequence[Array]) -> float:
    """Over the ratio of both variances, and over the memory; white noise alone is one of the possibilities."""
    found = [_log_likelihood([(float(v @ v), 0.0) for v in values], values)]
    for memory in np.geomspace(1.0, max(len(v) for v in values), _MEMORIES):

        def cost(log_ratio: float, memory: float = float(memory)) -> float:
            ratio = float(np.exp(log_ratio))
            return -_log_likelihood([_form(v, ratio, memory) for v in values], values)

        found.append(
            -float(minimize_scalar(cost, bounds=_RATIOS, method="bounded", options=_SEARCH).fun)
        )
    return max(found)


def _log_likelihood(forms: Sequence[tuple[float, float]], values: Sequence[Array]) -> float:
    """At the scale that is most likely, of quadratic forms and log-determinants of each series."""
    samples, squares = sum(map(len, values)), sum(square for square, _ in forms)
    determinants = sum(determinant for _, determinant in forms)
    return -0.5 * (samples * float(np.log(max(squares, _TINY) / samples)) + determinants)


def _form(values: Array, ratio: float, memory: float) -> tuple[float, float]:
    """The squares of a series by the inverse of its covariance, in variances of the white noise, and that one's
    log-determinant."""
    n, left = len(values), float(np.exp(-1.0 / memory))
    new = 1.0 - left**2
    band = np.empty((2, n))  # of the precision of the slow course, and of the samples
    band[0] = -left / (ratio * new)
    band[1] = (1.0 + left**2) / (ratio * new)
    band[1, [0, -1]] = 1.0 / (ratio * (new if n > 1 else 1.0))
    band[1] += 1.0
    factor = cholesky_banded(band, check_finite=False)
    slow = cho_solve_banded((factor, False), values, check_finite=False)
    of_course = n * np.log(ratio) + (n - 1) * np.log(new)
    determinant = 2 * float(np.log(factor[1]).sum()) + float(of_course)
    return float(values @ (values - slow)), determinant
