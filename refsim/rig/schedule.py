"""What a rig is told: valve currents and other inputs, held or joined by lines."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

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


@dataclass(frozen=True)
class Course:
    """One input besides the currents, joined by straight lines between samples: a contraction, a pressure.

    values[k] belongs to k step + late [s]; the first and the last hold outside. `starts` are the instants where the
    slope jumps by more than `jump` a step.
    """

    values: tuple[float, ...]
    step: float = 0.01  # s
    jump: float = float("inf")
    late: float = 0.0  # s

    @cached_property
    def starts(self) -> tuple[float, ...]:
        """The corners at which an integrator has to stop."""
        y = self.values
        bends = (k for k in range(1, len(y) - 1) if abs(y[k + 1] - 2 * y[k] + y[k - 1]) > self.jump)
        return tuple(k * self.step + self.late for k in bends)

    def at(self, t: float) -> tuple[float]:
        """The value at time t [s]."""
        place = (t - self.late) / self.step
        if place <= 0:
            return (self.values[0],)
        k = int(place)
        if k >= len(self.values) - 1:
            return (self.values[-1],)
        return (self.values[k] + (place - k) * (self.values[k + 1] - self.values[k]),)

    def within(self, left: float) -> Callable[[float], tuple[float, ...]]:
        """The value as a function of time; the same one in every piece."""
        return self.at

    def delayed(self, dead_time: float) -> Course:
        """The same course, `dead_time` [s] later."""
        return replace(self, late=self.late + dead_time)


@dataclass(frozen=True)
class Joint:
    """Several inputs at once: their values one after another."""

    parts: tuple[Schedule | Course, ...]

    @cached_property
    def starts(self) -> tuple[float, ...]:
        """The switches of all parts."""
        return tuple(sorted({t for part in self.parts for t in part.starts}))

    def at(self, t: float) -> tuple[float, ...]:
        """All values at time t [s]."""
        return tuple(value for part in self.parts for value in part.at(t))

    def within(self, left: float) -> Callable[[float], tuple[float, ...]]:
        """All values as a function of time, in the piece that begins at `left` [s]."""
        pieces = [part.within(left) for part in self.parts]
        return lambda t: tuple(value for piece in pieces for value in piece(t))
