"""The likelihood of a reading under a model, compared with that of the noise alone.

A reading that was rounded to steps says only that signal and noise fell into its interval. Its likelihood is the
probability of that (Sheppard's grouped observations; for regression, Heitjan, Statistical Science 4, 1989). Twice what
the logarithm of it lacks of its largest value is the square of the residual (the deviance residual of McCullagh and
Nelder, Generalized Linear Models, 1989), so that least squares remain maximum likelihood: inside the interval the
residual is nearly zero, outside it is the distance to the edge in standard deviations of the noise. Without steps it is
measured minus model in standard deviations, as ever.

How large the squares are on average, if the model is right, follows from where the model lies between two steps. So a
long hold inside an interval counts for nothing, and one near an edge, where the readings go to and fro, counts for as
many samples as it has.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from scipy.special import log_ndtr

from pam_cosim.arrays import Array
from pam_cosim.measurement import Signal

_FINE = 1.0  # steps of less than this many standard deviations: each square is one on average, to a part in 500
_CENTRE = 1e-4  # standard deviations, within which the slope is the one at zero
_TAIL = 8.0  # standard deviations, beyond which noise does not carry a reading
_NODES = 64  # of the table of expected squares, at least, and in a standard deviation


def standardized_residuals(error: Array, signal: Signal, reading: Array | float = 0.0) -> Array:
    """Residuals in standard deviations of the noise; of rounded readings, deviance residuals.

    Args:
        error: (n,) measured minus model [unit of the signal], may be NaN.
        signal: with its noise.
        reading: (n,) what was measured [unit of the signal]; counts where the noise grows with it.
    """
    if not signal.step:
        return error / signal.sigma_at(reading)
    return np.asarray(
        np.sign(error) * np.sqrt(_deviance(error / signal.noise, signal.step / signal.noise))
    )


def slope(error: Array, signal: Signal, reading: Array | float = 0.0) -> Array:
    """(n,) derivative of ``standardized_residuals`` by the error [1/unit]."""
    if not signal.step:
        return np.full(len(error), 1.0 / signal.sigma_at(reading))
    steps = signal.step / signal.noise
    t = np.where(np.abs(error) < _CENTRE * signal.noise, _CENTRE, error / signal.noise)
    inside = _log_mass(t, steps)
    at_edges = np.exp(_log_density(t - steps / 2) - inside) - np.exp(
        _log_density(t + steps / 2) - inside
    )
    root = np.sign(t) * np.sqrt(_deviance(t, steps))
    # far inside an interval neither is seen
    return np.asarray(
        np.divide(at_edges, root * signal.noise, out=np.zeros(len(t)), where=np.abs(root) > 0.0)
    )


def expected_squares(error: Array, signal: Signal) -> Array:
    """(n,) mean squares of ``standardized_residuals`` that noise alone would have, if the model were right.

    Which of the steps a reading is at, does not matter; where the model lies between two, does.
    """
    steps = signal.step / signal.noise if signal.step else 0.0
    if steps < _FINE:
        return np.ones(len(error))
    phase, mean = _table(steps)
    return np.asarray(np.interp(error / signal.step, phase, mean, period=1.0))


def usual_square(signal: Signal) -> float:
    """The mean of ``expected_squares`` where the model is anywhere between two steps."""
    steps = signal.step / signal.noise if signal.step else 0.0
    return 1.0 if steps < _FINE else float(np.mean(_table(steps)[1]))


@lru_cache(maxsize=64)
def _table(steps: float) -> tuple[Array, Array]:
    """Places of the model between two steps, and the mean squares there."""
    count = int(np.ceil(_NODES * max(1.0, steps)))
    phase = (np.arange(count) + 0.5) / count - 0.5
    reach = int(np.ceil(_TAIL / steps)) + 1
    mean = np.zeros(count)
    for reading in range(-reach, reach + 1):
        t = (reading - phase) * steps
        mean += np.exp(_log_mass(t, steps)) * _deviance(t, steps)
    return -phase, mean


def _deviance(t: Array, steps: float) -> Array:
    """Twice what the logarithm of a reading's probability lacks of its largest value."""
    largest = float(_log_mass(np.zeros(1), steps)[0])
    return np.asarray(np.maximum(2.0 * (largest - _log_mass(t, steps)), 0.0))


def _log_mass(t: Array, steps: float) -> Array:
    """Logarithm of the probability that noise of one falls into an interval of this width about ``t``."""
    away = np.abs(t)
    log_near, log_far = log_ndtr(steps / 2 - away), log_ndtr(-steps / 2 - away)
    return np.asarray(log_near + np.log(-np.expm1(log_far - log_near)))


def _log_density(t: Array) -> Array:
    return np.asarray(-(t**2 + np.log(2.0 * np.pi)) / 2.0)
