"""The posterior of the parameters: weighted samples from about Laplace's approximation, between bounds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting.fit import Fit, spread_of
from pam_cosim.fitting.free import Free
from pam_cosim.fitting.objective import Objective
from pam_cosim.fitting.truncated_normal import truncated_normal
from pam_cosim.measurement import DataSet
from pam_cosim.simulation import AnySimulator

_WIDTH = 1.5  # of the proposal, in sd of the linearised posterior
_PRIOR_WIDTH = 10.0  # distances of the bounds: sd of a weak prior, which keeps an undetermined parameter finite


@dataclass(frozen=True)
class ParameterPosterior:
    """Samples of the parameters of a fitted model, given the data.

    Attributes:
        names: of the parameters that were fitted.
        units: SI units, by name.
        samples: (n, k) values [SI].
        weights: (n,) relative probability of each sample; they sum to one.
        fixed: what else the model is run with [SI].
    """

    json_keys = "names units samples weights effective fixed"

    names: tuple[str, ...]
    units: dict[str, str]
    samples: Array
    weights: Array
    fixed: dict[str, float]

    @property
    def effective(self) -> float:
        """The effective sample size (Kish 1965)."""
        return float(1.0 / np.sum(self.weights**2))

    @property
    def values(self) -> list[dict[str, float]]:
        """Each sample with what else the model is run with [SI]."""
        return [
            self.fixed | dict(zip(self.names, map(float, row), strict=True)) for row in self.samples
        ]


def parameter_posterior(
    simulator: AnySimulator,
    data: DataSet,
    fit: Fit,
    free: Sequence[Free],
    count: int,
    seed: int = 0,
) -> ParameterPosterior:
    """Samples of the fitted parameters.

    About the optimum the chi-square is a quadratic, from the slopes of the residuals; between the bounds every value
    of a search coordinate is as likely beforehand. That is Laplace's approximation. Samples are drawn from a wider one,
    and each is weighted by what the chi-square really is there (importance sampling): where the model bends, the
    approximation alone is too narrow. Residuals that are larger than the noise or correlated widen it all as they
    widen the intervals of the fit.

    Args:
        simulator: the model that was fitted.
        data: what it was fitted to.
        fit: the optimum.
        free: its parameters, with their bounds; others of the fit stay where they are.
        count: of the samples.
        seed: of the random numbers.

    Raises:
        SimulationFailure: the model breaks down at the optimum.
    """
    names = [f.name for f in free]
    model_values = {**fit.comparison.parameters, **fit.values}
    fixed = {name: value for name, value in model_values.items() if name not in names}
    objective = Objective(simulator, data, data.fit_runs, free, fixed)
    low, high = objective.bounds
    z = np.clip([f.to_z(fit.values[f.name]) for f in free], low, high)
    residuals = objective.residuals(z)
    if not np.all(np.isfinite(residuals)):
        raise SimulationFailure(objective.first_failure)
    scale = np.ones(len(residuals))
    scale[: objective.size] = 1.0 / spread_of(fit.residuals["fit"])
    slopes = objective.jacobian(z, residuals) * scale[:, None]
    # parameters without influence are limited by the bounds, far within which this is flat
    precision = slopes.T @ slopes + np.diag(1.0 / (_PRIOR_WIDTH * (high - low)) ** 2)
    mean = z - np.linalg.solve(precision, slopes.T @ (residuals * scale))
    wider, rng = precision / _WIDTH**2, np.random.default_rng(seed)
    drawn = (
        truncated_normal(mean, wider, (low, high), z, count, rng) if names else np.zeros((count, 0))
    )
    weights = _weights(objective, scale, drawn, mean, wider)
    values = np.array(
        [[f.to_value(float(c)) for f, c in zip(free, row, strict=True)] for row in drawn]
    )
    return ParameterPosterior(
        tuple(names),
        {f.name: f.unit for f in free},
        values.reshape(count, len(names)),
        weights,
        fixed | fit.start_values,
    )


def _weights(
    objective: Objective, scale: Array, drawn: Array, mean: Array, precision: Array
) -> Array:
    """(n,) the posterior over the density that samples were drawn from; zero where the simulation fails."""
    chi2 = np.array([float(np.sum((objective.plain_residuals(z) * scale) ** 2)) for z in drawn])
    away = drawn - mean
    quadratic = np.einsum("ni,ij,nj->n", away, precision, away)
    logarithm = 0.5 * (quadratic - chi2)
    finite = np.isfinite(logarithm)
    if not finite.any():
        raise SimulationFailure("the model breaks down with every sample of its parameters")
    weights = np.where(finite, np.exp(logarithm - logarithm[finite].max()), 0.0)
    return np.asarray(weights / weights.sum())
