"""A model linearised about its parameters, in few rows: what a search over many models reckons with."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.fitting.objective import Objective


@dataclass(frozen=True)
class Linear:
    """Samples minus model and the model's slopes about some values, in standard deviations of the noise.

    Rows are means over neighbouring samples of a signal, weighted so that a slow residual keeps its sum of squares and
    noise between neighbours averages out.

    Attributes:
        names: of the k parameters; ``values`` (k,) where it was linearised, ``low`` and ``high`` (k,) the bounds [SI].
        residual: (m,).
        slopes: (m, k) of the model by the values.
    """

    names: tuple[str, ...]
    values: Array
    low: Array
    high: Array
    residual: Array
    slopes: Array

    def columns(self, names: tuple[str, ...]) -> Array:
        """(m, j) the slopes by the named parameters; those that it does not have are left out."""
        return self.slopes[:, [self.names.index(n) for n in names if n in self.names]]


def linearised(objective: Objective, z: Array, rows: int) -> Linear | None:
    """The objective about search coordinates ``z`` in about so many rows; None where it cannot be simulated.

    Priors are left out.
    """
    residual = objective.residuals(z)
    if not np.all(np.isfinite(residual)):
        return None
    by_z = objective.jacobian(z, residual)
    slope = np.array([f.slope(float(c)) for f, c in zip(objective.free, z, strict=True)])
    both = _condensed(np.column_stack([residual, -by_z / slope])[: objective.size], objective.series, rows)
    return Linear(
        tuple(f.name for f in objective.free),
        np.array([f.to_value(float(c)) for f, c in zip(objective.free, z, strict=True)]),
        np.array([f.low for f in objective.free]),
        np.array([f.high for f in objective.free]),
        both[:, 0],
        both[:, 1:],
    )


def residual_rows(objective: Objective, z: Array, rows: int) -> Array | None:
    """(m,) the residual at search coordinates ``z`` alone, as ``linearised`` has it; None: it cannot be simulated."""
    residual = objective.plain_residuals(z)
    if not np.all(np.isfinite(residual)):
        return None
    return _condensed(residual[: objective.size, None], objective.series, rows)[:, 0]


def _condensed(matrix: Array, series: list[int], rows: int) -> Array:
    """Means over blocks of each series of rows, times the root of their length."""
    block = max(1, round(len(matrix) / rows))
    if block == 1:
        return matrix
    starts, at = [], 0
    for count in series:
        starts.append(np.arange(at, at + count, block))
        at += count
    begin = np.concatenate([s for s in starts if len(s)])
    lengths = np.diff(np.append(begin, at))
    sums: Array = np.add.reduceat(matrix, begin, axis=0)
    return sums / np.sqrt(lengths)[:, None]
