"""What a model that nobody fitted yet is expected to leave, from the slopes of those that were.

A model with effect A, fitted, and what effect B does to the samples beside the base model are enough to say, to first
order, what a model with both would leave when all parameters are fitted: a linear least squares problem. That is less
than a millisecond against the seconds of a fit, so many models are ranked and those fitted that promise most.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.fitting import Linear, bounded_step


def effect_alone(base: Linear, model: Linear) -> Linear:
    """An effect by itself: its model less the base model at the same base parameters, with its own parameters only.

    Args:
        base: the base model.
        model: the same with the effect; parameters that it has not stay where the base model has them.
    """
    values = dict(zip(model.names, model.values, strict=True))
    change = np.array([values.get(n, v) - v for n, v in zip(base.names, base.values, strict=True)])
    at = [i for i, name in enumerate(model.names) if name not in base.names]
    names = tuple(model.names[i] for i in at)
    return Linear(
        names,
        model.values[at],
        model.low[at],
        model.high[at],
        model.residual - base.residual + base.slopes @ change,
        model.slopes[:, at],
        {name: model.priors[name] for name in names if name in model.priors},
    )


class Expectation(NamedTuple):
    """What a model is expected to come to when all parameters keep to their bounds, and to what is known of them.

    Attributes:
        reduction: of the sum of squares.
        values: of the parameters then [SI].
        chi2_priors: what they are off what is known of them beforehand, in variances.
        residual: (m,) what is left then.
    """

    reduction: float
    values: Mapping[str, float]
    chi2_priors: float
    residual: Array


def expected(model: Linear, effect: Linear) -> Expectation:
    """What a fitted model comes to with an effect (``effect_alone``), all parameters fitted together."""
    both = Linear(
        (*model.names, *effect.names),
        np.concatenate([model.values, effect.values]),
        np.concatenate([model.low, effect.low]),
        np.concatenate([model.high, effect.high]),
        model.residual + effect.residual,
        np.column_stack([model.slopes, effect.slopes]),
        {**model.priors, **effect.priors},
    )
    step = bounded_step(both)
    residual = both.residual - both.slopes @ step
    reduction = float(model.residual @ model.residual - residual @ residual)
    values = dict(zip(both.names, (both.values + step).tolist(), strict=True))
    surprises = [prior.surprise(values[name]) for name, prior in both.priors.items()]
    return Expectation(max(reduction, 0.0), values, sum(s**2 for s in surprises), residual)
