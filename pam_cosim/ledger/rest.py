"""Where runs begin whose model begins at rest: implicit Euler steps that grow until they are Newton's.

The runtime of an FMU does the same (``fmu/pam_equilibrium.c``; Kelley and Keyes, SIAM J. Numer. Anal. 35, 1998).
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array

_MOST_STEPS = 300
_FIRST, _LAST, _LEAST = 1e-4, 1e9, 1e-12  # [s] steps
_GROW, _SHRINK = 8.0, 0.1
_FAR = 1.0  # part of its size by which a state may change in one step
_STILL = 1e-10  # part of its size by which a state changes in the last step

Rates = Callable[[Array], tuple[Array, Array]]


def settled(rates: Rates, begin: Array, moves: NDArray[np.bool_], size: Array) -> Array:
    """(n,) the states of one run at rest, or ``begin`` where no rest is found.

    Args:
        rates: f (n,) and df/dx (n, n) at states (n,).
        begin: (n,) where the rest is sought from.
        moves: (n,) which states rest; the others stay.
        size: (n,) of the states, about zero.
    """
    x, h = begin.copy(), _FIRST
    f, by = _of_those(rates(x), moves)
    for _ in range(_MOST_STEPS):
        try:
            step = np.linalg.solve(np.eye(len(f)) / h - by, f)
        except np.linalg.LinAlgError:
            step = np.full(len(f), np.nan)
        part = float(np.max(np.abs(step) / (np.abs(x[moves]) + size[moves])))
        if part <= _STILL and h >= _LAST:
            return x
        candidate = x.copy()
        candidate[moves] += step
        new = _of_those(rates(candidate), moves) if part <= _FAR else None
        if new is not None and all(np.isfinite(value).all() for value in new):
            x, (f, by), h = candidate, new, min(h * _GROW, _LAST)
        else:
            h *= _SHRINK
        if h < _LEAST:
            break
    return begin


def _of_those(slopes: tuple[Array, Array], moves: NDArray[np.bool_]) -> tuple[Array, Array]:
    value, by = slopes
    return value[moves], by[np.ix_(moves, moves)]
