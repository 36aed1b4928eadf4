"""What a fit would come to if nothing were known of its parameters beforehand."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from pam_cosim.fitting.fit import Fit
from pam_cosim.fitting.linear import bounded_step, reduction_by


@dataclass(frozen=True)
class WithoutPriors:
    """What a fitted model would come to, to first order, if nothing were known of its parameters beforehand.

    Attributes:
        reduction: of the squared error of the fitted samples.
        values: of the parameters of which something is known [SI].
    """

    reduction: float = 0.0
    values: Mapping[str, float] = field(default_factory=dict)


def without_priors(fit: Fit) -> WithoutPriors:
    """What a fitted model would come to without its priors; the fit as it is where it has no slopes."""
    estimates_with_prior = {
        name: e.value for name, e in fit.parameters.items() if e.prior is not None
    }
    linear = fit.linear
    if linear is None or not estimates_with_prior:
        return WithoutPriors(values=estimates_with_prior)
    step = bounded_step(replace(linear, priors={}))
    values = dict(zip(linear.names, (linear.values + step).tolist(), strict=True))
    return WithoutPriors(
        reduction_by(linear, step), {n: values.get(n, v) for n, v in estimates_with_prior.items()}
    )
