"""What a fit makes small: measured minus model in noise standard deviations."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison import RunComparison, simulate_run, slope, usual_square, weighted
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting.free import Free
from pam_cosim.fitting.tracker import Tracker
from pam_cosim.interface import sensitivity_name
from pam_cosim.measurement import DataSet, Run
from pam_cosim.names import is_ratio
from pam_cosim.simulation import AnySimulator


class Objective:
    """Residuals of some runs as a function of the search coordinates; those of the priors stand below them.

    Attributes:
        free: the parameters that are searched.
        size: number of samples. samples: how many these count for, fewer where they were rounded to coarse steps.
        ends: (runs + 1,) where the rows of each run begin, and the last ones end.
        series: run and signal of each part of the rows, in their order; ``kept``: which samples of each there are.
        tracker: is told of every point.
        evaluations: simulations of the whole set so far.
        failures: the first message of each kind of breakdown.
        tolerance: relative, of the solver.
    """

    def __init__(
        self,
        simulator: AnySimulator,
        data: DataSet,
        runs: Sequence[Run],
        free: Sequence[Free],
        fixed: Mapping[str, float] | None = None,
        tolerance: float | None = None,
        tracker: Tracker | None = None,
    ) -> None:
        self.tracker = tracker or Tracker()
        self._priors = [(i, f.prior) for i, f in enumerate(free) if f.prior is not None]
        self.simulator, self.data, self.runs, self.free = simulator, data, tuple(runs), tuple(free)
        self.fixed = dict(fixed or {})
        self.evaluations = 0
        self.failures: list[str] = []
        self._latest: tuple[bytes, Array, Array | None] | None = None  # where, residuals, exact Jacobian there
        self._signals = [
            [s for s, signal in data.signals.items() if signal.fitted and run.sample_count(s)] for run in self.runs
        ]
        self._told = [
            {name: self._told_slopes(run, name) for name in names}
            for run, names in zip(self.runs, self._signals, strict=True)
        ]
        self._outputs = [[*told, *(name for slopes in told.values() for _, name in slopes)] for told in self._told]
        self._exact = self._told_parameters()
        chosen = CRITERIA.fit.tolerance if all(self._exact) else CRITERIA.fit.difference_tolerance
        self.tolerance = chosen if tolerance is None else tolerance
        counts = [sum(run.sample_count(s) for s in names) for run, names in zip(self.runs, self._signals, strict=True)]
        self.size = sum(counts)
        self.series = [(run, s) for run, names in zip(self.runs, self._signals, strict=True) for s in names]
        self.kept = [np.isfinite(run.measurements[s]) for run, s in self.series]
        self.ends = np.cumsum([0, *counts])
        self.samples = sum(run.sample_count(s) * usual_square(data.signals[s]) for run, s in self.series)
        self._errors: dict[str, float] = {}

    @property
    def bounds(self) -> tuple[Array, Array]:
        """Lower and upper bounds in search coordinates."""
        low = np.array([f.to_z(f.low) for f in self.free])
        return low, np.array([f.to_z(f.high) for f in self.free])

    def values(self, z: Array) -> dict[str, float]:
        """Search coordinates to parameters by name, with the fixed ones [SI]."""
        return self.fixed | {f.name: f.to_value(float(c)) for f, c in zip(self.free, z, strict=True)}

    def _simulate(self, z: Array, outputs: Sequence[Sequence[str]], chosen: Sequence[int]) -> list[RunComparison]:
        """The chosen runs at ``z``. Raises SimulationFailure where one does not reach its end."""
        values = self.values(z)
        return [
            simulate_run(self.simulator, self.data, self.runs[i], values, self.tolerance, outputs[i]) for i in chosen
        ]

    def _moves(self, free: Free, run: Run) -> bool:
        """Whether a parameter acts on a run: one that is known for it, or is the run's own, does not."""
        if free.run:
            return free.run == run.name
        if is_ratio(free.name):
            return free.parameter in run.parameters
        own = any(f.run == run.name and f.parameter == free.parameter for f in self.free)
        return free.parameter not in run.parameters and not own

    def _told_slopes(self, run: Run, signal: str) -> list[tuple[int, str]]:
        """Number of each free parameter that moves a run, and the model's sensitivity of a signal to it, where told."""
        known = self.simulator.interface.sensitivities
        told = [(i, sensitivity_name(signal, f.parameter)) for i, f in enumerate(self.free) if self._moves(f, run)]
        return [(i, name) for i, name in told if name in known]

    def _told_parameters(self) -> list[bool]:
        """For each free parameter, whether the model tells its sensitivities."""
        known = self.simulator.interface.sensitivities
        return [
            all(sensitivity_name(s, f.parameter) in known for names in self._signals for s in names) for f in self.free
        ]

    def squares(self, z: Array) -> float:
        """The sum of squared residuals, simulated with slopes; infinite where a simulation breaks down."""
        residuals = self.residuals(z)
        return float(residuals @ residuals)

    def triangle(self, z: Array) -> Array:
        """The residuals linearised about ``z`` as few rows: the triangular factor of the slopes beside the residuals.

        (m, parameters + 1), m at most parameters + 1. The sum of squares is finite there.
        """
        residuals = self.residuals(z)
        return np.asarray(np.linalg.qr(np.column_stack([self.jacobian(z, residuals), residuals]), mode="r"))

    def residuals(self, z: Array) -> Array:
        """(size + priors,) in standard deviations; all infinite where a simulation breaks down."""
        if self._latest is not None and self._latest[0] == z.tobytes():
            return self._latest[1]
        self.evaluations += 1
        every = range(len(self.runs))
        try:
            runs = self._simulate(z, self._outputs, every)
        except SimulationFailure as failure:
            self._note(failure)
            return self._broken()
        residuals = self._with_priors(z, self._weighted(runs, every))
        self._saw(z, residuals)
        if np.all(np.isfinite(residuals)):
            self._latest = (z.tobytes(), residuals, self._exact_jacobian(z, runs) if any(self._exact) else None)
            return residuals
        return self._broken()

    def _broken(self) -> Array:
        return np.full(self.size + len(self._priors), np.inf)

    def _with_priors(self, z: Array, residuals: Array) -> Array:
        if not self._priors:
            return residuals
        off = [(prior.mean - self.free[i].to_value(float(z[i]))) / prior.sd for i, prior in self._priors]
        return np.append(residuals, off)

    def _saw(self, z: Array, residuals: Array) -> None:
        chi2 = float(residuals @ residuals) / max(self.samples, 1.0)
        self.tracker.saw(self.evaluations, chi2, lambda: self._errors, lambda: self.values(z))

    def cost(self, z: Array) -> float:
        """The squared residuals of all runs, without slopes; infinite where a simulation breaks down."""
        residuals = self.plain_residuals(z)
        self._saw(z, residuals)
        return float(residuals @ residuals) if np.all(np.isfinite(residuals)) else np.inf

    def plain_residuals(self, z: Array) -> Array:
        """As ``residuals``, simulated without slopes."""
        self.evaluations += 1
        return self._with_priors(z, self._without_slopes(z, range(len(self.runs))))

    def glance(self, z: Array) -> float:
        """The squared residuals of the first and the last run, which cost little and tell a good start from a bad one.

        Infinite where a simulation breaks down.
        """
        chosen = sorted({0, len(self.runs) - 1})
        residuals = self._with_priors(z, self._without_slopes(z, chosen))
        return float(residuals @ residuals) if np.all(np.isfinite(residuals)) else np.inf

    def _without_slopes(self, z: Array, chosen: Sequence[int]) -> Array:
        """Residuals of the chosen runs, infinite where one breaks down; what is known of the present point stays."""
        try:
            return self._weighted(self._simulate(z, self._signals, chosen), chosen)
        except SimulationFailure as failure:
            self._note(failure)
            return np.full(sum(self.ends[i + 1] - self.ends[i] for i in chosen), np.inf)

    @property
    def first_failure(self) -> str:
        """Why the model broke down first."""
        return self.failures[0] if self.failures else "the model gives no finite result"

    def _note(self, failure: SimulationFailure) -> None:
        if len(self.failures) < CRITERIA.fit.failures_kept:
            self.failures.append(str(failure))

    def _weighted(self, runs: Sequence[RunComparison], chosen: Sequence[int]) -> Array:
        parts, errors = [], defaultdict(list)
        for run, i in zip(runs, chosen, strict=True):
            for name in self._signals[i]:
                error = run.residual(name)[np.isfinite(run.run.measurements[name])]
                errors[name].append(error)
                parts.append(weighted(error, self.data.signals[name]))
        self._errors = {name: float(np.sqrt(np.mean(np.concatenate(e) ** 2))) for name, e in errors.items()}
        return np.concatenate(parts) if parts else np.zeros(0)

    def _exact_jacobian(self, z: Array, runs: Sequence[RunComparison]) -> Array:
        """(size + priors, parameters); columns of parameters whose sensitivities the model does not tell are zero."""
        jacobian = np.zeros((self.size + len(self._priors), len(self.free)))
        by_z = [free.slope(float(c)) for free, c in zip(self.free, z, strict=True)]
        row = 0
        for run, told in zip(runs, self._told, strict=True):
            for name, slopes in told.items():
                kept = np.isfinite(run.run.measurements[name])
                count = int(kept.sum())
                by_error = slope(run.residual(name)[kept], self.data.signals[name])
                for i, sensitivity in slopes:
                    moved = by_z[i] * self.free[i].size_in(run.run)
                    jacobian[row : row + count, i] = -by_error * run.model[sensitivity][kept] * moved
                row += count
        for k, (i, prior) in enumerate(self._priors):
            jacobian[self.size + k, i] = -self.free[i].slope(float(z[i])) / prior.sd
        return jacobian

    def jacobian(self, z: Array, at: Array) -> Array:
        """(size + priors, parameters) by the model's sensitivities, or by differences where it has none.

        Args:
            z: (parameters,) search coordinates.
            at: (size + priors,) the residuals there.
        """
        told, exact = self._exact, self._exact_at(z)
        columns = [self._difference(z, at, i) if exact is None or not told[i] else exact[:, i] for i in range(len(z))]
        return np.column_stack(columns) if columns else np.zeros((len(at), 0))

    def _exact_at(self, z: Array) -> Array | None:
        """The exact Jacobian at ``z``; None where the model has no sensitivities or breaks down."""
        if not any(self._exact):
            return None
        self.residuals(z)
        return self._latest[2] if self._latest is not None and self._latest[0] == z.tobytes() else None

    def _difference(self, z: Array, at: Array, i: int) -> Array:
        """One column by a difference, stepping inwards from a bound; only the runs are simulated that move.

        A direction in which the simulation breaks down is tried the other way; if that fails too, the column is
        zero: the fit does not move there.
        """
        low, high = self.bounds
        step = CRITERIA.fit.difference_step * max(1.0, abs(z[i]) if not self.free[i].logarithmic else 1.0)
        forward = step if z[i] + step <= high[i] else -step
        chosen = [k for k, run in enumerate(self.runs) if self._moves(self.free[i], run)]
        for h in (forward, -forward):
            moved = z.copy()
            moved[i] = min(max(z[i] + h, low[i]), high[i])
            if moved[i] == z[i]:
                continue
            self.evaluations += 1
            shifted = at.copy()
            rows = [np.arange(self.ends[k], self.ends[k + 1]) for k in chosen]
            shifted[np.concatenate(rows) if rows else np.zeros(0, int)] = self._without_slopes(moved, chosen)
            shifted = self._with_priors(moved, shifted[: self.size])
            if np.all(np.isfinite(shifted)):
                column: Array = (shifted - at) / (moved[i] - z[i])
                return column
        return np.zeros(len(at))
