"""Differential evolution by SciPy, and a descent from the best point that it comes to."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.optimize import differential_evolution

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
    """What differential evolution finds by itself; the same every time.

    Raises:
        SimulationFailure: the model breaks down wherever it was tried.
    """
    objective = problem.objective
    before, lowest = objective.evaluations, [np.inf]

    def cost(z: np.ndarray) -> float:
        here = objective.cost(z)
        lowest[-1] = min(lowest[-1], here)
        return here

    solution = differential_evolution(
        cost,
        list(zip(*objective.bounds, strict=True)),
        popsize=MEMBERS,
        maxiter=GENERATIONS,
        init="sobol",
        seed=0,
        polish=False,
        callback=lambda *_: lowest.append(lowest[-1]),
    )
    if not np.isfinite(solution.fun):
        raise SimulationFailure(
            f"no point within the bounds can be simulated: {objective.first_failure}"
        )
    return searched("differential evolution", objective, np.asarray(solution.x), lowest, before)
