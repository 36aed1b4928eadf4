"""Springs, frictions, relaxation, ends and masses by other laws than `force`. Positive forces oppose contraction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import expm1, pi, sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest

State = Sequence[float]


@dataclass(frozen=True)
class BraidedTube(Effect):
    """A thin tube of rubber that follows the braid; left to define: its law."""

    length: float = 0.24  # m
    diameter: float = 0.02  # m
    thickness: float = 0.254e-3  # m
    turns: float = 2.0

    @property
    def tangent(self) -> float:
        """Square of length by turned girth: the hoop stretch squared is 1 + tangent (1 - axial stretch squared)."""
        return (self.length / (self.turns * pi * self.diameter)) ** 2

    @property
    def wall(self) -> float:
        """Volume of the rubber [m3]."""
        return pi * self.diameter * self.thickness * self.length


@dataclass(frozen=True)
class GentTube(BraidedTube):
    """A thin tube of Gent's rubber that follows the braid: W = -mu J/2 ln(1 - (I1 - 3)/J), by virtual work.

    Its chains have a finite length, so that it locks at I1 = 3 + J; finite here up to 0.95 J.
    Source: A. N. Gent, A new constitutive relation for rubber, Rubber Chem. Technol. 69 (1996) 59.
    """

    family = "elasticity"
    form = "gent"
    mu: float = 2.4e5  # Pa
    limit: float = 5.0  # J

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        a, tangent = 1 - x / self.length, self.tangent
        s, s_a = 1 + tangent * (1 - a * a), -2 * tangent * a  # hoop stretch squared, and its slope
        invariant = a * a + s + 1 / (a * a * s)
        slope = 2 * a + s_a - 2 / (a**3 * s) - s_a / (a * s) ** 2
        used = min((invariant - 3) / self.limit, 0.95)
        return -self.wall / self.length * self.mu / 2 * slope / (1 - used)


@dataclass(frozen=True)
class BoucWen(Effect):
    """Bouc-Wen hysteresis: z' = v/d (1 - |z|^n (1 - g + g sign(v z))), force F_c z.

    Unlike Dahl's bristle it unloads by another curve than it loads (g below 1) and turns into sliding late (n above 1).
    Source: Y. K. Wen, Method for random vibration of hysteretic systems, J. Eng. Mech. Div. ASCE 102 (1976) 249.
    """

    family = "dry_friction"
    form = "bouc_wen"
    atol: ClassVar[tuple[float, ...]] = (1e-7,)
    f_c: float = 8.0  # N
    travel: float = 1e-3  # m, d
    n: float = 2.0
    g: float = 0.7

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        along = 1.0 if now.v * q[0] > 0 else -1.0
        return (now.v / self.travel * (1 - abs(q[0]) ** self.n * (1 - self.g + self.g * along)),)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.f_c * q[0]


@dataclass(frozen=True)
class FilmFriction(Effect):
    """Fibres that slide on a film of grease: c sqrt(p |v|) sign v, smooth below 1 mm/s.

    On a full film the coefficient of friction goes as the square root of viscosity times speed over pressure (the
    rising branch of the Stribeck curve), so the force, coefficient times pressure, goes as sqrt(p |v|).
    Source: B. J. Hamrock, S. R. Schmid, B. O. Jacobson, Fundamentals of Fluid Film Lubrication, 2nd ed. (2004).
    """

    family = "rate_friction"
    form = "film"
    c: float = 0.12  # N/sqrt(Pa m/s)
    eps: float = 1e-3  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * sqrt(max(p_gauge, 0.0)) * v / sqrt(sqrt(v * v + self.eps * self.eps))


@dataclass(frozen=True)
class OrificeDamper(Effect):
    """A dashpot whose oil is pressed through a hole: c v (1 + |v|/v_0), the square from the oil's inertia."""

    family = "rate_friction"
    form = "orifice_damper"
    c: float = 100.0  # N s/m
    v_0: float = 0.02  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * v * (1 + abs(v) / self.v_0)


@dataclass(frozen=True)
class FungCreep(Effect):
    """Quasi-linear viscoelasticity: one relaxation time acts on a spring that stiffens, e = x_0 (exp(x/x_0) - 1).

    Source: Y. C. Fung, Biomechanics: Mechanical Properties of Living Tissues (1981), section 7.6.
    """

    family = "creep"
    form = "fung"
    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    k: float = 200.0  # N/m
    tau: float = 1.5  # s
    x_0: float = 0.04  # m

    def _stretch(self, x: float) -> float:
        return self.x_0 * expm1(min(x / self.x_0, 6.0))

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (self._stretch(rest.x),)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((self._stretch(now.x) - q[0]) / self.tau,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * (self._stretch(x) - q[0])


@dataclass(frozen=True)
class LooseBladder(Effect):
    """The bladder does not fill the braid before it is pressed against it: pull times 1 - c p_0/(p_0 + p).

    Muscles are built with play between bladder and braid, above all at the ends, and need some pressure before they
    pull as the cylinder does; reasoned here as a share of the braid without contact that fades with pressure.
    """

    family = "end_shape"
    form = "loose_bladder"
    c: float = 0.1
    p_0: float = 5e4  # Pa

    def pull_factor(self, x: float, p_gauge: float) -> float:
        return 1 - self.c * self.p_0 / (self.p_0 + max(p_gauge, 0.0))


@dataclass(frozen=True)
class Rocker(Effect):
    """A balanced rocker arm of radius r whose end the load moves along a line: inertia m/(1 - (x/r)^2).

    The arm's angle is asin(x/r), its energy m r^2 angle'^2/2; the force m'(x) v^2/2 goes with it (Lagrange).
    """

    family = "moving_mass"
    form = "rocker"
    m: float = 3.0  # kg, the arm's moment of inertia over r^2
    radius: float = 0.15  # m

    def _room(self, x: float) -> float:
        return max(1 - (x / self.radius) ** 2, 0.1)

    def balanced_mass(self, x: float) -> float:
        return self.m / self._room(x)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        room = self._room(x)
        return self.m * x / (self.radius * room) ** 2 * v * v if room > 0.1 else 0.0


@dataclass(frozen=True)
class SlippingFlywheel(Effect):
    """A pulley of inertia m that the cord drags along with viscous slip: force m (v - w)/tau with w' = (v - w)/tau.

    Slow movements carry it in full, quick ones slip over it.
    """

    family = "moving_mass"
    form = "slipping_flywheel"
    atol: ClassVar[tuple[float, ...]] = (1e-9,)
    m: float = 3.0  # kg, moment of inertia over radius squared
    tau: float = 0.03  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.v - q[0]) / self.tau,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.m * (v - q[0]) / self.tau
