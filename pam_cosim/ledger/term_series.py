"""A missing term over time, with the variables that it may be a function of."""

from __future__ import annotations

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.ledger.augmented import TERM, AugmentedModel, UnknownInput
from pam_cosim.ledger.grid import Grid
from pam_cosim.ledger.ledger import TermSeries
from pam_cosim.ledger.smoothed_models import SmoothedModel


def term_series(
    explanation: SmoothedModel, unknown_input: UnknownInput
) -> tuple[tuple[TermSeries, ...], dict[str, str]]:
    """A term over time in each run, with variables and what free parameters imitate; and units of the variables."""
    problem, smoothed, j = (
        explanation.problem,
        explanation.smoothed,
        explanation.unknown_inputs.index(unknown_input),
    )
    grid: Grid = problem.grid
    p = problem.parameters(smoothed.point.free)[grid.run_of_node]
    p[:, problem.model.unknown_at] = smoothed.point.w
    names = _variables(explanation.augmented, unknown_input)
    variables = problem.model.variables(
        grid.time, smoothed.point.x, grid.node_inputs, grid.node_delayed, p
    )
    against = {
        short: variables[full] for short, full in names.items() if np.ptp(variables[full]) > 0
    }
    against = {
        n: against[n] for n in sorted(against, key=lambda n: n not in unknown_input.variables)
    }
    against.pop(TERM, None)
    value = smoothed.point.w[:, j]
    against = {n: v for n, v in against.items() if not np.allclose(v, value, rtol=1e-6, atol=0)}
    units = {n: explanation.augmented.ode.interface.locals[names[n]].unit for n in against}
    imitated = _imitated(explanation, p, j)
    series = []
    for r, run in enumerate(grid.runs):
        at = grid.nodes(r)
        values_at_point = {n: v[at] for n, v in against.items()}
        imitations = {n: imitated[at, q] for q, n in enumerate(explanation.free)}
        series.append(
            TermSeries(
                run.name,
                run.role,
                grid.time[at],
                value[at],
                smoothed.deviation[at, j],
                values_at_point,
                imitations,
            )
        )
    return tuple(series), units


def _imitated(explanation: SmoothedModel, parameters: Array, j: int) -> Array:
    """(N, Q) [unit of the term per unit of the parameter]: how much of term ``j`` acts as each free parameter does.

    Rates only are asked, weighed by the size of their states: what a parameter does to a signal at once, no term does.
    """
    slopes = explanation.problem.everything(explanation.smoothed.point.x, parameters)
    n = explanation.problem.model.states
    weight = 1 / explanation.problem.size
    unknown_input = slopes.by_unknown_input[:, :n, j] * weight
    free = slopes.by_parameter[:, :n] * weight[:, None]
    if not np.any(unknown_input):  # the term acts on a signal alone
        unknown_input, free = (
            slopes.by_unknown_input[:, n:, j] / explanation.problem.sigma,
            slopes.by_parameter[:, n:] / explanation.problem.sigma[:, None],
        )
    imitated: Array = (
        np.einsum("ki,kiq->kq", unknown_input, free)
        / np.maximum(np.sum(unknown_input**2, axis=1), 1e-300)[:, None]
    )
    return imitated


def _variables(augmented: AugmentedModel, unknown_input: UnknownInput) -> dict[str, str]:
    """Variables of the component that holds a term: short and full names."""
    prefix = unknown_input.parameter.rpartition(".")[0] + "."
    names = [
        n
        for n in augmented.ode.interface.locals
        if n.startswith(prefix) and "." not in n[len(prefix) :]
    ]
    return {n[len(prefix) :]: n for n in names}
