"""The objective of a fit: measured minus model in noise standard deviations."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from functools import partial

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison import (
    RunComparison,
    simulate_run,
    slope,
    standardized_residuals,
    usual_square,
)
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import SimulationFailure
from pam_cosim.fitting.free import Free
from pam_cosim.fitting.sensitivities import (
    acts_on,
    has_sensitivities,
    outputs_of,
    sensitivities_of_run,
)
from pam_cosim.fitting.tracker import Tracker
from pam_cosim.measurement import DataSet, Run
from pam_cosim.model.interface import sensitivity_name
from pam_cosim.simulation import AnySimulator
from pam_cosim.starts import EliminatedStarts, measured_signals

_MOST_FAILURES = 10  # messages that are kept

DIFFERENCE_TOLERANCE = 1e-7  # of the solver, where slopes are differences, which magnify its error
_DIFFERENCE_STEP = 1e-3  # in search coordinates: far above the solver's error


class Objective:
    """Residuals of some runs as a function of the search coordinates; those of the priors stand below them.

    Attributes:
        free: the parameters that are searched.
        size: number of samples. samples: how many these count for, fewer where they were rounded to coarse steps.
        ends: (runs + 1,) where the rows of each run begin, and the last ones end.
        series: run and signal of each part of the rows, in their order; ``kept``: which samples of each there are.
        tracker: gets a report of every point.
        evaluations: simulations of the whole set so far.
        failures: the first message of each kind of breakdown.
        starts: start values that are parameters of their runs, which are eliminated.
        tolerance: relative, of the solver.
        latest_runs: as they were simulated last.

    Args:
        simulator, data, runs, free: as above, and the measurement.
        fixed: further parameters; start values among them are where estimates of these begin [SI].
        tracker, tolerance: as above.
        starts_are_known: runs begin as ``fixed`` says; no start values are eliminated.
        is_over: whether a limit of the fit is reached: descents end, and no start values are looked for any more.
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
        *,
        starts_are_known: bool = False,
        is_over: Callable[[], bool] = lambda: False,
    ) -> None:
        self.tracker, self.is_over = tracker or Tracker(), is_over
        self._priors = [(i, f.prior) for i, f in enumerate(free) if f.prior is not None]
        self.simulator, self.data, self.runs, self.free = simulator, data, tuple(runs), tuple(free)
        self.fixed = dict(fixed or {})
        self.evaluations = 0
        self.failures: list[str] = []
        self._latest: tuple[bytes, Array, Array | None] | None = (
            None  # where, residuals, exact Jacobian there
        )
        self._squares_at: dict[bytes, float] = {}
        sensitivity_names = simulator.interface.sensitivities
        self._signals = [
            sensitivities_of_run(run, measured_signals(run, data), free, sensitivity_names)
            for run in self.runs
        ]
        self._outputs = [outputs_of(slopes) for slopes in self._signals]
        self._exact = has_sensitivities(self._signals, free, sensitivity_names)
        usual = CRITERIA.fit.tolerance if all(self._exact) else DIFFERENCE_TOLERANCE
        self.tolerance = usual if tolerance is None else tolerance
        self.series = [
            (run, name)
            for run, names in zip(self.runs, self._signals, strict=True)
            for name in names
        ]
        self.kept = [np.isfinite(run.measurements[name]) for run, name in self.series]
        counts = [
            sum(map(r.sample_count, n)) for r, n in zip(self.runs, self._signals, strict=True)
        ]
        self.ends = np.cumsum([0, *counts])
        self.size = int(self.ends[-1])
        estimated = () if starts_are_known else self.runs
        self.starts = EliminatedStarts(simulator, data, estimated, self.ends, self._squares_from)
        self.samples = sum(
            r.sample_count(s) * usual_square(data.signals[s]) for r, s in self.series
        )
        self.latest_runs: Sequence[RunComparison] = ()

    @property
    def bounds(self) -> tuple[Array, Array]:
        """Lower and upper bounds in search coordinates."""
        low = np.array([f.to_z(f.low) for f in self.free])
        return low, np.array([f.to_z(f.high) for f in self.free])

    def values(self, z: Array) -> dict[str, float]:
        """Search coordinates to parameters by name, with the fixed ones [SI]."""
        return self.fixed | {
            f.name: f.to_value(float(c)) for f, c in zip(self.free, z, strict=True)
        }

    def start_afresh(self, z: Array) -> None:
        """From ``z`` on start values are looked for where the first samples and the model's rest at ``z`` put them."""
        if self.starts.begin_afresh(z, self.values(z)):
            self._squares_at.clear()

    def found_other_starts(self, z: Array) -> bool:
        """Whether start values were found that leave less; a descent that goes on from ``z`` has them."""
        if not self._has_starts(z):
            return False

        def anew() -> Array:
            self._latest = None
            return self.residuals(z)

        residuals, values = self.residuals(z), self.values(z)
        estimated_starts = self.starts.found_others(
            z, values, residuals, anew, self._start_values_of_part
        )
        self._latest = None
        if estimated_starts:
            self._squares_at.clear()
        return estimated_starts

    def _start_values_of_part(self, part: Run, values: Mapping[str, float]) -> dict[str, float]:
        """The start values by state [SI] that leave least of a part of a run; none where it fails."""
        if self.is_over():
            return {}
        objective_of_part = Objective(self.simulator, self.data, [part], (), values, self.tolerance)
        objective_of_part.starts.state_ranges = self.starts.state_ranges
        if not np.isfinite(objective_of_part.squares(np.zeros(0))):
            return {}
        return {
            n: v
            for start in objective_of_part.starts.by_run.values()
            for n, v in start.named().items()
        }

    def _run(self, z: Array, i: int, outputs: Sequence[str]) -> RunComparison:
        """A run at ``z``. Raises SimulationFailure where it does not reach its end."""
        values = self.values(z)
        self.starts.place(values)
        values |= self.starts.of_run(i)
        return simulate_run(
            self.simulator, self.data, self.runs[i], values, self.tolerance, outputs
        )

    def _squares_from(self, i: int, values: Mapping[str, float]) -> float:
        """What a run leaves with given parameters and start [SI]; infinite where it breaks down."""
        try:
            run = simulate_run(
                self.simulator, self.data, self.runs[i], values, self.tolerance, [*self._signals[i]]
            )
        except SimulationFailure:
            return np.inf
        return _squares(self._weighted(run, i))

    def is_at_noise(self, squares: float) -> bool:
        """Whether a sum of squares is so small that another start could find little."""
        return squares <= CRITERIA.fit.at_noise * self.samples

    def squares(self, z: Array) -> float:
        """The sum of squared residuals, simulated with slopes; infinite where a simulation breaks down.

        A point that is requested again has the same: start values that were looked for from elsewhere meanwhile could
        lead to less there, by chance.
        """
        point = z.tobytes()
        if point not in self._squares_at:
            residuals = self.residuals(z)
            self._squares_at[point] = float(residuals @ residuals)
        return self._squares_at[point]

    def triangle(self, z: Array) -> Array:
        """The residuals linearised about ``z`` as few rows: the triangular factor of the slopes and the residuals.

        (m, parameters + 1), m at most parameters + 1. The sum of squares is finite there. A descent continues from
        ``z``: so do the start values.
        """
        residuals = self.residuals(z)
        jacobian = self.starts.followed(self._slopes(z, residuals), z)
        return np.asarray(np.linalg.qr(np.column_stack([jacobian, residuals]), mode="r"))

    def residuals(self, z: Array) -> Array:
        """(size + priors,) in standard deviations; all infinite where a simulation breaks down."""
        if self._latest is not None and self._latest[0] == z.tobytes():
            return self._latest[1]
        self.evaluations += 1
        self._latest = None  # the start values leave its point, also where the model breaks down
        try:
            residuals = self._with_priors(z, self._with_starts_eliminated(z))
            self._report(z, residuals)
            if np.all(np.isfinite(residuals)):
                exact = self._exact_jacobian(z) if any(self._exact) else None
                self._latest = z.tobytes(), residuals, exact
                return residuals
        except SimulationFailure as failure:
            self._note_failure(failure)
        return np.full(self._rows, np.inf)

    def _with_starts_eliminated(self, z: Array) -> Array:
        """The residuals of all runs without what start values can take away of them."""
        self.starts.set_out(z, self.values(z))
        runs, parts = list[RunComparison](), [np.zeros(0)]
        for i, outputs in enumerate(self._outputs):
            if i in self.starts.by_run:
                run, remaining_residuals = self.starts.eliminated(
                    i, partial(self._run_with_start_slopes, z, i)
                )
            else:
                run = self._run(z, i, outputs)
                remaining_residuals = self._weighted(run, i)
            runs.append(run)
            parts.append(remaining_residuals)
        self.starts.keep(z)
        self.latest_runs = runs
        return np.concatenate(parts)

    def _run_with_start_slopes(self, z: Array, i: int) -> tuple[RunComparison, Array, Array]:
        """A run, its residuals and their slopes by its start values."""
        start = self.starts.by_run[i]
        names = {s: [sensitivity_name(s, state) for state in start.names] for s in self._signals[i]}
        signal_names = [name for of_signal in names.values() for name in of_signal]
        is_exact = self.simulator.interface.sensitivities.keys() >= {*signal_names}
        run = self._run(z, i, [*self._outputs[i], *signal_names] if is_exact else self._outputs[i])
        residuals = self._weighted(run, i)
        if is_exact:
            columns = [np.column_stack(self._exact_slopes(run, s, n)) for s, n in names.items()]
            return run, residuals, np.vstack(columns)
        start_values, columns = start.values, []
        for k, sd in enumerate(start.sd):
            start.values = start_values.copy()
            start.values[k] += _DIFFERENCE_STEP * sd
            shifted_residuals = self._weighted(self._run(z, i, [*self._signals[i]]), i)
            columns.append((shifted_residuals - residuals) / (start.values[k] - start_values[k]))
            start.values = start_values
        return run, residuals, np.column_stack(columns)

    @property
    def _rows(self) -> int:
        """Samples, priors, and what is known of start values beforehand."""
        return self.size + len(self._priors) + self.starts.count

    def _with_priors(self, z: Array, residuals: Array) -> Array:
        rows = [-prior.surprise(self.free[i].to_value(float(z[i]))) for i, prior in self._priors]
        return np.concatenate([residuals, rows, *self.starts.prior_rows()])

    def _report(self, z: Array, residuals: Array) -> None:
        chi2 = float(residuals @ residuals) / max(self.samples, 1.0)
        self.tracker.report(self.evaluations, chi2, self._rms_errors, lambda: self.values(z))

    def _rms_errors(self) -> dict[str, float]:
        """Of each fitted signal [SI], over all runs as they were simulated last."""
        squares = defaultdict[str, list[Array]](list)
        for run, names in zip(self.latest_runs, self._signals, strict=False):
            for name in names:
                squares[name].append(run.at_samples(name)[1] ** 2)
        return {name: float(np.sqrt(np.mean(np.concatenate(e)))) for name, e in squares.items()}

    def cost(self, z: Array) -> float:
        """The squared residuals of all runs, without slopes; infinite where a simulation breaks down."""
        residuals = self.plain_residuals(z)
        self._report(z, residuals)
        return _squares(residuals)

    def plain_residuals(self, z: Array) -> Array:
        """Residuals (rows,) at search coordinates ``z`` (k,), in standard deviations, as ``residuals`` has them.

        The simulation is without slopes if no start values need them.
        """
        if self._has_starts(z):
            return self.residuals(z)
        self.evaluations += 1
        return self._with_priors(z, self._without_slopes(z, range(len(self.runs))))

    def _has_starts(self, z: Array) -> bool:
        """Whether start values are parameters; not where the model breaks down."""
        try:
            return bool(self.starts.place(self.values(z)))
        except SimulationFailure:
            return False

    def glance(self, z: Array) -> float:
        """The squared residuals of the first and the last run, which distinguish good initial guesses cheaply.

        Infinite where a simulation breaks down.
        """
        chosen = sorted({0, len(self.runs) - 1})
        return _squares(self._with_priors(z, self._without_slopes(z, chosen)))

    def _without_slopes(self, z: Array, chosen: Sequence[int]) -> Array:
        """Residuals of the chosen runs, infinite where one breaks down; what is known of the present point stays."""
        try:
            runs = self.latest_runs = [self._run(z, i, [*self._signals[i]]) for i in chosen]
            parts = [self._weighted(run, i) for run, i in zip(runs, chosen, strict=True)]
            return np.concatenate([np.zeros(0), *parts])
        except SimulationFailure as failure:
            self._note_failure(failure)
            return np.full(sum(self.ends[i + 1] - self.ends[i] for i in chosen), np.inf)

    @property
    def first_failure(self) -> str:
        """Why the model broke down first."""
        return self.failures[0] if self.failures else "the model gives no finite result"

    def _note_failure(self, failure: SimulationFailure) -> None:
        if len(self.failures) < _MOST_FAILURES:
            self.failures.append(str(failure))

    def _weighted(self, run: RunComparison, i: int) -> Array:
        parts = [np.zeros(0)]
        for name in self._signals[i]:
            _, error, reading = run.at_samples(name)
            parts.append(standardized_residuals(error, self.data.signals[name], reading))
        return np.concatenate(parts)

    def _exact_slopes(self, run: RunComparison, name: str, by: Sequence[str]) -> list[Array]:
        """The slopes of the residuals of a signal, at the samples that are there, by its sensitivities."""
        sample_mask, error, reading = run.at_samples(name)
        by_error = -slope(error, self.data.signals[name], reading)
        return [by_error * run.model[sensitivity][sample_mask] for sensitivity in by]

    def _exact_jacobian(self, z: Array) -> Array:
        """(size + priors, parameters) at the runs that were simulated last.

        Columns of parameters whose sensitivities the model does not have are zero.
        """
        jacobian = np.zeros((self._rows, len(self.free)))
        by_z = [free.slope(float(c)) for free, c in zip(self.free, z, strict=True)]
        row = 0
        for run, sensitivities in zip(self.latest_runs, self._signals, strict=True):
            for name, acting in sensitivities.items():
                rows = slice(row, row := row + run.run.sample_count(name))
                columns = self._exact_slopes(run, name, [sensitivity for _, sensitivity in acting])
                for (i, _), column in zip(acting, columns, strict=True):
                    jacobian[rows, i] = column * (by_z[i] * self.free[i].size_in(run.run))
        for k, (i, prior) in enumerate(self._priors, self.size):
            jacobian[k, i] = -by_z[i] * prior.slope(self.free[i].to_value(float(z[i])))
        return jacobian

    def jacobian(self, z: Array, at: Array) -> Array:
        """(size + priors, parameters) by the model's sensitivities, or by differences where it has none.

        Args:
            z: (parameters,) search coordinates.
            at: (size + priors,) the residuals there.
        """
        return self.starts.followed(self._slopes(z, at))

    def _slopes(self, z: Array, at: Array) -> Array:
        """As ``jacobian``, with the start values where they are."""
        if not len(z):
            return np.zeros((len(at), 0))
        exact = self._exact_at(z)
        columns = [
            exact[:, i] if exact is not None and is_exact else self._difference(z, at, i)
            for i, is_exact in enumerate(self._exact)
        ]
        return np.column_stack(columns)

    def _exact_at(self, z: Array) -> Array | None:
        """The exact Jacobian at ``z``; None where the model has no sensitivities or breaks down."""
        if not any(self._exact):
            return None
        self.residuals(z)
        return self._latest and self._latest[2]

    def _difference(self, z: Array, at: Array, i: int) -> Array:
        """One column by a difference, stepping inwards from a bound; only the runs are simulated that move.

        A direction in which the simulation breaks down is tried the other way; if that fails too, the column is
        zero: the fit does not move there.
        """
        low, high = self.bounds
        step = _DIFFERENCE_STEP * max(1.0, abs(z[i]) if not self.free[i].logarithmic else 1.0)
        forward = step if z[i] + step <= high[i] else -step
        chosen = [k for k, run in enumerate(self.runs) if acts_on(self.free[i], run, self.free)]
        rows = np.concatenate(
            [np.zeros(0, int), *(np.arange(self.ends[k], self.ends[k + 1]) for k in chosen)]
        )
        for h in (forward, -forward):
            shifted_z = z.copy()
            shifted_z[i] = min(max(z[i] + h, low[i]), high[i])
            if shifted_z[i] == z[i]:
                continue
            self.evaluations += 1
            shifted = at[: self.size].copy()
            shifted[rows] = self._without_slopes(shifted_z, chosen)
            shifted = self._with_priors(shifted_z, shifted)
            if np.all(np.isfinite(shifted)):
                return np.asarray((shifted - at) / (shifted_z[i] - z[i]))
        return np.zeros(len(at))


def _squares(residuals: Array) -> float:
    return float(residuals @ residuals) if np.all(np.isfinite(residuals)) else np.inf
