"""What a fitted hypothesis predicts of an experiment, and how far its parameters could still give way."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.comparison import simulate_run
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.fmu import build_source
from pam_cosim.measurement import DataSet, Run
from pam_cosim.model.interface import Interface, sensitivity_name
from pam_cosim.model.references import is_ratio, parameter_of
from pam_cosim.simulation import Simulator


class Hypothesis:
    """A candidate's model at its fitted parameters; a context manager.

    Args:
        candidate: with a fit.
        data: the measurement, with noise levels; its fit runs hold the parameters where they are.
        files: further Modelica files.
    """

    def __init__(self, candidate: Candidate, data: DataSet, files: Sequence[Path] = ()) -> None:
        self.candidate, self.data = candidate, data
        self.values = candidate.fit.values_and_starts
        self.free = [n for n, e in candidate.fit.parameters.items() if not e.at_bound and not e.run]
        self.sigma = {n: s.sigma for n, s in data.fitted_signals.items()}
        name, differentiated = candidate.equations.split()[1], [parameter_of(n) for n in self.free]
        self._simulator = Simulator(
            build_source(name, candidate.equations, files, sensitivities=differentiated, lean=True)
        )
        self._information_root: Array | None = None

    def __enter__(self) -> Hypothesis:
        return self

    def __exit__(self, *_: object) -> None:
        self._simulator.close()

    @property
    def interface(self) -> Interface:
        """Inputs, outputs and parameters of the model."""
        return self._simulator.interface

    def predict(self, run: Run, tolerance: float | None = None) -> Prediction:
        """Signals of a run, their slopes and their noise: a sample of each signal at each row of the run.

        Args:
            run: inputs, known parameters and sample times.
            tolerance: of the solver; None: its own.

        Raises:
            SimulationFailure: the run did not reach its end.
        """
        sensitivities = self._simulator.interface.sensitivities
        slopes = {
            (s, p): n
            for s in self.sigma
            for p in self.free
            if (n := sensitivity_name(s, parameter_of(p))) in sensitivities
        }
        output_names = [*self.sigma, *slopes.values()]
        comparison = simulate_run(
            self._simulator, self.data, run, self.values, tolerance, output_names
        )
        values = np.concatenate([comparison.model[s] for s in self.sigma])
        columns = np.zeros((len(values), len(self.free)))
        for j, p in enumerate(self.free):
            size = (
                run.parameters.get(parameter_of(p), 0.0)
                if is_ratio(p)
                else float(p not in run.parameters)
            )
            if size:
                columns[:, j] = np.concatenate(
                    [
                        size * comparison.model[slopes[s, p]]
                        if (s, p) in slopes
                        else np.zeros(len(run.time))
                        for s in self.sigma
                    ]
                )
        noise = [self._noise(s, comparison.model[s]) for s in self.sigma]
        return Prediction(values, columns, np.concatenate(noise))

    def _noise(self, signal: str, values: Array) -> Array:
        """(n,) standard deviations of readings of these values."""
        return np.broadcast_to(self.data.signals[signal].sigma_at(values), values.shape)

    @property
    def information_root(self) -> Array:
        """(k, k) triangular: the fit runs resist a change of the parameters by the square of its product."""
        if self._information_root is None:
            rows = [np.zeros((1, len(self.free))), *map(self._information_rows, self.data.fit_runs)]
            self._information_root = np.asarray(np.linalg.qr(np.vstack(rows), mode="r"))
        return self._information_root

    def _information_rows(self, run: Run) -> Array:
        """(m, k) slopes of the m samples that were taken in a run, in standard deviations of their noise."""
        never = np.full(len(run.time), np.nan)
        is_measured = np.isfinite(
            np.concatenate([run.measurements.get(s, never) for s in self.sigma])
        )
        prediction = self.predict(run)
        return np.asarray((prediction.slopes / prediction.sigma[:, None])[is_measured])

    def refitted_miss(self, truth: Prediction, prediction: Prediction) -> float:
        """Sum of squares that is left when this hypothesis is fitted to what it has seen and to a new run as well.

        To first order in the parameters. A parameter without sensitivities stays where it is. The noise is that of the
        truth's readings: both are weighed by it, also where it grows with the reading.
        """
        miss = (truth.values - prediction.values) / truth.sigma
        rows = np.vstack([prediction.slopes / truth.sigma[:, None], self.information_root])
        size = np.linalg.norm(rows, axis=0)
        size[size == 0] = 1.0
        target = np.concatenate([miss, np.zeros(len(self.information_root))])
        change = np.linalg.lstsq(rows / size, target, rcond=1e-10)[0]
        return float(np.sum((target - rows / size @ change) ** 2))


@dataclass(frozen=True)
class Prediction:
    """What a model predicts of n samples.

    Attributes:
        values: (n,) in the units of the signals, one signal after another.
        slopes: (n, k) by the free parameters.
        sigma: (n,) standard deviation of the noise of a reading.
    """

    values: Array
    slopes: Array
    sigma: Array
