"""The discrepancy of a fitted model in addition to the noise: a stationary process, estimated from its residuals.

A model that lacks an effect errs for a while in one direction. In addition to white noise, its residual then
contains a process about zero, here of one variance and one memory in all runs, and independent from run to run (Kennedy
and O'Hagan, Journal of the Royal Statistical Society B 63, 2001, with a first-order autoregressive process). A few
independent pieces of residuals determine the variance poorly, so that bands are those of Student's distribution.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import exp, sqrt

import numpy as np
from scipy.special import stdtrit

from pam_cosim.arrays import Array
from pam_cosim.comparison import RunComparison, autocorrelation
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement import Signal

TAIL = 0.025  # of the samples, on either side of a 95 % band


@dataclass(frozen=True)
class Discrepancy:
    """The discrepancy of a model in one signal, in addition to the noise.

    Attributes:
        sd: standard deviation [unit of the signal].
        memory: time over which its autocorrelation falls to 1/e, if that is an exponential [s].
        pieces: degrees of freedom of ``sd``: independent pieces of the residuals, less what was fitted to them.
        runs: names of the runs that it was estimated from.
        held_out: whether these were held out, not fitted.
    """

    sd: float
    memory: float
    pieces: float
    runs: tuple[str, ...]
    held_out: bool

    def reach(self, duration: float = 0.0) -> float:
        """Half width of the 95 % interval of its mean over so many seconds; 0: of its value [unit of the signal]."""
        factor = float(stdtrit(self.pieces, 1.0 - TAIL))
        return factor * self.sd * sqrt(_of_mean(duration / self.memory))


def discrepancies(
    runs: Sequence[RunComparison],
    signals: Mapping[str, Signal],
    freedom: int,
    predicted: str = "",
) -> dict[str, Discrepancy]:
    """The discrepancy of each signal, from held-out runs where any has readings of it, else from fitted ones.

    Args:
        runs: of the fitted model.
        signals: by name.
        freedom: number of parameters that the fitted runs determine.
        predicted: name of the run that is predicted: it is not used for its own error, unless it is the only one.
    """
    residuals = {name: _residuals(runs, signal, predicted) for name, signal in signals.items()}
    pieces = {name: sum(residual.pieces for residual in parts) for name, parts in residuals.items()}
    fitted = {name for name, parts in residuals.items() if parts and signals[name].fitted}
    fitted_pieces = sum(pieces[name] for name in fitted if not residuals[name][0].held_out)
    result = {}
    for name, parts in residuals.items():
        if parts:
            mixed = name in fitted and not parts[0].held_out
            spent = freedom * pieces[name] / fitted_pieces if mixed else 0.0
            result[name] = _estimate(parts, pieces[name], spent)
    return result


@dataclass(frozen=True)
class _Residual:
    """Of a signal in a run: sum of squares beyond the noise, samples, duration and memory [s]."""

    run: str
    held_out: bool
    excess: float
    samples: int
    duration: float
    memory: float

    @property
    def pieces(self) -> float:
        return max(1.0, self.duration / (2.0 * self.memory))


def _residuals(runs: Sequence[RunComparison], signal: Signal, predicted: str) -> list[_Residual]:
    """One for each run with information, held-out ones before fitted ones."""
    usable = [
        r
        for r in runs
        if not r.run.is_static and r.run.sample_count(signal.name) > CRITERIA.residuals.lags
    ]
    for role in ("holdout", "fit"):
        runs_of_role = [r for r in usable if r.run.role == role]
        training_runs = [r for r in runs_of_role if r.run.name != predicted]
        if training_runs or (role == "fit" and runs_of_role):
            return [_residual(r, signal) for r in training_runs or runs_of_role]
    return []


def _residual(compared: RunComparison, signal: Signal) -> _Residual:
    error = compared.residual(signal.name)
    at = np.isfinite(error)
    noise = np.broadcast_to(signal.sigma_at(compared.model[signal.name]), error.shape)
    excess = float(np.sum(error[at] ** 2 - noise[at] ** 2))
    time = compared.run.time[at]
    duration = float(time[-1] - time[0]) * len(time) / (len(time) - 1)
    memory = _memory(time, error[at], excess)
    held_out = compared.run.role == "holdout"
    return _Residual(compared.run.name, held_out, excess, int(at.sum()), duration, memory)


def _memory(time: Array, error: Array, excess: float) -> float:
    """Integral of the autocorrelation about zero up to where it vanishes, without the white part [s]."""
    count = len(time)
    grid = np.linspace(time[0], time[-1], count)
    step = float(grid[1] - grid[0])
    if excess <= 0.0:
        return step / 2.0
    even = np.interp(grid, time, error)
    power, correlation = float(np.sum(even**2)), autocorrelation(even, count)
    insignificant = np.flatnonzero(correlation <= CRITERIA.residuals.memory_gone / sqrt(count))
    summed = power * float(
        np.sum(correlation[1 : insignificant[0] if len(insignificant) else count])
    )
    return step * (0.5 + summed / max(excess, power * float(correlation[1])))


def _estimate(parts: Sequence[_Residual], pieces: float, spent: float) -> Discrepancy:
    """One variance and one memory of all runs; what was fitted has taken its share of the squares."""
    samples = sum(p.samples for p in parts)
    power = [max(p.excess, 0.0) for p in parts]
    variance = max(sum(p.excess for p in parts), 0.0) / samples
    weights = power if sum(power) else [1.0] * len(parts)
    memory = float(np.average([p.memory for p in parts], weights=weights))
    degrees_of_freedom = max(pieces - spent, 1.0)
    names = tuple(p.run for p in parts)
    return Discrepancy(
        sqrt(variance * max(pieces / degrees_of_freedom, 1.0)),
        memory,
        degrees_of_freedom,
        names,
        parts[0].held_out,
    )


def _of_mean(span: float) -> float:
    """Variance of the mean of an exponentially correlated process over so many memories, over that of its value."""
    if span < 1e-4:
        return 1.0
    return 2.0 * (span - 1.0 + exp(-span)) / span**2
