"""Effects that belong to none of the sixteen families: the right answer is that something unknown is missing.

Each is kept away from what a family says. A spring, a friction, a mass, a valve that opens late or by another law, a
line, a leak, heat, a slow thermometer, a constant error of the pressure reading are families and do not occur here.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import cos, pi, sin, tanh
from typing import ClassVar

from rig.effect import Effect, Now, Rest
from rig.flow import G
from rig.schedule import Currents, SampledSchedule, Schedule

State = Sequence[float]


@dataclass(frozen=True)
class Strange(Effect):
    """Of no family."""

    family = "none_of_these"


@dataclass(frozen=True)
class Clocked(Strange):
    """Its own state is the time."""

    atol: ClassVar[tuple[float, ...]] = (1e-9,)

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (1.0,)


@dataclass(frozen=True)
class ForceRipple(Strange):
    """A force that is periodic in the position, as of a toothed belt: F sin(2 pi x/pitch)."""

    form = "force_ripple"
    size: float = 5.0  # N
    pitch: float = 8e-3  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.size * sin(2 * pi * x / self.pitch)


@dataclass(frozen=True)
class PumpingSupply(Clocked):
    """The compressor pumps: the supply's absolute pressure swings by a share, and no instrument sees it."""

    form = "pumping_supply"
    share: float = 0.08
    frequency: float = 0.9  # Hz
    phase: float = 0.0

    def supply(self, q: State, p: float) -> float:
        return p * (1 + self.share * sin(2 * pi * self.frequency * q[0] + self.phase))


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
class SpringLoad(Strange):
    """A part of the load hangs on a spring and swings up and down by itself (states: place and speed of it)."""

    form = "swinging_load"
    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-8)
    part: float = 0.8  # kg
    frequency: float = 2.5  # Hz
    damping: float = 0.05  # ratio

    def hanging_mass(self) -> float:
        return -self.part

    def resting_mass(self) -> float:
        return 0.0

    def _pull(self, q: State, x: float, v: float) -> float:
        omega = 2 * pi * self.frequency
        return self.part * (omega**2 * (x - q[0]) + 2 * self.damping * omega * (v - q[1]))

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x - G / (2 * pi * self.frequency) ** 2, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return q[1], self._pull(q, now.x, now.v) / self.part - G

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self._pull(q, x, v)


@dataclass(frozen=True)
class SecondWeight(Strange):
    """A second weight lies on the floor and is picked up on the way."""

    form = "second_weight"
    mass: float = 0.8  # kg
    x_1: float = 0.03  # m
    width: float = 5e-4  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.mass * G * (1 + tanh((x - self.x_1) / self.width)) / 2


@dataclass(frozen=True)
class Vibration(Clocked):
    """A machine next door shakes the frame."""

    form = "vibration"
    size: float = 4.0  # N
    frequency: float = 1.7  # Hz
    phase: float = 0.0

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.size * sin(2 * pi * self.frequency * q[0] + self.phase)


@dataclass(frozen=True)
class StickyValves(Strange):
    """The valves never open twice by the same area: each command is met by a factor of its own."""

    form = "sticky_valves"
    scatter: float = 0.15
    start: int = 0

    def _factor(self, k: int) -> float:
        # the fractional parts of a multiple of an irrational number: spread evenly, and the same on every machine
        return 1 + self.scatter * (2 * ((self.start + k + 1) * 0.6180339887498949 % 1) - 1)

    def _felt(self, k: int, command: Currents) -> Currents:
        factor = self._factor(k)
        a, b = (0.145 + (u - 0.145) * factor if u > 0.145 else u for u in command)
        return a, b

    def drive(self, schedule: Schedule) -> Schedule:
        if isinstance(schedule, SampledSchedule):
            openings, opened, felt = 0, False, []
            for command in schedule.samples:
                now = max(command) > 0.145
                openings += now and not opened
                opened = now
                felt.append(self._felt(openings, command))
            return replace(schedule, samples=tuple(felt))
        return Schedule(schedule.starts, tuple(self._felt(k, c) for k, c in enumerate(schedule.currents)))


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
