"""Masses that move with the load, with their weight or without. Positive forces oppose contraction."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi, sqrt, tanh
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State


@dataclass(frozen=True)
class OwnWall(Effect):
    """The muscle's own wall moves along and outward: inertia m (1/3 + r'(x)^2), half of its weight.

    Its points move in proportion to their distance from the upper clamp (Rayleigh's third), and all outward with the
    radius; the force m'(x) v^2/2 goes with it (Lagrange). Source: J. W. Strutt, The Theory of Sound I (1877).
    """

    family = "moving_mass"
    form = "own_wall"
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


@dataclass(frozen=True)
class Crank(Effect):
    """A balanced flywheel that the load turns by a crank: inertia m/sin^2(phi), a + x = r (1 - cos(phi)).

    Near the dead centre it turns fastest; the force m'(x) v^2/2 goes with it (Lagrange). Source: kinematics of the
    Scotch yoke, e.g. J. E. Shigley, J. J. Uicker, Theory of Machines and Mechanisms (1995).
    """

    family = "moving_mass"
    form = "crank"
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


@dataclass(frozen=True)
class Freewheel(Effect):
    """A flywheel behind a freewheel: it is taken along up, force m e/tau for e = v - w > 0, and then turns by itself.

    w' = e/tau - w/coast for e > 0, else without the first; rounded over 1 mm/s. Reasoned from the overrunning clutch.
    """

    family = "moving_mass"
    form = "freewheel"
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
