"""Masses that move with the load, with their weight or without. Positive forces oppose contraction."""

from __future__ import annotations

from math import pi, sqrt, tanh
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law


@law
class Counterweight(Effect):
    """A mass over a pulley that pulls up with a part of the weight that it has inertia: m with net weight w m."""

    m: float = 1.5  # kg
    w: float = 0.25

    def hanging_mass(self) -> float:
        return self.w * self.m

    def balanced_mass(self, x: float) -> float:
        return (1 - self.w) * self.m


@law
class Lever(Effect):
    """A balanced lever whose ratio changes: inertia m(x) = m (1 + x/x_0) and the force m' v^2/2 that goes with it."""

    m: float = 2.0  # kg
    x_0: float = 0.05  # m

    def balanced_mass(self, x: float) -> float:
        return self.m * (1 + max(x, 0.0) / self.x_0)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.m / self.x_0 * v * v / 2 if x > 0 else 0.0


@law
class Rocker(Effect):
    """A balanced rocker arm of radius r whose end the load moves along a line: inertia m/(1 - (x/r)^2).

    The arm's angle is asin(x/r), its energy m r^2 angle'^2/2; the force m'(x) v^2/2 goes with it (Lagrange).
    """

    m: float = 3.0  # kg, the arm's moment of inertia over r^2
    radius: float = 0.15  # m

    def _room(self, x: float) -> float:
        return max(1 - (x / self.radius) ** 2, 0.1)

    def balanced_mass(self, x: float) -> float:
        return self.m / self._room(x)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        room = self._room(x)
        return self.m * x / (self.radius * room) ** 2 * v * v if room > 0.1 else 0.0


@law
class SlippingFlywheel(Effect):
    """A pulley of inertia m that the cord drags along with viscous slip: force m (v - w)/tau with w' = (v - w)/tau.

    Slow movements carry it in full, quick ones slip over it.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    m: float = 3.0  # kg, moment of inertia over radius squared
    tau: float = 0.03  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.v - q[0]) / self.tau,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.m * (v - q[0]) / self.tau


@law
class BeltedFlywheel(Effect):
    """A balanced flywheel behind an elastic belt, far above the movements that it is to follow.

    States: the flywheel's place [m] and speed [m/s] along the belt.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-8)
    m: float = 3.0  # kg, moment of inertia over radius squared
    frequency: float = 12.0  # Hz, of the flywheel on the held belt
    damping: float = 0.2  # ratio

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x, 0.0)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        omega = 2 * pi * self.frequency
        return self.m * (omega * omega * (x - q[0]) + 2 * self.damping * omega * (v - q[1]))

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return q[1], self.force(q, now.x, now.v, now.p_gauge) / self.m


@law
class WindingDrum(Effect):
    """The cord turns a drum and winds up on it in layers, so that the radius grows: inertia m/(1 + x/x_0)^2.

    The force m'(x) v^2/2 goes with it (Lagrange).
    """

    m: float = 3.0  # kg, moment of inertia over the square of the bare drum's radius
    x_0: float = 0.1  # m

    def balanced_mass(self, x: float) -> float:
        return self.m / (1 + x / self.x_0) ** 2

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return -self.m / self.x_0 * v * v / (1 + x / self.x_0) ** 3


@law
class SideSled(Effect):
    """A sled on a level rail d beside the way, drawn along it by a cord: inertia m (a + x)^2/(d^2 + (a + x)^2).

    The cord's length sqrt(d^2 + (a + x)^2) grows with the load's way; the force m'(x) v^2/2 goes with it (Lagrange).
    """

    m: float = 4.0  # kg
    a: float = 0.04  # m
    d: float = 0.08  # m

    def balanced_mass(self, x: float) -> float:
        along = (self.a + x) ** 2
        return self.m * along / (self.d**2 + along)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.m * (self.a + x) * self.d**2 / (self.d**2 + (self.a + x) ** 2) ** 2 * v * v


@law
class OwnWall(Effect):
    """The muscle's own wall moves along and outward: inertia m (1/3 + r'(x)^2), half of its weight.

    Its points move in proportion to their distance from the upper clamp (Rayleigh's third), and all outward with the
    radius; the force m'(x) v^2/2 goes with it (Lagrange). Source: J. W. Strutt, The Theory of Sound I (1877).
    """

    m: float = 0.3  # kg
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    turns: float = 2.0

    def hanging_mass(self) -> float:
        return self.m / 2

    def _outward(self, x: float) -> tuple[float, float]:
        """r' and r''; r = sqrt(b^2 - L^2)/(2 pi n)."""
        length = self.length - x
        root = sqrt(self.fibre_squared - length * length)
        scale = 1 / (2 * pi * self.turns)
        return scale * length / root, -scale * self.fibre_squared / root**3

    def balanced_mass(self, x: float) -> float:
        return self.m * (self._outward(x)[0] ** 2 - 1 / 6)  # a half hangs, a third moves

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        slope, curvature = self._outward(x)
        return self.m * slope * curvature * v * v


@law
class Crank(Effect):
    """A balanced flywheel that the load turns by a crank: inertia m/sin^2(phi), a + x = r (1 - cos(phi)).

    Near the dead centre it turns fastest; the force m'(x) v^2/2 goes with it (Lagrange). Source: kinematics of the
    Scotch yoke, e.g. J. E. Shigley, J. J. Uicker, Theory of Machines and Mechanisms (1995).
    """

    m: float = 2.0  # kg, moment of inertia over r^2
    radius: float = 0.1  # m
    a: float = 0.02  # m, from the dead centre at rest

    def _room(self, x: float) -> tuple[float, float]:
        """Cosine of phi, and the square of its sine."""
        u = 1 - (self.a + x) / self.radius
        return u, max(1 - u * u, 0.1)

    def balanced_mass(self, x: float) -> float:
        return self.m / self._room(x)[1]

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        u, room = self._room(x)
        return -self.m * u / self.radius / room**2 * v * v if room > 0.1 else 0.0


@law
class Freewheel(Effect):
    """A flywheel behind a freewheel: it is taken along up, force m e/tau for e = v - w > 0, and then turns by itself.

    w' = e/tau - w/coast for e > 0, else without the first; rounded over 1 mm/s. Reasoned from the overrunning clutch.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    m: float = 3.0  # kg, moment of inertia over radius squared
    tau: float = 0.02  # s
    coast: float = 1.0  # s

    def _taken(self, w: float, v: float) -> float:
        faster = v - w
        return faster * (1 + tanh(faster / 1e-3)) / 2 / self.tau

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (self._taken(q[0], now.v) - q[0] / self.coast,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.m * self._taken(q[0], v)
