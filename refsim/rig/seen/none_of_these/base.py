"""What effects in no family have in common: a family's name, a clock, edges of the clock in the schedule."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law
from rig.schedule import SampledSchedule, Schedule


@law
class Strange(Effect):
    """Of no family."""

    family = "none_of_these"


@law
class Clocked(Strange):
    """Its own state is the time."""

    atol: ClassVar[tuple[float, ...]] = (1e-9,)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (1.0,)


def with_edges(schedule: Schedule, instants: Sequence[float]) -> Schedule:
    """The same currents with switches at further instants, so that the integrator does not step over them."""
    starts = tuple(sorted({*schedule.starts, *instants}))
    if isinstance(schedule, SampledSchedule):
        return replace(schedule, starts=starts)
    return Schedule(starts, tuple(schedule.at(t) for t in starts))


@law
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
