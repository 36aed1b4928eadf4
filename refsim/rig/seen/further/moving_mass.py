"""Masses that move with the load, with their weight or without. Positive forces oppose contraction."""

from __future__ import annotations

from math import cos, sin, tanh
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law


@law
class ClutchedFlywheel(Effect):
    """A flywheel behind a slip clutch: force m a tanh((v - w)/(a tau)), w' = a tanh((v - w)/(a tau)).

    It moves along with the load until that speeds up by more than a, then the clutch slides at its limit; tau = 10 ms
    is its stiffness. State: the flywheel's speed w [m/s] at the cord. Source: torque limiters, e.g. R. G. Budynas, J.
    K. Nisbett, Shigley's Mechanical Engineering Design (2011), chapter 16.
    """

    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    m: float = 3.0  # kg, moment of inertia over radius squared
    a: float = 3.0  # m/s2
    tau: float = 0.01  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def _speeding(self, w: float, v: float) -> float:
        return self.a * tanh((v - w) / (self.a * self.tau))

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (self._speeding(q[0], now.v),)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.m * self._speeding(q[0], v)


@law
class EccentricWheel(Effect):
    """The cord turns a balanced wheel that is mounted off its centre: inertia m/(1 + e sin(x/r + phi))^2.

    Its lever changes with the angle, to first order in the eccentricity e by that sine; the force m'(x) v^2/2 goes with
    it (Lagrange). Source: eccentric pulleys in exercise machines and bows; kinematics reasoned.
    """

    m: float = 3.0  # kg, moment of inertia over radius squared
    radius: float = 0.03  # m
    e: float = 0.3
    phi: float = 0.0  # rad

    def _lever(self, x: float) -> tuple[float, float]:
        """Lever by its mean, and its slope [1/m]."""
        angle = x / self.radius + self.phi
        return 1 + self.e * sin(angle), self.e * cos(angle) / self.radius

    def balanced_mass(self, x: float) -> float:
        return self.m / self._lever(x)[0] ** 2

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        lever, slope = self._lever(x)
        return -self.m * slope / lever**3 * v * v
