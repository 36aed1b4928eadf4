"""Forces on the load: springs, friction, creep, inertia, and the pull of the sleeve."""

from __future__ import annotations

from dataclasses import dataclass
from math import exp, log1p, pi, sqrt
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State
from rig.family_members.chance import Chance, Place, order, some
from rig.flow import T_ATM, G
from rig.seen.creep import HardeningCreep
from rig.seen.moving_mass import Freewheel, SlippingFlywheel

LENGTH = 0.24  # m
FIBRE_SQUARED = 0.0734  # m2


def pull(x: float, p_gauge: float) -> float:
    """Pull of the cylindrical sleeve [N]."""
    return max(p_gauge * (3 * (LENGTH - x) ** 2 - FIBRE_SQUARED) / (16 * pi), 0.0)


@dataclass(frozen=True)
class OddSpring(Effect):
    """k max(x - slack, 0) (1 + a s + b s^2 + c s^3) (1 + h q), s = x/60 mm, q the gauge pressure by 100 kPa."""

    family = "elasticity"
    form = "random"
    k: float = 200.0  # N/m
    a: float = 0.0
    b: float = 0.0
    c: float = 0.0
    h: float = 0.0
    slack: float = 0.0  # m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        s = x / 0.06
        over = x - self.slack
        stretched = 0.5 * (over + sqrt(over * over + 1e-8)) if self.slack else x
        return (
            self.k
            * stretched
            * (1 + s * (self.a + s * (self.b + s * self.c)))
            * (1 + self.h * p_gauge / 1e5)
        )


@dataclass(frozen=True)
class OddWall(Effect):
    """A stiff wall takes of the pull what there is of p_0 + p_w (s + r s^2)/(1 + s + r s^2), s = x/x_w."""

    family = "elasticity"
    form = "random"
    p_0: float = 2e4  # Pa
    p_w: float = 3e4  # Pa
    x_w: float = 5e-3  # m
    r: float = 0.5

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        s = max(x, 0.0) / self.x_w
        bent = s * (1 + self.r * s)
        held = (
            (self.p_0 + self.p_w * bent / (1 + bent)) * (3 * LENGTH**2 - FIBRE_SQUARED) / (16 * pi)
        )
        return min(held, pull(x, p_gauge))


def _wall(rng: Chance) -> dict[str, float]:
    return {
        "p_0": order(rng, 5e3, 3e4),
        "p_w": order(rng, 1e4, 4e4),
        "x_w": order(rng, 2e-3, 8e-3),
        "r": some(rng, 0, 2),
    }


def _spring(rng: Chance) -> dict[str, float]:
    return {
        "k": order(rng, 80, 600),
        "a": some(rng, -0.5, 1),
        "b": some(rng, -0.3, 1.5),
        "c": some(rng, -0.15, 2),
    }


SPRINGS: dict[str, Place] = {
    "contraction": lambda rng: OddSpring(**_spring(rng)),
    "contraction and pressure": lambda rng: OddSpring(**_spring(rng), h=some(rng, -0.25, 0.8)),
    "slack": lambda rng: OddSpring(**_spring(rng), slack=some(rng, 0.005, 0.03)),
    "wall": lambda rng: OddWall(**_wall(rng)),
}


@dataclass(frozen=True)
class OddDryFriction(Effect):
    """Bristles that give way over a travel d, times everything that dry friction may depend on.

    F (1 + f q^n) + mu pull, times exp(g x/30 mm), 1 + rise/(1 + (v/v_s)^2), 1 + side sgn v, 1 + b ln(1 + age/0.1 s).
    States: the bristle's share, the contact's age.
    """

    family = "dry_friction"
    form = "random"
    stiff = True
    atol: ClassVar[tuple[float, ...]] = (1e-6, 1e-5)
    force_0: float = 6.0  # N
    f: float = 0.0
    n: float = 1.0
    mu: float = 0.0
    g: float = 0.0
    rise: float = 0.0
    v_s: float = 0.01  # m/s
    side: float = 0.0
    b: float = 0.0
    d: float = 5e-4  # m

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return 0.0, 2.0

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        size = abs(now.v)
        return (now.v - size * q[0]) / self.d, 1 - max(q[1], 0.0) * size / 1e-3

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        normal = self.force_0 * (1 + self.f * max(p_gauge / 1e5, 0.0) ** self.n) + self.mu * pull(
            x, p_gauge
        )
        age = 1 + self.b * log1p(max(q[1], 0.0) / 0.1) if self.b else 1.0
        slow = 1 + self.rise / (1 + (v / self.v_s) ** 2)
        return float(normal * exp(self.g * x / 0.03) * slow * age * q[0] * (1 + self.side * q[0]))


@dataclass(frozen=True)
class OddBristle(Effect):
    """A bristle that gives way at a level of its own: r' = (v - |v| r/g)/d, force F r.

    g = (1 + f q^n) exp(c x/30 mm) (1 + rise exp(-(v/v_s)^2)), q the gauge pressure by 100 kPa: a bristle that sticks
    keeps its force when its level changes, as in the LuGre model.
    """

    family = "dry_friction"
    form = "random"
    stiff = True
    atol: ClassVar[tuple[float, ...]] = (1e-6,)
    force_0: float = 6.0  # N
    f: float = 0.0
    n: float = 1.0
    c: float = 0.0
    rise: float = 0.0
    v_s: float = 0.01  # m/s
    d: float = 5e-4  # m

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        pressed = (1 + self.f * max(now.p_gauge / 1e5, 0.0) ** self.n) * exp(self.c * now.x / 0.03)
        level = pressed * (1 + self.rise * exp(-((now.v / self.v_s) ** 2)))
        return ((now.v - abs(now.v) * q[0] / level) / self.d,)

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.force_0 * q[0]


def _travel(rng: Chance) -> float:
    return order(rng, 1e-4, 3e-3)


def _force(rng: Chance) -> float:
    return order(rng, 3, 12)


DRY: dict[str, Place] = {
    "pressure": lambda rng: OddDryFriction(
        _force(rng) / 2, f=order(rng, 0.5, 4), n=some(rng, 0.6, 2), d=_travel(rng)),
    "load": lambda rng: OddDryFriction(0.0, mu=some(rng, 0.05, 0.2), d=_travel(rng)),
    "contraction": lambda rng: OddDryFriction(_force(rng), g=some(rng, -0.6, 0.6), d=_travel(rng)),
    "slow motion": lambda rng: OddDryFriction(
        _force(rng), rise=some(rng, 0.2, 1), v_s=order(rng, 3e-3, 0.05), d=_travel(rng)),
    "direction": lambda rng: OddDryFriction(_force(rng), side=some(rng, -0.6, 0.6), d=_travel(rng)),
    "time at rest": lambda rng: OddDryFriction(_force(rng), b=some(rng, 0.05, 0.2), d=_travel(rng)),
    "pressure and slow motion": lambda rng: OddDryFriction(
        _force(rng) / 2, f=order(rng, 0.5, 3), rise=some(rng, 0.2, 1), v_s=order(rng, 3e-3, 0.05), d=_travel(rng)),
    "level of the bristle": lambda rng: OddBristle(
        _force(rng) / 2, f=order(rng, 0.5, 3), n=some(rng, 0.6, 2), c=some(rng, -0.4, 0.4), rise=some(rng, 0.2, 1),
        v_s=order(rng, 3e-3, 0.05), d=_travel(rng)),
}  # fmt: skip


@dataclass(frozen=True)
class OddDamper(Effect):
    """c v (|v|/0.1 m/s)^a (1 + f q^n) (1 + x/x_0)^m (1 + side sgn v) (1 + l pull/20 N), linear below 0.3 mm/s."""

    family = "rate_friction"
    form = "random"
    c: float = 60.0  # N s/m
    a: float = 0.0
    f: float = 0.0
    n: float = 1.0
    m: float = 0.0
    side: float = 0.0
    load: float = 0.0

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        size = sqrt(v * v + 1e-7)
        law = self.c * v * (size / 0.1) ** self.a * (1 + self.side * v / size)
        by = (1 + self.f * max(p_gauge / 1e5, 0.0) ** self.n) * (1 + max(x, 0.0) / 0.03) ** self.m
        return float(law * by * (1 + self.load * pull(x, p_gauge) / 20))


def _damper(rng: Chance) -> dict[str, float]:
    return {"c": order(rng, 30, 200), "a": some(rng, -0.6, 0.8)}


DAMPERS: dict[str, Place] = {
    "speed": lambda rng: OddDamper(**_damper(rng)),
    "pressure": lambda rng: OddDamper(**_damper(rng), f=order(rng, 0.3, 3), n=some(rng, 0.5, 2)),
    "contraction": lambda rng: OddDamper(**_damper(rng), m=some(rng, -0.7, 1.5)),
    "direction": lambda rng: OddDamper(**_damper(rng), side=some(rng, -0.8, 0.8)),
    "load": lambda rng: OddDamper(**_damper(rng), load=order(rng, 0.3, 3)),
}


@dataclass(frozen=True)
class OddCreep(Effect):
    """Four Maxwell elements of random weights on a scale of times, of a spring (1 + a s) x (1 + h q), s = x/30 mm.

    Rates grow by 1 + thin (load/10 mm)^2 and exp(hot (T - T_atm)/10 K), and are recovery times less where load falls.
    """

    family = "creep"
    form = "random"
    atol: ClassVar[tuple[float, ...]] = (1e-9,) * 5
    k: float = 400.0  # N/m, of all
    tau: float = 0.2  # s, of the first
    spread: float = 4.0
    weights: tuple[float, float, float, float] = (1.0, 1.0, 1.0, 1.0)
    a: float = 0.0
    h: float = 0.0
    thin: float = 0.0
    hot: float = 0.0
    recovery: float = 1.0

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (rest.x,) * 4 + (0.0,)

    def _load(self, x: float, p_gauge: float) -> float:
        return x * (1 + self.a * x / 0.03) * (1 + self.h * p_gauge / 1e5)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        y = self._load(now.x, now.p_gauge)
        warm = exp(self.hot * (now.temperature - T_ATM) / 10)
        rates = []
        for i in range(4):
            e = y - q[i]
            slower = self.recovery if e < 0 else 1.0
            rates.append(
                e * (1 + self.thin * (e / 0.01) ** 2) * warm / (self.tau * self.spread**i * slower)
            )
        return *rates, 0.0

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        y = self._load(x, p_gauge)
        return (
            self.k
            * sum(w * (y - s) for w, s in zip(self.weights, q[:4], strict=True))
            / sum(self.weights)
        )


def _creep(rng: Chance) -> dict[str, float]:
    return {"k": order(rng, 150, 800), "tau": order(rng, 0.05, 0.5), "spread": some(rng, 2, 5)}


def _weights(rng: Chance) -> tuple[float, float, float, float]:
    return some(rng, 0, 1), some(rng, 0, 1), some(rng, 0, 1), some(rng, 0, 1)


CREEP: dict[str, Place] = {
    "time": lambda rng: OddCreep(**_creep(rng), weights=_weights(rng)),
    "strain": lambda rng: OddCreep(**_creep(rng), weights=_weights(rng), a=some(rng, -0.3, 1)),
    "load": lambda rng: OddCreep(**_creep(rng), weights=_weights(rng), thin=order(rng, 0.05, 1)),
    "pressure": lambda rng: OddCreep(**_creep(rng), weights=_weights(rng), h=some(rng, 0.1, 0.8)),
    "temperature": lambda rng: OddCreep(
        **_creep(rng), weights=_weights(rng), hot=some(rng, 0.1, 0.5)
    ),
    "recovery": lambda rng: OddCreep(
        **_creep(rng), weights=_weights(rng), recovery=order(rng, 0.3, 5)
    ),
    "hardening": lambda rng: HardeningCreep(
        k=order(rng, 150, 800),
        tau=order(rng, 0.1, 1),
        x_0=order(rng, 3e-3, 2e-2),
        m=some(rng, 0.5, 3),
    ),
}


@dataclass(frozen=True)
class OddEnds(Effect):
    """The pull is that of the cylinder times 1 + (a + b e + c e^2) (stays + (1 - stays) exp(-p/p_0)), e = x/L/0.25."""

    family = "end_shape"
    form = "random"
    a: float = 0.0
    b: float = -0.1
    c: float = 0.0
    stays: float = 1.0
    p_0: float = 1e5  # Pa

    def pull_factor(self, x: float, p_gauge: float) -> float:
        e = x / LENGTH / 0.25
        fade = self.stays + (1 - self.stays) * exp(-max(p_gauge, 0.0) / self.p_0)
        return 1 + (self.a + e * (self.b + self.c * e)) * fade


def _ends(rng: Chance) -> dict[str, float]:
    return {"a": some(rng, -0.12, 0.12), "b": some(rng, -0.25, 0.1), "c": some(rng, -0.15, 0.15)}


ENDS: dict[str, Place] = {
    "contraction": lambda rng: OddEnds(**_ends(rng)),
    "pressure": lambda rng: OddEnds(**_ends(rng), stays=0.0, p_0=order(rng, 4e4, 2e5)),
    "contraction and pressure": lambda rng: OddEnds(
        **_ends(rng), stays=some(rng, -0.5, 0.8), p_0=order(rng, 4e4, 2e5)
    ),
}


@dataclass(frozen=True)
class OddMass(Effect):
    """A lever, cam or rocker moves m at 1 + a s + b s^2 times the load's speed, s = x/30 mm; a share hangs on it."""

    family = "moving_mass"
    form = "random"
    m: float = 2.0  # kg
    a: float = 0.0
    b: float = 0.0
    share: float = 0.0

    def _ratio(self, x: float) -> float:
        s = max(x, 0.0) / 0.03
        return 1 + s * (self.a + self.b * s)

    def balanced_mass(self, x: float) -> float:
        return self.m * self._ratio(x) ** 2

    def resting_mass(self) -> float:
        return self.share * self.m

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        slope = (self.a + 2 * self.b * x / 0.03) / 0.03 if x > 0 else 0.0
        return self.m * self._ratio(x) * slope * v * v + self.share * self.m * G * self._ratio(x)


MASSES: dict[str, Place] = {
    "hanging": lambda rng: OddMass(order(rng, 0.3, 2), share=some(rng, 0.5, 1)),
    "balanced": lambda rng: OddMass(order(rng, 2, 12)),
    "lever": lambda rng: OddMass(order(rng, 0.5, 5), a=some(rng, -0.2, 0.6), share=some(rng, 0, 1)),
    "rocker": lambda rng: OddMass(
        order(rng, 0.5, 5), a=some(rng, -0.2, 0.3), b=some(rng, -0.1, 0.2), share=some(rng, 0, 1)),
    "dragged along": lambda rng: SlippingFlywheel(order(rng, 2, 12), order(rng, 0.02, 0.2)),
    "dragged along one way": lambda rng: Freewheel(order(rng, 2, 8), order(rng, 0.02, 0.1), order(rng, 0.3, 3)),
}  # fmt: skip
