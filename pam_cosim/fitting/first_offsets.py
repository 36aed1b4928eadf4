"""How far the first samples of a run are from where the model begins by itself."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from pam_cosim.comparison.run_start import first_of_run
from pam_cosim.comparison.start_probe import StartProbe
from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement import DataSet, FirstSamples, Run
from pam_cosim.simulation import AnySimulator
from pam_cosim.units import format_quantity


@dataclass(frozen=True)
class FirstOffset:
    """A signal at its first sample, beside the model that begins by itself.

    Attributes:
        name: of the signal.
        unit: of all numbers.
        sample: the first sample, with its noise.
        others: what the samples after it say of the first instant; None: there are none.
        model: what the model gives there.
        noise: the largest offset that noise makes.
        span: range of the signal over all runs and the model's first value.
    """

    name: str
    unit: str
    sample: FirstSamples
    others: FirstSamples | None
    model: float
    noise: float
    span: float

    @property
    def offset(self) -> float:
        """The first sample less the model's value."""
        return self.sample.value - self.model

    @property
    def exceeds_noise(self) -> bool:
        """Whether the offset is more than noise makes, and more than one slip: the samples after it show it too."""
        also = self.others is None or abs(self.others.value - self.model) > self.noise
        return also and abs(self.offset) > self.noise

    def exceeds_instrument(self, common: float | None) -> bool:
        """Whether neither noise nor an instrument's offset explains it, which is small and the same in all runs.

        Args:
            common: the offset of most runs; None where too few are known.
        """
        if not self.exceeds_noise:
            return False
        is_large = abs(self.offset) > CRITERIA.recognition.offset * self.span
        return is_large or (common is not None and abs(self.offset - common) > self.noise)

    def sample_text(self) -> str:
        """The first sample with its unit."""
        return format_quantity(self.sample.value, self.unit, 3)

    def model_text(self) -> str:
        """The model's value with its unit."""
        return format_quantity(self.model, self.unit, 3)


def first_offsets(
    simulator: AnySimulator, data: DataSet, run: Run, parameters: Mapping[str, float]
) -> list[FirstOffset]:
    """Of the signals that show a state, or of all that are fitted where none does.

    Args:
        simulator: the model.
        data: the measurement with its noise.
        run: one of its runs.
        parameters: what the run is simulated with [SI].

    Raises:
        SimulationFailure: the run cannot be simulated.
    """
    probe = StartProbe(simulator, data, run, parameters)
    when = {name: _first_time(run, name) for name in probe.signals}
    times = np.unique(list(when.values()))
    if not times.size:
        return []
    course = probe.course(times, probe.signals)
    model = {
        name: float(course[name][np.searchsorted(times, when[name])]) for name in probe.signals
    }
    offsets = [_offset(data, run, name, value) for name, value in model.items()]
    showing = probe.signals_of_one_state()
    return [one for one in offsets if one.name in showing] or offsets


def _first_time(run: Run, name: str) -> float:
    times, values = run.start.leading.get(name, (run.time[:0], run.time[:0]))
    both = np.append(values, run.measurements[name])
    return float(np.append(times, run.time)[np.isfinite(both)][0])


def _offset(data: DataSet, run: Run, name: str, model: float) -> FirstOffset:
    signal = data.signals[name]
    sample = first_of_run(run, name, signal.sigma)
    assert sample is not None
    values = np.concatenate(
        [[model], *(r.measurements[name] for r in data.runs if name in r.measurements)]
    )
    span = float(np.nanmax(values) - np.nanmin(values))
    others = first_of_run(run, name, signal.sigma, skipped=1)
    return FirstOffset(
        name, signal.unit, sample, others, model, CRITERIA.starts.away * signal.sigma, span
    )
