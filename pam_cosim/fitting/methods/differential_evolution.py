"""Differential evolution by SciPy, and a descent from the best point that it comes to."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.optimize import differential_evolution

from pam_cosim.arrays import Array
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting.methods.global_search import GlobalSearch, searched
from pam_cosim.fitting.methods.solution import Solution
from pam_cosim.fitting.solve import FitProblem, solve

MEMBERS = 5  # for each parameter
GENERATIONS = 40


def minimise(problem: FitProblem) -> Solution:
    """From where differential evolution (SciPy) over the bounds comes to, which is reported as it left it.

    Raises:
        SimulationFailure: the model breaks down wherever it was tried.
    """
    search = differential_evolution_search(problem)
    return Solution(solve(replace(problem, starts=[search.parameters])), search)


def differential_evolution_search(problem: FitProblem) -> GlobalSearch:
    """Differential evolution before any descent; the same every time.

    Raises:
        SimulationFailure: the model breaks down wherever it was tried.
    """
    objective = problem.objective
    before = objective.evaluations
    costs: list[float] = []

    def cost(z: Array) -> float:
        costs.append(objective.cost(z))
        return costs[-1]

    solution = differential_evolution(
        cost,
        list(zip(*objective.bounds, strict=True)),
        popsize=MEMBERS,
        maxiter=GENERATIONS,
        init="sobol",
        seed=0,
        polish=False,
    )
    if not np.isfinite(solution.fun):
        raise SimulationFailure(
            f"no point within the bounds can be simulated: {objective.first_failure}"
        )
    members = len(solution.population)  # each generation computes the cost of as many points
    lowest = np.minimum.accumulate(costs)[members - 1 :: members]
    return searched("differential evolution", objective, np.asarray(solution.x), lowest, before)
