"""Forces on the load that belong to no family. Positive forces oppose contraction."""

from __future__ import annotations

from math import cos, exp, pi, sin, sqrt, tanh
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law
from rig.flow import G
from rig.schedule import Schedule
from rig.seen.none_of_these.base import Clocked, Strange, with_edges


@law
class ForceRipple(Strange):
    """A force that is periodic in the position, as of a toothed belt: F sin(2 pi x/pitch)."""

    size: float = 5.0  # N
    pitch: float = 8e-3  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.size * sin(2 * pi * x / self.pitch)


@law
class SpringLoad(Strange):
    """A part of the load hangs on a spring and swings up and down by itself (states: place and speed of it)."""

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


@law
class SecondWeight(Strange):
    """A second weight lies on the floor and is picked up on the way."""

    mass: float = 0.8  # kg
    x_1: float = 0.03  # m
    width: float = 5e-4  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.mass * G * (1 + tanh((x - self.x_1) / self.width)) / 2


@law
class Vibration(Clocked):
    """A machine next door shakes the frame."""

    size: float = 4.0  # N
    frequency: float = 1.7  # Hz
    phase: float = 0.0

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.size * sin(2 * pi * self.frequency * q[0] + self.phase)


@law
class Nudge(Clocked):
    """Somebody pushes the load for a moment, at the same time in each run: F sin^2 over the time of the push."""

    size: float = 8.0  # N
    start: float = 3.0  # s
    duration: float = 0.6  # s

    def drive(self, schedule: Schedule) -> Schedule:
        return with_edges(schedule, (self.start, self.start + self.duration))

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        share = (q[0] - self.start) / self.duration
        return self.size * sin(pi * share) ** 2 if 0 < share < 1 else 0.0


@law
class ObliqueString(Strange):
    """The displacement sensor's string runs aslant: it shows sqrt((a + x)^2 + d^2) - sqrt(a^2 + d^2).

    The sensor sits d beside the line of movement and, at rest, a along it.
    """

    d: float = 0.08  # m
    a: float = 0.25  # m

    def position_shown(self, q: State, x: float) -> float:
        return sqrt((self.a + x) ** 2 + self.d**2) - sqrt(self.a**2 + self.d**2)


@law
class RestlessStart(Clocked):
    """The frame still rings from the handling when a run starts: F exp(-t/tau) cos(2 pi f t + phase)."""

    size: float = 8.0  # N
    tau: float = 3.0  # s
    frequency: float = 1.2  # Hz
    phase: float = 0.0

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.size * exp(-q[0] / self.tau) * cos(2 * pi * self.frequency * q[0] + self.phase)


@law
class HoldingMagnet(Strange):
    """The load rests on a magnetic plate and comes off it with a jerk: F/(1 + x/d)^2 off the plate."""

    size: float = 8.0  # N
    d: float = 1e-3  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.size / (1 + max(x, 0.0) / self.d) ** 2


@law
class Ripple(Effect):
    """A force that goes up and down along the travel."""

    family = "ripple"
    amplitude: float = 6.0  # N
    length: float = 0.03  # m

    def force(self, q: object, x: float, v: float, p_gauge: float) -> float:
        return self.amplitude * sin(2 * pi * x / self.length) if x > 0 else 0.0


@law
class Coupled(Effect):
    """A force that grows with the pressure and with the square of the travel."""

    family = "coupled"
    c: float = 8e-4  # N/Pa at 70 mm

    def force(self, q: object, x: float, v: float, p_gauge: float) -> float:
        return self.c * p_gauge * (x / 0.07) ** 2


@law
class Detent(Strange):
    """A ball snaps into a notch of the guide: F u exp((1 - u^2)/2), u = (x - x_1)/w; against, then with the motion."""

    size: float = 10.0  # N
    x_1: float = 0.025  # m
    width: float = 1.5e-3  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        u = (x - self.x_1) / self.width
        return self.size * u * exp((1 - min(u * u, 400.0)) / 2)


@law
class DrippingLoad(Clocked):
    """The load is a bucket that drips: its weight falls with time. What inertia it loses is left out, it is minor."""

    rate: float = 0.02  # kg/s

    def resting_mass(self) -> float:
        """Nothing but the load rests at the start; a rig without one does not drip."""
        return 0.0

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return -self.rate * q[0] * G
