"""Fits and candidates whose statistics are written down."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import SimpleNamespace

import numpy as np

from pam_cosim.comparison import ResidualStatistics, RunComparison
from pam_cosim.diagnosis import Candidate, Verdict
from pam_cosim.diagnosis.judgement.fitted_models import FittedModels
from pam_cosim.diagnosis.judgement.model_space import ModelSpace
from pam_cosim.diagnosis.judgement.verdict import judge
from pam_cosim.fitting import Estimate, Fit
from pam_cosim.measurement import Run, Signal

SAMPLES = 1000
NOISE = 1.0  # chi2 of a residual that is noise


def statistics(
    chi2: float, score: float = 0.0, time: float = 1.0, samples: int = SAMPLES
) -> ResidualStatistics:
    """``chi2`` reduced; the white part of the residual is that of the noise."""
    return ResidualStatistics(chi2 * samples, samples, min(chi2, NOISE), score, time)


EMPTY = ResidualStatistics(0.0, 0, float("nan"), 0.0, 1.0)


class WhiteFit(Fit):
    """A fit that leaves independent samples, one in each correlation time: no course of them goes on in the next."""

    def coloured_deviance(self, largest: float) -> float:
        known = [s for s in self.residuals_beyond_uncertainty.values() if s.samples]
        return self.chi2_priors + sum(self._white(s, largest) for s in known)

    @staticmethod
    def _white(s: ResidualStatistics, largest: float) -> float:
        variance = min(s.chi2_reduced, largest)
        return s.samples / s.correlation_time * (math.log(variance) + s.chi2_reduced / variance - 1)


def fitted(
    chi2: float,
    holdout: float | None = None,
    score: float = 0.0,
    parameters: int = 2,
    time: float = 1.0,
    own: Mapping[str, Estimate] | None = None,
    shown: Mapping[str, float] | None = None,
    measured: Signal | None = None,
    runs: Mapping[str, float] | None = None,
) -> Fit:
    """A fit whose residual has these reduced chi-squares.

    ``shown``: rms errors of signals that were not fitted, of a noise of one; ``measured``: a fitted signal, and its
    error in each of the ``runs``.
    """
    estimates = {f"base.{i}": Estimate(1.0, 0.9, 1.1) for i in range(parameters)} | dict(own or {})
    signals = {n: Signal(n, "K", 1.0, fitted=False) for n in shown or {}}
    signals |= {measured.name: measured} if measured else {}
    comparison = SimpleNamespace(
        runs=tuple(
            _run(name, measured.name, error) for name, error in (runs or {}).items() if measured
        ),
        data=SimpleNamespace(
            signals=signals,
            fitted_signals={n: s for n, s in signals.items() if s.fitted},
        ),
        scores={
            "all": {n: SimpleNamespace(rmse=v, noise_rmse=1.0) for n, v in (shown or {}).items()},
            "fit": {},
        },
        chi2_reduced=lambda role: {"fit": chi2}.get(role, float("nan")),
    )
    structure = {
        "fit": statistics(chi2, score, time),
        "holdout": EMPTY if holdout is None else statistics(holdout, score, time),
    }
    return WhiteFit("Test", estimates, comparison, structure, 1)  # type: ignore[arg-type]


def _run(name: str, signal: str, error: float) -> RunComparison:
    times = np.arange(8.0)
    measured = {signal: np.resize([error, error, -error, -error], 8)}
    run = Run(name, Path(name), "fit", "linear", {}, times, {}, measured)
    return RunComparison(run, {signal: np.zeros(8)})


def candidate(
    effect: str,
    fit: Fit,
    family: str | None = None,
    own: Mapping[str, Estimate] | None = None,
    balance: str = "force",
    before: tuple[str, ...] = (),
) -> Candidate:
    return Candidate(effect, family or effect, balance, (*before, effect), tuple(own or {}), fit)


def models_of(
    base: Fit,
    path: Sequence[Candidate] = (),
    tried: Sequence[Candidate] = (),
    family: Mapping[str, str] | None = None,
    every: int = 10,
) -> FittedModels:
    """Models of a search among so many effects."""
    families = {c.effect: c.family for c in (*path, *tried)} | dict(family or {})
    return FittedModels(base, families, ModelSpace(every), tuple(path), tuple(tried))


def judged(
    base: Fit,
    path: Sequence[Candidate] = (),
    rivals: Sequence[Candidate] = (),
    tried: Sequence[Candidate] = (),
    family: Mapping[str, str] | None = None,
    every: int = 10,
) -> Verdict:
    """The verdict on such models."""
    families = {c.effect: c.family for c in rivals} | dict(family or {})
    return judge(models_of(base, path, tried, families, every), rivals)


LOST = Estimate(1e4, 0.1, 1e4, "s", at_bound=True, determined=False)
KNOWN = Estimate(250.0, 240.0, 260.0, "N/m")
