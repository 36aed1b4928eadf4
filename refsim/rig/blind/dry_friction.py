"""Dry friction: by the direction of motion and the way since it turned. Positive forces oppose contraction."""

from __future__ import annotations

from dataclasses import dataclass
from math import sqrt, tanh
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State


@dataclass(frozen=True)
class CrossingContact(Effect):
    """Dry friction where fibres cross: c p sin(2 theta_0)/sin(2 theta) tanh(v/width), theta the braid's angle.

    Two fibres of a width w touch over a rhomb of w^2/sin(2 theta), which pressure presses together. Source: S. Davis,
    D. G. Caldwell, Braid effects on contractile range and friction modeling in pneumatic muscle actuators, Int. J.
    Robot. Res. 25 (2006) 359.
    """

    family = "dry_friction"
    form = "crossing_contact"
    c: float = 6e-5  # m2, force by pressure at rest
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    width: float = 5e-4  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        length = self.length - x
        rest = self.length * sqrt(self.fibre_squared - self.length**2)
        rhomb = rest / (length * sqrt(self.fibre_squared - length * length))
        return self.c * max(p_gauge, 0.0) * rhomb * tanh(v / self.width)


@dataclass(frozen=True)
class CarriedPressure(Effect):
    """Only what the bladder does not carry itself presses the fibres: c P z, P = p - p_b (D/D0 - 1) where above 0.

    z' = (v - |v| z)/d is Dahl's bristle; P is rounded over 5 kPa. Source: Amontons' law with the pressure that C.-P.
    Chou and B. Hannaford, IEEE Trans. Robot. Autom. 12 (1996) 90, say a bladder needs to meet the braid.
    """

    family = "dry_friction"
    form = "carried_pressure"
    atol: ClassVar[tuple[float, ...]] = (1e-7,)
    c: float = 8e-5  # m2
    p_b: float = 1e5  # Pa, what the bladder needs to be twice as wide
    travel: float = 1e-3  # m, d
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.v - abs(now.v) * q[0]) / self.travel,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        wider = sqrt(
            (self.fibre_squared - (self.length - x) ** 2) / (self.fibre_squared - self.length**2)
        )
        left = p_gauge - self.p_b * (wider - 1)
        return self.c * (left + sqrt(left * left + 2.5e7)) / 2 * q[0]


@dataclass(frozen=True)
class BreakawayByWay(Effect):
    """A force to break away that fades with the way: F_c ((1 + a) z_1 - a z_2), bristles of travel d/4 and d.

    It peaks after each turn by the way alone, at any speed. Source: P.-A. Bliman, M. Sorine, Easy-to-use realistic dry
    friction models for automatic control, Eur. Control Conf. (1995) 3788, their second order.
    """

    family = "dry_friction"
    form = "bliman_sorine"
    atol: ClassVar[tuple[float, ...]] = (1e-7, 1e-7)
    f_c: float = 8.0  # N
    a: float = 0.6
    travel: float = 2e-3  # m, d

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        size = abs(now.v)
        return (now.v - size * q[0]) * 4 / self.travel, (now.v - size * q[1]) / self.travel

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.f_c * ((1 + self.a) * q[0] - self.a * q[1])
