"""From start points to the lowest residuals: descents from the best starts, until the noise is reached."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting.free import Free
from pam_cosim.fitting.levenberg_marquardt import Minimum, levenberg_marquardt
from pam_cosim.fitting.objective import Objective
from pam_cosim.fitting.options import FitOptions


@dataclass(frozen=True)
class FitProblem:
    """What a method has to solve.

    Attributes:
        objective: residuals and slopes as a function of the search coordinates.
        starts: points to start from, by name [SI], the parameters' own start values first.
        options: how the fit goes.
    """

    objective: Objective
    starts: Sequence[Mapping[str, float]]
    options: FitOptions


def solve(problem: FitProblem) -> Minimum:
    """The lowest point that descents from the best starts come to.

    Raises:
        SimulationFailure: the model breaks down at every start.
    """
    objective, options = problem.objective, problem.options
    best: Minimum | None = None
    points = _points(objective.free, problem.starts)
    starts = _starts(objective, points)
    if min(len(points), options.screened_starts) > options.descents:
        starts = _winners(problem, starts)
    for start in itertools.islice(starts, options.descents):
        reached = _minimise(problem, start)
        objective.tracker.descents.append(reached.cost / max(objective.samples, 1.0))
        if best is None or reached.cost < best.cost:
            best = reached
        if objective.is_over() or (objective.is_at_noise(best.cost) and not options.starts):
            break  # no other initial guess can improve it, or no time remains
    return best or _minimise(problem, _rescue(objective))


def spread_starts(
    free: Sequence[Free], count: int = CRITERIA.fit.spread_starts
) -> list[dict[str, float]]:
    """Start values spread evenly over the bounds by a Sobol sequence; the same ones every time."""
    if not free:
        return []
    from scipy.stats import qmc  # half a second, which few need

    points = qmc.Sobol(len(free), seed=0).random_base2(max(count - 1, 0).bit_length())[:count]
    ends = [(f.to_z(f.low), f.to_z(f.high)) for f in free]
    return [
        {
            f.name: f.to_value(low + u * (high - low))
            for f, (low, high), u in zip(free, ends, point, strict=True)
        }
        for point in points
    ]


def _points(free: Sequence[Free], starts: Sequence[Mapping[str, float]]) -> list[Array]:
    """Search coordinates of the starts, within the bounds, each point once."""
    points: list[Array] = []
    for start in starts:
        values = {f.name: start.get(f.name, f.start) for f in free}
        z = np.array([f.to_z(min(max(values[f.name], f.low), f.high)) for f in free])
        if not any(np.array_equal(z, other) for other in points):
            points.append(z)
    return points


def _starts(objective: Objective, points: Sequence[Array]) -> Iterator[Array]:
    """The points at which every run can be simulated, the best first by the residuals of two runs.

    A glance does not see what acts in the other runs: the stated start goes first where all runs say so.
    """
    scored = [
        (objective.glance(z) if len(points) > 1 else 0.0, i)
        for i, z in enumerate(points)
        if not (i and objective.is_over())
    ]
    order = [i for score, i in sorted(scored) if np.isfinite(score)]
    if (
        order
        and order[0]
        and 0 in order
        and objective.squares(points[0]) < objective.squares(points[order[0]])
    ):
        order = [0, *(i for i in order if i)]
    for i in order:
        objective.start_afresh(points[i])
        if np.isfinite(objective.squares(points[i])):
            yield points[i]


def _winners(problem: FitProblem, starts: Iterator[Array]) -> Iterator[Array]:
    """Where a few steps from the best initial guesses lead, the lowest first: two runs do not distinguish local minima.

    Once one leads to the noise, no further one is tried.
    """
    options = problem.options
    screening_problem = replace(
        problem, options=replace(options, evaluations=CRITERIA.fit.screening_evaluations)
    )
    ends: list[Minimum] = []
    for start in itertools.islice(starts, options.screened_starts):
        ends.append(_minimise(screening_problem, start))
        if problem.objective.is_at_noise(ends[-1].cost) or problem.objective.is_over():
            break
    yield from (d.z for d in sorted(ends, key=lambda d: d.cost))


def _rescue(objective: Objective) -> Array:
    """The first of a fixed sequence of points within the bounds at which the model runs."""
    low, high = objective.bounds
    if len(low):
        from scipy.stats import qmc

        for u in qmc.Sobol(len(low), seed=0).random(CRITERIA.fit.rescue_starts):
            z: Array = low + u * (high - low)
            if np.isfinite(objective.squares(z)):
                return z
    raise SimulationFailure(
        f"no start value within the bounds can be simulated: {objective.first_failure}"
    )


def _minimise(problem: FitProblem, start: Array) -> Minimum:
    objective = problem.objective
    if not len(start):
        return Minimum(objective.squares(start), start, np.zeros((objective.size, 0)))
    reached = _descend(problem, start)
    for _ in range(CRITERIA.starts.steps if problem.options.second_look else 0):
        if objective.is_at_noise(reached.cost) or objective.is_over():
            break
        if not objective.found_other_starts(reached.z):
            break
        reached = _descend(problem, reached.z)
    return reached


def _descend(problem: FitProblem, start: Array) -> Minimum:
    objective, options = problem.objective, problem.options
    return levenberg_marquardt(
        objective.squares,
        objective.triangle,
        start,
        objective.bounds,
        options.precision,
        options.evaluations,
        objective.is_over,
    )
