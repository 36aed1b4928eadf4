"""Instruments that err in ways that belong to no family."""

from __future__ import annotations

from dataclasses import replace
from math import cos, exp, pi, sin, sqrt, tanh
from typing import ClassVar

from rig.effect import Now, Rest, State, law
from rig.schedule import LONGEST, SampledSchedule, Schedule
from rig.seen.none_of_these.base import Clocked, Strange, with_edges

_QUICK = 5e-3  # s, behind which states follow what an instrument feels at once


@law
class DriftingRuler(Clocked):
    """The displacement sensor drifts away and comes back within a run."""

    size: float = 1e-3  # m
    period: float = 7.0  # s

    def position_shown(self, q: State, x: float) -> float:
        return x + self.size * (1 - cos(2 * pi * q[0] / self.period)) / 2


@law
class EncoderError(Strange):
    """The displacement sensor interpolates badly between its lines."""

    size: float = 5e-4  # m
    pitch: float = 6e-3  # m

    def position_shown(self, q: State, x: float) -> float:
        return x + self.size * sin(2 * pi * x / self.pitch)


@law
class SensorBacklash(Strange):
    """The displacement sensor's gear has play: what it shows follows x through a rounded play of +-half a gap."""

    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    gap: float = 1e-3  # m

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        # q is the place in the gap, -1 to 1: it moves with v until it meets the flank
        toward = q[0] * (1 if now.v > 0 else -1)
        return (now.v / (self.gap / 2) * (1 - max(0.0, toward) ** 8),)

    def position_shown(self, q: State, x: float) -> float:
        return x - self.gap / 2 * q[0]


@law
class FilteredRuler(Strange):
    """The displacement sensor's amplifier filters: its reading lags."""

    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    tau: float = 0.05  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.x - q[0]) / self.tau,)

    def position_shown(self, q: State, x: float) -> float:
        return q[0]


@law
class SnubbedManometer(Strange):
    """A snubber in front of the pressure transducer: its reading lags."""

    atol: ClassVar[tuple[float, ...]] = (1e-4,)
    tau: float = 0.05  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.p_gauge - q[0]) / self.tau,)

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return q[0]


@law
class WarmingJunction(Clocked):
    """The thermocouple's reference junction sits on warming electronics: the reading drifts by dT (1 - exp(-t/tau))."""

    size: float = 2.0  # K
    tau: float = 4.0  # s

    def reading(self, q: State, temperature: float) -> float:
        return temperature - self.size * (1 - exp(-q[0] / self.tau))


@law
class MainsHum(Clocked):
    """Rectified hum of 100 Hz in the pressure signal: sampled at 100 Hz, it shows as a slow beat.

    The beat is twice what the mains are off 50 Hz, plus what the recorder's clock is off.
    """

    size: float = 3e3  # Pa
    frequency: float = 0.3  # Hz, of the beat
    phase: float = 0.0

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge + self.size * cos(2 * pi * self.frequency * q[0] + self.phase)


@law
class CrossTalk(Strange):
    """The coils of the valves share the ground of the displacement sensor: its reading moves with their currents.

    The states are the currents behind the amplifier's filter of 5 ms.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-7,)
    size: float = 3e-3  # m/A

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (sum(rest.currents),)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((sum(now.command) - q[0]) / 5e-3,)

    def position_shown(self, q: State, x: float) -> float:
        return x + self.size * q[0]


@law
class ClockSkew(Strange):
    """The controller's clock is not the recorder's: what is recorded for t reached the valves at t (1 + skew)."""

    skew: float = 0.01

    def drive(self, schedule: Schedule) -> Schedule:
        longer = 1 + self.skew
        starts = tuple(t * longer for t in schedule.starts)
        if isinstance(schedule, SampledSchedule):
            return replace(
                schedule, starts=starts, step=schedule.step * longer, late=schedule.late * longer
            )
        return replace(schedule, starts=starts)


@law
class SlippedRuler(Clocked):
    """The clamp of the displacement sensor slips once in a run, and what it shows is off from then on."""

    size: float = 1e-3  # m
    at: float = 3.0  # s

    def position_shown(self, q: State, x: float) -> float:
        return x + self.size * (1 + tanh((q[0] - self.at) / 0.02)) / 2


@law
class SaggingExcitation(Strange):
    """The valves draw from the supply of the pressure transducer, whose gain sags with their currents.

    The state is the sum of the currents by 0.35 A behind 5 ms.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-7,)
    share: float = 0.03

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (sum(rest.currents) / 0.35,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((sum(now.command) / 0.35 - q[0]) / 5e-3,)

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge * (1 - self.share * q[0])


@law
class OwnClock(Strange):
    """The displacement is logged by a device with a clock of its own, which goes wrong more and more in a run.

    What stands at t was at t (1 + skew), x + skew t v to first order. States: the time, and x behind 5 ms for v.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    skew: float = 0.01

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, rest.x)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return 1.0, (now.x - q[1]) / 5e-3

    def position_shown(self, q: State, x: float) -> float:
        return x + self.skew * q[0] * (x - q[1]) / 5e-3


@law
class SelfHeating(Strange):
    """A resistance thermometer whose measuring current heats it where no gas flows: T + dT/(1 + (|m|/m_0)^(1/2)).

    The state is the size of the flow behind 50 ms.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    size: float = 2.0  # K
    m_0: float = 3e-5  # kg/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((abs(now.net_mass_flow) - q[0]) / 0.05,)

    def reading(self, q: State, temperature: float) -> float:
        return temperature + self.size / (1 + sqrt(max(q[0], 0.0) / self.m_0))


@law
class CompliantFrame(Strange):
    """The beam that carries the muscle bends under its pull, and the ruler stands on the floor: it shows x - F/k.

    State: the bending behind 5 ms. Source: Hooke's law; the pull by virtual work as in the base model.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    compliance: float = 3e-5  # m/N
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    turns: float = 2.0

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        length = self.length - now.x
        pull = now.p_gauge * (3 * length * length - self.fibre_squared) / (4 * pi * self.turns**2)
        return ((self.compliance * pull - q[0]) / _QUICK,)

    def position_shown(self, q: State, x: float) -> float:
        return x - q[0]


@law
class GroundLoop(Strange):
    """The coils' return currents lift the thermocouple's ground, one way or the other: T + size (u_in - u_out)/0.35 A.

    State: the difference of the currents behind 5 ms. Source: R. Morrison, Grounding and Shielding (2007).
    """

    atol: ClassVar[tuple[float, ...]] = (1e-7,)
    size: float = 2.0  # K

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (((now.command[0] - now.command[1]) / 0.35 - q[0]) / _QUICK,)

    def reading(self, q: State, temperature: float) -> float:
        return temperature + self.size * q[0]


@law
class SlowReel(Strange):
    """The ruler's string is wound up by a weak reel: it follows down no faster than v_r. State: what it shows."""

    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    fastest: float = 0.03  # m/s, v_r

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        gap = (now.x - q[0]) / 1e-3
        return (gap if gap > 0 else gap / sqrt(1 + (gap / self.fastest) ** 2),)

    def position_shown(self, q: State, x: float) -> float:
        return q[0]


@law
class ResidualCharge(Strange):
    """The logger's multiplexer takes some charge from the ruler's channel to the thermocouple's: it shows T + c x.

    State: the contraction. Source: data sheets of scanning loggers, on settling between channels.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    per_metre: float = 30.0  # K/m

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.v,)

    def reading(self, q: State, temperature: float) -> float:
        return temperature + self.per_metre * q[0]


@law
class FrozenDisplay(Strange):
    """The ruler's display freezes for a moment now and then. States: the time, and what it shows (behind 5 ms)."""

    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    off: float = 0.1  # s
    period: float = 1.2  # s
    first: float = 0.4  # s

    def _begins(self) -> list[float]:
        return [
            self.first + k * self.period
            for k in range(int((LONGEST - self.first) / self.period) + 1)
        ]

    def drive(self, schedule: Schedule) -> Schedule:
        begins = self._begins()
        return with_edges(schedule, [*begins, *(t + self.off for t in begins)])

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, rest.x)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        since = q[0] - self.first
        frozen = since >= 0 and since % self.period < self.off
        return 1.0, 0.0 if frozen else (now.x - q[1]) / _QUICK

    def position_shown(self, q: State, x: float) -> float:
        return q[1]


@law
class SettlingRope(Strange):
    """The knots of a new rope settle when it first carries the load, which stays lower by s from then on.

    s' = (size - s)/tau while the load is off the stop, rounded over 0.3 mm at 1 mm. State: s.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    size: float = 1.5e-3  # m
    tau: float = 0.5  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        carried = (1 + tanh((now.x - 1e-3) / 3e-4)) / 2
        return ((self.size - q[0]) / self.tau * carried,)

    def position_shown(self, q: State, x: float) -> float:
        return x - q[0]


@law
class LostCounts(Strange):
    """The ruler's counter misses a share of its counts while the load is fast. State: the way that it missed."""

    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    share: float = 0.05
    fast: float = 0.04  # m/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        missing = (1 + tanh((abs(now.v) / self.fast - 1) * 10)) / 2
        return (self.share * missing * now.v,)

    def position_shown(self, q: State, x: float) -> float:
        return x - q[0]
