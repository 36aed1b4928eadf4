"""Effects in the balance of forces. Positive forces oppose contraction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import exp, pi, pow, tanh
from typing import ClassVar

from rig.effect import Effect, Now, Rest


@dataclass(frozen=True)
class LinearSpring(Effect):
    """The bladder as a spring: k x."""

    family = "elasticity"
    form = "linear"
    k: float = 250.0  # N/m

    def force(self, q: Sequence[float], x: float, v: float, p_gauge: float) -> float:
        return self.k * x


@dataclass(frozen=True)
class CubicSpring(Effect):
    """A spring that stiffens: k1 x + k3 x^3."""

    family = "elasticity"
    form = "cubic"
    k1: float = 120.0  # N/m
    k3: float = 5.0e4  # N/m3

    def force(self, q: Sequence[float], x: float, v: float, p_gauge: float) -> float:
        return self.k1 * x + self.k3 * x**3


@dataclass(frozen=True)
class ExponentialSpring(Effect):
    """A spring that stiffens exponentially: F0 (exp(x/x0) - 1)."""

    family = "elasticity"
    form = "exponential"
    f0: float = 5.0  # N
    x0: float = 0.04  # m

    def force(self, q: Sequence[float], x: float, v: float, p_gauge: float) -> float:
        return self.f0 * (exp(x / self.x0) - 1)


@dataclass(frozen=True)
class MooneyRivlin(Effect):
    """A thin incompressible Mooney-Rivlin tube that follows the braid; force by virtual work dW/dx.

    Axial stretch a = L/L0, hoop stretch c = D/D0 with D^2 = (b^2 - L^2)/(n pi)^2 at rest geometry;
    W = V_wall (C10 (a^2 + c^2 + 1/(a c)^2 - 3) + C01 (1/a^2 + 1/c^2 + (a c)^2 - 3)).
    """

    family = "elasticity"
    form = "mooney_rivlin"
    c10: float = 1.2e5  # Pa
    c01: float = 2.0e4  # Pa
    length: float = 0.24  # m
    diameter: float = 0.02  # m
    thickness: float = 0.254e-3  # m
    turns: float = 2.0

    def force(self, q: Sequence[float], x: float, v: float, p_gauge: float) -> float:
        wall = pi * self.diameter * self.thickness * self.length
        circumference = self.turns * pi * self.diameter
        a = 1 - x / self.length
        tangent = (self.length / circumference) ** 2
        s = 1 + tangent * (1 - a * a)  # c^2
        s_a = -2 * tangent * a  # d(c^2)/da
        i1_a = 2 * a + s_a - 2 / (a**3 * s) - s_a / (a * s) ** 2
        i2_a = -2 / a**3 - s_a / s**2 + 2 * a * s + a * a * s_a
        return -wall / self.length * (self.c10 * i1_a + self.c01 * i2_a)


@dataclass(frozen=True)
class Coulomb(Effect):
    """Coulomb friction F_c tanh(v/width)."""

    family = "dry_friction"
    form = "coulomb"
    stiff = True
    f_c: float = 8.0  # N
    width: float = 1e-5  # m/s

    def force(self, q: Sequence[float], x: float, v: float, p_gauge: float) -> float:
        return self.f_c * tanh(v / self.width)


@dataclass(frozen=True)
class Dahl(Effect):
    """Dahl friction: a bristle q with q' = v - |v| stiffness q/F_c and force stiffness q; at rest q = 0."""

    family = "dry_friction"
    form = "dahl"
    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    f_c: float = 8.0  # N
    stiffness: float = 2.0e4  # N/m

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: Sequence[float], now: Now) -> tuple[float, ...]:
        return (now.v - abs(now.v) * self.stiffness * q[0] / self.f_c,)

    def force(self, q: Sequence[float], x: float, v: float, p_gauge: float) -> float:
        return self.stiffness * q[0]


@dataclass(frozen=True)
class Viscous(Effect):
    """Viscous friction c v."""

    family = "rate_friction"
    form = "viscous"
    c: float = 300.0  # N s/m

    def force(self, q: Sequence[float], x: float, v: float, p_gauge: float) -> float:
        return self.c * v


@dataclass(frozen=True)
class PressureViscous(Effect):
    """Friction in proportion to gauge pressure and speed: c p_gauge v."""

    family = "rate_friction"
    form = "pressure"
    c: float = 3.0e-3  # N s/(m Pa)

    def force(self, q: Sequence[float], x: float, v: float, p_gauge: float) -> float:
        return self.c * p_gauge * v


@dataclass(frozen=True)
class PowerViscous(Effect):
    """Friction c |v|^a sign(v), made differentiable at rest: c v (v^2 + eps^2)^((a-1)/2)."""

    family = "rate_friction"
    form = "power"
    c: float = 60.0  # N (s/m)^a
    a: float = 0.5
    eps: float = 1e-4  # m/s

    def force(self, q: Sequence[float], x: float, v: float, p_gauge: float) -> float:
        return self.c * v * pow(v * v + self.eps * self.eps, (self.a - 1) / 2)


@dataclass(frozen=True)
class Creep(Effect):
    """A spring that relaxes (Maxwell element): k (x - q) with q' = (x - q)/tau."""

    family = "creep"
    form = "maxwell"
    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    k: float = 400.0  # N/m
    tau: float = 1.5  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: Sequence[float], now: Now) -> tuple[float, ...]:
        return ((now.x - q[0]) / self.tau,)

    def force(self, q: Sequence[float], x: float, v: float, p_gauge: float) -> float:
        return self.k * (x - q[0])


@dataclass(frozen=True)
class TonduEnds(Effect):
    """The ends contract less: contraction counts k times in the force (Tondu and Lopez)."""

    family = "end_shape"
    form = "tondu"
    k: float = 1.06

    def contraction_factor(self, p_gauge: float) -> float:
        return self.k


@dataclass(frozen=True)
class KangEnds(Effect):
    """Contraction counts q(P) = 1 + c1 exp(-P/p0) times in the force (Kang)."""

    family = "end_shape"
    form = "kang"
    c1: float = 0.2
    p0: float = 1.0e5  # Pa

    def contraction_factor(self, p_gauge: float) -> float:
        return 1 + self.c1 * exp(-p_gauge / self.p0)


@dataclass(frozen=True)
class HangingMass(Effect):
    """The rig's own moving mass hangs on the muscle too: inertia and weight."""

    family = "moving_mass"
    form = "hanging"
    m: float = 0.8  # kg

    def hanging_mass(self) -> float:
        return self.m
