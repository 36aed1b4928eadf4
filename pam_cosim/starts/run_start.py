"""Where the simulation of a run begins, the inputs from there on, and the first samples of the signals."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement import DataSet, Run
from pam_cosim.simulation import AnySimulator, Inputs, Settle, Trajectory

_LEAST = 3  # samples, through which no line has to go


@dataclass(frozen=True)
class FirstSamples:
    """A signal at the first instant of a run, by a line through its first samples.

    Attributes:
        value: [unit]; ``sd``: its standard deviation [unit].
        slope: [unit/s]; ``slope_sd``: its standard deviation, infinite for a single sample.
    """

    value: float
    sd: float
    slope: float = 0.0
    slope_sd: float = float("inf")

    @property
    def moves(self) -> bool:
        """Whether the samples show that the signal changes."""
        return abs(self.slope) > CRITERIA.starts.moving * self.slope_sd


def start_time(run: Run) -> float:
    """When the simulation of a run begins [s].

    A run that records inputs begins with its first row, or as long before as something is known of them. A run without
    inputs is a free motion from the state at time zero, which the first sample may come after.
    """
    first_time = float(run.time[0])
    if run.start.periodic:
        return first_time - run.start.periods * _period(run)
    if run.start.seconds:
        return first_time - run.start.seconds
    return first_time if run.inputs or run.start.is_found else min(0.0, first_time)


def _period(run: Run) -> float:
    """The duration of a periodic run [s]: the row after the last one would be the first again."""
    return float(run.time[-1] - run.time[0] + np.median(np.diff(run.time)))


def inputs_of_run(run: Run) -> Inputs | None:
    """What drives the model, from the start of the simulation on."""
    start, time, values = run.start, run.time, run.inputs
    if not values:
        return None
    if start.seconds:
        # a step at the first row: the value before, and that of the row
        time = np.concatenate([[time[0] - start.seconds, time[0]], time])
        values = {
            n: np.concatenate([np.full(2, start.before.get(n, v[0])), v]) for n, v in values.items()
        }
    elif start.periodic:
        shifts = _period(run) * np.arange(-start.periods, 1)
        time = (shifts[:, None] + time).ravel()
        values = {n: np.tile(v, len(shifts)) for n, v in values.items()}
    return Inputs(time, values, run.interpolation)


@dataclass(frozen=True)
class InitialState:
    """How a simulation begins.

    Attributes:
        values: start values of states by name [SI].
        settle: which states come to rest first, as ``Simulator.run`` has it.
        shown: the signal that shows each of the states; of one that a rate shows, the signal of that.
    """

    values: dict[str, float] = field(default_factory=dict)
    settle: Settle = "none"
    shown: dict[str, str] = field(default_factory=dict)

    def trajectory(
        self,
        simulator: AnySimulator,
        run: Run,
        parameters: Mapping[str, float],
        times: ArrayLike,
        outputs: Sequence[str],
        tolerance: float | None = None,
    ) -> Trajectory:
        """The simulation of a run that begins here.

        Args:
            simulator: the model.
            run: has the inputs, and the time at which the simulation begins.
            parameters: values of the run [SI].
            times: (n,) of the samples of the outputs [s].
            outputs: names of variables.
            tolerance: of the solver.

        Raises:
            SimulationFailure: the run did not reach its end.
        """
        return simulator.run(
            times,
            parameters={**parameters, **self.values},
            inputs=inputs_of_run(run),
            outputs=outputs,
            start_time=start_time(run),
            tolerance=tolerance,
            settle=self.settle,
        )


def measured_signals(run: Run, data: DataSet) -> list[str]:
    """The fitted signals that have samples in a run."""
    return [name for name in data.fitted_signals if run.sample_count(name)]


def first_of_run(run: Run, signal: str, sigma: float, skipped: int = 0) -> FirstSamples | None:
    """A signal at the first row of a run; None where it has no sample, or the first comes after a pause.

    Args:
        run: what was recorded.
        signal: its name.
        sigma: standard deviation of the noise [SI].
        skipped: number of samples at the beginning that are ignored.
    """
    time, values = run.time, run.measurements[signal]
    if signal in run.start.leading:
        early, recorded = run.start.leading[signal]
        later = time >= run.time[0] + run.start.lead
        time, values = np.append(early, time[later]), np.append(recorded, values[later])
    is_sampled = np.isfinite(values)
    is_sampled[np.flatnonzero(is_sampled)[:skipped]] = False
    return first_samples(time, np.where(is_sampled, values, np.nan), sigma, float(run.time[0]))


def first_samples(time: Array, values: Array, sigma: float, start: float) -> FirstSamples | None:
    """The signal at time ``start``; None where there is no sample, or the first comes after a pause.

    Args:
        time: (n,) [s].
        values: (n,) [unit], NaN where a sample is missing.
        sigma: standard deviation of the noise [unit].
        start: [s].
    """
    sample_rows: NDArray[np.intp] = np.flatnonzero(np.isfinite(values))[
        : CRITERIA.starts.most_samples
    ]
    if not sample_rows.size:
        return None
    t, first_value = time[sample_rows] - start, float(values[sample_rows[0]])
    if len(t) > 1 and t[0] > CRITERIA.starts.pause * float(np.median(np.diff(t))):
        return None  # a line through such samples shows the signal's slope then, not its start
    if len(sample_rows) < _LEAST or not sigma:
        return FirstSamples(first_value, sigma)
    # straight lines through the first one, two, ... n samples
    n, y = np.arange(1.0, len(t) + 1.0), values[sample_rows] - first_value
    mean, level = np.cumsum(t) / n, np.cumsum(y) / n
    spread = np.cumsum(t**2) - n * mean**2
    products = np.cumsum(t * y) - n * mean * level
    slope = np.divide(products, spread, out=np.zeros(len(t)), where=spread > 0.0)
    squares = np.maximum(np.cumsum(y**2) - n * level**2 - slope * products, 0.0) / sigma**2
    freedom = n - 2.0
    bent = squares > freedom + CRITERIA.starts.bent * np.sqrt(2.0 * np.maximum(freedom, 0.0))
    bent[: _LEAST - 1] = False
    last = (int(np.argmax(bent)) if bent.any() else len(t)) - 1
    if last < _LEAST - 1 or spread[last] <= 0.0:
        return FirstSamples(first_value, sigma)
    return FirstSamples(
        float(first_value + level[last] - slope[last] * mean[last]),
        float(sigma * np.sqrt(1.0 / n[last] + mean[last] ** 2 / spread[last])),
        float(slope[last]),
        float(sigma / np.sqrt(spread[last])),
    )
