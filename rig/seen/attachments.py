"""Ends of the muscle, and what its cord drives."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi, sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest

State = Sequence[float]


@dataclass(frozen=True)
class ConicalEnds(Effect):
    """Between fitting and cylinder the braid is a cone, the longer the thicker the muscle: pull times 1 - c (D/D0 - 1).

    Source: N. Tsagarakis, D. G. Caldwell, Improved modelling and assessment of pneumatic muscle actuators, IEEE Int.
    Conf. Robotics and Automation (2000) 3641, whose truncated cones are taken to first order here.
    """

    family = "end_shape"
    form = "conical"
    c: float = 0.1
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def pull_factor(self, x: float, p_gauge: float) -> float:
        length = self.length - x
        wider = sqrt((self.fibre_squared - length * length) / (self.fibre_squared - self.length**2))
        return 1 - self.c * (wider - 1)


@dataclass(frozen=True)
class BentFibres(Effect):
    """Stiff fibres bend near the clamps over sqrt(E I/tension): contraction counts 1 + c/sqrt(1 + p/p_0) times.

    The tension of a fibre goes with pressure. Reasoned from the edge of a clamped beam under tension (S. Timoshenko,
    Strength of Materials II, 1956).
    """

    family = "end_shape"
    form = "bent_fibres"
    c: float = 0.15
    p_0: float = 3e4  # Pa

    def shape_factor(self, x: float, p_gauge: float) -> float:
        return 1 + self.c / sqrt(1 + max(p_gauge, 0.0) / self.p_0)


@dataclass(frozen=True)
class BeltedFlywheel(Effect):
    """A balanced flywheel behind an elastic belt, far above the movements that it is to follow.

    States: the flywheel's place [m] and speed [m/s] along the belt.
    """

    family = "moving_mass"
    form = "belted_flywheel"
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


@dataclass(frozen=True)
class WindingDrum(Effect):
    """The cord turns a drum and winds up on it in layers, so that the radius grows: inertia m/(1 + x/x_0)^2.

    The force m'(x) v^2/2 goes with it (Lagrange).
    """

    family = "moving_mass"
    form = "winding_drum"
    m: float = 3.0  # kg, moment of inertia over the square of the bare drum's radius
    x_0: float = 0.1  # m

    def balanced_mass(self, x: float) -> float:
        return self.m / (1 + x / self.x_0) ** 2

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return -self.m / self.x_0 * v * v / (1 + x / self.x_0) ** 3
