"""Piecewise constant valve currents."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

Currents = tuple[float, float]  # u_in, u_out [A]
LONGEST = 12.0  # s, more than any run lasts


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

    def within(self, left: float) -> Callable[[float], Currents]:
        """Currents [A] as a function of time, in the piece that begins at `left` [s]."""
        held = self.at(left)
        return lambda t: held

    def delayed(self, dead_time: float) -> Schedule:
        """The same currents, `dead_time` [s] later."""
        return Schedule(tuple(t + dead_time for t in self.starts), self.currents)


@dataclass(frozen=True)
class SampledSchedule(Schedule):
    """Currents joined by straight lines between samples; `starts` are the instants where the slope jumps much.

    samples[k] belongs to k step [s]; the first and the last hold outside.
    """

    step: float = 0.01  # s
    samples: tuple[Currents, ...] = ()
    late: float = 0.0  # s

    @staticmethod
    def joined(samples: Sequence[Currents], step: float, jump: float = 0.02) -> SampledSchedule:
        """Lines between samples `step` [s] apart, with corners where the slope changes by `jump` [A/step]."""
        corners = [
            k * step for k in range(1, len(samples) - 1)
            if any(abs(samples[k + 1][i] - 2 * samples[k][i] + samples[k - 1][i]) > jump for i in (0, 1))
        ]  # fmt: skip
        return SampledSchedule(tuple(corners), (), step, tuple(samples))

    def at(self, t: float) -> Currents:
        """Currents [A] at time t [s]."""
        place = (t - self.late) / self.step
        if place <= 0:
            return self.samples[0]
        k = int(place)
        if k >= len(self.samples) - 1:
            return self.samples[-1]
        share, (a, b), (c, d) = place - k, self.samples[k], self.samples[k + 1]
        return a + share * (c - a), b + share * (d - b)

    def within(self, left: float) -> Callable[[float], Currents]:
        """Currents [A] as a function of time; the same one in every piece."""
        return self.at

    def delayed(self, dead_time: float) -> SampledSchedule:
        """The same currents, `dead_time` [s] later."""
        starts = tuple(t + dead_time for t in self.starts)
        return replace(self, starts=starts, late=self.late + dead_time)
