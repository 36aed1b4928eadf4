"""Particle swarm search as Dzahir and Yamamoto (2019), Table 1, use it: 50 particles, 10 generations, v1 = v2 = 1.5."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting.methods.global_search import GlobalSearch, searched
from pam_cosim.fitting.methods.solution import Solution
from pam_cosim.fitting.solve import FitProblem, solve

PARTICLES = 50
GENERATIONS = 10
OWN_PULL = 1.5  # v1, towards a particle's own best point
COMMON_PULL = 1.5  # v2, towards the best point of all
INERTIA = 0.73  # not printed; with pulls of 1.5 it is the value that makes a swarm converge (Clerc and Kennedy 2002)


@dataclass(frozen=True)
class Swarm:
    """The result of a swarm.

    Attributes:
        best: (k,) the best point that any particle has been at.
        costs: (generations + 1,) lowest cost so far: of the random particles, then after each generation.
    """

    best: Array
    costs: Array


def swarm(
    cost: Callable[[Array], float],
    low: Array,
    high: Array,
    *,
    particles: int = PARTICLES,
    generations: int = GENERATIONS,
    seed: int = 0,
) -> Swarm:
    """The best point found between the bounds, and how the cost fell; the same every time.

    Args:
        cost: what to make small; infinite where it cannot be computed.
        low, high: (k,) bounds.
        particles, generations: size of the search.
        seed: of the random numbers.
    """
    random = np.random.default_rng(seed)
    span = high - low
    at = low + random.random((particles, len(low))) * span
    velocity = (random.random(at.shape) - 0.5) * span
    costs = np.array([cost(z) for z in at])
    best_places, own_costs = at.copy(), costs.copy()
    lowest = [float(own_costs.min())]
    for _ in range(generations):
        best = best_places[int(np.argmin(own_costs))]
        pull = OWN_PULL * random.random(at.shape) * (
            best_places - at
        ) + COMMON_PULL * random.random(at.shape) * (best - at)
        velocity = INERTIA * velocity + pull
        at = np.clip(at + velocity, low, high)
        costs = np.array([cost(z) for z in at])
        better = costs < own_costs
        best_places[better], own_costs[better] = at[better], costs[better]
        lowest.append(float(own_costs.min()))
    return Swarm(best_places[int(np.argmin(own_costs))], np.array(lowest))


def minimise(problem: FitProblem) -> Solution:
    """From the best particle of a swarm over the bounds, which is reported as the swarm left it.

    Raises:
        SimulationFailure: the model breaks down at every particle.
    """
    search = swarm_search(problem)
    return Solution(solve(replace(problem, starts=[search.parameters])), search)


def swarm_search(problem: FitProblem) -> GlobalSearch:
    """The search of Dzahir and Yamamoto (2019), Table 1, before any descent.

    Raises:
        SimulationFailure: the model breaks down at every particle.
    """
    objective = problem.objective
    before = objective.evaluations
    optimum = swarm(objective.cost, *objective.bounds)
    if not np.isfinite(optimum.costs[-1]):
        raise SimulationFailure(
            f"no particle of the swarm can be simulated: {objective.first_failure}"
        )
    return searched(
        f"swarm of {PARTICLES} particles", objective, optimum.best, optimum.costs, before
    )
