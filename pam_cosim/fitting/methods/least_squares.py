"""Descents from the start values."""

from pam_cosim.fitting.methods.solution import Solution
from pam_cosim.fitting.solve import Problem, solve


def minimise(problem: Problem) -> Solution:
    """From the start values."""
    return Solution(solve(problem))
