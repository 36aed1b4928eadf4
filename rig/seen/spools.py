"""What is between a command and a spool, and the shapes of the openings that a spool uncovers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import acos, pi, sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest
from rig.schedule import Currents, Schedule

State = Sequence[float]
_LONGEST = 12.0  # s, more than any run lasts


@dataclass(frozen=True)
class HeldCommand(Effect):
    """The output stage passes a command on once in a cycle and holds it in between.

    Programmable controllers and fieldbus valve terminals have cycles of 10 to 100 ms. Source: K. J. Astrom,
    B. Wittenmark, Computer-Controlled Systems (1997), chapter 2, on zero-order hold.
    """

    family = "valve_dynamics"
    form = "held_command"
    cycle: float = 0.05  # s
    first: float = 0.5  # of the cycle

    def drive(self, schedule: Schedule) -> Schedule:
        starts: list[float] = []
        felt: list[Currents] = []
        for k in range(int(_LONGEST / self.cycle)):
            t = (self.first + k) * self.cycle
            command = schedule.at(t)
            if not felt or command != felt[-1]:
                starts.append(t)
                felt.append(command)
        return Schedule(tuple(starts), tuple(felt))


@dataclass(frozen=True)
class ThreeLags(Effect):
    """Driver, coil and spool follow one another, three equal first-order lags in series.

    Source: H. E. Merritt, Hydraulic Control Systems (1967), chapter 5, on the chain from amplifier to spool.
    """

    family = "valve_dynamics"
    form = "three_lags"
    atol: ClassVar[tuple[float, ...]] = (1e-9,) * 6
    tau: float = 0.02  # s, of each

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,) * 6

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        before = (now.command[0], q[0], q[1], now.command[1], q[3], q[4])
        return tuple((a - b) / self.tau for a, b in zip(before, q, strict=True))

    def current(self, q: State, command: Currents) -> Currents:
        return q[2], q[5]


@dataclass(frozen=True)
class RoundPort(Effect):
    """A spool that uncovers round holes in its sleeve: the area is a circle's segment over the stroke, by a share.

    The rest of the holes are the slots of the linear law, and both are fully open at the same stroke. Source: J. F.
    Blackburn, G. Reethof, J. L. Shearer, Fluid Power Control (1960), chapter 7, on round ports.
    """

    family = "valve_area"
    form = "round_port"
    share: float = 0.3
    full: float = 9e-7  # m2, of the linear law where the holes are fully open

    def _area(self, linear: float) -> float:
        h = min(linear / self.full, 1.0)
        segment = (acos(1 - 2 * h) - 2 * (1 - 2 * h) * sqrt(h * (1 - h))) / pi
        return (1 - self.share) * linear + self.share * self.full * segment

    def areas(self, areas: tuple[float, float], currents: Currents) -> tuple[float, float]:
        return self._area(areas[0]), self._area(areas[1])


@dataclass(frozen=True)
class NarrowSlot(Effect):
    """Where the opening is narrow, its walls slow the flow down: A A/(A + A_t).

    The discharge coefficient rises from nothing with the opening and levels off, as flow turns from laminar to
    turbulent. Source: H. E. Merritt, Hydraulic Control Systems (1967), section 3.3; the transition is reasoned.
    """

    family = "valve_area"
    form = "narrow_slot"
    transition: float = 3e-8  # m2, A_t

    def areas(self, areas: tuple[float, float], currents: Currents) -> tuple[float, float]:
        a, b = (area * area / (area + self.transition) for area in areas)
        return a, b
