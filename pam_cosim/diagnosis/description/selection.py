"""Which forms describe what a model leaves: chosen one or two at a time, by the error in runs left out."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.diagnosis.description.forms import Form

_MOST_FORMS = 8  # addends of a spline: two variables with a line and three bends each
LEAST_GAIN = 0.03  # of the remaining error of left-out runs, that an addend must take away
_LEAST_GAIN_OF_TERM = 0.005  # the same, of the whole term
_DESCRIBED_ERROR = 0.3  # noise variances: mean square that needs no description


@dataclass(frozen=True)
class FeltForms:
    """Residuals of a model, and what a coefficient of each form would change in them, to first order.

    Attributes:
        residual: (n,) in standard deviations.
        felt: (n,) by text of the form.
        imitated: (n, Q) what the free parameters do.
        group: (n,) number of the run (or part of it) that a row belongs to.
    """

    residual: Array
    felt: Mapping[str, Array]
    imitated: Array
    group: NDArray[np.intp]

    def columns(self, forms: Sequence[Form]) -> list[Array]:
        """What addends of these forms, with coefficients of 1, explain of the residuals."""
        return [self.felt[form.text] for form in forms]


def select_forms(rows: FeltForms, library: Sequence[Form]) -> list[Form]:
    """At most ``_MOST_FORMS``, in order of selection; where no further one helps, two are added at once."""
    picked: list[Form] = []
    error = error_without = cross_validation_error(rows, [])
    while len(picked) < _MOST_FORMS and error > _DESCRIBED_ERROR:
        unused_forms = [f for f in library if f not in picked]
        for count in (1, 2):
            additions = list(combinations(unused_forms, count))
            errors = [cross_validation_error(rows, [*picked, *addition]) for addition in additions]
            new_error = min(errors, default=np.inf)
            if (
                new_error < (1 - LEAST_GAIN) * error
                and error - new_error > _LEAST_GAIN_OF_TERM * error_without
            ):
                picked += additions[int(np.argmin(errors))]
                error = new_error
                break
        else:
            break
    return [f for f in picked if _is_needed(rows, picked, f, error)]


def _is_needed(rows: FeltForms, picked: Sequence[Form], form: Form, error: float) -> bool:
    remaining_forms = [f for f in picked if f is not form]
    return (
        not remaining_forms
        or cross_validation_error(rows, remaining_forms) > (1 + LEAST_GAIN) * error
    )


def cross_validation_error(rows: FeltForms, forms: Sequence[Form]) -> float:
    """Mean square in each group, with coefficients and free parameters of the others."""
    table = np.column_stack([rows.imitated, *rows.columns(forms)])
    moments = []
    for g in range(int(rows.group.max()) + 1):
        columns, residual = table[rows.group == g], rows.residual[rows.group == g]
        moments.append((columns.T @ columns, columns.T @ residual, float(residual @ residual)))
    everything = sum(matrix for matrix, _, _ in moments)
    target = sum(right for _, right, _ in moments)
    total = 0.0
    for matrix, right, square in moments:
        solution = _regularised_solution(everything - matrix, target - right)
        total += square - 2 * float(right @ solution) + float(solution @ matrix @ solution)
    return total / len(rows.residual)


def coefficients_of(rows: FeltForms, forms: Sequence[Form]) -> tuple[Array, float]:
    """Coefficients (k,) of the forms by least squares, with the free parameters, and the residual [noise variances]."""
    table = np.column_stack([rows.imitated, *rows.columns(forms)])
    solution = _regularised_solution(table.T @ table, table.T @ rows.residual)
    mean_square = float(np.mean((rows.residual - table @ solution) ** 2))
    return solution[rows.imitated.shape[1] :], mean_square


def _regularised_solution(matrix: Array, right: Array) -> Array:
    if not len(right):
        return right
    size = np.sqrt(np.maximum(np.diag(matrix), 1e-300))
    scaled = matrix / np.outer(size, size) + 1e-9 * np.eye(len(right))
    solution: Array = np.linalg.solve(scaled, right / size) / size
    return solution
