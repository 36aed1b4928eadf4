"""Descents from the start values."""

from pam_cosim.fitting.methods.solution import Solution
from pam_cosim.fitting.solve import FitProblem, solve


def minimise(problem: FitProblem) -> Solution:
    """From the start values."""
    return Solution(solve(problem))
