"""How far a model is from a measurement, as numbers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from pam_cosim.comparison.residual_statistics import Series, lag_one
from pam_cosim.comparison.residuals import RunComparison
from pam_cosim.comparison.rounding import expected_squares, standardized_residuals
from pam_cosim.measurement import Signal


@dataclass(frozen=True)
class SignalScore:
    """Scores of one signal over one or several runs; SI units.

    Attributes:
        rmse: root mean square of measured minus model.
        nrmse: rmse over the measured range.
        bias: mean of measured minus model.
        max: largest size of the difference; ``max_time`` [s] and ``max_run`` say where; of
            points at rest, the former is what they are sorted by [SI].
        correlation: Pearson's, measured against model.
        chi2_reduced: mean square of the difference in noise standard deviations, of readings in coarse steps beyond
            their rounding (``rounding``); NaN without a known noise.
        noise_rmse: the noise's standard deviation, the lowest rmse a model can honestly reach.
        samples: how many samples were compared; ``effective_samples``: how many those count for in chi-square, fewer
            where they were rounded to coarse steps.
        autocorrelation: of neighbouring differences, about zero.
        whiteness_score: the same in standard deviations of white noise; the larger, the less they are white, because
            of a wrong model or of an instrument that drifts.
    """

    rmse: float
    nrmse: float
    bias: float
    max: float
    max_time: float
    max_run: str
    correlation: float
    chi2_reduced: float
    noise_rmse: float
    samples: int
    autocorrelation: float = float("nan")
    whiteness_score: float = float("nan")
    effective_samples: float = float("nan")


def score_signal(runs: Sequence[RunComparison], signal: Signal) -> SignalScore | None:
    """Scores one signal over the runs that measured it; None where no run did."""
    runs = [r for r in runs if r.run.sample_count(signal.name)]
    if not runs:
        return None
    error, measured, model, time, names = [], [], [], [], []
    for r in runs:
        residual = r.residual(signal.name)
        is_measured = np.isfinite(residual)
        error.append(residual[is_measured])
        measured.append(r.run.measurements[signal.name][is_measured])
        model.append(r.model[signal.name][is_measured])
        time.append(r.run.time[is_measured])
        names += [r.run.name] * int(is_measured.sum())
    e, y, m, t = (np.concatenate(a) for a in (error, measured, model, time))
    rmse = float(np.sqrt(np.mean(e**2)))
    span = float(np.ptp(y))
    worst = int(np.argmax(np.abs(e)))
    series = [
        Series(
            standardized_residuals(error_of_run, signal, reading),
            expected_squares(error_of_run, signal),
        )
        for error_of_run, reading in zip(error, measured, strict=True)
    ]
    correlation, whiteness_score = lag_one(series)
    effective = sum(part.samples for part in series)
    chi2 = float(sum(np.sum(part.values**2) for part in series))
    return SignalScore(
        rmse=rmse,
        nrmse=rmse / span if span else np.nan,
        bias=float(np.mean(e)),
        max=float(abs(e[worst])),
        max_time=float(t[worst]),
        max_run=names[worst],
        correlation=float(np.corrcoef(y, m)[0, 1]) if span and np.ptp(m) else np.nan,
        chi2_reduced=chi2 / effective,
        noise_rmse=float(signal.sigma),
        samples=len(e),
        autocorrelation=correlation,
        whiteness_score=whiteness_score,
        effective_samples=effective,
    )


def score(runs: Sequence[RunComparison], signals: Mapping[str, Signal]) -> dict[str, SignalScore]:
    """Scores every signal over ``runs``."""
    by_name = {name: score_signal(runs, signal) for name, signal in signals.items()}
    return {name: s for name, s in by_name.items() if s is not None}


def chi2_reduced(scores: Mapping[str, SignalScore]) -> float:
    """Mean square of all differences in noise standard deviations, over all signals; NaN without samples."""
    samples = sum(s.effective_samples for s in scores.values())
    chi2 = sum(s.chi2_reduced * s.effective_samples for s in scores.values())
    return chi2 / samples if samples else float("nan")
