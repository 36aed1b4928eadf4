"""Particle swarm search as Dzahir and Yamamoto (2019), Table 1, use it: 50 particles, 10 generations, v1 = v2 = 1.5."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting.methods.solution import Record, Solution
from pam_cosim.fitting.solve import FitProblem, solve

PARTICLES = 50
GENERATIONS = 10
OWN_PULL = 1.5  # v1, towards a particle's own best point
COMMON_PULL = 1.5  # v2, towards the best point of all
INERTIA = 0.73  # not printed; with pulls of 1.5 it is the value that makes a swarm converge (Clerc and Kennedy 2002)


@dataclass(frozen=True)
class Swarm:
    """What a swarm saw.

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
    own, own_costs = at.copy(), costs.copy()
    lowest = [float(own_costs.min())]
    for _ in range(generations):
        best = own[int(np.argmin(own_costs))]
        pull = OWN_PULL * random.random(at.shape) * (own - at) + COMMON_PULL * random.random(
            at.shape
        ) * (best - at)
        velocity = INERTIA * velocity + pull
        at = np.clip(at + velocity, low, high)
        costs = np.array([cost(z) for z in at])
        better = costs < own_costs
        own[better], own_costs[better] = at[better], costs[better]
        lowest.append(float(own_costs.min()))
    return Swarm(own[int(np.argmin(own_costs))], np.array(lowest))


@dataclass(frozen=True)
class SwarmSearch(Record):
    """What a particle swarm did by itself, before any descent.

    Attributes:
        parameters: the swarm's own best particle, by name [unit].
        units: SI units, by name.
        chi2_reduced: the lowest so far: of the random particles, then after each generation.
        particles: size of the swarm.
        evaluations: simulations of the set of fit runs that it took.
    """

    parameters: dict[str, float]
    units: dict[str, str]
    chi2_reduced: tuple[float, ...]
    particles: int
    evaluations: int

    @property
    def generations(self) -> int:
        """After the random particles."""
        return len(self.chi2_reduced) - 1

    def as_dict(self) -> dict[str, object]:
        """Plain data for JSON, SI units."""
        return {
            "best_particle": {
                n: {"value": v, "unit": self.units[n]} for n, v in self.parameters.items()
            },
            "chi2_reduced": self.chi2_reduced[-1],
            "chi2_by_generation": list(self.chi2_reduced),
            "particles": self.particles,
            "generations": self.generations,
            "evaluations": self.evaluations,
        }

    def __str__(self) -> str:
        first, *later = (f"{c:.4g}" for c in self.chi2_reduced)
        lines = [
            f"  swarm of {self.particles} particles: chi2 {first} of the random ones, then by generation "
            + ", ".join(later),
            f"  its own best particle, chi2 {self.chi2_reduced[-1]:.4g}:",
        ]
        for name, value in self.parameters.items():
            unit = "" if self.units[name] == "1" else self.units[name]
            lines.append(f"    {name} = {value:.4g} {unit}".rstrip())
        return "\n".join(lines)


def minimise(problem: FitProblem) -> Solution:
    """From the best particle of a swarm over the bounds, which is reported as the swarm left it.

    Raises:
        SimulationFailure: the model breaks down at every particle.
    """
    search = swarm_search(problem)
    return Solution(solve(replace(problem, starts=[search.parameters])), search)


def swarm_search(problem: FitProblem) -> SwarmSearch:
    """What the swarm finds by itself, as Dzahir and Yamamoto (2019), Table 1.

    Raises:
        SimulationFailure: the model breaks down at every particle.
    """
    objective = problem.objective
    before = objective.evaluations
    seen = swarm(objective.cost, *objective.bounds)
    if not np.isfinite(seen.costs[-1]):
        raise SimulationFailure(
            f"no particle of the swarm can be simulated: {objective.first_failure}"
        )
    best = {f.name: f.to_value(float(z)) for f, z in zip(objective.free, seen.best, strict=True)}
    costs = tuple(float(c) / max(objective.samples, 1.0) for c in seen.costs)
    units = {f.name: f.unit for f in objective.free}
    return SwarmSearch(best, units, costs, PARTICLES, objective.evaluations - before)
