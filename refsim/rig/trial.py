"""One run on any bench: what is told, and when is looked."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from rig.integrate import Array
from rig.schedule import Course, SampledSchedule, Schedule


@dataclass(frozen=True)
class Trial:
    """One run.

    Attributes:
        style: of what is told. role: fit or holdout. samples, rate: how many, and how many a second [Hz].
        schedules: of the currents, one for each pair of valves. course: the other input that moves, if there is one.
        values: what is different in this run, by parameter or constant input of the bench [SI].
        begin: the first sample that is recorded; what comes before it happens all the same.
    """

    style: str
    role: str
    samples: int
    rate: float
    schedules: tuple[Schedule, ...] = ()
    course: Course | None = None
    values: Mapping[str, float] = field(default_factory=dict)
    begin: int = 0

    @property
    def times(self) -> Array:
        """Instants of the samples [s]."""
        return np.arange(self.samples) / self.rate

    @property
    def recorded(self) -> Array:
        """Instants of those that are recorded [s]."""
        return self.times[self.begin :]

    @property
    def held(self) -> bool:
        """Whether the currents are held between their switches, and not joined by lines."""
        return bool(self.schedules) and not any(
            isinstance(s, SampledSchedule) for s in self.schedules
        )
