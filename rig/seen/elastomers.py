"""Rubber that stiffens late, springs across the way, creep that hardens or warms. Positive: against contraction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest
from rig.flow import T_ATM
from rig.seen.mechanics import BraidedTube

State = Sequence[float]
_WLF = (6.4, 142.0)  # [-] and [K]: the universal constants 17.44 and 51.6 K, moved from -70 degC, latex's, to 20 degC


@dataclass(frozen=True)
class YeohTube(BraidedTube):
    """A thin tube of Yeoh's rubber that follows the braid: W = c1 J - r2 c1 J^2 + r3 c1 J^3, J = I1 - 3.

    The second coefficient is negative and the third positive for filled rubber: soft in between, stiff in the end.
    Source: O. H. Yeoh, Some forms of the strain energy function for rubber, Rubber Chem. Technol. 66 (1993) 754.
    """

    family = "elasticity"
    form = "yeoh"
    c1: float = 1.2e5  # Pa
    r2: float = 0.08
    r3: float = 0.01

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        a, tangent = 1 - x / self.length, self.tangent
        s, s_a = 1 + tangent * (1 - a * a), -2 * tangent * a  # hoop stretch squared, and its slope
        j = a * a + s + 1 / (a * a * s) - 3
        j_a = 2 * a + s_a - 2 / (a**3 * s) - s_a / (a * s) ** 2
        return -self.wall / self.length * self.c1 * (1 - 2 * self.r2 * j + 3 * self.r3 * j * j) * j_a


@dataclass(frozen=True)
class SideSpring(Effect):
    """A spring from the load to a post beside the rig: k x (1 - l/sqrt(d^2 + x^2)).

    It lies across the way at rest, d long and l unstretched, so that it pulls along the way only once it is turned.
    The large-displacement truss of every textbook, e.g. J. M. T. Thompson, G. W. Hunt, Elastic Instability Phenomena
    (1984).
    """

    family = "elasticity"
    form = "side_spring"
    k: float = 1000.0  # N/m
    d: float = 0.08  # m
    unstretched: float = 0.9  # l by d

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * x * (1 - self.unstretched * self.d / sqrt(self.d * self.d + x * x))


@dataclass(frozen=True)
class HardeningCreep(Effect):
    """A spring k e whose dashpot hardens as it flows: q' = e/tau (x_0/(x_0 + |q|))^m, e = x - q.

    Primary creep by strain hardening, as of cords and braids of polyethylene or polyamide. Source: F. H. Norton, The
    Creep of Steel at High Temperatures (1929), with the hardening of R. W. Bailey, Proc. Inst. Mech. Eng. 131 (1935)
    131; here with a load to the first power.
    """

    family = "creep"
    form = "strain_hardening"
    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    k: float = 400.0  # N/m
    tau: float = 0.3  # s
    x_0: float = 5e-3  # m
    m: float = 2.0

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.x - q[0]) / self.tau * (self.x_0 / (self.x_0 + abs(q[0]))) ** self.m,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * (x - q[0])


@dataclass(frozen=True)
class WarmCreep(Effect):
    """A Maxwell element of rubber that flows quicker when the gas is warm: tau 10^(-c1 theta/(c2 + theta)).

    theta is half of what the gas is above ambient, as in the middle of a thin bladder. Source: M. L. Williams,
    R. F. Landel, J. D. Ferry, The temperature dependence of relaxation mechanisms in amorphous polymers, J. Am. Chem.
    Soc. 77 (1955) 3701.
    """

    family = "creep"
    form = "time_temperature"
    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    k: float = 400.0  # N/m
    tau: float = 1.5  # s, at ambient temperature

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        theta = max(-60.0, (now.temperature - T_ATM) / 2)
        shift = 10 ** (-_WLF[0] * theta / (_WLF[1] + theta))
        return ((now.x - q[0]) / (self.tau * shift),)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * (x - q[0])
