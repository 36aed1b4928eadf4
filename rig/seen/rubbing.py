"""Cords over bars, contacts that age, brakes and impregnated braids. Positive forces oppose contraction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import expm1, log1p, pi, tanh
from typing import ClassVar

from rig.effect import Effect, Now, Rest

State = Sequence[float]


@dataclass(frozen=True)
class Capstan(Effect):
    """The cord to the load runs over a fixed bar: F (1 - exp(-mu_phi tanh(v/width))) with the muscle's pull F.

    The tensions on both sides of the bar differ by exp(mu phi), phi being the angle of contact.
    Source: L. Euler, Remarques sur l'effet du frottement dans l'equilibre, Mem. Acad. Sci. Berlin 18 (1769) 265.
    """

    family = "dry_friction"
    form = "capstan"
    mu_phi: float = 0.1
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    turns: float = 2.0
    width: float = 5e-4  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        length = self.length - x
        pull = p_gauge * (3 * length * length - self.fibre_squared) / (4 * pi * self.turns**2)
        return -max(pull, 0.0) * expm1(-self.mu_phi * tanh(v / self.width))


@dataclass(frozen=True)
class AgeingContact(Effect):
    """Friction that grows with the logarithm of a contact's age: F_c (1 + b ln(1 + a/a_0)) tanh(v/width).

    The age a [s] is renewed by sliding over a distance d: a' = 1 - a |v|/d.
    Source: J. H. Dieterich, Modeling of rock friction, J. Geophys. Res. 84 (1979) 2161 (its law of ageing); found for
    paper and polymers too (T. Baumberger, C. Caroli, Adv. Phys. 55 (2006) 279).
    """

    family = "dry_friction"
    form = "ageing"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    f_c: float = 8.0  # N
    b: float = 0.1
    d: float = 1e-3  # m
    width: float = 5e-4  # m/s
    a_0: float = 0.1  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (5.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (1 - q[0] * abs(now.v) / self.d,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        age = max(q[0], 0.0) / self.a_0
        return self.f_c * (1 + self.b * log1p(age)) * tanh(v / self.width)


@dataclass(frozen=True)
class EddyBrake(Effect):
    """A geared eddy-current brake: c v/(1 + (v/v_k)^2), which brakes most at its critical speed v_k.

    Source: W. R. Smythe, On eddy currents in a rotating disk, Trans. AIEE 61 (1942) 681.
    """

    family = "rate_friction"
    form = "eddy_brake"
    c: float = 300.0  # N s/m
    v_k: float = 0.08  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * v / (1 + (v / self.v_k) ** 2)


@dataclass(frozen=True)
class ShearedMatrix(Effect):
    """A braid in a soft viscous matrix, which its fibres shear as they turn: c v/sin^2 of the braid angle.

    The fibres turn by v/(b sin), and the work on the matrix goes with the square of that. Derived by virtual power.
    """

    family = "rate_friction"
    form = "sheared_matrix"
    c: float = 60.0  # N s/m
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * v / (1 - (self.length - x) ** 2 / self.fibre_squared)
