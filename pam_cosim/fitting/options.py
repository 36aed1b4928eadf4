"""Options of a fit."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import dataclass

from pam_cosim.criteria import CRITERIA
from pam_cosim.simulation import Simulator


@dataclass(frozen=True)
class FitOptions:
    """Options of a fit; the defaults suit a single fit.

    Attributes:
        method: name of the method, as in ``fitting.METHODS``.
        evaluations: of each descent, at most.
        descents: how many of all starts are followed to their ends, the best first; each further one only where those
            before did not reach the noise.
        screened_starts: how many of all starts go a few steps first, so that those are followed which came farthest;
            0: none.
        starts: points spread over the bounds that the method "multi-start" follows, each to its end; 0: those that
            promise most, until the noise is reached.
        tolerance: relative, of the solver; None: tight enough for the noise and for finite differences.
        precision: a descent ends where a step takes away less than this part of the chi-square.
        rows: of the linearised model about the optimum that the fit keeps; 0: none is kept.
        second_look: whether start values of runs are estimated again where a descent ends above the noise.
        rules: whether to say where the error sits.
        holdout_uncertainty: whether to say what held-out runs gain as far as the parameters are uncertain.
        simulations: runs that are simulated, after which no descent continues.
        deadline: of ``time.monotonic`` [s], likewise.
    """

    method: str = "least-squares"
    evaluations: int = CRITERIA.fit.evaluations
    descents: int = 1
    screened_starts: int = CRITERIA.fit.screened_starts
    starts: int = 0
    tolerance: float | None = None
    precision: float = CRITERIA.fit.precision
    rows: int = 0
    second_look: bool = True
    rules: bool = True
    holdout_uncertainty: bool = False
    simulations: float = math.inf
    deadline: float = math.inf

    def limit(self) -> Callable[[], bool]:
        """Whether a fit that begins now has reached one of its limits when it is asked."""
        before = Simulator.simulations

        def is_over() -> bool:
            simulated = Simulator.simulations - before
            return simulated >= self.simulations or time.monotonic() >= self.deadline

        return is_over
