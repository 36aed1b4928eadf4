"""Springs, frictions, relaxation, ends and masses. Positive forces oppose contraction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import asinh, atan, exp, log1p, pi, sinh, sqrt, tanh
from typing import ClassVar

from rig.effect import Effect, Now, Rest

State = Sequence[float]


@dataclass(frozen=True)
class YoungTube(Effect):
    """A thin tube of Hooke's rubber, incompressible (Poisson 1/2), that follows the braid; force by virtual work."""

    family = "elasticity"
    form = "young"
    modulus: float = 5e5  # Pa
    length: float = 0.24  # m
    diameter: float = 0.02  # m
    thickness: float = 0.254e-3  # m
    turns: float = 2.0

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        wall = pi * self.diameter * self.thickness * self.length
        a, s, s_a = _stretches(x, self.length, self.diameter, self.turns)
        c = sqrt(s)
        along, around = a - 1, c - 1
        # plane stress with Poisson's ratio 1/2: W = (2/3) E (e1^2 + e2^2 + e1 e2)
        slope = (2 * along + around) + (2 * around + along) * s_a / (2 * c)
        return -2 / 3 * self.modulus * wall * slope / self.length


def _stretches(x: float, length: float, diameter: float, turns: float) -> tuple[float, float, float]:
    """Axial stretch a, hoop stretch squared, and the latter's slope over a."""
    a = 1 - x / length
    tangent = (length / (turns * pi * diameter)) ** 2
    return a, 1 + tangent * (1 - a * a), -2 * tangent * a


@dataclass(frozen=True)
class ArctanSpring(Effect):
    """A spring that yields: F0 atan(x/x0)."""

    family = "elasticity"
    form = "arctan"
    f0: float = 12.0  # N
    x0: float = 0.02  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.f0 * atan(x / self.x0)


@dataclass(frozen=True)
class LogSpring(Effect):
    """A spring that softens slowly: F0 ln(1 + x/x0)."""

    family = "elasticity"
    form = "logarithmic"
    f0: float = 8.0  # N
    x0: float = 0.015  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.f0 * log1p(x / self.x0) if x > 0 else self.f0 * x / self.x0


@dataclass(frozen=True)
class LockingSpring(Effect):
    """Chains that lock: k x/(1 - (x/x_lock)^2), finite up to 0.97 x_lock."""

    family = "elasticity"
    form = "locking"
    k: float = 120.0  # N/m
    x_lock: float = 0.12  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        share = min(abs(x) / self.x_lock, 0.97)
        return self.k * x / (1 - share * share)


@dataclass(frozen=True)
class MaxwellSlip(Effect):
    """Four Dahl bristles in parallel with travels d/8, d/4, d/2 and d."""

    family = "dry_friction"
    form = "maxwell_slip"
    atol: ClassVar[tuple[float, ...]] = (1e-7,) * 4
    f_c: float = 8.0  # N
    travel: float = 2e-3  # m

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,) * 4

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        size = abs(now.v)
        return tuple((now.v - size * r) / (self.travel * 0.5 ** (3 - i)) for i, r in enumerate(q))

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.f_c * sum(q) / 4


@dataclass(frozen=True)
class Stribeck(Effect):
    """Dry friction that is larger while it starts: F_c (1 + a exp(-(v/v_s)^2)) tanh(v/width)."""

    family = "dry_friction"
    form = "stribeck"
    f_c: float = 8.0  # N
    a: float = 0.4
    v_s: float = 0.01  # m/s
    width: float = 3e-4  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.f_c * (1 + self.a * exp(-((v / self.v_s) ** 2))) * tanh(v / self.width)


@dataclass(frozen=True)
class LuGre(Effect):
    """LuGre bristles: r' = v - |v| r/(d g), force F_c (r/d + s1 r'), with g = 1 + a exp(-(v/v_s)^2)."""

    family = "dry_friction"
    form = "lugre"
    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    f_c: float = 8.0  # N
    travel: float = 3e-4  # m
    a: float = 0.3
    v_s: float = 0.01  # m/s
    damping: float = 2.0  # s/m, times F_c

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def _rate(self, r: float, v: float) -> float:
        return v - abs(v) * r / (self.travel * (1 + self.a * exp(-((v / self.v_s) ** 2))))

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (self._rate(q[0], now.v),)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.f_c * (q[0] / self.travel + self.damping * self._rate(q[0], v))


@dataclass(frozen=True)
class PressedFriction(Effect):
    """Dry friction whose size grows with the pressure that presses the fibres: c (p_0 + p_gauge) tanh(v/width)."""

    family = "dry_friction"
    form = "pressed"
    c: float = 4e-5  # m2
    p_0: float = 5e4  # Pa
    width: float = 3e-4  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * (self.p_0 + max(p_gauge, 0.0)) * tanh(v / self.width)


@dataclass(frozen=True)
class LoadRate(Effect):
    """Friction ab F v/L0 with the muscle's pull F (Dzahir and Yamamoto)."""

    family = "rate_friction"
    form = "load_rate"
    ab: float = 0.5  # s
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    turns: float = 2.0

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        length = self.length - x
        pull = p_gauge * (3 * length * length - self.fibre_squared) / (4 * pi * self.turns**2)
        return self.ab * max(pull, 0.0) * v / self.length


@dataclass(frozen=True)
class Eyring(Effect):
    """Friction that saturates: c v_0 asinh(v/v_0)."""

    family = "rate_friction"
    form = "eyring"
    c: float = 500.0  # N s/m
    v_0: float = 0.01  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * self.v_0 * asinh(v / self.v_0)


@dataclass(frozen=True)
class GrowingViscous(Effect):
    """Viscous friction that grows with contraction: c v (1 + x/x_0)."""

    family = "rate_friction"
    form = "growing"
    c: float = 120.0  # N s/m
    x_0: float = 0.02  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * v * (1 + max(x, 0.0) / self.x_0)


@dataclass(frozen=True)
class OneSidedViscous(Effect):
    """A damper that works mainly in contraction: c v, and share c v in extension."""

    family = "rate_friction"
    form = "one_sided"
    c: float = 300.0  # N s/m
    share: float = 0.3

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * v * (1.0 if v > 0 else self.share)


@dataclass(frozen=True)
class Prony(Effect):
    """Two Maxwell elements whose times lie a decade apart."""

    family = "creep"
    form = "prony"
    atol: ClassVar[tuple[float, ...]] = (1e-10, 1e-10)
    k: float = 300.0  # N/m, of the fast one
    ratio: float = 1.0  # stiffness of the slow one by that of the fast one
    tau: float = 0.8  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x, rest.x)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return ((now.x - q[0]) / self.tau, (now.x - q[1]) / (10 * self.tau))

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * (x - q[0] + self.ratio * (x - q[1]))


@dataclass(frozen=True)
class FractionalCreep(Effect):
    """Relaxation by a power of time, as five Maxwell elements from 0.1 s to 31.6 s: weights tau^-a."""

    family = "creep"
    form = "fractional"
    atol: ClassVar[tuple[float, ...]] = (1e-10,) * 5
    k: float = 200.0  # N/m, at 1 s
    a: float = 0.3

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,) * 5

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return tuple((now.x - r) / tau for r, tau in zip(q, _DECADES, strict=True))

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return float(self.k * sum((x - r) * tau**-self.a for r, tau in zip(q, _DECADES, strict=True)))


_DECADES = tuple(0.1 * 10 ** (0.625 * i) for i in range(5))  # s


@dataclass(frozen=True)
class EyringCreep(Effect):
    """A Maxwell element whose dashpot thins when it is loaded: q' = (x_0/tau) sinh((x - q)/x_0)."""

    family = "creep"
    form = "eyring"
    atol: ClassVar[tuple[float, ...]] = (1e-10,)
    k: float = 400.0  # N/m
    tau: float = 2.0  # s
    x_0: float = 0.015  # m

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (self.x_0 / self.tau * sinh(max(-20.0, min(20.0, (now.x - q[0]) / self.x_0))),)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.k * (x - q[0])


@dataclass(frozen=True)
class KerscherEnds(Effect):
    """The pull is 1 + c exp(-eps/eps_0) times the cylinder's."""

    family = "end_shape"
    form = "kerscher"
    c: float = 0.1
    eps_0: float = 0.1
    length: float = 0.24  # m

    def pull_factor(self, x: float, p_gauge: float) -> float:
        return 1 + self.c * exp(-x / self.length / self.eps_0)


@dataclass(frozen=True)
class BulgingEnds(Effect):
    """The ends hold back more, the more the middle bulges: contraction counts 1 + c eps times in the force."""

    family = "end_shape"
    form = "bulging"
    c: float = 0.4
    length: float = 0.24  # m

    def shape_factor(self, x: float, p_gauge: float) -> float:
        return 1 + self.c * x / self.length


@dataclass(frozen=True)
class SpreadEnds(Effect):
    """The ends spread linearly with pressure: contraction counts 1 + c (1 - p/p_0) times, at least once."""

    family = "end_shape"
    form = "spread"
    c: float = 0.15
    p_0: float = 3e5  # Pa

    def shape_factor(self, x: float, p_gauge: float) -> float:
        return 1 + self.c * max(0.0, 1 - p_gauge / self.p_0)


@dataclass(frozen=True)
class BalancedMass(Effect):
    """Inertia without weight."""

    family = "moving_mass"
    form = "balanced"
    m: float = 3.0  # kg

    def balanced_mass(self, x: float) -> float:
        return self.m


@dataclass(frozen=True)
class Counterweight(Effect):
    """A mass over a pulley that pulls up with a part of the weight that it has inertia: m with net weight w m."""

    family = "moving_mass"
    form = "counterweight"
    m: float = 1.5  # kg
    w: float = 0.25

    def hanging_mass(self) -> float:
        return self.w * self.m

    def balanced_mass(self, x: float) -> float:
        return (1 - self.w) * self.m


@dataclass(frozen=True)
class Lever(Effect):
    """A balanced lever whose ratio changes: inertia m(x) = m (1 + x/x_0) and the force m' v^2/2 that goes with it."""

    family = "moving_mass"
    form = "lever"
    m: float = 2.0  # kg
    x_0: float = 0.05  # m

    def balanced_mass(self, x: float) -> float:
        return self.m * (1 + max(x, 0.0) / self.x_0)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.m / self.x_0 * v * v / 2 if x > 0 else 0.0
