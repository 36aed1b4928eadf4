"""Fitted parameters with what is known of their uncertainty."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.fitting.free import Free
from pam_cosim.measurement import Prior
from pam_cosim.measurement.free_parameter import INTERVAL


@dataclass(frozen=True)
class Estimate:
    """One fitted parameter.

    Attributes:
        value: the estimate [unit].
        low, high: ends of the 95 % interval [unit]; the bounds where the data do not determine it.
        unit: SI unit.
        at_bound: the fit ended at a bound, so the interval is one-sided at best.
        determined: the data say something about it.
        held: it was held at this value, since the fit is no worse with it there.
        run: the one run that it is of; empty: all.
        prior: what was known of it beforehand [unit].
    """

    json_keys = "value low high unit at_bound determined held run? prior=_prior?"

    value: float
    low: float
    high: float
    unit: str = ""
    at_bound: bool = False
    determined: bool = True
    held: bool = False
    run: str = ""
    prior: Prior | None = None

    @property
    def surprise(self) -> float:
        """How far it is from what was known of it beforehand, in standard deviations of that; NaN without a prior."""
        return float("nan") if self.prior is None else self.prior.surprise(self.value)

    @property
    def _prior(self) -> dict[str, object]:
        if self.prior is None:
            return {}
        shape = {"logarithmic": True} if self.prior.logarithmic else {}
        return {
            "mean": self.prior.mean,
            "sd": self.prior.sd,
            "surprise": self.surprise,
            **shape,
        }

    def __str__(self) -> str:
        if self.held:
            return f"{self.value:.4g}, held there: these data do not need it"
        text = f"{self.value:.4g} ({self.low:.4g} to {self.high:.4g}) {'' if self.unit == '1' else self.unit}".rstrip()
        p = self.prior
        notes = [] if p is None else [f"{self.surprise:+.2g} sd from the prior {p}"]
        notes += ["at its bound"] * self.at_bound + ["not determined by these data"] * (
            not self.determined
        )
        return ", ".join([text, *notes])


def estimates(
    free: Sequence[Free], z: Array, jacobian: Array, bounds: tuple[Array, Array], spread: float
) -> dict[str, Estimate]:
    """Linearised 95 % intervals, made in the search coordinates.

    Args:
        free: the fitted parameters.
        z: (k,) solution in search coordinates.
        jacobian: (n, k) of the weighted residuals at ``z``.
        bounds: of z.
        spread: factor on the standard deviations, for residuals larger than the noise or correlated in time.
    """
    low, high = bounds
    size = np.linalg.norm(jacobian, axis=0) if len(free) else np.zeros(0)
    largest = float(size.max(initial=0.0))
    bound = (z - low <= CRITERIA.fit.at_bound * (high - low)) | (
        high - z <= CRITERIA.fit.at_bound * (high - low)
    )
    alive = size > max(CRITERIA.fit.dead * largest, 1e-12)
    inner = [i for i in range(len(free)) if alive[i] and not bound[i]]
    deviation = np.full(len(free), np.inf)
    if inner:
        deviation[inner] = spread * standard_deviations(jacobian[:, inner])
    edge = [i for i in range(len(free)) if alive[i] and bound[i]]
    for i in edge:
        deviation[i] = spread * standard_deviations(jacobian[:, [*inner, i]])[-1]
    by_name = {}
    for i, f in enumerate(free):
        reach = INTERVAL * deviation[i]
        value = f.to_value(float(z[i]))
        lower = f.to_value(float(max(z[i] - reach, low[i])))
        upper = f.to_value(float(min(z[i] + reach, high[i])))
        covers_range = z[i] - reach <= low[i] and z[i] + reach >= high[i]
        by_name[f.name] = Estimate(
            value, lower, upper, f.unit, bool(bound[i]), not covers_range, False, f.run, f.prior
        )
    return by_name


def standard_deviations(jacobian: Array) -> Array:
    """Square roots of the diagonal of (J'J)^-1, directions that the data do not see left infinite."""
    norms = np.linalg.norm(jacobian, axis=0)
    _, s, vt = np.linalg.svd(jacobian / norms, full_matrices=False)
    is_determined = s > CRITERIA.fit.seen * s[0]
    variance = ((vt[is_determined] / s[is_determined, None]) ** 2).sum(axis=0)
    blind = (vt[~is_determined] ** 2).sum(axis=0) > CRITERIA.fit.blind
    return np.where(blind, np.inf, np.sqrt(variance) / norms)


def describe(parameters: dict[str, Estimate]) -> str:
    """One line each."""
    return "\n".join(f"  {name} = {e}" for name, e in parameters.items())


__all__ = ["Estimate", "describe", "estimates", "standard_deviations"]
