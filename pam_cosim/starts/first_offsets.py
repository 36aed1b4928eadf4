"""How far the first samples of a run are from where the model begins by itself."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pam_cosim.criteria import CRITERIA
from pam_cosim.measurement import Run
from pam_cosim.starts.probe import StartProbe
from pam_cosim.starts.run_start import FirstSamples, first_of_run
from pam_cosim.units import format_quantity


@dataclass(frozen=True)
class FirstOffset:
    """A signal at its first sample, compared with the model that begins by itself.

    Attributes:
        name: of the signal.
        unit: of all numbers.
        sample: the first sample, with its noise.
        others: the first instant by the samples after it; None: there are none.
        model: the model's value there.
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

    def text(self, value: float) -> str:
        """A value of the signal with its unit."""
        return format_quantity(value, self.unit, 3)


def first_offsets(probe: StartProbe) -> list[FirstOffset]:
    """Of the signals that show a state, or of all that are fitted where none does.

    Raises:
        SimulationFailure: the run cannot be simulated.
    """
    if not probe.signals:
        return []
    when = {name: _first_time(probe.run, name) for name in probe.signals}
    times = np.unique(list(when.values()))
    course = probe.course(times)
    offsets = [
        _offset(probe, name, float(course[name][np.searchsorted(times, time)]))
        for name, time in when.items()
    ]
    showing = probe.signals_of_one_state()
    return [one for one in offsets if one.name in showing] or offsets


def _first_time(run: Run, name: str) -> float:
    times, values = run.start.leading.get(name, (run.time[:0], run.time[:0]))
    both = np.append(values, run.measurements[name])
    return float(np.append(times, run.time)[np.isfinite(both)][0])


def _offset(probe: StartProbe, name: str, model: float) -> FirstOffset:
    signal = probe.data.signals[name]
    runs = (r.measurements[name] for r in probe.data.runs if name in r.measurements)
    values = np.concatenate([[model], *runs])
    return FirstOffset(
        name,
        signal.unit,
        probe.first[name],
        first_of_run(probe.run, name, signal.sigma, skipped=1),
        model,
        CRITERIA.starts.away * signal.sigma,
        float(np.nanmax(values) - np.nanmin(values)),
    )
