"""Whether one instrument explains the error: a reading that is off by a constant or a factor, or lags.

The model by itself, with its free parameters, is held against the samples; one signal at a time may read
``offset + (1 + gain) y`` of a first-order lag of the model's values, the same in all runs.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.ledger.grid import Grid
from pam_cosim.ledger.radau import integrate
from pam_cosim.ledger.smoothing_problem import LinearisedProblem, Point, SmoothingProblem, linearise

_GAIN = 0.1  # prior sd of the relative error of the factor of an instrument
_OFFSET = 0.1  # of the range: prior sd of the offset of an instrument
_LAGS = 12  # time constants that are tried, in equal ratios
_ROUNDS_WITH_FAULT = 3  # in which the free parameters are adapted to a fault, at most
_PROMISING_SHARE = 0.5  # of chi-square, that a fault may leave to be adapted to
_SETTLED_CHANGE = 1.0  # change of the deviance that ends these rounds, far below strong evidence


@dataclass(frozen=True)
class SensorFault:
    """The likeliest fault of one instrument.

    Attributes:
        signal: the signal.
        unit: of the signal.
        offset: [unit], with its standard deviation; the reading at the signal's mean is off by this.
        gain: the factor of the reading, minus one, with its standard deviation.
        lag: time constant [s]; zero where none helps. Found on a grid: good to a third.
        deviance: of the model with this fault, as in ``Smoothed``.
        chi2: sum of squared residuals in noise variances.
        free: values of the free parameters [SI].
    """

    signal: str
    unit: str
    offset: float
    offset_deviation: float
    gain: float
    gain_deviation: float
    lag: float
    deviance: float
    chi2: float
    free: tuple[float, ...]


@dataclass(frozen=True)
class Unaugmented:
    """The model by itself on the samples.

    Attributes:
        deviance, chi2: of the model without any fault.
        point: its states.
        faults: the likeliest fault of each instrument, most probable first.
    """

    deviance: float
    chi2: float
    point: Point
    faults: tuple[SensorFault, ...]


def try_sensors(
    problem: SmoothingProblem, start: tuple[Array, Array], signals: Sequence[tuple[str, str]]
) -> Unaugmented:
    """The model by itself, and with a fault in each of the signals, given by name and unit.

    Args:
        problem: without unknown inputs.
        start: the states at the nodes and inside the steps with the prior values of the free parameters.
        signals: names and units.
    """
    linearised = _Linearised(problem, problem.prior, start)
    none = linearised.least_squares()
    measured = [j for j in range(len(signals)) if np.isfinite(problem.grid.measured[:, j]).any()]
    faults = sorted((_fault(linearised, signals[j], j) for j in measured), key=lambda f: f.deviance)
    # The free parameters move when an instrument is believed no more.
    for _ in range(_ROUNDS_WITH_FAULT):
        if not faults or faults[0].chi2 > _PROMISING_SHARE * none.chi2:
            break
        j = [name for name, _ in signals].index(faults[0].signal)
        free = np.array(faults[0].free)
        better = _fault(
            _Linearised(
                problem, free, integrate(problem.model, problem.grid, problem.parameters(free))
            ),
            signals[j],
            j,
        )
        settled = abs(better.deviance - faults[0].deviance) < _SETTLED_CHANGE
        faults[0] = better
        if settled:
            break
    return Unaugmented(
        none.deviance, none.chi2, linearised.point, tuple(sorted(faults, key=lambda f: f.deviance))
    )


def additional_fault(
    grid: Grid,
    signal: tuple[str, str],
    measured: Array,
    readings: Array,
    sigma: float,
    free: Sequence[float],
) -> SensorFault:
    """The most likely fault of an instrument whose samples were not used to estimate its signal.

    ``deviance`` and ``chi2`` are of this signal alone; the error of the estimated signal is neglected.

    Args:
        grid: N nodes.
        signal: name and unit.
        measured: (N,) samples, NaN where there is none [unit].
        readings: (N,) estimated signal [unit].
        sigma: standard deviation of the noise [unit].
        free: (Q,) estimated free parameters, for the result.
    """
    is_measured = np.isfinite(measured)
    span = float(np.ptp(measured[is_measured])) or 1.0
    solutions = []
    for lag, lagged in zip(
        (0.0, *_lags(grid)),
        (readings[:, None], *_lagged(grid, readings[:, None], _lags(grid))),
        strict=True,
    ):
        y = lagged[is_measured, 0]
        rows = (
            np.column_stack(
                [
                    np.full(len(y), _OFFSET * span),
                    _GAIN * (y - np.mean(lagged)),
                ]
            )
            / sigma
        )
        r = (measured[is_measured] - y) / sigma
        matrix = rows.T @ rows + np.eye(2)
        change = np.linalg.solve(matrix, rows.T @ r)
        chi2 = float(((r - rows @ change) ** 2).sum())
        deviance = (
            chi2
            + float((change**2).sum() + np.linalg.slogdet(matrix)[1])
            + 2 * float(np.log(_LAGS + 1))
        )
        solutions.append((deviance, chi2, lag, change, np.sqrt(np.diag(np.linalg.inv(matrix)))))
    deviance, chi2, lag, change, spread = min(solutions, key=lambda t: t[0])
    offset = _OFFSET * span
    return SensorFault(
        signal[0],
        signal[1],
        float(change[0]) * offset,
        float(spread[0]) * offset,
        float(change[1]) * _GAIN,
        float(spread[1]) * _GAIN,
        float(lag),
        deviance,
        chi2,
        tuple(free),
    )


def _lags(grid: Grid) -> Array:
    longest = float(grid.step.sum()) / len(grid.runs) / 2
    return np.geomspace(min(float(np.median(grid.step)), longest / 2), longest, _LAGS)


@dataclass(frozen=True)
class _Solution:
    """Parameters (free ones, offset, gain) with deviations in their own scales, and what they are worth."""

    deviance: float
    chi2: float
    change: Array
    deviation: Array


class _Linearised:
    """The model by itself, linearised in its free parameters about some values of them."""

    def __init__(self, problem: SmoothingProblem, free: Array, states: tuple[Array, Array]) -> None:
        self.problem, self.free = problem, free
        self.point = Point(*states, np.zeros((len(states[0]), 0)), free)
        self.linear = linearise(problem, self.point)
        self.slopes = _output_slopes(problem, self.linear)

    def least_squares(
        self, j: int | None = None, readings: Array | None = None, span: float = 1.0
    ) -> _Solution:
        """The free parameters, and a fault of signal ``j`` whose reading with slopes is ``readings``, (N, 1 + Q)."""
        problem, slopes, residual = (
            self.problem,
            self.slopes,
            self.linear.residual / self.problem.sigma,
        )
        extra = np.zeros((*slopes.shape[:2], 0))
        if j is not None and readings is not None:
            residual, slopes = residual.copy(), slopes.copy()
            residual[:, j] = (problem.grid.measured[:, j] - readings[:, 0]) / problem.sigma[j]
            slopes[:, j] = readings[:, 1:]
            extra = np.zeros((*slopes.shape[:2], 2))
            extra[:, j, 0] = _OFFSET * span / problem.sigma[j]
            extra[:, j, 1] = _GAIN * (readings[:, 0] - np.mean(readings[:, 0])) / problem.sigma[j]
        is_measured = np.isfinite(residual)
        rows, r = np.concatenate([slopes, extra], axis=2)[is_measured], residual[is_measured]
        prior = np.zeros(rows.shape[1])
        prior[: len(self.free)] = (problem.prior - self.free) / problem.spread
        matrix = rows.T @ rows + np.eye(rows.shape[1])
        change = self._bounded(matrix, rows.T @ r + prior)
        chi2 = float(((r - rows @ change) ** 2).sum())
        deviance = chi2 + float(((change - prior) ** 2).sum() + np.linalg.slogdet(matrix)[1])
        return _Solution(deviance, chi2, change, np.sqrt(np.diag(np.linalg.inv(matrix))))

    def _bounded(self, matrix: Array, right: Array) -> Array:
        """The solution with free parameters held at a bound that they would pass."""
        problem, q = self.problem, len(self.free)
        low, high = (np.full(len(right), s * np.inf) for s in (-1, 1))
        low[:q], high[:q] = (
            (problem.low - self.free) / problem.spread,
            (problem.high - self.free) / problem.spread,
        )
        held = np.zeros(len(right), dtype=bool)
        change = np.zeros(len(right))
        for _ in range(q + 1):
            loose = ~held
            remaining_right = right[loose] - matrix[np.ix_(loose, held)] @ change[held]
            change[loose] = np.linalg.solve(matrix[np.ix_(loose, loose)], remaining_right)
            passed = loose & ((change < low) | (change > high))
            if not passed.any():
                break
            change = np.clip(change, low, high)
            held |= passed
        return change


def _fault(linearised: _Linearised, signal: tuple[str, str], j: int) -> SensorFault:
    grid = linearised.problem.grid
    span = float(np.nanmax(grid.measured[:, j]) - np.nanmin(grid.measured[:, j])) or 1.0
    lags = _lags(grid)
    reading_series = np.column_stack([linearised.linear.outputs[:, j], linearised.slopes[:, j]])
    solutions_by_lag = [(0.0, linearised.least_squares(j, reading_series, span))]
    solutions_by_lag += [
        (lag, linearised.least_squares(j, readings, span))
        for lag, readings in zip(lags.tolist(), _lagged(grid, reading_series, lags), strict=True)
    ]
    lag, best = min(solutions_by_lag, key=lambda t: t[1].deviance)
    q = len(linearised.free)
    free = np.clip(
        linearised.free + best.change[:q] * linearised.problem.spread,
        linearised.problem.low,
        linearised.problem.high,
    )
    return SensorFault(
        signal=signal[0],
        unit=signal[1],
        offset=float(best.change[q]) * _OFFSET * span,
        offset_deviation=float(best.deviation[q]) * _OFFSET * span,
        gain=float(best.change[q + 1]) * _GAIN,
        gain_deviation=float(best.deviation[q + 1]) * _GAIN,
        lag=lag,
        deviance=best.deviance + 2 * float(np.log(len(solutions_by_lag))),
        chi2=best.chi2,
        free=tuple(free.tolist()),
    )


def _output_slopes(problem: SmoothingProblem, linear: LinearisedProblem) -> Array:
    """(N, S, Q) by the free parameters, in standard deviations of the samples."""
    by_state, by_free = linear.flow
    grid = problem.grid
    n, q = problem.model.states, len(problem.prior)
    states = np.zeros((len(grid.time), n, q))
    for k, node in enumerate(grid.start_node.tolist()):
        states[node + 1] = by_state[k] @ states[node] + by_free[k]
    rows, rows_free = linear.rows
    slopes: Array = np.einsum("nsi,niq->nsq", rows[:, :, :n], states) + rows_free
    return slopes


def _lagged(grid: Grid, reading_series: Array, lags: Array) -> Array:
    """First-order lags (T,) of columns (N, c), exact for straight lines between the nodes: (T, N, c)."""
    z = grid.step[:, None] / lags
    decay, mean = np.exp(-z)[:, :, None], (-np.expm1(-z) / z)[:, :, None]
    at = grid.start_node
    drive = (mean - decay) * reading_series[at][:, None] + (1 - mean) * reading_series[at + 1][
        :, None
    ]
    lagged = np.repeat(reading_series[:, None], len(lags), axis=1)
    for k, node in enumerate(at.tolist()):
        lagged[node + 1] = decay[k] * lagged[node] + drive[k]
    return lagged.transpose(1, 0, 2)
