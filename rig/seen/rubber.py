"""Rubber that stretches, cords that come taut, and rubber that flows. Positive forces oppose contraction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest
from rig.seen.mechanics import BraidedTube

State = Sequence[float]
_TRELOAR = ((6.3e5, 1.3), (1.2e3, 5.0), (-1e4, -2.0))  # Pa and exponents of vulcanised natural rubber
_TRELOAR_MODULUS = sum(mu * alpha for mu, alpha in _TRELOAR) / 2  # Pa


@dataclass(frozen=True)
class OgdenTube(BraidedTube):
    """A thin tube of Ogden's rubber that follows the braid: W = sum mu/alpha (a^alpha + c^alpha + (a c)^-alpha - 3).

    Axial stretch a, hoop stretch c; Ogden's three terms for Treloar's rubber, times one factor; by virtual work.
    Source: R. W. Ogden, Large deformation isotropic elasticity, Proc. R. Soc. Lond. A 326 (1972) 565.
    """

    family = "elasticity"
    form = "ogden"
    modulus: float = 2.4e5  # Pa, shear modulus at rest

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        a, tangent = 1 - x / self.length, self.tangent
        c = sqrt(1 + tangent * (1 - a * a))
        c_a = -tangent * a / c
        thinner = c + a * c_a  # slope of a c
        slope = sum(
            mu * (a ** (alpha - 1) + c ** (alpha - 1) * c_a - (a * c) ** (-alpha - 1) * thinner)
            for mu, alpha in _TRELOAR
        )
        return float(-self.wall / self.length * self.modulus / _TRELOAR_MODULUS * slope)


@dataclass(frozen=True)
class SlackCord(Effect):
    """An elastic cord that hangs slack at rest and comes taut at x_0, rounded over 1 mm: k (x - x_0) beyond.

    Return springs and safety cords are fastened with play; reasoned here.
    """

    family = "elasticity"
    form = "slack_cord"
    k: float = 400.0  # N/m
    x_0: float = 0.02  # m
    rounded: float = 1e-3  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        over = x - self.x_0
        return self.k * (over + sqrt(over * over + self.rounded * self.rounded)) / 2


@dataclass(frozen=True)
class FlowingRubber(Effect):
    """A spring whose dashpot flows by a power m of its load: q' = e/tau (d + (e/x_0)^2)^((m - 1)/2), force k e.

    e = x - q. The exponent is 2 to 5 for filled rubber, so that relaxation is quick at first and has a long tail.
    Source: J. S. Bergstrom, M. C. Boyce, Constitutive modeling of the large strain time-dependent behavior of
    elastomers, J. Mech. Phys. Solids 46 (1998) 931; d = 0.01 keeps a little flow at rest.
    """

    family = "creep"
    form = "power_flow"
    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    k: float = 400.0  # N/m
    tau: float = 2.0  # s
    x_0: float = 0.015  # m
    m: float = 3.0

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        stretched = now.x - q[0]
        return (stretched / self.tau * (0.01 + (stretched / self.x_0) ** 2) ** ((self.m - 1) / 2),)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * (x - q[0])


@dataclass(frozen=True)
class SlowRecovery(Effect):
    """Rubber that recovers later than it gave way: a Maxwell element with tau under load and r tau after it.

    Source: A. N. Gent, Engineering with Rubber, 3rd ed. (2012), on creep and its incomplete recovery.
    """

    family = "creep"
    form = "slow_recovery"
    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    k: float = 400.0  # N/m
    tau: float = 1.0  # s
    r: float = 4.0

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        stretched = now.x - q[0]
        return (stretched / (self.tau if stretched > 0 else self.r * self.tau),)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * (x - q[0])
