"""Effects in no family: loose plugs and clamps, sensors in the wrong place, what comes from outside.

As those of `strange` and `faults`, each is kept away from what a family says.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, exp, pi, sqrt, tanh
from typing import ClassVar

from rig.effect import Now, Rest
from rig.schedule import Currents, Schedule
from rig.seen.faults import with_edges
from rig.seen.strange import Clocked, Strange

State = Sequence[float]
_LONGEST = 12.0  # s, more than any run lasts


@dataclass(frozen=True)
class LooseContact(Clocked):
    """The plug of the valves has a loose contact: now and then both are without current for a moment."""

    form = "loose_contact"
    off: float = 0.08  # s
    period: float = 1.2  # s
    first: float = 0.3  # s

    def _begins(self) -> list[float]:
        return [self.first + k * self.period for k in range(int((_LONGEST - self.first) / self.period) + 1)]

    def drive(self, schedule: Schedule) -> Schedule:
        begins = self._begins()
        return with_edges(schedule, [*begins, *(t + self.off for t in begins)])

    def current(self, q: State, command: Currents) -> Currents:
        since = q[0] - self.first
        return (0.0, 0.0) if since >= 0 and since % self.period < self.off else command


@dataclass(frozen=True)
class SlippedRuler(Clocked):
    """The clamp of the displacement sensor slips once in a run, and what it shows is off from then on."""

    form = "slipped_ruler"
    size: float = 1e-3  # m
    at: float = 3.0  # s

    def position_shown(self, q: State, x: float) -> float:
        return x + self.size * (1 + tanh((q[0] - self.at) / 0.02)) / 2


@dataclass(frozen=True)
class ObliqueString(Strange):
    """The displacement sensor's string runs aslant: it shows sqrt((a + x)^2 + d^2) - sqrt(a^2 + d^2).

    The sensor sits d beside the line of movement and, at rest, a along it.
    """

    form = "oblique_string"
    d: float = 0.08  # m
    a: float = 0.25  # m

    def position_shown(self, q: State, x: float) -> float:
        return sqrt((self.a + x) ** 2 + self.d**2) - sqrt(self.a**2 + self.d**2)


@dataclass(frozen=True)
class WarmCoils(Strange):
    """The valves' coils warm the thermocouple's connector: the reading sinks, behind a lag, with their electric power.

    The state is the power by that at 0.35 A, behind the lag.
    """

    form = "warm_coils"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    size: float = 2.0  # K
    tau: float = 2.0  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (((now.command[0] ** 2 + now.command[1] ** 2) / 0.35**2 - q[0]) / self.tau,)

    def reading(self, q: State, temperature: float) -> float:
        return temperature - self.size * q[0]


@dataclass(frozen=True)
class RestlessStart(Clocked):
    """The frame still rings from the handling when a run starts: F exp(-t/tau) cos(2 pi f t + phase)."""

    form = "restless_start"
    size: float = 8.0  # N
    tau: float = 3.0  # s
    frequency: float = 1.2  # Hz
    phase: float = 0.0

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.size * exp(-q[0] / self.tau) * cos(2 * pi * self.frequency * q[0] + self.phase)


@dataclass(frozen=True)
class EmptyBottle(Clocked):
    """The bottle of compressed air runs empty: the supply's absolute pressure sinks in a run, by a share in 10 s."""

    form = "empty_bottle"
    share: float = 0.15

    def supply(self, q: State, p: float) -> float:
        return p * (1 - min(self.share * q[0] / 10.0, 0.7))
