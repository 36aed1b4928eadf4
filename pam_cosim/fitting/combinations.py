"""What is known of two parameters that the data cannot separate: their product, or their ratio."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import exp

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.fitting.estimate import Estimate, standard_deviations
from pam_cosim.fitting.objective import Objective
from pam_cosim.measurement.free_parameter import INTERVAL
from pam_cosim.units import product, quotient

# relative difference of the slopes of two parameters, below which a test of both pays
_PARALLEL_SLOPES = 1e-3
_EXCHANGE_FACTOR = 1.2  # factor on one parameter, and divisor of the other, in that test
_UNCHANGED_RMS = 0.02  # sd, rms change of the residuals, below which only the product is determined


@dataclass(frozen=True)
class Combination:
    """Two parameters of which only one combination is known.

    Attributes:
        names: the parameters.
        kind: "product" or "ratio", the first by the second.
        value: of the combination [unit].
        low, high: its 95 % interval [unit].
        unit: SI unit.
    """

    names: tuple[str, str]
    kind: str
    value: float
    low: float
    high: float
    unit: str = ""

    def __str__(self) -> str:
        sign = "*" if self.kind == "product" else "/"
        value = f"{self.value:.4g} ({self.low:.4g} to {self.high:.4g}) {self.unit}".rstrip()
        names = f" {sign} ".join(self.names)
        return f"only the {self.kind} is determined: {names} = {value}; hold one of the two fixed"


def combinations(
    objective: Objective,
    z: Array,
    jacobian: Array,
    parameters: Mapping[str, Estimate],
    spread: float,
) -> tuple[Combination, ...]:
    """The pairs among the parameters that the data do not determine whose product or ratio they do determine.

    Two slopes that agree by the logarithm are a hint; that raising one and lowering the other changes nothing is the
    proof, and costs one evaluation for each pair.

    Args:
        objective: of the fit.
        z: (k,) solution in search coordinates.
        jacobian: (n, k) of the weighted residuals at ``z``.
        parameters: the estimates, by name, in the order of ``z``.
        spread: factor on the standard deviations, as for ``estimates``.
    """
    values = np.array([e.value for e in parameters.values()])
    slopes = np.array([f.slope(float(c)) for f, c in zip(objective.free, z, strict=True)])
    by_logarithm = jacobian * values / slopes
    size = np.linalg.norm(by_logarithm, axis=0)
    open_ones = [
        i
        for i, e in enumerate(parameters.values())
        if not e.determined and e.value > 0 and size[i] > 0
    ]
    found_combinations = []
    for i, j in itertools.combinations(open_ones, 2):
        for kind, sign in (("product", 1.0), ("ratio", -1.0)):
            apart = np.linalg.norm(by_logarithm[:, i] - sign * by_logarithm[:, j])
            is_parallel = apart < _PARALLEL_SLOPES * size[i]
            if is_parallel and _changes_nothing(objective, z, i, j, -sign):
                correlated = [j, *(k for k in open_ones if k != i)]
                deviation = spread * _deviation(by_logarithm, i, correlated)
                found_combinations.append(
                    _combination(list(parameters.items()), i, j, kind, deviation)
                )
    return tuple(found_combinations)


def _changes_nothing(objective: Objective, z: Array, i: int, j: int, power: float) -> bool:
    """Whether the residuals stay where parameter i grows by a factor and j by that factor to ``power``."""
    low, high = objective.bounds
    # Whichever stays within the bounds.
    for stretch in (_EXCHANGE_FACTOR, 1 / _EXCHANGE_FACTOR):
        shifted = z.copy()
        for k, factor in ((i, stretch), (j, stretch**power)):
            free = objective.free[k]
            shifted[k] = free.to_z(free.to_value(float(z[k])) * factor)
        if np.all((shifted >= low) & (shifted <= high)):
            change = objective.residuals(shifted) - objective.residuals(z)
            return bool(np.sqrt(np.mean(change**2)) < _UNCHANGED_RMS)
    return False


def _deviation(by_logarithm: Array, i: int, without: Sequence[int]) -> float:
    """Standard deviation of the logarithm of parameter i where those in ``without`` are held."""
    free_columns = [
        k for k in range(by_logarithm.shape[1]) if k not in without and np.any(by_logarithm[:, k])
    ]
    return float(standard_deviations(by_logarithm[:, free_columns])[free_columns.index(i)])


def _combination(
    parameters: Sequence[tuple[str, Estimate]], i: int, j: int, kind: str, deviation: float
) -> Combination:
    (first, a), (second, b) = parameters[i], parameters[j]
    value = a.value * b.value if kind == "product" else a.value / b.value
    reach = exp(min(INTERVAL * deviation, 700.0))
    unit = (product if kind == "product" else quotient)(a.unit, b.unit)
    return Combination((first, second), kind, value, value / reach, value * reach, unit)
