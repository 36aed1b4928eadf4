"""How far apart the predictions of rivals lie in a run, after each is fitted to it."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import replace
from pathlib import Path

import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.criteria import CRITERIA
from pam_cosim.diagnosis.judgement.candidate import Candidate
from pam_cosim.diagnosis.judgement.prediction import Hypothesis, Prediction
from pam_cosim.diagnosis.planning.course import Course
from pam_cosim.diagnosis.planning.limits import Limits
from pam_cosim.errors import SimulationFailure
from pam_cosim.measurement import DataSet, Run, further_run
from pam_cosim.model.interface import Interface

_ROWS = 400  # of a course while courses are compared


class Rivals:
    """Fitted models of different explanations; a context manager.

    Args:
        explanations: at least two, each with its models, candidates with a fit.
        data: the measurement, with noise levels.
        limits: of the rig.
        files: further Modelica files.
        tests_first: only the first explanation is to be told from the others, and not these from one another.
    """

    def __init__(
        self,
        explanations: Sequence[Sequence[Candidate]],
        data: DataSet,
        limits: Limits,
        files: Sequence[Path] = (),
        *,
        tests_first: bool = False,
    ) -> None:
        self.models = tuple(model for models in explanations for model in models)
        self.data, self.limits = data, limits
        of = [number for number, models in enumerate(explanations) for _ in models]
        all_pairs = itertools.combinations(range(len(self.models)), 2)
        self.pairs = [
            (i, j) for i, j in all_pairs if of[i] != of[j] and not (tests_first and of[i] > 0)
        ]
        self._files, self._stack = files, ExitStack()
        self._hypotheses: list[Hypothesis] = []

    def __enter__(self) -> Rivals:
        with ExitStack() as stack:
            self._hypotheses = [
                stack.enter_context(Hypothesis(model, self.data, self._files))
                for model in self.models
            ]
            self._stack = stack.pop_all()
        return self

    def __exit__(self, *_: object) -> None:
        self._stack.close()

    @property
    def interface(self) -> Interface:
        """Inputs, outputs and parameters of the first model."""
        return self._hypotheses[0].interface

    @property
    def sigma(self) -> dict[str, float]:
        """Noise of the signals that are predicted, in their order [SI]; where it grows, its root mean square."""
        return self._hypotheses[0].sigma

    def run_of(self, course: Course, interval: float | None = None) -> Run:
        """A course as a run of the data set, without measurements.

        Args:
            course: what is driven and set.
            interval: between two samples [s]; None: that of the recordings.
        """
        time, inputs = course.table(self.limits, interval)
        return further_run(self.data, time, inputs, course.parameters)

    def predictions(self, run: Run, tolerance: float | None = None) -> list[Prediction] | None:
        """What each model predicts of a run; None where one breaks down or a signal leaves its limits."""
        try:
            predictions = [p.predict(run, tolerance) for p in self._hypotheses]
        except SimulationFailure:
            return None
        return predictions if all(self._is_allowed(p, len(run.time)) for p in predictions) else None

    def separations(self, predictions: Sequence[Prediction], weight: float = 1.0) -> Array:
        """(pairs,) chi-square that the worse of two models is expected to leave more than the other.

        Whichever of the two is right, the other one is fitted to what has been seen and to the new run as well, to
        first order: what counts is what it then still misses (T-optimality, Atkinson and Fedorov 1975).

        Args:
            predictions: by each model.
            weight: number of samples that each row stands for.
        """
        scaled = [replace(p, sigma=p.sigma / weight**0.5) for p in predictions]
        models = self._hypotheses
        return np.array([
            min(models[j].refitted_miss(scaled[i], scaled[j]), models[i].refitted_miss(scaled[j], scaled[i]))
            for i, j in self.pairs
        ])  # fmt: skip

    def thinned(self, course: Course) -> Array | None:
        """The separations of a course from fewer samples, each of which counts for several."""
        interval = max(self.limits.interval, self.limits.seconds / _ROWS)
        predictions = self.predictions(
            self.run_of(course, interval), CRITERIA.search.screening_tolerance
        )
        return (
            None
            if predictions is None
            else self.separations(predictions, interval / self.limits.interval)
        )

    def _is_allowed(self, predictions: Prediction, rows: int) -> bool:
        for i, name in enumerate(self.sigma):
            if name in self.limits.outputs:
                low, high = self.limits.outputs[name]
                values = predictions.values[i * rows : (i + 1) * rows]
                if values.min() < low or values.max() > high:
                    return False
        return True


def soft_minimum(separations: Array) -> float:
    """The chi-square of the pair that is least apart, where others that are as near count as well.

    The chance to take one of two models for the other is below exp(-chi-square / 8) / 2 (Bhattacharyya 1943, for two
    normal distributions of one variance); the mean of these bounds over the pairs is that of this number.
    """
    least = float(separations.min())
    return least - 8.0 * float(np.log(np.mean(np.exp(-(separations - least) / 8.0))))
