"""Least squares weighted by the noise, bounded, from several starts."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.stats import qmc

from pam_cosim.arrays import Array
from pam_cosim.comparison import Comparison, compare
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting.combinations import Combination, combinations
from pam_cosim.fitting.descent import Descent, descend
from pam_cosim.fitting.estimate import Estimate, describe, estimates
from pam_cosim.fitting.free import Free, base_parameters
from pam_cosim.fitting.objective import Objective
from pam_cosim.fitting.structure import Structure, series_of, stated_of, structure
from pam_cosim.fitting.swarm import PARTICLES, swarm
from pam_cosim.measurement import ROLES, DataSet, Run
from pam_cosim.simulation import AnySimulator

Progress = Callable[[int, float], None]


@dataclass(frozen=True)
class SwarmSearch:
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
            "best_particle": {n: {"value": v, "unit": self.units[n]} for n, v in self.parameters.items()},
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


@dataclass(frozen=True)
class Fit:
    """A model with its free parameters fitted to the fit runs of a data set.

    Attributes:
        model: name of the model.
        parameters: estimates by name.
        comparison: the fitted model against all runs.
        structure: what the residuals are like, per role ("fit", "holdout").
        evaluations: simulations of the set of fit runs that it took.
        failures: breakdowns of the simulation on the way, in the words of the solver.
        combinations: pairs of parameters of which only the product or the ratio is determined.
        swarm: what a particle swarm did before the descent, where one was asked for.
    """

    model: str
    parameters: dict[str, Estimate]
    comparison: Comparison
    structure: dict[str, Structure]
    evaluations: int
    failures: tuple[str, ...] = ()
    combinations: tuple[Combination, ...] = ()
    swarm: SwarmSearch | None = None

    @property
    def values(self) -> dict[str, float]:
        """Fitted parameters [SI] by name."""
        return {name: e.value for name, e in self.parameters.items()}

    @property
    def freedom(self) -> int:
        """Number of parameters that the data determine."""
        return sum(e.determined for e in self.parameters.values())

    def as_dict(self) -> dict[str, object]:
        """Plain data for JSON, SI units."""
        return {
            "model": self.model,
            "parameters": {n: e.as_dict() for n, e in self.parameters.items()},
            "evaluations": self.evaluations,
            "failures": list(self.failures),
            "combinations": [c.as_dict() for c in self.combinations],
            "swarm": self.swarm.as_dict() if self.swarm else None,
            "chi2_reduced": self.structure["fit"].chi2_reduced,
            "comparison": self.comparison.as_dict(),
        }

    def __str__(self) -> str:
        lines = [str(self.comparison)]
        if self.swarm:
            reached = self.structure["fit"].chi2_reduced
            lines += [str(self.swarm), f"  the descent from there comes to chi2 {reached:.4g}:"]
        return "\n".join([*lines, describe(self.parameters), *(f"  {c}" for c in self.combinations)])


def fit(
    simulator: AnySimulator,
    data: DataSet,
    free: Sequence[Free] | None = None,
    *,
    fixed: Mapping[str, float] | None = None,
    starts: Sequence[Mapping[str, float]] = (),
    runs: Sequence[Run] | None = None,
    progress: Progress | None = None,
    most_evaluations: int = CRITERIA.fit.evaluations,
    follow: int = 2,
    heats: int = 0,
    tolerance: float | None = None,
    precision: float = CRITERIA.fit.precision,
) -> Fit:
    """Fits ``free`` (default: what the data set declares under [fit]) to the fit runs.

    Args:
        simulator: the model.
        data: the measurement; every signal needs a noise level.
        free: parameters to move.
        fixed: further parameter values [SI].
        starts: further points to start from, by name [SI].
        runs: default ``data.fit_runs``.
        progress: called with the number of evaluations and the present reduced chi-square.
        most_evaluations: of each descent.
        follow: how many of all starts are followed, the best first; each further one only where those before did
            not reach the noise.
        heats: how many of all starts make a few steps first, so that those are followed which came farthest; 0: none.
        tolerance: relative, of the solver; default: tight enough for the noise and for finite differences.
        precision: a descent ends where a step takes away less than this part of the chi-square.

    Raises:
        SimulationFailure: the model breaks down at every start.
        InputError: a parameter that the model does not have.
    """
    chosen = tuple(base_parameters(data, simulator.interface) if free is None else free)
    objective = Objective(simulator, data, data.fit_runs if runs is None else runs, chosen, fixed, tolerance)
    how = _How(most_evaluations, precision, progress, follow, heats)
    found = _solve(objective, _start_points(chosen, starts), how)
    comparison = compare(simulator, data, objective.values(found.z), objective.tolerance)
    by_role = structures(comparison)
    spread = _spread(by_role["fit"])
    parameters = estimates(chosen, found.z, found.jacobian, objective.bounds, spread)
    return Fit(
        simulator.interface.model,
        parameters,
        comparison,
        by_role,
        objective.evaluations,
        tuple(dict.fromkeys(objective.failures)),
        combinations(objective, found.z, found.jacobian, parameters, spread),
    )


def structures(comparison: Comparison) -> dict[str, Structure]:
    """What the residuals of a comparison are like, per role ("fit", "holdout")."""
    signals = comparison.data.signals
    sigma = {n: s.sigma for n, s in signals.items() if s.fitted and s.sigma}
    found: dict[str, Structure] = {}
    for role in ROLES:
        runs = [r for r in comparison.runs if r.run.role == role]
        found[role] = structure(series_of(runs, sigma), stated_of(runs, signals))
    return found


def swarm_search(
    simulator: AnySimulator,
    data: DataSet,
    free: Sequence[Free],
    fixed: Mapping[str, float] | None = None,
    progress: Progress | None = None,
) -> SwarmSearch:
    """A particle swarm over the bounds, as Dzahir and Yamamoto (2019), Table 1; its best is a start for ``fit``.

    Raises:
        SimulationFailure: the model breaks down at every particle.
    """
    objective = Objective(simulator, data, data.fit_runs, free, fixed)
    size = max(objective.size, 1)
    lowest = np.inf

    def cost(z: Array) -> float:
        nonlocal lowest
        here = objective.cost(z)
        lowest = min(lowest, here)
        if progress is not None and np.isfinite(lowest):
            progress(objective.evaluations, lowest / size)
        return here

    seen = swarm(cost, *objective.bounds)
    if not np.isfinite(seen.costs[-1]):
        reason = objective.failures[0] if objective.failures else "the model gives no finite result"
        raise SimulationFailure(f"no particle of the swarm can be simulated: {reason}")
    best = {f.name: f.to_value(float(z)) for f, z in zip(free, seen.best, strict=True)}
    costs = tuple(float(c) / size for c in seen.costs)
    return SwarmSearch(best, {f.name: f.unit for f in free}, costs, PARTICLES, objective.evaluations)


def spread_starts(free: Sequence[Free], count: int = 16) -> list[dict[str, float]]:
    """Start values spread evenly over the bounds by a Sobol sequence; the same ones every time."""
    if not free:
        return []
    points = qmc.Sobol(len(free), seed=0).random(count)
    reach = [(f.to_z(f.low), f.to_z(f.high)) for f in free]
    return [
        {f.name: f.to_value(low + u * (high - low)) for f, (low, high), u in zip(free, reach, point, strict=True)}
        for point in points
    ]


def _spread(s: Structure) -> float:
    """Residuals beyond the declared noise, and correlated ones, widen the intervals."""
    time = s.correlation_time if s.score > CRITERIA.residuals.correlated else 1.0
    return float(np.sqrt(max(1.0, s.chi2_reduced) * time))


def _start_points(free: Sequence[Free], starts: Sequence[Mapping[str, float]]) -> list[Array]:
    points = [{f.name: f.start for f in free}]
    points += [{f.name: start.get(f.name, f.start) for f in free} for start in starts]
    found: list[Array] = []
    for p in points:
        z = np.array([f.to_z(min(max(p[f.name], f.low), f.high)) for f in free])
        if not any(np.array_equal(z, other) for other in found):
            found.append(z)
    return found


@dataclass(frozen=True)
class _How:
    """How a descent goes; see ``fit``."""

    most_evaluations: int
    precision: float
    progress: Progress | None
    follow: int
    heats: int


def _solve(objective: Objective, points: list[Array], how: _How) -> Descent:
    best: Descent | None = None
    starts = _starts(objective, points)
    if how.heats > how.follow:
        starts = _winners(objective, starts, how)
    for start in itertools.islice(starts, how.follow):
        found = _descend(objective, start, how)
        if best is None or found.cost < best.cost:
            best = found
        if best.cost <= CRITERIA.fit.at_noise * objective.size:
            break  # nothing is left that another start could find
    return best or _descend(objective, _rescue(objective), how)


def _starts(objective: Objective, points: Sequence[Array]) -> Iterator[Array]:
    """The points at which every run can be simulated, the best first as far as a glance tells."""
    scored = [(objective.glance(z) if len(points) > 1 else 0.0, i) for i, z in enumerate(points)]
    for score, i in sorted(scored):
        if np.isfinite(score) and np.isfinite(_cost(objective.residuals(points[i]))):
            yield points[i]


def _winners(objective: Objective, starts: Iterator[Array], how: _How) -> Iterator[Array]:
    """Where a few steps from the best starts lead, the lowest first: a glance does not tell one valley from another."""
    few = replace(how, most_evaluations=CRITERIA.fit.screening_evaluations)
    ends = [_descend(objective, start, few) for start in itertools.islice(starts, how.heats)]
    yield from (d.z for d in sorted(ends, key=lambda d: d.cost))


def _cost(residuals: Array) -> float:
    return float(residuals @ residuals)


def _rescue(objective: Objective) -> Array:
    """The first of a fixed sequence of points within the bounds at which the model runs."""
    low, high = objective.bounds
    if len(low):
        for u in qmc.Sobol(len(low), seed=0).random(CRITERIA.fit.rescue_starts):
            z: Array = low + u * (high - low)
            if np.isfinite(_cost(objective.residuals(z))):
                return z
    reason = objective.failures[0] if objective.failures else "the model gives no finite result"
    raise SimulationFailure(f"no start value within the bounds can be simulated: {reason}")


def _descend(objective: Objective, start: Array, how: _How) -> Descent:
    def residuals(z: Array) -> Array:
        e = objective.residuals(z)
        if how.progress is not None and np.all(np.isfinite(e)):
            how.progress(objective.evaluations, _cost(e) / max(len(e), 1))
        return e

    def jacobian(z: Array) -> Array:
        return objective.jacobian(z, objective.residuals(z))

    if not len(start):
        e = objective.residuals(start)
        return Descent(_cost(e), start, np.zeros((len(e), 0)))
    return descend(residuals, jacobian, start, objective.bounds, how.precision, how.most_evaluations)
