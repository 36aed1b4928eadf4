"""More effects that belong to none of the sixteen families: disturbances from around the rig and faults in its use.

None is a function of the rig's own state that a term of a balance could stand for: four follow the clock, one the
command, and one shifts the clock itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import cos, exp, pi, sin
from typing import ClassVar

from rig.effect import Now, Rest
from rig.schedule import SampledSchedule, Schedule
from rig.seen.strange import Clocked, Strange

State = Sequence[float]


def with_edges(schedule: Schedule, instants: Sequence[float]) -> Schedule:
    """The same currents with switches at further instants, so that the integrator does not step over them."""
    starts = tuple(sorted({*schedule.starts, *instants}))
    if isinstance(schedule, SampledSchedule):
        return replace(schedule, starts=starts)
    return Schedule(starts, tuple(schedule.at(t) for t in starts))


@dataclass(frozen=True)
class Nudge(Clocked):
    """Somebody pushes the load for a moment, at the same time in each run: F sin^2 over the time of the push."""

    form = "nudge"
    size: float = 8.0  # N
    start: float = 3.0  # s
    duration: float = 0.6  # s

    def drive(self, schedule: Schedule) -> Schedule:
        return with_edges(schedule, (self.start, self.start + self.duration))

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        share = (q[0] - self.start) / self.duration
        return self.size * sin(pi * share) ** 2 if 0 < share < 1 else 0.0


@dataclass(frozen=True)
class Intermittent(Clocked):
    """It goes for a share of each period of the clock."""

    period: float = 2.5  # s
    on: float = 0.4  # share of the period
    first: float = 0.5  # s

    def drive(self, schedule: Schedule) -> Schedule:
        begins = [self.first + k * self.period for k in range(12)]
        return with_edges(schedule, [*begins, *(t + self.on * self.period for t in begins)])

    def goes(self, q: State) -> bool:
        """Whether it goes at the time that is its state."""
        place = (q[0] - self.first) / self.period
        return place >= 0 and place % 1 < self.on


@dataclass(frozen=True)
class SecondConsumer(Intermittent):
    """A neighbour draws air from the same supply at times: its absolute pressure is lower by a share for a while."""

    form = "second_consumer"
    share: float = 0.08

    def supply(self, q: State, p: float) -> float:
        return p * (1 - self.share) if self.goes(q) else p


@dataclass(frozen=True)
class WarmingJunction(Clocked):
    """The thermocouple's reference junction sits on warming electronics: the reading drifts by dT (1 - exp(-t/tau))."""

    form = "warming_junction"
    size: float = 2.0  # K
    tau: float = 4.0  # s

    def reading(self, q: State, temperature: float) -> float:
        return temperature - self.size * (1 - exp(-q[0] / self.tau))


@dataclass(frozen=True)
class MainsHum(Clocked):
    """Rectified hum of 100 Hz in the pressure signal: sampled at 100 Hz, it shows as a slow beat.

    The beat is twice what the mains are off 50 Hz, plus what the recorder's clock is off.
    """

    form = "mains_hum"
    size: float = 3e3  # Pa
    frequency: float = 0.3  # Hz, of the beat
    phase: float = 0.0

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge + self.size * cos(2 * pi * self.frequency * q[0] + self.phase)


@dataclass(frozen=True)
class CrossTalk(Strange):
    """The coils of the valves share the ground of the displacement sensor: its reading moves with their currents.

    The states are the currents behind the amplifier's filter of 5 ms.
    """

    form = "cross_talk"
    atol: ClassVar[tuple[float, ...]] = (1e-7,)
    size: float = 3e-3  # m/A

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (sum(rest.currents),)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((sum(now.command) - q[0]) / 5e-3,)

    def position_shown(self, q: State, x: float) -> float:
        return x + self.size * q[0]


@dataclass(frozen=True)
class ClockSkew(Strange):
    """The controller's clock is not the recorder's: what is recorded for t reached the valves at t (1 + skew)."""

    form = "clock_skew"
    skew: float = 0.01

    def drive(self, schedule: Schedule) -> Schedule:
        longer = 1 + self.skew
        starts = tuple(t * longer for t in schedule.starts)
        if isinstance(schedule, SampledSchedule):
            return replace(schedule, starts=starts, step=schedule.step * longer, late=schedule.late * longer)
        return replace(schedule, starts=starts)
