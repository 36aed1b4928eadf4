"""How likely residuals are as noise of any colour: white, and plus a slow drift of unknown size and memory.

The slow drift of each signal is a stationary first-order autoregressive process (Ornstein and Uhlenbeck) with white
noise: drifts of instruments, filters of loggers. Size and memory of both are those that make the residuals most likely.
The precision of such a process is tridiagonal (Rue and Held, Gaussian Markov Random Fields, 2005, sec. 1.1), so that a
series of n samples takes of the order of n operations.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from scipy.fft import dct
from scipy.linalg.lapack import dpttrf, dpttrs
from scipy.optimize import minimize_scalar

from pam_cosim.arrays import Array
from pam_cosim.comparison.residual_statistics import Series

_MEMORIES = 8  # between a sample and the longest series, in equal ratios: a likelihood hardly changes between two
_RATIOS = np.log(10.0) * np.linspace(-3, 3, 25)  # logarithms, of the slow variance to the white
_AROUND = 3  # of their steps, to both sides of the likeliest, in which the exact one is sought
_SEARCH = {"xatol": 0.05}  # of the logarithm
_UNLIKELY = 12.0  # log-likelihood: a memory that is less likely by that, near enough, is not looked at exactly
_SINGLE = 32  # lowest frequencies, each by itself; the others in bands
_BAND = 1.05  # from one band to the next
_TINY = 1e-300


def noise_log_likelihood(series: Sequence[Series], largest: float) -> float:
    """The largest log-likelihood of residuals as noise of each signal, but for a constant.

    Args:
        series: one for each run and signal; a distance is a number of samples.
        largest: mean square that noise may have at most: instruments drift, but not far.
    """
    return sum(_most_likely(values, largest) for values in _by_signal(series))


def _most_likely(series: Sequence[Array], largest: float) -> float:
    """Over the ratio of both variances, and over the memory; near the best points of the grid."""
    values, lengths = np.concatenate(series), [len(v) for v in series]
    ends = np.cumsum(lengths) - 1
    likelihoods = [float(_log_likelihood(len(values), float(values @ values), 0.0, 0.0, largest))]
    grid = _likelihoods(series, largest)[:, 1:]
    for memory, at_memory in zip(_memories(max(lengths)), grid, strict=True):
        if at_memory.max() < grid.max() - _UNLIKELY:
            continue

        def cost(log_ratio: float, memory: float = memory) -> float:
            ratio = float(np.exp(log_ratio))
            form = _form(values, ends, ratio, memory)
            return -float(_log_likelihood(len(values), *form, ratio, largest))

        likeliest = int(at_memory.argmax())
        bounds = _RATIOS[[max(likeliest - _AROUND, 0), min(likeliest + _AROUND, len(_RATIOS) - 1)]]
        likelihoods.append(
            -float(minimize_scalar(cost, bounds=bounds, method="bounded", options=_SEARCH).fun)
        )
    return max(likelihoods)


def _memories(longest: int) -> list[float]:
    return [float(m) for m in np.geomspace(1.0, longest, _MEMORIES)]


def _log_likelihood(
    samples: int,
    squares: Array | float,
    determinants: Array | float,
    ratios: Array | float,
    largest: float,
) -> Array:
    """() or (g,) at the scale that is most likely and makes both variances together no larger than noise may be.

    Args:
        samples: how many.
        squares, determinants: () or (g,) quadratic forms and log-determinants by the variance of the white noise.
        ratios: () or (g,) of the variance of the slow drift to that.
        largest: what both may be together.
    """
    variance = np.minimum(np.maximum(squares, _TINY) / samples, largest / (1 + ratios))
    beyond = squares / variance - samples
    return np.asarray(-0.5 * (samples * np.log(variance) + beyond + determinants))


def _form(
    values: Array, ends: NDArray[np.int_], ratio: float, memory: float
) -> tuple[float, float]:
    """The squares of series by the inverse of their covariance, in variances of the white noise, and that one's
    log-determinant.

    Args:
        values: (n,) of all series.
        ends: where the last sample of each is.
        ratio, memory: of the slow drift, to the variance of the white noise, and in samples.
    """
    n, decay = len(values), float(np.exp(-1.0 / memory))
    new = 1.0 - decay**2
    # of the precision of the slow drift, by its variance
    diagonal = np.full(n, (1.0 + decay**2) / new)
    heads = np.append(0, ends[:-1] + 1)
    diagonal[heads] -= decay**2 / new
    diagonal[ends] -= decay**2 / new
    off_diagonal = np.full(max(n - 1, 1), -decay / (new * ratio))
    off_diagonal[ends[:-1]] = 0.0
    pivots, factor, _ = dpttrf(1.0 + diagonal / ratio, off_diagonal)
    slow, _ = dpttrs(pivots, factor, values)
    drift_determinant = n * np.log(ratio) + (n - len(ends)) * np.log(new)
    return float(values @ (values - slow)), float(np.log(pivots).sum() + drift_determinant)


def approximate_log_likelihood(series: Sequence[Series], largest: float) -> float:
    """As ``noise_log_likelihood``, in a hundredth of the time.

    In the discrete cosine transform the components of a slow drift that is reflected at its ends are independent, each
    with its part of the spectrum, which hardly changes within a band. Ratio and memory are the likeliest of a grid.

    Args:
        series: one for each run and signal.
        largest: mean square that noise may have at most.
    """
    return sum(float(_likelihoods(values, largest).max()) for values in _by_signal(series))


def _by_signal(series: Sequence[Series]) -> list[list[Array]]:
    of_signal: dict[str, list[Array]] = {}
    for part in series:
        if part.values.size:
            of_signal.setdefault(part.signal, []).append(part.values)
    return [*of_signal.values()]


def _likelihoods(series: Sequence[Array], largest: float) -> Array:
    """(memories, 1 + ratios) of the series of a signal, the first of each memory without a slow drift."""
    longest, samples = max(map(len, series)), sum(map(len, series))
    squares, determinants = np.zeros(1), np.zeros(1)
    for values in series:
        first, inverse, determinant = _spectra(len(values), longest)
        squares = squares + inverse @ np.add.reduceat(dct(values, norm="ortho") ** 2, first)
        determinants = determinants + determinant
    ratios = np.tile(_ratios(), _MEMORIES)
    grid = _log_likelihood(samples, squares, determinants, ratios, largest)
    return grid.reshape(_MEMORIES, -1)


def _ratios() -> Array:
    """Ratios of the grid: no slow drift, and increasing ones."""
    return np.append(0.0, np.exp(_RATIOS))


@lru_cache(maxsize=128)
def _spectra(samples: int, longest: int) -> tuple[NDArray[np.int_], Array, Array]:
    """Likelihoods of white noise with the slow drifts of a grid, in bands of frequency.

    Returns:
        where each band begins (b,), one over the spectra there (g, b), and the log-determinants (g,).
    """
    beyond = _SINGLE * _BAND ** np.arange(max(np.log(samples / _SINGLE) / np.log(_BAND), 0.0))
    frequencies = np.unique(np.append(np.arange(min(_SINGLE, samples)), beyond.astype(int)))
    wide = np.diff(np.append(frequencies, samples))
    frequency = np.pi * (frequencies + (wide - 1) / 2) / samples
    decay = np.exp(-1.0 / np.array(_memories(longest)))[:, None, None]
    slow = (1 - decay**2) / (1 - 2 * decay * np.cos(frequency) + decay**2)
    spectrum = (1 + _ratios()[:, None] * slow).reshape(-1, len(frequencies))
    return frequencies, 1 / spectrum, np.log(spectrum) @ wide
