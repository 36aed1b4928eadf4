"""Piecewise constant valve currents."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass

Currents = tuple[float, float]  # u_in, u_out [A]


@dataclass(frozen=True)
class Phase:
    """Both currents held for a while."""

    duration: float  # s
    u_in: float = 0.0  # A
    u_out: float = 0.0  # A


@dataclass(frozen=True)
class Schedule:
    """The currents (u_in, u_out)[k] from time starts[k] on; zero before the first."""

    starts: tuple[float, ...]
    currents: tuple[Currents, ...]

    @staticmethod
    def of(phases: Sequence[Phase]) -> Schedule:
        """The schedule that runs the phases one after another from t = 0; the last is held."""
        starts, t = [], 0.0
        for phase in phases:
            starts.append(round(t, 9))
            t += phase.duration
        return Schedule(tuple(starts), tuple((phase.u_in, phase.u_out) for phase in phases))

    def at(self, t: float) -> Currents:
        """Currents [A] at time t [s]; a switch belongs to the phase that begins."""
        k = bisect_right(self.starts, t + 1e-9) - 1
        return self.currents[k] if k >= 0 else (0.0, 0.0)

    def delayed(self, dead_time: float) -> Schedule:
        """The same currents, `dead_time` [s] later."""
        return Schedule(tuple(t + dead_time for t in self.starts), self.currents)
