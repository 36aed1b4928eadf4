"""A model linearised about its parameters, condensed to few rows for the search over many models."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.comparison import (
    RunComparison,
    Series,
    approximate_log_likelihood,
    standardized_residuals,
)
from pam_cosim.criteria import CRITERIA
from pam_cosim.fitting.bounded_linear import bounded_least_squares
from pam_cosim.fitting.objective import Objective
from pam_cosim.measurement import DataSet, Prior
from pam_cosim.starts import measured_signals


@dataclass(frozen=True)
class Linear:
    """Samples minus model and the model's slopes about some values, in standard deviations of the noise.

    Rows are means over neighbouring samples of a signal, weighted so that a slow residual keeps its sum of squares and
    noise between neighbours averages out.

    Attributes:
        names: of the k parameters; ``values`` (k,) where it was linearised, ``low`` and ``high`` (k,) the bounds [SI].
        residual: (m,).
        slopes: (m, k) of the model by the values.
        priors: what is known of parameters beforehand, by name; it is not among the rows.
        series: signal of each series, and how many rows it has; they follow one another.
        absorbed: (m, s) the directions in which start values of runs take away what parameters change, with the root of
            the share; residual and slopes are what they leave.
    """

    names: tuple[str, ...]
    values: Array
    low: Array
    high: Array
    residual: Array
    slopes: Array
    priors: Mapping[str, Prior] = field(default_factory=dict)
    series: tuple[tuple[str, int], ...] = ()
    absorbed: Array = field(default_factory=lambda: np.zeros((0, 0)))

    def left_by_starts(self, change: Array) -> Array:
        """What start values leave of a change (m,) or (m, k) of the residual at the same start values."""
        if not self.absorbed.size:
            return change
        return np.asarray(change - self.absorbed @ (self.absorbed.T @ change))

    @property
    def movable(self) -> Array:
        """(m, j) the slopes by the parameters that no bound keeps where they are."""
        margin = CRITERIA.fit.at_bound * (self.high - self.low)
        gradient = self.slopes.T @ self.residual
        low, high = self.values <= self.low + margin, self.values >= self.high - margin
        return self.slopes[:, ~((low & (gradient < 0)) | (high & (gradient > 0)))]


def bounded_step(linear: Linear) -> Array:
    """(k,) by how much the parameters move within their bounds to leave the least squares, priors among them."""
    low, high = (
        np.minimum(linear.low - linear.values, 0.0),
        np.maximum(linear.high - linear.values, 0.0),
    )
    rows, targets = linear.slopes, linear.residual
    if linear.priors:
        prior_slopes, pull = prior_rows(linear.names, linear.values, linear.priors)
        rows, targets = np.vstack([rows, np.diag(prior_slopes)]), np.append(targets, pull)
    return bounded_least_squares(rows, targets, low, high)


def prior_rows(
    names: Sequence[str], values: Array, priors: Mapping[str, Prior]
) -> tuple[Array, Array]:
    """(k,) slopes of the priors of parameters, and (k,) the shifts that would remove them; zeros without a prior."""
    determined = [
        (priors[n].slope(v), -priors[n].surprise(v)) if n in priors else (0.0, 0.0)
        for n, v in zip(names, values.tolist(), strict=True)
    ]
    slopes, targets = np.array(determined).reshape(-1, 2).T
    return slopes, targets


def reduction_by(linear: Linear, step: Array) -> float:
    """By how much the sum of squares of the samples falls with a step (k,), to first order."""
    change = linear.slopes @ step
    return max(float(change @ (2 * linear.residual - change)), 0.0)


def linearised(objective: Objective, z: Array, rows: int) -> Linear | None:
    """The objective about search coordinates ``z`` in about so many rows; None where it cannot be simulated."""
    residual = objective.residuals(z)
    if not np.all(np.isfinite(residual)):
        return None
    by_z = objective.jacobian(z, residual)
    slope = np.array([f.slope(float(c)) for f, c in zip(objective.free, z, strict=True)])
    residual_and_slopes = _condensed(
        np.column_stack([residual, -by_z / slope])[: objective.size], objective.kept, rows
    )
    by_starts, information = objective.starts.slopes(objective.size)
    by_starts = _condensed(by_starts, objective.kept, rows)
    return Linear(
        tuple(f.name for f in objective.free),
        np.array([f.to_value(float(c)) for f, c in zip(objective.free, z, strict=True)]),
        np.array([f.low for f in objective.free]),
        np.array([f.high for f in objective.free]),
        residual_and_slopes[:, 0],
        residual_and_slopes[:, 1:],
        {f.name: f.prior for f in objective.free if f.prior is not None},
        tuple(
            (name, len(begin))
            for (_, name), begin in zip(
                objective.series, _blocks(objective.kept, rows), strict=True
            )
        ),
        _absorbed(by_starts, information),
    )


def _absorbed(slopes: Array, information: Array) -> Array:
    """(m, s) as in ``Linear``, of slopes (m, s) by start values of which (s,) is known beforehand [1/variance]."""
    if not slopes.shape[1]:
        return slopes
    rows = np.vstack([slopes, np.diag(np.sqrt(information))])
    triangle: Array = np.asarray(np.linalg.qr(rows, mode="r"))
    return np.asarray(np.linalg.solve(triangle.T, slopes.T).T)


def coloured_deviance(linear: Linear, residual: Array, largest: float) -> float:
    """Minus twice the log-likelihood of residuals (m,), in its rows, as noise of any colour, but for a constant.

    Args:
        linear: whose rows they are.
        residual: the residuals.
        largest: mean square that noise may have at most in a row.
    """
    of_rows = linear.series or (("", len(residual)),)
    ends = np.cumsum([rows for _, rows in of_rows])
    series = [
        Series.plain(residual[end - rows : end], signal=name)
        for (name, rows), end in zip(of_rows, ends.tolist(), strict=True)
    ]
    return -2 * approximate_log_likelihood(series, largest)


def judged_by(linear: Linear, runs: Sequence[RunComparison], data: DataSet, rows: int) -> Linear:
    """The same with the residuals of other samples of the same runs.

    The slopes keep the samples that are set aside: few of those that a row is the mean of.

    Args:
        linear: as ``linearised`` made it in so many ``rows``.
        runs: of the model there, those held out among them.
        data: with the samples.
    """
    series = [(r, n) for r in runs if r.run.role == "fit" for n in measured_signals(r.run, data)]
    at_samples = [(n, *r.at_samples(n)) for r, n in series]
    errors = [standardized_residuals(e, data.signals[n], y) for n, _, e, y in at_samples]
    residuals, masks = (
        np.concatenate([np.zeros(0), *errors]),
        [masks for _, masks, _, _ in at_samples],
    )
    return replace(linear, residual=_condensed(residuals[:, None], masks, rows)[:, 0])


def residual_rows(objective: Objective, z: Array, rows: int) -> Array | None:
    """(m,) the residual at search coordinates ``z`` alone, as ``linearised`` has it; None: it cannot be simulated."""
    residual = objective.plain_residuals(z)
    if not np.all(np.isfinite(residual)):
        return None
    return _condensed(residual[: objective.size, None], objective.kept, rows)[:, 0]


def rows_of_series(objective: Objective, rows: int) -> NDArray[np.int_]:
    """(m,) which of ``objective.series`` each row of ``linearised`` is of."""
    begin = _blocks(objective.kept, rows)
    return np.repeat(np.arange(len(begin)), [len(b) for b in begin])


def _condensed(matrix: Array, masks: Sequence[NDArray[np.bool_]], rows: int) -> Array:
    """Means over blocks of each series of rows, times the root of their length; a missing sample counts for nothing.

    Which rows there are depends on the times of all samples, not on which of them are missing.
    """
    sample_mask = np.concatenate(masks) if masks else np.zeros(0, bool)
    full = np.zeros((len(sample_mask), matrix.shape[1]))
    full[sample_mask] = matrix
    blocks = _blocks(masks, rows)
    if not len(sample_mask) or sum(map(len, blocks)) == len(sample_mask):
        return full
    begin = np.concatenate([b for b in blocks if len(b)])
    counts = np.add.reduceat(sample_mask.astype(float), begin)
    sums: Array = np.add.reduceat(full, begin, axis=0)
    return sums / np.sqrt(np.maximum(counts, 1.0))[:, None]


def _blocks(masks: Sequence[NDArray[np.bool_]], rows: int) -> list[NDArray[np.int_]]:
    """Where the blocks of each series begin, in about so many rows in all."""
    lengths = [len(series) for series in masks]
    block = max(1, round(sum(lengths) / rows))
    ends = np.cumsum([0, *lengths])
    return [np.arange(at, at + n, block) for at, n in zip(ends[:-1], lengths, strict=True)]
