"""Descents from points all over the bounds."""

from dataclasses import replace

from pam_cosim.fitting.methods.solution import Solution
from pam_cosim.fitting.solve import FitProblem, solve, spread_starts


def minimise(problem: FitProblem) -> Solution:
    """From points spread over the bounds too."""
    options, free = problem.options, problem.objective.free
    spread = spread_starts(free, options.starts) if options.starts else spread_starts(free)
    starts = [*problem.starts, *spread]
    chosen = replace(options, descents=len(starts)) if options.starts else options
    return Solution(solve(replace(problem, starts=starts, options=chosen)))
