"""Dry friction: by the direction of motion and the way since it turned. Positive forces oppose contraction."""

from __future__ import annotations

from math import exp, expm1, log1p, pi, sin, sqrt, tanh
from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law


@law
class Stribeck(Effect):
    """Dry friction that is larger while it starts: F_c (1 + a exp(-(v/v_s)^2)) tanh(v/width)."""

    f_c: float = 8.0  # N
    a: float = 0.4
    v_s: float = 0.01  # m/s
    width: float = 3e-4  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.f_c * (1 + self.a * exp(-((v / self.v_s) ** 2))) * tanh(v / self.width)


@law
class LuGre(Effect):
    """LuGre bristles: r' = v - |v| r/(d g), force F_c (r/d + s1 r'), with g = 1 + a exp(-(v/v_s)^2)."""

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


@law
class PressedFriction(Effect):
    """Dry friction whose size grows with the pressure that presses the fibres: c (p_0 + p_gauge) tanh(v/width)."""

    c: float = 4e-5  # m2
    p_0: float = 5e4  # Pa
    width: float = 3e-4  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        return self.c * (self.p_0 + max(p_gauge, 0.0)) * tanh(v / self.width)


@law
class BoucWen(Effect):
    """Bouc-Wen hysteresis: z' = v/d (1 - |z|^n (1 - g + g sign(v z))), force F_c z.

    Unlike Dahl's bristle it unloads by another curve than it loads (g below 1) and turns into sliding late (n above 1).
    Source: Y. K. Wen, Method for random vibration of hysteretic systems, J. Eng. Mech. Div. ASCE 102 (1976) 249.
    """

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


@law
class Capstan(Effect):
    """The cord to the load runs over a fixed bar: F (1 - exp(-mu_phi tanh(v/width))) with the muscle's pull F.

    The tensions on both sides of the bar differ by exp(mu phi), phi being the angle of contact.
    Source: L. Euler, Remarques sur l'effet du frottement dans l'equilibre, Mem. Acad. Sci. Berlin 18 (1769) 265.
    """

    mu_phi: float = 0.1
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    turns: float = 2.0
    width: float = 5e-4  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        length = self.length - x
        pull = p_gauge * (3 * length * length - self.fibre_squared) / (4 * pi * self.turns**2)
        return -max(pull, 0.0) * expm1(-self.mu_phi * tanh(v / self.width))


@law
class AgeingContact(Effect):
    """Friction that grows with the logarithm of a contact's age: F_c (1 + b ln(1 + a/a_0)) tanh(v/width).

    The age a [s] is renewed by sliding over a distance d: a' = 1 - a |v|/d.
    Source: J. H. Dieterich, Modeling of rock friction, J. Geophys. Res. 84 (1979) 2161 (its law of ageing); found for
    paper and polymers too (T. Baumberger, C. Caroli, Adv. Phys. 55 (2006) 279).
    """

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


@law
class ElastoPlastic(Effect):
    """A bristle that is a spring up to its breakaway: z' = v/d (1 - alpha(z) |z|) while v loads it, else v/d; F_c z.

    alpha rises from 0 at the breakaway to 1 at |z| = 1 by half a wave, so small movements come back without drift.
    Source: P. Dupont, V. Hayward, B. Armstrong, F. Altpeter, Single state elastoplastic friction models, IEEE Trans.
    Autom. Control 47 (2002) 787.
    """

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


@law
class Wiper(Effect):
    """The lip of a rod's wiper drags more one way than the other: F_c t (1 + a t), t = tanh(v/width).

    Different levels for either direction are the rule in identified friction. Source: B. Armstrong-Helouvry,
    P. Dupont, C. Canudas de Wit, A survey of models, analysis tools and compensation methods, Automatica 30 (1994)
    1083.
    """

    f_c: float = 8.0  # N, mean of both ways
    a: float = 0.4
    width: float = 5e-4  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        t = tanh(v / self.width)
        return self.f_c * t * (1 + self.a * t)


@law
class CrossingContact(Effect):
    """Dry friction where fibres cross: c p sin(2 theta_0)/sin(2 theta) tanh(v/width), theta the braid's angle.

    Two fibres of a width w touch over a rhomb of w^2/sin(2 theta), which pressure presses together. Source: S. Davis,
    D. G. Caldwell, Braid effects on contractile range and friction modeling in pneumatic muscle actuators, Int. J.
    Robot. Res. 25 (2006) 359.
    """

    c: float = 6e-5  # m2, force by pressure at rest
    length: float = 0.24  # m
    fibre_squared: float = 0.0734  # m2
    width: float = 5e-4  # m/s

    def force(self, q: State, x: float, v: float, p_gauge: float) -> float:
        length = self.length - x
        rest = self.length * sqrt(self.fibre_squared - self.length**2)
        rhomb = rest / (length * sqrt(self.fibre_squared - length * length))
        return self.c * max(p_gauge, 0.0) * rhomb * tanh(v / self.width)


@law
class CarriedPressure(Effect):
    """Only what the bladder does not carry itself presses the fibres: c P z, P = p - p_b (D/D0 - 1) where above 0.

    z' = (v - |v| z)/d is Dahl's bristle; P is rounded over 5 kPa. Source: Amontons' law with the pressure that C.-P.
    Chou and B. Hannaford, IEEE Trans. Robot. Autom. 12 (1996) 90, say a bladder needs to meet the braid.
    """

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


@law
class BreakawayByWay(Effect):
    """A force to break away that fades with the way: F_c ((1 + a) z_1 - a z_2), bristles of travel d/4 and d.

    It peaks after each turn by the way alone, at any speed. Source: P.-A. Bliman, M. Sorine, Easy-to-use realistic dry
    friction models for automatic control, Eur. Control Conf. (1995) 3788, their second order.
    """

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
