"""The start values of the runs of an objective: where they begin at each point of a search, and how they follow it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.errors import SimulationFailure
from pam_cosim.measurement import DataSet, Run
from pam_cosim.measurement.pieces import first_rows
from pam_cosim.simulation import AnySimulator
from pam_cosim.starts.initial_state import measured_initial_state
from pam_cosim.starts.probe import StartProbe
from pam_cosim.starts.run_start import measured_signals, start_time
from pam_cosim.starts.start_values import (
    LinearisedRun,
    StartValues,
    eliminate,
    settings_of,
)

_STILL = 1e-9  # of its size, by which a state that does not move moves by rounding


class RestTrajectory(NamedTuple):
    """The states of a run that begins where its first samples and the equilibrium with them put it.

    Attributes:
        first: where each state begins then [SI].
        ranges: how far the run takes each state from there [SI]; zero where it rests.
        begin: where an estimate begins [SI]: there, or at the start values among the parameters, whichever leaves less.
    """

    first: dict[str, float]
    ranges: dict[str, float]
    begin: dict[str, float]


class EliminatedStarts:
    """Start values of runs with an estimated start, eliminated run by run (``start_values``).

    Attributes:
        by_run: start values by number of the run; empty until the first point is simulated.
        state_ranges: how far runs take each state [SI].

    Args:
        simulator: the model.
        data: the measurement with its noise.
        runs: the runs.
        ends: (runs + 1,) where the rows of the residuals of each run begin, and the last ones end.
        squares_from: what a run leaves of its samples, by its number and the parameters with its start [SI].
    """

    def __init__(
        self,
        simulator: AnySimulator,
        data: DataSet,
        runs: Sequence[Run],
        ends: NDArray[np.int_],
        squares_from: Callable[[int, Mapping[str, float]], float],
    ) -> None:
        self._simulator, self._data, self._runs = simulator, data, runs
        self._squares_from = squares_from
        self._rows = [slice(*rows) for rows in zip(ends[:-1], ends[1:], strict=True)]
        self.by_run: dict[int, StartValues] = {}
        self.state_ranges: Mapping[str, float] = {}
        self._is_placed = False
        self._at: dict[bytes, dict[int, Array]] = {}  # where each point left them
        self._linearised_at: Array | None = None  # where the descent was last linearised

    @property
    def count(self) -> int:
        """Number of start values, and of the rows of what is known of them beforehand."""
        return sum(len(values_of_run.names) for values_of_run in self.by_run.values())

    @property
    def settings(self) -> dict[str, float]:
        """The start values that are estimated, as they are now, by "state@run" [SI]."""
        return {
            n: v
            for values_of_run in self.by_run.values()
            for n, v in values_of_run.settings().items()
        }

    def of_run(self, i: int) -> dict[str, float]:
        """Where a run begins, by "state@run" [SI]; empty where its start is not estimated."""
        return settings_of(self._runs[i], self.by_run[i].named()) if i in self.by_run else {}

    def place(self, values: Mapping[str, float]) -> dict[int, StartValues]:
        """The start values, about where the first samples put them with the first parameters [SI]."""
        if not self._is_placed:
            trajectories = {
                i: self._rest_trajectory(i, values)
                for i, run in enumerate(self._runs)
                if run.start.mode == "estimated"
            }
            # a state that rests in one run may be on its way as that begins, as far as others take it
            all_ranges = [
                self.state_ranges,
                *(run_trajectory.ranges for run_trajectory in trajectories.values()),
            ]
            self.state_ranges = {
                name: max(ranges.get(name, 0.0) for ranges in all_ranges)
                for name in self._simulator.interface.states
            }
            placed = {
                i: self._start_values(i, run_trajectory)
                for i, run_trajectory in trajectories.items()
            }
            self.by_run = {
                i: values_of_run for i, values_of_run in placed.items() if values_of_run.names
            }
            self._is_placed = True
        return self.by_run

    def _start_values(self, i: int, run_trajectory: RestTrajectory) -> StartValues:
        moving = tuple(n for n in run_trajectory.first if self.state_ranges[n])
        variables = [self._simulator.interface.start_values[n] for n in moving]
        low = np.array(
            [-np.inf if variable.min is None else variable.min for variable in variables]
        )
        high = np.array(
            [np.inf if variable.max is None else variable.max for variable in variables]
        )
        mean = np.array([run_trajectory.first[n] for n in moving])
        sd = CRITERIA.starts.range * np.array([self.state_ranges[n] for n in moving])
        values = np.clip(np.array([run_trajectory.begin[n] for n in moving]), low, high)
        still = {n: v for n, v in run_trajectory.first.items() if n not in moving}
        return StartValues(self._runs[i], moving, mean, sd, values, low, high, still)

    def _rest_trajectory(self, i: int, values: Mapping[str, float]) -> RestTrajectory:
        """The trajectory of a run from its first samples and the equilibrium with them.

        Raises:
            SimulationFailure: the run does not reach its end.
        """
        run, states = self._runs[i], self._simulator.interface.states
        run_parameters = self._data.parameters_of(run, values)
        bare = {n: v for n, v in run_parameters.items() if n not in states}
        stated_starts = {n: run_parameters[n] for n in states if n in run_parameters}
        probe = StartProbe(self._simulator, self._data, run, bare)
        start = measured_initial_state(probe)
        times = np.unique(np.append(start_time(run), run.time))
        run_trajectory = start.trajectory(self._simulator, run, bare, times, states)
        initial = {n: float(run_trajectory[n][0]) for n in states}
        begin = initial | stated_starts
        if stated_starts:
            begin = min(
                (begin, initial),
                key=lambda states: self._squares_from(i, {**values, **settings_of(run, states)}),
            )
        return RestTrajectory(initial, {n: _range(run_trajectory[n]) for n in states}, begin)

    def set_out(self, z: Array, values: Mapping[str, float]) -> None:
        """Puts start values where ``z`` left them, or where new points look for them.

        What a trial elsewhere made of them must not be where the next one begins: they may have gone astray there.
        """
        before = self._at.get(z.tobytes())
        for i, values_of_run in self.place(values).items():
            values_of_run.values = before[i] if before else self.expected(z, values_of_run)

    def expected(self, z: Array, values_of_run: StartValues) -> Array:
        """Where the start values of a run are looked for first: where the slopes of the descent lead them.

        No farther than the slopes by start values are trusted (``eliminate``).
        """
        if self._linearised_at is None or values_of_run.follow is None:
            return values_of_run.begin
        step = values_of_run.within_reach(values_of_run.follow @ (z - self._linearised_at), 1.0)
        return np.clip(values_of_run.begin + step, values_of_run.low, values_of_run.high)

    def eliminated(self, i: int, simulate: LinearisedRun) -> tuple[Any, Array]:
        """The result of a run, and its residuals without what its start values take away; see ``eliminate``."""
        return eliminate(self.by_run[i], simulate)

    def keep(self, z: Array) -> None:
        """Keeps where ``z`` left the start values."""
        if self.by_run:
            self._at[z.tobytes()] = {
                i: values_of_run.values for i, values_of_run in self.by_run.items()
            }

    def _blocks(self, residuals: Array) -> Iterator[tuple[StartValues, slice, slice]]:
        """The start values of each run, the rows of its residuals, and of what is known of them beforehand."""
        row = len(residuals) - self.count
        for i, values_of_run in self.by_run.items():
            yield values_of_run, self._rows[i], slice(row, row := row + len(values_of_run.names))

    def slopes(self, rows: int) -> tuple[Array, Array]:
        """(rows, s) slopes of the residuals by all start values, and (s,) what is known of these [1/variance]."""
        slopes, known, column = np.zeros((rows, self.count)), [np.zeros(0)], 0
        for i, values_of_run in self.by_run.items():
            columns = slice(column, column := column + len(values_of_run.names))
            slopes[self._rows[i], columns] = values_of_run.slopes[: -len(values_of_run.names)]
            known.append(values_of_run.sd**-2)
        return slopes, np.concatenate(known)

    def prior_rows(self) -> list[Array]:
        """The rows of what is known of start values beforehand, which are the last ones of the residuals."""
        return [values_of_run.prior_rows() for values_of_run in self.by_run.values()]

    def followed(self, jacobian: Array, z: Array | None = None) -> Array:
        """The slopes with the start values moving along, so that least is left.

        Args:
            jacobian: (rows, parameters) of the residuals with the start values where they are.
            z: where a descent continues, along these slopes; None: nowhere.
        """
        followed = jacobian.copy()
        for values_of_run, rows, prior_places in self._blocks(jacobian):
            moves = values_of_run.following(jacobian[rows]) if jacobian.shape[1] else None
            if moves is not None:
                count = len(values_of_run.names)
                followed[rows] += values_of_run.slopes[:-count] @ moves
                followed[prior_places] = values_of_run.slopes[-count:] @ moves
            if z is not None:
                values_of_run.begin, values_of_run.follow = values_of_run.values, moves
        self._linearised_at = self._linearised_at if z is None else z.copy()
        return followed

    def begin_afresh(self, z: Array, values: Mapping[str, float]) -> bool:
        """Whether start values are looked for where the first samples and the model's rest put them from ``z`` on."""
        if not self._is_placed or z.tobytes() in self._at:
            return False
        for i, values_of_run in self.by_run.items():
            if (fresh := self._fresh(i, values)) is not None:
                values_of_run.begin = values_of_run.clipped(fresh)
        self._linearised_at = None
        return True

    def _fresh(self, i: int, values: Mapping[str, float]) -> dict[str, float] | None:
        """Where the first samples and the model's rest put start values of a run; None: the model breaks down."""
        try:
            return self._rest_trajectory(i, values).begin
        except SimulationFailure:
            return None

    def found_others(
        self,
        z: Array,
        values: Mapping[str, float],
        residuals: Array,
        anew: Callable[[], Array],
        of_part: Callable[[Run, Mapping[str, float]], dict[str, float]],
    ) -> bool:
        """Whether better start values are found by fits of a growing part of each run with more than noise.

        The squared error of a whole oscillating run has many minima, that of its first samples has one. A descent that
        continues from ``z`` uses the better start values.

        Args:
            z: (k,) the search coordinates.
            values: the parameters there [SI].
            residuals: (rows,) there, in standard deviations; the rows of the priors of start values are the last.
            anew: simulates ``z`` again and returns its residuals (rows,).
            of_part: returns the start values by state [SI] with the smallest squared error of a part of a run, with
                given parameters; none where the simulation fails.
        """
        before = self._squares(residuals)
        values_before = {i: values_of_run.values for i, values_of_run in self.by_run.items()}
        for i, values_of_run in self.by_run.items():
            rows, values_of_run.begin = self._rows[i], values_of_run.values
            if before[i] <= CRITERIA.fit.at_noise * (rows.stop - rows.start):
                continue
            if (start_values := self._fresh(i, values)) is None:
                continue
            run = self._runs[i]
            for count in horizons(run, measured_signals(run, self._data), len(start_values)):
                begin = settings_of(run, start_values)
                start_values = start_values | of_part(first_rows(run, count), {**values, **begin})
            values_of_run.begin = values_of_run.clipped(start_values)
        self._forget(z)
        after = self._squares(anew())
        better = {i for i in after if after[i] < (1 - CRITERIA.starts.linear) * before[i]}
        for i, values_of_run in self.by_run.items():
            values_of_run.begin = values_of_run.values if i in better else values_before[i]
        self._forget(z)
        return bool(better)

    def _forget(self, z: Array) -> None:
        """The residuals at ``z``, evaluated again from the present start values."""
        self._linearised_at = None
        self._at.pop(z.tobytes(), None)

    def _squares(self, residuals: Array) -> dict[int, float]:
        """The squares of each run with start values, and of what is known of these beforehand."""
        squares = [
            float(
                residuals[rows] @ residuals[rows]
                + residuals[prior_places] @ residuals[prior_places]
            )
            for _, rows, prior_places in self._blocks(residuals)
        ]
        return dict(zip(self.by_run, squares, strict=True))


def _range(run_trajectory: Array) -> float:
    """How far a state moves; nothing where that is rounding."""
    extent = float(np.ptp(run_trajectory))
    return extent if extent > _STILL * float(np.max(np.abs(run_trajectory))) else 0.0


def horizons(run: Run, signals: Sequence[str], unknowns: int) -> list[int]:
    """How many of the first rows of a run are used, twice as many each time, before all are.

    The first ones have two samples for each unknown start value.
    """
    samples = np.cumsum(sum(np.isfinite(run.measurements[name]).astype(int) for name in signals))
    rows = int(np.searchsorted(samples, 2 * unknowns)) + 1
    row_counts = []
    while rows < len(run.time):
        row_counts.append(rows)
        rows *= 2
    return row_counts
