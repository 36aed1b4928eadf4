"""Descents from points all over the bounds."""

from dataclasses import replace

from pam_cosim.fitting.methods.solution import Solution
from pam_cosim.fitting.solve import Problem, solve, spread_starts


def minimise(problem: Problem) -> Solution:
    """From points spread over the bounds too."""
    spread = spread_starts(problem.objective.free)
    return Solution(solve(replace(problem, starts=[*problem.starts, *spread])))
