"""The objective of a fit: measured minus model in noise standard deviations."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

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
    measured_signals,
    outputs_of,
    sensitivities_of_run,
)
from pam_cosim.fitting.start_values import (
    RestCourse,
    StartValues,
    eliminate,
    eliminate_to_first_order,
    horizons,
    rest_course,
    start_values,
)
from pam_cosim.fitting.tracker import Tracker
from pam_cosim.measurement import DataSet, Run
from pam_cosim.measurement.pieces import first_rows
from pam_cosim.model.interface import sensitivity_name
from pam_cosim.simulation import AnySimulator

DIFFERENCE_TOLERANCE = 1e-7  # of the solver, where slopes are differences, which magnify its error
_DIFFERENCE_STEP = 1e-3  # in search coordinates: far above the solver's error

Outputs = Sequence[Sequence[str]] | Mapping[int, Sequence[str]]  # by number of the run


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
        starts: start values that are parameters of their runs, by number of the run.
        tolerance: relative, of the solver.
        latest_runs: as they were simulated last.

    Args:
        simulator, data, runs, free: as above, and the measurement.
        fixed: further parameters; start values among them are where estimates of these begin [SI].
        tracker, tolerance: as above.
        starts_to_first_order: start values are eliminated by one linear step from where they begin, and stay there;
            those that ``fixed`` has take the place of the first samples.
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
        starts_to_first_order: bool = False,
    ) -> None:
        self._to_first_order = starts_to_first_order
        self._eliminate = eliminate_to_first_order if starts_to_first_order else eliminate
        self.tracker = tracker or Tracker()
        self._priors = [(i, f.prior) for i, f in enumerate(free) if f.prior is not None]
        self.simulator, self.data, self.runs, self.free = simulator, data, tuple(runs), tuple(free)
        self.fixed = dict(fixed or {})
        self.evaluations = 0
        self.failures: list[str] = []
        self._latest: tuple[bytes, Array, Array | None] | None = (
            None  # where, residuals, exact Jacobian there
        )
        self.starts: dict[int, StartValues] | None = (
            None  # by number of the run; None: nothing was simulated yet
        )
        self._starts_at: dict[bytes, dict[int, Array]] = {}  # where each point left them
        self._squares_at: dict[bytes, float] = {}
        self.state_ranges: Mapping[str, float] = {}  # how far runs take each state [SI]
        # where they were as the descent was last linearised, and (start values, parameters) how they move from there
        self._starts_begin: dict[int, Array] = {}
        self._starts_follow: dict[int, Array] = {}
        self._linearised_at: Array | None = None
        self._signals = [measured_signals(run, data) for run in self.runs]
        known = simulator.interface.sensitivities
        self._sensitivities = [
            sensitivities_of_run(run, names, free, known)
            for run, names in zip(self.runs, self._signals, strict=True)
        ]
        self._outputs = [outputs_of(slopes) for slopes in self._sensitivities]
        self._exact = has_sensitivities(self._signals, free, known)
        usual = CRITERIA.fit.tolerance if all(self._exact) else DIFFERENCE_TOLERANCE
        self.tolerance = usual if tolerance is None else tolerance
        runs_and_signals = list(zip(self.runs, self._signals, strict=True))
        self.series = [(run, name) for run, names in runs_and_signals for name in names]
        self.kept = [np.isfinite(run.measurements[name]) for run, name in self.series]
        counts = [sum(map(run.sample_count, names)) for run, names in runs_and_signals]
        self.ends = np.cumsum([0, *counts])
        self.size = int(self.ends[-1])
        squares = [run.sample_count(s) * usual_square(data.signals[s]) for run, s in self.series]
        self.samples = sum(squares)
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

    @property
    def start_values(self) -> dict[str, float]:
        """Those that are estimated, as they are now, by name and run [SI]."""
        return {n: v for one in (self.starts or {}).values() for n, v in one.settings().items()}

    def _start_values_at(self, z: Array) -> dict[int, StartValues]:
        """The start values that are parameters, about where the first samples put them at the first ``z``."""
        if self.starts is None:
            found = self._first_starts(self.values(z))
            self.starts = {i: one for i, one in found.items() if one.names}
            self._starts_begin = self._starts_now()
        return self.starts

    def _first_starts(self, values: Mapping[str, float]) -> dict[int, StartValues]:
        """The start values of the runs by their number."""
        courses = {
            i: self._rest_course(run, values, about_given=self._to_first_order)
            for i, run in enumerate(self.runs)
            if run.start.mode == "estimated"
        }
        interface = self.simulator.interface
        every = [self.state_ranges, *(course.ranges for course in courses.values())]
        self.state_ranges = {
            name: max(ranges.get(name, 0.0) for ranges in every) for name in interface.states
        }
        return {
            i: start_values(course, self.state_ranges, interface) for i, course in courses.items()
        }

    def _rest_course(
        self, run: Run, values: Mapping[str, float], about_given: bool = False
    ) -> RestCourse:
        return rest_course(self.simulator, self.data, run, values, about_given=about_given)

    def _starts_now(self) -> dict[int, Array]:
        return {i: one.values for i, one in (self.starts or {}).items()}

    def _set_starts(self, z: Array) -> None:
        """The start values where ``z`` left them, or where new points look for them.

        What a trial elsewhere made of them must not be where the next one begins: they may have gone astray there.
        """
        known = self._starts_at.get(z.tobytes())
        for i, one in self._start_values_at(z).items():
            one.values = known[i] if known else self._expected_starts(z, i, one)

    def _expected_starts(self, z: Array, i: int, one: StartValues) -> Array:
        """Where the start values of a run are looked for first: where the slopes of the descent lead them.

        No farther than the slopes by start values are trusted (``eliminate``).
        """
        begin = self._starts_begin.get(i, one.values)
        if self._linearised_at is None or i not in self._starts_follow:
            return begin
        step = one.within_reach(self._starts_follow[i] @ (z - self._linearised_at), 1.0)
        return np.clip(begin + step, one.low, one.high)

    def start_afresh(self, z: Array) -> None:
        """From ``z`` on start values are looked for where the first samples and the model's rest at ``z`` put them."""
        if self.starts is None or self._to_first_order or z.tobytes() in self._starts_at:
            return
        for i, one in self.starts.items():
            fresh = self._fresh_starts(z, i)
            self._starts_begin[i] = self._starts_begin[i] if fresh is None else _put(one, fresh)
        self._linearised_at = None
        self._squares_at.clear()

    def _fresh_starts(self, z: Array, i: int) -> dict[str, float] | None:
        """Where the first samples and the model's rest put start values of a run; None: the model breaks down."""
        try:
            return self._rest_course(self.runs[i], self.values(z)).begin
        except SimulationFailure:
            return None

    def found_other_starts(self, z: Array) -> bool:
        """Whether a growing part of a run leads its start values to where less is left than where a descent led them.

        The squares of a whole run have many valleys where it swings, those of its first samples have one. Asked of the
        runs that leave more than noise. A descent that goes on from ``z`` has the better ones.
        """
        starts = {} if self._to_first_order else self._starts_if_it_runs(z)
        if not starts:
            return False
        before, here = self._squares_by_run(self.residuals(z)), self._starts_now()
        noise = CRITERIA.fit.at_noise * np.diff(self.ends)
        for i, one in starts.items():
            fresh = self._fresh_starts(z, i) if before[i] > noise[i] else None
            self._starts_begin[i] = (
                here[i] if fresh is None else _put(one, self._led_by_first_samples(z, i, fresh))
            )
        self._forget(z)
        after, there = self._squares_by_run(self.residuals(z)), self._starts_now()
        better = {i for i in starts if after[i] < (1 - CRITERIA.starts.linear) * before[i]}
        self._starts_begin = {i: there[i] if i in better else here[i] for i in starts}
        self._forget(z)
        if better:
            self._squares_at.clear()
        return bool(better)

    def _forget(self, z: Array) -> None:
        """What ``z`` left: it is asked again, from where start values begin now."""
        self._latest = self._linearised_at = None
        self._starts_at.pop(z.tobytes(), None)

    def _led_by_first_samples(self, z: Array, i: int, known: dict[str, float]) -> dict[str, float]:
        """Where a growing part of its run leads start values."""
        run = self.runs[i]
        for rows in horizons(run, self._signals[i], len(known)):
            begin = {f"{name}@{run.name}": value for name, value in known.items()}
            values, part = {**self.values(z), **begin}, first_rows(run, rows)
            few = Objective(self.simulator, self.data, [part], (), values, self.tolerance)
            few.state_ranges = self.state_ranges
            if np.isfinite(few.squares(np.zeros(0))):
                known = known | {
                    n: v for one in (few.starts or {}).values() for n, v in one.named().items()
                }
        return known

    def _squares_by_run(self, residuals: Array) -> dict[int, float]:
        """The squares of each run with start values, and of what is known of these beforehand."""
        squares, row = dict[int, float](), self.size + len(self._priors)
        for i, one in (self.starts or {}).items():
            own = residuals[self.ends[i] : self.ends[i + 1]]
            known = residuals[row : row + len(one.names)]
            squares[i], row = float(own @ own + known @ known), row + len(one.names)
        return squares

    def _simulate(self, z: Array, outputs: Outputs, chosen: Sequence[int]) -> list[RunComparison]:
        """The chosen runs at ``z``. Raises SimulationFailure where one does not reach its end."""
        starts = self._start_values_at(z)
        values = self.values(z) | {
            n: v for i in chosen if i in starts for n, v in starts[i].every().items()
        }
        return [
            simulate_run(
                self.simulator, self.data, self.runs[i], values, self.tolerance, outputs[i]
            )
            for i in chosen
        ]

    def is_at_noise(self, squares: float) -> bool:
        """Whether a sum of squares is so small that another start could find little."""
        return squares <= CRITERIA.fit.at_noise * self.samples

    def squares(self, z: Array) -> float:
        """The sum of squared residuals, simulated with slopes; infinite where a simulation breaks down.

        A point that is asked for again has the same: start values that were looked for from elsewhere meanwhile could
        lead to less there, by chance.
        """
        point = z.tobytes()
        if point not in self._squares_at:
            residuals = self.residuals(z)
            self._squares_at[point] = float(residuals @ residuals)
        return self._squares_at[point]

    def triangle(self, z: Array) -> Array:
        """The residuals linearised about ``z`` as few rows: the triangular factor of the slopes beside the residuals.

        (m, parameters + 1), m at most parameters + 1. The sum of squares is finite there. A descent goes on from
        ``z``: so do the start values.
        """
        residuals = self.residuals(z)
        self._starts_begin = self._starts_now()
        jacobian, self._starts_follow = self._with_starts_following(self._slopes(z, residuals))
        self._linearised_at = z.copy()
        return np.asarray(np.linalg.qr(np.column_stack([jacobian, residuals]), mode="r"))

    def residuals(self, z: Array) -> Array:
        """(size + priors,) in standard deviations; all infinite where a simulation breaks down."""
        if self._latest is not None and self._latest[0] == z.tobytes():
            return self._latest[1]
        self.evaluations += 1
        self._latest = None  # the start values leave its point, also where the model breaks down
        try:
            runs, left = self._with_starts_eliminated(z)
        except SimulationFailure as failure:
            self._note_failure(failure)
            return self._infinite()
        residuals = self._with_priors(z, left)
        self._report(z, residuals)
        if np.all(np.isfinite(residuals)):
            self._latest = (
                z.tobytes(),
                residuals,
                self._exact_jacobian(z, runs) if any(self._exact) else None,
            )
            return residuals
        return self._infinite()

    def _with_starts_eliminated(self, z: Array) -> tuple[list[RunComparison], Array]:
        """All runs, and their residuals without what start values can take away of them."""
        self._set_starts(z)
        starts, runs, parts = self._start_values_at(z), list[RunComparison](), []
        for i in range(len(self.runs)):
            if i not in starts:
                runs += self._simulate(z, self._outputs, [i])
                parts.append(self._weighted(runs[-1:], [i]))
                continue
            run, left = self._eliminate(starts[i], lambda i=i: self._run_with_start_slopes(z, i))  # type: ignore[misc]
            runs.append(run)
            parts.append(left)
        if starts:
            self._starts_at[z.tobytes()] = self._starts_now()
        self.latest_runs = runs
        return runs, np.concatenate(parts) if parts else np.zeros(0)

    def _run_with_start_slopes(self, z: Array, i: int) -> tuple[RunComparison, Array, Array]:
        """A run, its residuals and their slopes by its start values."""
        one = self._start_values_at(z)[i]
        names = {s: [sensitivity_name(s, state) for state in one.names] for s in self._signals[i]}
        every = [name for of_signal in names.values() for name in of_signal]
        is_exact = self.simulator.interface.sensitivities.keys() >= {*every}
        outputs = [*self._outputs[i], *every] if is_exact else self._outputs[i]
        run = self._simulate(z, {i: outputs}, [i])[0]
        residuals = self._weighted([run], [i])
        if not is_exact:
            return run, residuals, self._start_slopes_by_differences(z, i, residuals)
        parts = []
        for signal, slopes in names.items():
            kept = np.isfinite(run.run.measurements[signal])
            by_error = self._by_error(run, signal, kept)
            parts.append(-np.column_stack([run.model[n][kept] * by_error for n in slopes]))
        return run, residuals, np.vstack(parts)

    def _start_slopes_by_differences(self, z: Array, i: int, at: Array) -> Array:
        """The slopes of the residuals of a run by its start values, by differences."""
        one = self._start_values_at(z)[i]
        here, columns = one.values, []
        for k, sd in enumerate(one.sd):
            one.values = here.copy()
            one.values[k] += _DIFFERENCE_STEP * sd
            moved = self._weighted(self._simulate(z, {i: self._signals[i]}, [i]), [i])
            columns.append((moved - at) / (one.values[k] - here[k]))
            one.values = here
        return np.column_stack(columns)

    def _infinite(self) -> Array:
        return np.full(self._rows, np.inf)

    @property
    def _rows(self) -> int:
        """Samples, priors, and what is known of start values beforehand."""
        return (
            self.size
            + len(self._priors)
            + sum(len(one.names) for one in (self.starts or {}).values())
        )

    def _with_priors(self, z: Array, residuals: Array) -> Array:
        prior_rows = [
            -prior.surprise(self.free[i].to_value(float(z[i]))) for i, prior in self._priors
        ]
        starts = [one.prior_rows(one.values) for one in (self.starts or {}).values()]
        return (
            np.concatenate([residuals, prior_rows, *starts]) if prior_rows or starts else residuals
        )

    def _report(self, z: Array, residuals: Array) -> None:
        chi2 = float(residuals @ residuals) / max(self.samples, 1.0)
        self.tracker.report(self.evaluations, chi2, self._rms_errors, lambda: self.values(z))

    def _rms_errors(self) -> dict[str, float]:
        """Of each fitted signal [SI], over all runs as they were simulated last."""
        squares = defaultdict[str, list[Array]](list)
        for run, names in zip(self.latest_runs, self._signals, strict=False):
            for name in names:
                error = run.residual(name)[np.isfinite(run.run.measurements[name])]
                squares[name].append(error**2)
        return {name: float(np.sqrt(np.mean(np.concatenate(e)))) for name, e in squares.items()}

    def cost(self, z: Array) -> float:
        """The squared residuals of all runs, without slopes; infinite where a simulation breaks down."""
        residuals = self.plain_residuals(z)
        self._report(z, residuals)
        return float(residuals @ residuals) if np.all(np.isfinite(residuals)) else np.inf

    def plain_residuals(self, z: Array) -> Array:
        """As ``residuals``, simulated without slopes where no start values need them.

        To first order the slopes by start values are those of the point that was simulated first.
        """
        starts = self._starts_if_it_runs(z)
        if starts and not (
            self._to_first_order and all(one.slopes.size for one in starts.values())
        ):
            return self.residuals(z)
        self.evaluations += 1
        left = self._without_slopes(z, range(len(self.runs)))
        if np.all(np.isfinite(left)):
            for i, one in starts.items():
                rows = slice(self.ends[i], self.ends[i + 1])
                left[rows] = one.taken_away(left[rows])
        return self._with_priors(z, left)

    def _starts_if_it_runs(self, z: Array) -> dict[int, StartValues]:
        """The start values that are parameters; none where the model breaks down."""
        try:
            return self._start_values_at(z)
        except SimulationFailure:
            return {}

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
            self.latest_runs = self._simulate(z, self._signals, chosen)
            return self._weighted(self.latest_runs, chosen)
        except SimulationFailure as failure:
            self._note_failure(failure)
            return np.full(sum(self.ends[i + 1] - self.ends[i] for i in chosen), np.inf)

    @property
    def first_failure(self) -> str:
        """Why the model broke down first."""
        return self.failures[0] if self.failures else "the model gives no finite result"

    def _note_failure(self, failure: SimulationFailure) -> None:
        if len(self.failures) < CRITERIA.run.failures_kept:
            self.failures.append(str(failure))

    def _weighted(self, runs: Sequence[RunComparison], chosen: Sequence[int]) -> Array:
        parts = []
        for run, i in zip(runs, chosen, strict=True):
            for name in self._signals[i]:
                kept = np.isfinite(run.run.measurements[name])
                error, reading = run.residual(name)[kept], run.run.measurements[name][kept]
                parts.append(standardized_residuals(error, self.data.signals[name], reading))
        return np.concatenate(parts) if parts else np.zeros(0)

    def _by_error(self, run: RunComparison, name: str, kept: NDArray[np.bool_]) -> Array:
        """How the residuals of a signal grow with its errors, at the samples that are there."""
        return slope(
            run.residual(name)[kept], self.data.signals[name], run.run.measurements[name][kept]
        )

    def _exact_jacobian(self, z: Array, runs: Sequence[RunComparison]) -> Array:
        """(size + priors, parameters); columns of parameters whose sensitivities the model does not tell are zero."""
        jacobian = np.zeros((self._rows, len(self.free)))
        by_z = [free.slope(float(c)) for free, c in zip(self.free, z, strict=True)]
        row = 0
        for run, sensitivities in zip(runs, self._sensitivities, strict=True):
            for name, slopes in sensitivities.items():
                kept = np.isfinite(run.run.measurements[name])
                count = int(kept.sum())
                by_error = self._by_error(run, name, kept)
                for i, sensitivity in slopes:
                    moved = by_z[i] * self.free[i].size_in(run.run)
                    jacobian[row : row + count, i] = (
                        -by_error * run.model[sensitivity][kept] * moved
                    )
                row += count
        for k, (i, prior) in enumerate(self._priors):
            own = self.free[i]
            jacobian[self.size + k, i] = -own.slope(float(z[i])) * prior.slope(
                own.to_value(float(z[i]))
            )
        return jacobian

    def jacobian(self, z: Array, at: Array) -> Array:
        """(size + priors, parameters) by the model's sensitivities, or by differences where it has none.

        Args:
            z: (parameters,) search coordinates.
            at: (size + priors,) the residuals there.
        """
        return self._with_starts_following(self._slopes(z, at))[0]

    def _slopes(self, z: Array, at: Array) -> Array:
        """As ``jacobian``, with the start values where they are."""
        if not len(z):
            return np.zeros((len(at), 0))
        exact, columns, compared = self._exact_at(z), [], None
        for i, is_exact in enumerate(self._exact):
            if exact is not None and is_exact:
                columns.append(exact[:, i])
                continue
            compared = self._before_elimination(z, at) if compared is None else compared
            columns.append(self._difference(z, compared, i))
        return np.column_stack(columns)

    def _before_elimination(self, z: Array, at: Array) -> Array:
        """The residuals that those of a moved point are compared with.

        To first order the start values stay where they are, and ``at`` lacks what they can take away.
        """
        if not (self._to_first_order and self.starts):
            return at
        return np.concatenate([self._without_slopes(z, range(len(self.runs))), at[self.size :]])

    def _with_starts_following(self, jacobian: Array) -> tuple[Array, dict[int, Array]]:
        """The slopes with the start values moving along, so that least is left; and how those of each run move."""
        if not jacobian.shape[1]:
            return jacobian, {}
        moves = dict[int, Array]()
        followed, row = jacobian.copy(), self.size + len(self._priors)
        for i, one in (self.starts or {}).items():
            rows = slice(self.ends[i], self.ends[i + 1])
            moved = moves[i] = one.following(jacobian[rows])
            count = len(one.names)
            followed[rows] += one.slopes[:-count] @ moved
            followed[row : row + count] = one.slopes[-count:] @ moved
            row += count
        return followed, moves

    def _exact_at(self, z: Array) -> Array | None:
        """The exact Jacobian at ``z``; None where the model has no sensitivities or breaks down."""
        if not any(self._exact):
            return None
        self.residuals(z)
        return (
            self._latest[2] if self._latest is not None and self._latest[0] == z.tobytes() else None
        )

    def _difference(self, z: Array, at: Array, i: int) -> Array:
        """One column by a difference, stepping inwards from a bound; only the runs are simulated that move.

        A direction in which the simulation breaks down is tried the other way; if that fails too, the column is
        zero: the fit does not move there.
        """
        low, high = self.bounds
        step = _DIFFERENCE_STEP * max(1.0, abs(z[i]) if not self.free[i].logarithmic else 1.0)
        forward = step if z[i] + step <= high[i] else -step
        chosen = [k for k, run in enumerate(self.runs) if acts_on(self.free[i], run, self.free)]
        for h in (forward, -forward):
            moved = z.copy()
            moved[i] = min(max(z[i] + h, low[i]), high[i])
            if moved[i] == z[i]:
                continue
            self.evaluations += 1
            shifted = at.copy()
            rows = [np.arange(self.ends[k], self.ends[k + 1]) for k in chosen]
            shifted[np.concatenate(rows) if rows else np.zeros(0, int)] = self._without_slopes(
                moved, chosen
            )
            shifted = self._with_priors(moved, shifted[: self.size])
            if np.all(np.isfinite(shifted)):
                column: Array = (shifted - at) / (moved[i] - z[i])
                return column
        return np.zeros(len(at))


def _put(of: StartValues, named: Mapping[str, float]) -> Array:
    """Start values by name in their order, within what the model says that they can be."""
    return np.clip([named[name] for name in of.names], of.low, of.high)
