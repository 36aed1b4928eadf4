"""Instruments that err in ways that belong to no family."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import cos, exp, pi, sin, sqrt, tanh
from typing import ClassVar

from rig.effect import Now, Rest, State
from rig.schedule import SampledSchedule, Schedule
from rig.seen.none_of_these.base import Clocked, Strange


@dataclass(frozen=True)
class DriftingRuler(Clocked):
    """The displacement sensor drifts away and comes back within a run."""

    form = "drifting_ruler"
    size: float = 1e-3  # m
    period: float = 7.0  # s

    def position_shown(self, q: State, x: float) -> float:
        return x + self.size * (1 - cos(2 * pi * q[0] / self.period)) / 2


@dataclass(frozen=True)
class EncoderError(Strange):
    """The displacement sensor interpolates badly between its lines."""

    form = "encoder_error"
    size: float = 5e-4  # m
    pitch: float = 6e-3  # m

    def position_shown(self, q: State, x: float) -> float:
        return x + self.size * sin(2 * pi * x / self.pitch)


@dataclass(frozen=True)
class SensorBacklash(Strange):
    """The displacement sensor's gear has play: what it shows follows x through a rounded play of +-half a gap."""

    form = "sensor_backlash"
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


@dataclass(frozen=True)
class FilteredRuler(Strange):
    """The displacement sensor's amplifier filters: its reading lags."""

    form = "filtered_ruler"
    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    tau: float = 0.05  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.x - q[0]) / self.tau,)

    def position_shown(self, q: State, x: float) -> float:
        return q[0]


@dataclass(frozen=True)
class SnubbedManometer(Strange):
    """A snubber in front of the pressure transducer: its reading lags."""

    form = "snubbed_manometer"
    atol: ClassVar[tuple[float, ...]] = (1e-4,)
    tau: float = 0.05  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.p_gauge - q[0]) / self.tau,)

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return q[0]


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
            return replace(
                schedule, starts=starts, step=schedule.step * longer, late=schedule.late * longer
            )
        return replace(schedule, starts=starts)


@dataclass(frozen=True)
class SlippedRuler(Clocked):
    """The clamp of the displacement sensor slips once in a run, and what it shows is off from then on."""

    form = "slipped_ruler"
    size: float = 1e-3  # m
    at: float = 3.0  # s

    def position_shown(self, q: State, x: float) -> float:
        return x + self.size * (1 + tanh((q[0] - self.at) / 0.02)) / 2


@dataclass(frozen=True)
class SaggingExcitation(Strange):
    """The valves draw from the supply of the pressure transducer, whose gain sags with their currents.

    The state is the sum of the currents by 0.35 A behind 5 ms.
    """

    form = "sagging_excitation"
    atol: ClassVar[tuple[float, ...]] = (1e-7,)
    share: float = 0.03

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (sum(rest.currents) / 0.35,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((sum(now.command) / 0.35 - q[0]) / 5e-3,)

    def pressure_shown(self, q: State, p_gauge: float) -> float:
        return p_gauge * (1 - self.share * q[0])


@dataclass(frozen=True)
class OwnClock(Strange):
    """The displacement is logged by a device with a clock of its own, which goes wrong more and more in a run.

    What stands at t was at t (1 + skew), x + skew t v to first order. States: the time, and x behind 5 ms for v.
    """

    form = "own_clock"
    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    skew: float = 0.01

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, rest.x)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return 1.0, (now.x - q[1]) / 5e-3

    def position_shown(self, q: State, x: float) -> float:
        return x + self.skew * q[0] * (x - q[1]) / 5e-3


@dataclass(frozen=True)
class SelfHeating(Strange):
    """A resistance thermometer whose measuring current heats it where no gas flows: T + dT/(1 + (|m|/m_0)^(1/2)).

    The state is the size of the flow behind 50 ms.
    """

    form = "self_heating"
    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    size: float = 2.0  # K
    m_0: float = 3e-5  # kg/s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((abs(now.net_mass_flow) - q[0]) / 0.05,)

    def reading(self, q: State, temperature: float) -> float:
        return temperature + self.size / (1 + sqrt(max(q[0], 0.0) / self.m_0))
