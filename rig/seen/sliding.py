"""Contacts that give before they break away, lips that drag one way, grease that breaks down, rubber that is viscous.

Positive forces oppose contraction.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi, sin, tanh
from typing import ClassVar

from rig.effect import Effect, Now, Rest

State = Sequence[float]


@dataclass(frozen=True)
class ElastoPlastic(Effect):
    """A bristle that is a spring up to its breakaway: z' = v/d (1 - alpha(z) |z|) while v loads it, else v/d; F_c z.

    alpha rises from 0 at the breakaway to 1 at |z| = 1 by half a wave, so small movements come back without drift.
    Source: P. Dupont, V. Hayward, B. Armstrong, F. Altpeter, Single state elastoplastic friction models, IEEE Trans.
    Autom. Control 47 (2002) 787.
    """

    family = "dry_friction"
    form = "elasto_plastic"
    atol: ClassVar[tuple[float, ...]] = (1e-7,)
    f_c: float = 8.0  # N
    travel: float = 1e-3  # m, d
    breakaway: float = 0.6  # of |z|

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def _alpha(self, size: float) -> float:
        place = (size - self.breakaway) / (1 - self.breakaway)
        return (1 + sin(pi * (min(max(place, 0.0), 1.0) - 0.5))) / 2

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        size = abs(q[0])
        slip = self._alpha(size) * size if now.v * q[0] > 0 else 0.0
        return (now.v / self.travel * (1 - slip),)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.f_c * q[0]


@dataclass(frozen=True)
class Wiper(Effect):
    """The lip of a rod's wiper drags more one way than the other: F_c t (1 + a t), t = tanh(v/width).

    Different levels for either direction are the rule in identified friction. Source: B. Armstrong-Helouvry,
    P. Dupont, C. Canudas de Wit, A survey of models, analysis tools and compensation methods, Automatica 30 (1994)
    1083.
    """

    family = "dry_friction"
    form = "wiper"
    f_c: float = 8.0  # N, mean of both ways
    a: float = 0.4
    width: float = 5e-4  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        t = tanh(v / self.width)
        return self.f_c * t * (1 + self.a * t)


@dataclass(frozen=True)
class ThixotropicGrease(Effect):
    """Grease that breaks down when sheared and sets again at rest: c v (r + (1 - r) s), s' = (1 - s)/tau - s |v|/d.

    Source: F. Moore, The rheology of ceramic slips and bodies, Trans. Brit. Ceram. Soc. 58 (1959) 470; J. Mewis,
    N. J. Wagner, Thixotropy, Adv. Colloid Interface Sci. 147 (2009) 214.
    """

    family = "rate_friction"
    form = "thixotropic"
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    c: float = 400.0  # N s/m, of grease that has set
    r: float = 0.3
    d: float = 0.01  # m
    tau: float = 2.0  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (1.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((1 - q[0]) / self.tau - q[0] * abs(now.v) / self.d,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * v * (self.r + (1 - self.r) * q[0])


@dataclass(frozen=True)
class ViscousBladder(Effect):
    """The bladder's rubber is viscous beside its springiness (Kelvin-Voigt) and follows the braid.

    The power is 4 eta times the wall's volume times (e_a^2 + e_h^2 + e_a e_h), with the rates of stretching e_a = -v/L
    along and e_h = L v/(b^2 - L^2) around. Derived by virtual power; source of the power: G. K. Batchelor, An
    Introduction to Fluid Dynamics (1967), section 3.4.
    """

    family = "rate_friction"
    form = "viscous_bladder"
    eta: float = 1e5  # Pa s
    wall: float = 3.8e-6  # m3, volume of the rubber
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        length = self.length - x
        around = length / (self.fibre_squared - length * length)
        along = -1 / length
        return 4 * self.eta * self.wall * v * (along * along + around * around + along * around)
