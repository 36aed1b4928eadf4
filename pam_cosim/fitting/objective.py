"""What a fit makes small: measured minus model in noise standard deviations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison import RunComparison, simulate_run
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting.free import Free
from pam_cosim.interface import sensitivity_name
from pam_cosim.measurement import DataSet, Run
from pam_cosim.simulation import AnySimulator


class Objective:
    """Residuals of some runs as a function of the search coordinates.

    Attributes:
        free: the parameters that are searched.
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
    ) -> None:
        self.simulator, self.data, self.runs, self.free = simulator, data, tuple(runs), tuple(free)
        self.fixed = dict(fixed or {})
        self.evaluations = 0
        self.failures: list[str] = []
        self._latest: tuple[bytes, Array, Array | None] | None = None  # where, residuals, exact Jacobian there
        self._signals = [
            [s for s, signal in data.signals.items() if signal.fitted and run.sample_count(s)] for run in self.runs
        ]
        self._outputs = [
            [*names, *self._slopes(run, names)] for run, names in zip(self.runs, self._signals, strict=True)
        ]
        self._exact = self._told_parameters()
        chosen = CRITERIA.fit.tolerance if all(self._exact) else CRITERIA.fit.difference_tolerance
        self.tolerance = chosen if tolerance is None else tolerance
        self.size = sum(run.sample_count(s) for run, names in zip(self.runs, self._signals, strict=True) for s in names)

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

    def _slopes(self, run: Run, signals: Sequence[str]) -> list[str]:
        """The model's sensitivities of these signals; a parameter that is known for the run does not move it."""
        known = self.simulator.interface.sensitivities
        moved = [f.name for f in self.free if f.name not in run.parameters]
        return [n for s in signals for f in moved if (n := sensitivity_name(s, f)) in known]

    def _told_parameters(self) -> list[bool]:
        """For each free parameter, whether the model tells its sensitivities."""
        known = self.simulator.interface.sensitivities
        return [all(sensitivity_name(s, f.name) in known for names in self._signals for s in names) for f in self.free]

    def residuals(self, z: Array) -> Array:
        """(size,) in noise standard deviations; all infinite where a simulation breaks down."""
        if self._latest is not None and self._latest[0] == z.tobytes():
            return self._latest[1]
        self.evaluations += 1
        every = range(len(self.runs))
        try:
            runs = self._simulate(z, self._outputs, every)
        except SimulationFailure as failure:
            self._note(failure)
            return np.full(self.size, np.inf)
        residuals = self._weighted(runs, every)
        if np.all(np.isfinite(residuals)):
            self._latest = (z.tobytes(), residuals, self._exact_jacobian(z, runs) if any(self._exact) else None)
            return residuals
        return np.full(self.size, np.inf)

    def cost(self, z: Array) -> float:
        """The squared residuals of all runs, without slopes; infinite where a simulation breaks down."""
        self.evaluations += 1
        residuals = self._without_slopes(z, range(len(self.runs)))
        return float(residuals @ residuals) if np.all(np.isfinite(residuals)) else np.inf

    def glance(self, z: Array) -> float:
        """The squared residuals of the first and the last run, which cost little and tell a good start from a bad one.

        Infinite where a simulation breaks down.
        """
        chosen = sorted({0, len(self.runs) - 1})
        residuals = self._without_slopes(z, chosen)
        return float(residuals @ residuals) if np.all(np.isfinite(residuals)) else np.inf

    def _without_slopes(self, z: Array, chosen: Sequence[int]) -> Array:
        """Residuals of the chosen runs, infinite where one breaks down; what is known of the present point stays."""
        try:
            return self._weighted(self._simulate(z, self._signals, chosen), chosen)
        except SimulationFailure as failure:
            self._note(failure)
            return np.full(self.size, np.inf)

    @property
    def first_failure(self) -> str:
        """Why the model broke down first."""
        return self.failures[0] if self.failures else "the model gives no finite result"

    def _note(self, failure: SimulationFailure) -> None:
        if len(self.failures) < CRITERIA.fit.failures_kept:
            self.failures.append(str(failure))

    def _weighted(self, runs: Sequence[RunComparison], chosen: Sequence[int]) -> Array:
        parts = []
        for run, i in zip(runs, chosen, strict=True):
            for name in self._signals[i]:
                residual = run.residual(name)
                sigma = self.data.signals[name].sigma
                assert sigma is not None, "fits need a noise level; see measurement.with_noise"
                parts.append(residual[np.isfinite(run.run.measurements[name])] / sigma)
        return np.concatenate(parts) if parts else np.zeros(0)

    def _exact_jacobian(self, z: Array, runs: Sequence[RunComparison]) -> Array:
        """(size, parameters); columns of parameters whose sensitivities the model does not tell are zero."""
        jacobian = np.zeros((self.size, len(self.free)))
        row = 0
        for run, names in zip(runs, self._signals, strict=True):
            for name in names:
                sigma = self.data.signals[name].sigma
                assert sigma is not None
                kept = np.isfinite(run.run.measurements[name])
                count = int(kept.sum())
                for i, free in enumerate(self.free):
                    slope = run.model.get(sensitivity_name(name, free.name))
                    if slope is not None:
                        jacobian[row : row + count, i] = -slope[kept] * free.slope(float(z[i])) / sigma
                row += count
        return jacobian

    def jacobian(self, z: Array, at: Array) -> Array:
        """(size, parameters) by the model's sensitivities, or by differences where it has none.

        Args:
            z: (parameters,) search coordinates.
            at: (size,) the residuals there.
        """
        told, exact = self._exact, self._exact_at(z)
        columns = [self._difference(z, at, i) if exact is None or not told[i] else exact[:, i] for i in range(len(z))]
        return np.column_stack(columns) if columns else np.zeros((self.size, 0))

    def _exact_at(self, z: Array) -> Array | None:
        """The exact Jacobian at ``z``; None where the model has no sensitivities or breaks down."""
        if not any(self._exact):
            return None
        self.residuals(z)
        return self._latest[2] if self._latest is not None and self._latest[0] == z.tobytes() else None

    def _difference(self, z: Array, at: Array, i: int) -> Array:
        """One column by a difference, stepping inwards from a bound.

        A direction in which the simulation breaks down is tried the other way; if that fails too, the column is
        zero: the fit does not move there.
        """
        low, high = self.bounds
        step = CRITERIA.fit.difference_step * max(1.0, abs(z[i]) if not self.free[i].logarithmic else 1.0)
        forward = step if z[i] + step <= high[i] else -step
        for h in (forward, -forward):
            moved = z.copy()
            moved[i] = min(max(z[i] + h, low[i]), high[i])
            if moved[i] == z[i]:
                continue
            self.evaluations += 1
            shifted = self._without_slopes(moved, range(len(self.runs)))
            if np.all(np.isfinite(shifted)):
                column: Array = (shifted - at) / (moved[i] - z[i])
                return column
        return np.zeros(self.size)
