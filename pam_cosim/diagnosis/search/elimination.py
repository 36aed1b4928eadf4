"""Which effects of a fitted model the data need: backward elimination on the linearised model, without a simulation."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from math import log

import numpy as np

from pam_cosim.criteria import CRITERIA
from pam_cosim.fitting import Linear, bounded_least_squares, prior_rows


def needed_effects(
    linear: Linear,
    parameters: Mapping[str, Sequence[str]],
    absent: Mapping[str, float],
    misfit: float,
    price: float,
    most: int | None = None,
) -> tuple[str, ...]:
    """The effects whose absence costs more than they do, each left out with all others fitted again, to first order.

    Args:
        linear: the model about its optimum.
        parameters: full names of the parameters of each effect.
        absent: values at which the effects vanish, by full name; an effect without one stays.
        misfit: mean square of what the model leaves, at least one [noise variances].
        price: of an effect in the criterion, without its parameters.
        most: number of effects that are kept at most, those that are needed most; None: any.
    """
    kept = [*parameters]
    for effect, gain in elimination(linear, parameters, absent, misfit, price):
        if gain > 0 and (most is None or len(kept) <= most):
            break
        kept.remove(effect)
    return tuple(kept)


def elimination(
    linear: Linear,
    parameters: Mapping[str, Sequence[str]],
    absent: Mapping[str, float],
    misfit: float,
    price: float,
) -> Iterator[tuple[str, float]]:
    """The effects in the order in which they are left out, the least needed first, as for ``needed_effects``.

    Each with what it gains beside those that are still there, less what it costs; without those that have no absence.
    """
    together = _samples_of_one(linear)
    of_parameter = log(max(len(linear.residual) / together, CRITERIA.evidence.least_samples))
    cost = {e: price + of_parameter * len(names) for e, names in parameters.items()}
    values = dict(zip(linear.names, linear.values.tolist(), strict=True))

    def remaining(effects: Sequence[str]) -> float:
        fixed = left_out(effects, parameters, values, absent)
        return fitted_with(linear, fixed)[1] / (misfit * together)

    kept = [*parameters]
    criterion = remaining(kept)
    while removable := [e for e in kept if any(n in absent for n in parameters[e])]:
        without = {e: remaining([n for n in kept if n != e]) for e in removable}
        first = min(removable, key=lambda e: (without[e] - cost[e], e))
        yield first, without[first] - criterion - cost[first]
        kept.remove(first)
        criterion = without[first]


def left_out(
    kept: Collection[str],
    parameters: Mapping[str, Sequence[str]],
    values: Mapping[str, float],
    absent: Mapping[str, float],
) -> dict[str, float]:
    """The parameters of the effects that are not kept: where these vanish, or else where they stand [SI].

    Args:
        kept: the others.
        parameters: full names of the parameters of each effect; those without a value are not fitted.
        values: of the parameters.
        absent: values at which the effects vanish.
    """
    return {
        n: absent.get(n, values[n])
        for e, names in parameters.items()
        for n in names
        if e not in kept and n in values
    }


def fitted_with(linear: Linear, fixed: Mapping[str, float]) -> tuple[dict[str, float], float]:
    """All parameters, some of them at fixed values and the others fitted again, to first order.

    Returns the values by name [SI], and the sum of squares that is left.
    """
    moved = np.array([name not in fixed for name in linear.names])
    change = np.array(
        [fixed.get(n, v) - v for n, v in zip(linear.names, linear.values, strict=True)]
    )
    weights, pull = prior_rows(linear.names, linear.values, linear.priors)
    rows = np.vstack([linear.slopes, np.diag(weights)])
    wanted = np.append(linear.residual, pull) - rows @ change
    step = bounded_least_squares(
        rows[:, moved],
        wanted,
        np.minimum(linear.low - linear.values, 0.0)[moved],
        np.maximum(linear.high - linear.values, 0.0)[moved],
    )
    residual = (wanted - rows[:, moved] @ step)[: len(linear.residual)]
    change[moved] = step
    values = linear.values + change
    return dict(zip(linear.names, values.tolist(), strict=True)), float(residual @ residual)


def _samples_of_one(linear: Linear) -> float:
    """How many rows count for one independent row, by the correlation of neighbours in each series."""
    ends = np.cumsum([rows for _, rows in linear.series])
    series = [
        linear.residual[end - n : end] for (_, n), end in zip(linear.series, ends, strict=True)
    ]
    together = sum(float(residuals[1:] @ residuals[:-1]) for residuals in series)
    squares = max(float(linear.residual @ linear.residual), 1e-300)
    share = min(max(together / squares, 0.0), CRITERIA.residuals.reddest)
    return (1 + share) / (1 - share)
